//! The parser: text in, items out. It never fails and never recurses.

mod check;
mod content;
mod declaration;
mod doctype;
mod end_tag;
mod markup;
mod names;
mod prolog;
mod recover;
mod tag;
mod text;
mod token;
mod value;

use std::collections::HashMap;

use super::error::{Condition, ItemError, SyntaxError, SyntaxErrorKind};
use super::item::{EntityUse, Item, ItemDetails};
use super::node::{AttrData, NONE, NodeData, NodeId, NodeKind};
use base::limits::ITEM_ERRORS;
use base::{IdVec, TextRange, count_line_ends};
use names::NamespaceScopes;

pub(super) use prolog::{Footer, Header, RootState};

/// What expat says, and the offset where it stops.
type ExpatError = (&'static str, usize);

/// What ended a run of content.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ContentEnd {
    /// An element is complete: so is the item.
    Element,
    /// The root's end tag stands at the current position.
    RootEnd,
    /// The text is used up.
    End,
}

/// What [`ItemParser::step`] found.
pub(super) enum ParseStep {
    /// An item; there is more.
    Item(Item),
    /// The rest of the file.
    Footer(Footer),
}

/// Reads items from a window of text that starts on an item boundary.
pub(super) struct ItemParser<'t> {
    text: &'t str,
    bytes: &'t [u8],
    /// Whether the text ends where the file ends.
    is_final: bool,
    pos: usize,
    /// Where the current item starts.
    base: usize,
    /// How far the parser had to look to shape the current item.
    lookahead: usize,
    /// The shape of the current item depends on the text ending here.
    hit_end: bool,
    needs_root_name: bool,
    /// The current item is the header.
    in_header: bool,
    /// Inside a piece of markup: the largest offset of its errors so far. What is found later comes later
    /// for expat too, even if it would name an earlier offset.
    min_offset: Option<u32>,
    root_name: &'t str,
    /// No forbidden characters in the text.
    clean: bool,
    /// `]]>` occurs in the text.
    has_cdata_end: bool,
    /// Delimiters that do not occur from an offset on.
    absent: Vec<(&'static str, usize)>,
    /// The first forbidden character from an offset on.
    illegal: Option<(usize, Option<usize>)>,
    has_doctype: bool,
    nodes: IdVec<NodeId, NodeData>,
    attrs: Vec<AttrData>,
    errors: Vec<ItemError>,
    /// The open elements.
    open: Vec<NodeId>,
    entity_uses: HashMap<(&'t str, bool), u32>,
    scopes: NamespaceScopes<'t>,
}

impl<'t> ItemParser<'t> {
    pub(super) fn new(text: &'t str, root_name: &'t str, is_final: bool) -> Self {
        let bytes = text.as_bytes();
        Self {
            text,
            bytes,
            is_final,
            pos: 0,
            base: 0,
            lookahead: 0,
            hit_end: false,
            needs_root_name: false,
            in_header: false,
            min_offset: None,
            root_name,
            clean: super::chars::first_illegal(text).is_none(),
            has_cdata_end: memchr::memmem::find(bytes, b"]]>").is_some(),
            absent: Vec::new(),
            illegal: None,
            has_doctype: false,
            nodes: IdVec::default(),
            attrs: Vec::new(),
            errors: Vec::new(),
            open: Vec::new(),
            entity_uses: HashMap::new(),
            scopes: NamespaceScopes::default(),
        }
    }

    /// The current position in the window.
    pub(super) fn pos(&self) -> usize {
        self.pos
    }

    /// Read the next item. It is worthless when [`needs_more_input`](Self::needs_more_input) says so.
    pub(super) fn step(&mut self) -> ParseStep {
        self.begin_item();
        let stop = self.content();
        if stop == ContentEnd::Element
            || self.nodes.iter().any(|node| node.kind == NodeKind::Element)
        {
            return ParseStep::Item(self.finish_item());
        }
        ParseStep::Footer(self.footer(stop))
    }

    /// Whether the last item would need text beyond the window.
    pub(super) fn needs_more_input(&self) -> bool {
        self.hit_end && !self.is_final
    }

    fn begin_item(&mut self) {
        self.base = self.pos;
        self.lookahead = self.pos;
        self.hit_end = false;
        self.needs_root_name = false;
        self.in_header = false;
        self.min_offset = None;
        self.nodes.clear();
        self.attrs.clear();
        self.errors.clear();
        self.open.clear();
        self.entity_uses.clear();
        self.scopes.clear();
    }

    fn finish_item(&mut self) -> Item {
        let text = self.text.get(self.base..self.pos).unwrap_or("");
        let lookahead = if self.hit_end {
            u32::MAX
        } else {
            (self.lookahead.max(self.pos) - self.base) as u32
        };
        let plain = self.errors.is_empty()
            && self.entity_uses.is_empty()
            && !self.needs_root_name
            && lookahead as usize == text.len();
        let extra = (!plain).then(|| ItemDetails {
            errors: self.errors.drain(..).collect(),
            entity_uses: self.take_entity_uses(),
            lookahead: if lookahead as usize == text.len() {
                0
            } else {
                lookahead
            },
            needs_root_name: self.needs_root_name,
        });
        let (nodes, attrs) = (self.nodes.as_slice(), &self.attrs);
        Item::new(text, count_line_ends(text), nodes, attrs, extra)
    }

    fn take_entity_uses(&mut self) -> Vec<EntityUse> {
        let uses = self.entity_uses.drain();
        let uses = uses.map(|((name, in_attribute), count)| EntityUse {
            name: name.into(),
            in_attribute,
            count,
        });
        let mut uses: Vec<EntityUse> = uses.collect();
        uses.sort_by(|a, b| (&a.name, a.in_attribute).cmp(&(&b.name, b.in_attribute)));
        uses
    }

    /// The shape of the current item depends on the text before `to`.
    fn look(&mut self, to: usize) {
        self.lookahead = self.lookahead.max(to);
        self.hit_end |= to > self.bytes.len();
    }

    fn peek(&mut self) -> Option<u8> {
        let byte = self.bytes.get(self.pos).copied();
        self.hit_end |= byte.is_none();
        byte
    }

    fn starts_with(&self, prefix: &[u8]) -> bool {
        self.bytes
            .get(self.pos..)
            .is_some_and(|rest| rest.starts_with(prefix))
    }

    fn skip_space(&mut self) {
        while self
            .bytes
            .get(self.pos)
            .is_some_and(|&b| super::chars::is_space(b))
        {
            self.pos += 1;
        }
    }

    fn slice(&self, start: usize, end: usize) -> &'t str {
        self.text.get(start..end).unwrap_or("")
    }

    /// An offset in the window as one in the current item.
    fn rel(&self, at: usize) -> u32 {
        (at - self.base) as u32
    }

    fn range(&self, start: usize, end: usize) -> TextRange {
        TextRange::new(self.rel(start), self.rel(end))
    }

    /// Add a node that ends at the current position.
    fn push_node(&mut self, kind: NodeKind, start: usize, flags: u8) -> NodeId {
        let (start, end) = (self.rel(start), self.rel(self.pos));
        self.nodes.push(NodeData {
            kind,
            flags,
            start,
            end,
            parent: self.open.last().map_or(NONE, |open| open.0),
            subtree_end: self.nodes.next_id().0 + 1,
            name_len: 0,
            start_tag_end: 0,
            end_tag: NONE,
            attrs: (0, 0),
        })
    }

    fn push_error(&mut self, condition: Condition, mut error: SyntaxError) {
        if let Some(min_offset) = self.min_offset.as_mut() {
            error.expat_offset = error.expat_offset.max(*min_offset);
            if condition == Condition::Always {
                *min_offset = error.expat_offset;
            }
        }
        if self.errors.len() < ITEM_ERRORS {
            self.errors.push(ItemError {
                error,
                condition,
                diverges: false,
            });
        }
    }

    /// The tree is a guess from the last error on.
    fn mark_divergence(&mut self) {
        if let Some(last) = self.errors.last_mut() {
            last.diverges = true;
        }
    }

    /// Report `start..end`; expat stops at `at` and says `expat`.
    fn error(
        &mut self,
        kind: SyntaxErrorKind,
        (start, end): (usize, usize),
        (expat, at): ExpatError,
        message: impl Into<String>,
    ) {
        let error = SyntaxError {
            kind,
            range: self.range(start, end),
            related: None,
            message: message.into(),
            expat,
            expat_offset: self.rel(at),
        };
        self.push_error(Condition::Always, error);
    }

    /// The end of the character at `at`.
    fn char_end(&self, at: usize) -> usize {
        let len = self
            .text
            .get(at..)
            .and_then(|rest| rest.chars().next())
            .map_or(0, char::len_utf8);
        at + len
    }
}
