//! Views of the nodes and attributes of an item.

use std::borrow::Cow;

use super::decode::decode;
use super::entities::Entities;
use super::item::Item;
use base::{Id, TextRange};

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NodeKind {
    /// An element with its tags and everything between.
    Element,
    /// Character data and references up to the next markup.
    Text,
    /// `<!-- … -->`
    Comment,
    /// `<![CDATA[ … ]]>`
    CData,
    /// `<?target … ?>`
    Pi,
    /// `<?xml … ?>`
    Declaration,
    /// `<!DOCTYPE … >`
    Doctype,
    /// Text that has no place in XML: a stray `<`, an end tag that closes nothing.
    Junk,
}

/// Number of a node in its item; parents come before their children.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub u32);

base::ids!(NodeId);

/// No node, no offset.
pub(super) const NONE: u32 = u32::MAX;

/// Raw text holds `$`.
pub(super) const HAS_DOLLAR: u8 = 1;
/// Raw text differs from its value: references, line ends, TABs.
pub(super) const NEEDS_DECODING: u8 = 2;
/// Comment, CDATA or instruction has its closing delimiter.
pub(super) const CLOSED: u8 = 4;
/// Start tag ends in `/>`, or was given up.
pub(super) const NO_CONTENT: u8 = 8;
/// Start tag ends in `/>`.
pub(super) const SELF_CLOSING: u8 = 16;
/// Attribute value has a quote on both sides.
pub(super) const QUOTED: u8 = 32;
/// Attribute has a `=`.
pub(super) const HAS_EQUALS: u8 = 64;
/// Attribute has a sound name with a prefix.
pub(super) const PREFIXED: u8 = 128;

/// A node as stored; offsets relative to the item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NodeData {
    pub(super) kind: NodeKind,
    pub(super) flags: u8,
    pub(super) start: u32,
    pub(super) end: u32,
    pub(super) parent: u32,
    /// The id behind the last descendant.
    pub(super) subtree_end: u32,
    /// Length of the name of an element or of the target of an instruction.
    pub(super) name_len: u32,
    /// Elements: offset behind the start tag.
    pub(super) start_tag_end: u32,
    /// Elements: offset of the end tag, or [`NONE`].
    pub(super) end_tag: u32,
    /// Elements: attributes in the item's list.
    pub(super) attrs: (u32, u32),
}

/// An attribute as stored; offsets relative to the item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AttrData {
    pub(super) name: u32,
    pub(super) name_len: u32,
    pub(super) value: u32,
    pub(super) value_end: u32,
    pub(super) end: u32,
    pub(super) flags: u8,
}

/// A node of an item.
#[derive(Clone, Copy)]
pub struct Node<'a> {
    item: &'a Item,
    id: NodeId,
}

const NO_NODE: NodeData = NodeData {
    kind: NodeKind::Junk,
    flags: 0,
    start: 0,
    end: 0,
    parent: NONE,
    subtree_end: 0,
    name_len: 0,
    start_tag_end: 0,
    end_tag: NONE,
    attrs: (0, 0),
};

impl<'a> Node<'a> {
    pub(super) fn new(item: &'a Item, id: NodeId) -> Self {
        Self { item, id }
    }

    #[inline]
    fn data(self) -> &'a NodeData {
        self.item.nodes.get(self.id.index()).unwrap_or(&NO_NODE)
    }

    #[inline]
    fn slice(self, start: u32, end: u32) -> &'a str {
        TextRange::new(start, end).slice(&self.item.text)
    }

    /// What the node is.
    #[inline]
    pub fn kind(self) -> NodeKind {
        self.data().kind
    }

    /// Its number in the item.
    #[inline]
    pub fn id(self) -> NodeId {
        self.id
    }

    /// The item it belongs to.
    #[inline]
    pub fn item(self) -> &'a Item {
        self.item
    }

    /// All of its text, relative to the item. The root's, in the header, is its start tag.
    #[inline]
    pub fn range(self) -> TextRange {
        TextRange::new(self.data().start, self.data().end)
    }

    /// The name of an element as written, the target of an instruction; else empty.
    #[inline]
    pub fn name(self) -> &'a str {
        self.name_range().slice(&self.item.text)
    }

    /// The part of the name behind the prefix.
    #[inline]
    pub fn local_name(self) -> &'a str {
        self.name()
            .split_once(':')
            .map_or(self.name(), |(_, local)| local)
    }

    /// Where the name of the start tag stands.
    #[inline]
    pub fn name_range(self) -> TextRange {
        let data = self.data();
        let start = data.start
            + match data.kind {
                NodeKind::Element => 1,
                NodeKind::Pi | NodeKind::Declaration => 2,
                _ => 0,
            };
        TextRange::new(start, start + data.name_len)
    }

    /// The start tag from `<` to `>`.
    #[inline]
    pub fn start_tag_range(self) -> TextRange {
        TextRange::new(self.data().start, self.data().start_tag_end)
    }

    /// The end tag from `</` to `>`. `None` for the root: see [`Document::root_end_tag`](super::Document::root_end_tag).
    #[inline]
    pub fn end_tag(self) -> Option<TextRange> {
        let data = self.data();
        (data.end_tag != NONE).then(|| TextRange::new(data.end_tag, data.end))
    }

    /// Where the name of the end tag stands.
    pub fn end_name_range(self) -> Option<TextRange> {
        let tag = self.end_tag()?;
        let name = tag.slice(&self.item.text).trim_start_matches("</");
        let len = name
            .find(|c: char| c.is_ascii_whitespace() || c == '>')
            .unwrap_or(name.len());
        Some(TextRange::new(tag.start + 2, tag.start + 2 + len as u32))
    }

    /// Whether the start tag ends in `/>`.
    #[inline]
    pub fn is_self_closing(self) -> bool {
        self.data().flags & SELF_CLOSING != 0
    }

    /// The attributes in document order, namespace declarations included.
    #[inline]
    pub fn attrs(self) -> impl ExactSizeIterator<Item = Attr<'a>> + DoubleEndedIterator {
        let (start, end) = self.data().attrs;
        let item = self.item;
        let attrs = item.attrs.get(start as usize..end as usize).unwrap_or(&[]);
        attrs.iter().map(move |data| Attr { item, data })
    }

    /// The first attribute with this name (as written).
    #[inline]
    pub fn attr(self, name: &str) -> Option<Attr<'a>> {
        self.attrs().find(|attr| attr.name() == name)
    }

    /// The nodes inside, in order.
    #[inline]
    pub fn children(self) -> Siblings<'a> {
        Siblings::new(self.item, self.id.0 + 1, self.data().subtree_end)
    }

    /// The elements inside, in order.
    #[inline]
    pub fn child_elements(self) -> impl Iterator<Item = Node<'a>> {
        self.children()
            .filter(|node| node.kind() == NodeKind::Element)
    }

    /// The first node inside.
    #[inline]
    pub fn first_child(self) -> Option<Node<'a>> {
        self.children().next()
    }

    /// The next node with the same parent (or at the top of the item).
    pub fn next_sibling(self) -> Option<Node<'a>> {
        let end = match self.parent() {
            Some(parent) => parent.data().subtree_end,
            None => self.item.nodes.len() as u32,
        };
        Siblings::new(self.item, self.data().subtree_end, end).next()
    }

    /// The element around; `None` for the top-level nodes of an item.
    #[inline]
    pub fn parent(self) -> Option<Node<'a>> {
        let parent = self.data().parent;
        (parent != NONE).then_some(Node {
            item: self.item,
            id: NodeId(parent),
        })
    }

    /// Text as written; comments, CDATA and instructions without their delimiters (an instruction also
    /// without target and the white space behind it); other nodes in full.
    #[inline]
    pub fn raw(self) -> &'a str {
        self.raw_range().slice(&self.item.text)
    }

    /// Where [`raw`](Self::raw) stands.
    pub fn raw_range(self) -> TextRange {
        let data = self.data();
        match data.kind {
            NodeKind::Comment => TextRange::new(data.start + 4, self.end_before(3)),
            NodeKind::CData => TextRange::new(data.start + 9, self.end_before(3)),
            NodeKind::Pi | NodeKind::Declaration => {
                let (start, end) = (data.start + 2 + data.name_len, self.end_before(2));
                let text = self.slice(start, end);
                let blank = text.len() - text.trim_start_matches([' ', '\t', '\r', '\n']).len();
                TextRange::new(start + blank as u32, end)
            }
            _ => self.range(),
        }
    }

    /// The end without a closing delimiter of `len` bytes, which is missing in a node that is not closed.
    #[inline]
    fn end_before(self, len: u32) -> u32 {
        let data = self.data();
        data.end - if data.flags & CLOSED != 0 { len } else { 0 }
    }

    /// What the parser of the reference hands on: text with references resolved, and for text, comments,
    /// CDATA and instructions line ends as LF.
    pub fn text(self, entities: &Entities) -> Cow<'a, str> {
        match self.kind() {
            NodeKind::Text if self.data().flags & NEEDS_DECODING == 0 => Cow::Borrowed(self.raw()),
            NodeKind::Text => decode(self.raw(), entities, false),
            _ => normalize_line_ends(self.raw()),
        }
    }

    /// Whether the raw text of a text node holds a `$`; for elements: whether an attribute does.
    #[inline]
    pub fn has_dollar(self) -> bool {
        match self.kind() {
            NodeKind::Element => self.attrs().any(Attr::has_dollar),
            _ => self.data().flags & HAS_DOLLAR != 0,
        }
    }
}

/// Text with line ends as an XML parser reports them.
pub fn normalize_line_ends(raw: &str) -> Cow<'_, str> {
    if memchr::memchr(b'\r', raw.as_bytes()).is_none() {
        return Cow::Borrowed(raw);
    }
    Cow::Owned(raw.replace("\r\n", "\n").replace('\r', "\n"))
}

impl PartialEq for Node<'_> {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.item, other.item) && self.id == other.id
    }
}

impl Eq for Node<'_> {}

impl std::fmt::Debug for Node<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:?} {:?} {:?}", self.kind(), self.range(), self.name())
    }
}

/// Nodes with the same parent, in order.
#[derive(Clone)]
pub struct Siblings<'a> {
    item: &'a Item,
    next: u32,
    end: u32,
}

impl<'a> Siblings<'a> {
    pub(super) fn new(item: &'a Item, next: u32, end: u32) -> Self {
        Self { item, next, end }
    }
}

impl<'a> Iterator for Siblings<'a> {
    type Item = Node<'a>;

    #[inline]
    fn next(&mut self) -> Option<Node<'a>> {
        if self.next >= self.end {
            return None;
        }
        let node = Node {
            item: self.item,
            id: NodeId(self.next),
        };
        self.next = node.data().subtree_end.max(self.next + 1);
        Some(node)
    }
}

/// An attribute of an element.
#[derive(Clone, Copy)]
pub struct Attr<'a> {
    item: &'a Item,
    data: &'a AttrData,
}

impl<'a> Attr<'a> {
    /// The item it belongs to.
    #[inline]
    pub fn item(self) -> &'a Item {
        self.item
    }

    /// The name as written.
    #[inline]
    pub fn name(self) -> &'a str {
        self.name_range().slice(&self.item.text)
    }

    /// Where the name stands, relative to the item.
    #[inline]
    pub fn name_range(self) -> TextRange {
        TextRange::new(self.data.name, self.data.name + self.data.name_len)
    }

    /// Name, `=` and value with its quotes, as far as they are there.
    #[inline]
    pub fn range(self) -> TextRange {
        TextRange::new(self.data.name, self.data.end)
    }

    /// The text between the quotes as written.
    #[inline]
    pub fn raw(self) -> &'a str {
        self.value_range().slice(&self.item.text)
    }

    /// Where [`raw`](Self::raw) stands.
    #[inline]
    pub fn value_range(self) -> TextRange {
        TextRange::new(self.data.value, self.data.value_end)
    }

    /// Whether there is a `=`.
    #[inline]
    pub fn has_equals(self) -> bool {
        self.data.flags & HAS_EQUALS != 0
    }

    /// Whether the value has both its quotes.
    #[inline]
    pub fn is_quoted(self) -> bool {
        self.data.flags & QUOTED != 0
    }

    /// The value as XML defines it: white space characters as blanks, references resolved, and for types of words
    /// (`NMTOKENS` and the like) single blanks between them.
    pub fn value(self, entities: &Entities) -> Cow<'a, str> {
        if entities.has_attributes() && self.is_tokenized(entities) {
            let value = decode(self.raw(), entities, true);
            let words: Vec<&str> = value.split(' ').filter(|word| !word.is_empty()).collect();
            return Cow::Owned(words.join(" "));
        }
        if self.data.flags & NEEDS_DECODING == 0 {
            return Cow::Borrowed(self.raw());
        }
        decode(self.raw(), entities, true)
    }

    fn is_tokenized(self, entities: &Entities) -> bool {
        // nothing begins inside a start tag, so the last node that begins in front of the name is the element
        let behind = self
            .item
            .nodes
            .partition_point(|node| node.start <= self.data.name);
        let element = self.item.node(NodeId::from_index(behind.saturating_sub(1)));
        entities.is_tokenized(element.name(), self.name())
    }

    /// Whether the raw value holds a `$`.
    #[inline]
    pub fn has_dollar(self) -> bool {
        self.data.flags & HAS_DOLLAR != 0
    }
}

impl PartialEq for Attr<'_> {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.data, other.data)
    }
}

impl Eq for Attr<'_> {}

impl std::fmt::Debug for Attr<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}={:?}", self.name(), self.raw())
    }
}
