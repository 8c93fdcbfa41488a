//! What is being typed at an offset: the one place that answers this, for completion, signature help and what is added
//! while somebody types.
//!
//! The tree of a half-typed file says what the file would mean; here it matters what the author is in the middle of.
//! So the tree is asked for what begins in front of the offset and is not over there (`place`, `tag`), for end tags that are
//! missing or too many (`end_tags`), and the lexer for where an expression ends (`code`).

mod code;
mod end_tags;
mod tag;
#[cfg(test)]
mod tests;
mod typed_text;

pub use code::{CodeContext, Opened, UnclosedCode, cursor, open_call, unclosed};
pub use end_tags::{ended_at, has_end_tag, is_surplus};

use tag::TypedTag;
use xml::{Document, Node};

/// What is being typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typing<'a> {
    /// Nothing that could be completed: CDATA, an instruction, a place between attributes.
    Nothing,
    /// The text of a comment.
    Comment,
    /// Text between tags.
    Content,
    /// The name of a start tag.
    Tag,
    /// The name of an end tag.
    EndTag,
    /// The name of an attribute of this element.
    Attribute(Node<'a>),
    /// The value of the named attribute of this element.
    Value(Node<'a>, &'a str),
}

/// What is being typed at an offset.
#[derive(Clone, Debug)]
pub struct Typed<'a> {
    /// In which part of the markup the offset is.
    pub what: Typing<'a>,
    /// The elements around it, the outermost first; of a value or a tag, that element left out.
    pub open: Vec<Node<'a>>,
    /// What was typed of it so far.
    pub before: &'a str,
    /// All of the text of the item in front of the offset.
    pub text_before: &'a str,
    /// Where the innermost element begins, and where its start tag ends, when that is the last tag in front.
    pub just_opened: Option<(u32, u32)>,
    /// The text of the item behind the offset.
    pub after: &'a str,
    /// The offset in the document.
    pub offset: u32,
    /// The start tag that is typed.
    tag: Option<TypedTag<'a>>,
}

/// What is being typed at `offset`.
pub fn typed(document: &Document, offset: u32) -> Typed<'_> {
    let offset = offset.min(document.len());
    let found = typed_text::find(document, offset);
    let in_front = document.item_at(offset.saturating_sub(1));
    let text_before = part_of(in_front.item.text(), 0, offset - in_front.start);
    let before = match found.start.checked_sub(in_front.start) {
        Some(start) => part_of(text_before, start, offset - in_front.start),
        None => "",
    };
    let behind = document.item_at(offset);
    let open = typed_text::open_at(document, found.around);
    let just_opened = match found.what {
        Typing::Content => just_opened(document, &open, offset, found.start),
        _ => None,
    };
    Typed {
        what: found.what,
        open,
        before,
        text_before,
        just_opened,
        after: part_of(behind.item.text(), offset - behind.start, behind.item.len()),
        offset,
        tag: found.tag,
    }
}

fn part_of(text: &str, start: u32, end: u32) -> &str {
    text.get(start as usize..end as usize).unwrap_or("")
}

/// Where the start tag of the innermost element stands, when it ends at `start`.
fn just_opened(
    document: &Document,
    open: &[Node<'_>],
    offset: u32,
    start: u32,
) -> Option<(u32, u32)> {
    let inner = open.last()?;
    let base = if document.root() == Some(*inner) {
        0
    } else {
        document.item_at(offset.saturating_sub(1)).start
    };
    let tag = inner.start_tag_range().shift(base);
    (tag.end == start).then_some((tag.start, tag.end))
}

/// The value of an attribute as written, line ends and tabs as the blanks that XML takes them for.
pub fn attr_text(node: Node<'_>, name: &str) -> Option<String> {
    let value = node.attr(name)?.raw();
    Some(value.replace(['\n', '\r', '\t'], " "))
}

impl<'a> Typed<'a> {
    /// How much of the text behind the offset belongs to the word that is typed, in bytes.
    pub fn rest_of_word(&self, belongs: impl Fn(char) -> bool) -> u32 {
        let end = self
            .after
            .find(|c: char| !belongs(c))
            .unwrap_or(self.after.len());
        end as u32
    }

    /// How much of the text behind the offset still belongs to the value: up to its quote, where that stands on
    /// the same line.
    pub fn rest_of_value(&self) -> u32 {
        let attrs = self.tag.into_iter().flat_map(|TypedTag { node, base }| {
            let quoted = node.attrs().filter(|attr| attr.is_quoted());
            quoted.map(move |attr| attr.value_range().shift(base))
        });
        let value = attrs.filter(|value| value.touches(self.offset)).last();
        let rest = value.map_or(0, |value| value.end - self.offset);
        if part_of(self.after, 0, rest).contains(['\n', '\r', '<']) {
            0
        } else {
            rest
        }
    }

    /// The innermost element around with this name.
    pub fn inside(&self, name: &str) -> Option<Node<'a>> {
        self.open
            .iter()
            .rev()
            .find(|open| open.name() == name)
            .copied()
    }

    /// The macro around.
    pub fn in_macro(&self) -> Option<Node<'a>> {
        self.inside("xacro:macro")
    }

    /// The names of the elements beside what is typed: those in front of it and those behind. Children of the root, of
    /// which there may be many, are not listed.
    pub fn siblings(&self) -> Vec<&'a str> {
        let own = self.tag.map(|tag| tag.node);
        // what a tag without an end tag took in stands beside it
        let taken = own.filter(|node| node.end_tag().is_none());
        let around = self.open.last().into_iter().copied().chain(taken);
        around
            .flat_map(|node| node.child_elements())
            .filter(|node| Some(*node) != own)
            .map(Node::name)
            .collect()
    }

    /// Whether the start tag that is typed has an attribute beside the one that is typed.
    pub fn has_attr(&self, name: &str) -> bool {
        let Some(TypedTag { node, base }) = self.tag else {
            return false;
        };
        node.attrs()
            .any(|attr| attr.name() == name && !attr.name_range().shift(base).touches(self.offset))
    }

    /// Whether the start tag that is typed has its end.
    pub fn tag_ends(&self) -> bool {
        match self.tag {
            Some(tag) => tag::has_bracket(tag.node),
            // a `<` without a name begins no tag in the tree; what follows would be the rest of it
            None => {
                let end = self.after.find(['<', '>']);
                end.is_some_and(|end| self.after.as_bytes().get(end) == Some(&b'>'))
            }
        }
    }
}

/// Whether a character may stand in the name of an element or attribute.
pub fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | ':' | '-' | '.')
}
