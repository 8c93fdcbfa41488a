//! What is being typed at an offset, told from the text in front of it.
//!
//! The tree of a half-typed file says what the file would mean; here it matters what the author is in the middle
//! of. So the text from the start of the item to the offset is read once more, and whatever is open there counts.

mod code;

pub use code::{Cursor, Opened, Unclosed, cursor, open_call, unclosed};

use super::tag_reader::{Open, Reader, State};
use base::TextRange;
use xml::{Document, Node, Part};

/// What is being typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Typing {
    /// Nothing that could be completed: CDATA, an instruction, a place between attributes.
    Nothing,
    /// A comment.
    Comment,
    /// Text between tags.
    Content,
    /// The name of a start tag.
    Tag,
    /// The name of an end tag.
    EndTag,
    /// The name of an attribute of this element.
    Attribute(Open),
    /// The value of the named attribute of this element.
    Value(Open, String),
}

/// What is being typed at an offset.
#[derive(Clone, Debug)]
pub struct Typed {
    /// What it is.
    pub what: Typing,
    /// The elements around it, the outermost first; of a value or a tag, that element left out.
    pub open: Vec<Open>,
    /// What was typed of it so far.
    pub before: String,
    /// All of the text in front of the offset that was read: from the start of its item.
    pub text_before: String,
    /// Where the innermost element begins, and where its start tag ends, when that is the last tag in front.
    pub just_opened: Option<(u32, u32)>,
    /// The text behind the offset.
    pub after: String,
    /// The offset.
    pub offset: u32,
}

/// Most of the text behind an offset that is looked at.
const MOST_BEHIND: u32 = 1 << 20;

/// What is being typed at `offset`.
pub fn typed(document: &Document, offset: u32) -> Typed {
    let offset = offset.min(document.len());
    let begin = beginning(document, offset);
    let text = document.slice(TextRange::new(begin, offset));
    let mut reader = Reader::new(&text);
    if let (true, Some(root)) = (begin > 0, document.root()) {
        reader.open.push(Open::of(root));
    }
    let behind_root = document.root_end_tag().is_some_and(|tag| tag.end <= offset);
    let state = reader.run();
    let state_start = match &state {
        State::Content(start) => Some(*start),
        _ => None,
    };
    let from = |start: usize| text.get(start..).unwrap_or("").to_owned();
    let (what, before) = match state {
        _ if behind_root => (Typing::Nothing, String::new()),
        State::Comment(start) => (Typing::Comment, from(start)),
        State::Content(start) => (Typing::Content, from(start)),
        State::Tag(start) => (Typing::Tag, from(start)),
        State::EndTag(start) => (Typing::EndTag, from(start)),
        State::Attribute(tag, start) => (Typing::Attribute(tag), from(start)),
        State::Value(tag, name, start) => (Typing::Value(tag, name), from(start)),
        State::Nothing => (Typing::Nothing, String::new()),
    };
    let opened = reader.opened_at.filter(|&end| state_start == Some(end));
    let inner = opened.zip(reader.open.last());
    let inner = inner.map(|(end, open)| (begin + open.start as u32, begin + end as u32));
    // the root's start tag is a part of its own
    let root = document
        .root()
        .filter(|_| reader.open.len() == 1 && state_start == Some(0));
    let root = root
        .map(Node::start_tag_range)
        .filter(|tag| tag.end == begin);
    let just_opened = inner.or(root.map(|tag| (tag.start, tag.end)));
    let end = document.len().min(offset.saturating_add(MOST_BEHIND));
    let after = document.slice(TextRange::new(offset, end));
    let open = reader.open;
    Typed {
        what,
        open,
        before,
        text_before: text,
        just_opened,
        after,
        offset,
    }
}

/// Where to begin reading: with the item around `offset`, or in front of it when a tag was left open there.
fn beginning(document: &Document, offset: u32) -> u32 {
    let place = document.item_at(offset.saturating_sub(1));
    let mut index = match place.part {
        Part::Header => return 0,
        Part::Item(index) => index,
        Part::Footer => document.item_count(),
    };
    let mut start = place.start;
    while let Some((before, item)) = index.checked_sub(1).and_then(|index| document.item(index)) {
        if item.text().ends_with('>') {
            return start;
        }
        (index, start) = (index - 1, before);
    }
    if document.header().text().ends_with('>') {
        start
    } else {
        0
    }
}

impl Typed {
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
        let stop = |c: char| matches!(c, '"' | '<' | '\n' | '\r');
        match self.after.find(stop) {
            Some(end)
                if self
                    .after
                    .get(end..)
                    .is_some_and(|rest| rest.starts_with('"')) =>
            {
                end as u32
            }
            _ => 0,
        }
    }

    /// The innermost element around whose name `is` accepts.
    pub fn inside(&self, is: impl Fn(&str) -> bool) -> Option<&Open> {
        self.open.iter().rev().find(|open| is(&open.name))
    }

    /// The macro around.
    pub fn in_macro(&self) -> Option<&Open> {
        self.inside(|name| name == "xacro:macro")
    }

    /// The names of the elements beside what is typed: those in front of it and those behind.
    pub fn siblings(&self) -> Vec<String> {
        let mut names = self
            .open
            .last()
            .map(|open| open.children.clone())
            .unwrap_or_default();
        let from = self.rest_of_word(is_name_char) as usize;
        let mut reader = Reader::new(self.after.get(from..).unwrap_or("")).until_unmatched(1);
        reader.open.push(Open::default());
        reader.run();
        names.extend(
            reader
                .open
                .into_iter()
                .next()
                .map(|open| open.children)
                .unwrap_or_default(),
        );
        names
    }

    /// What stands behind the offset in the same start tag: the names of attributes, and whether the tag ends.
    pub fn rest_of_tag(&self) -> (Vec<String>, bool) {
        let from = self.rest_of_word(is_name_char) as usize;
        Reader::new(self.after.get(from..).unwrap_or("")).rest_of_tag()
    }
}

/// Whether a character may stand in the name of an element or attribute.
pub fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | ':' | '-' | '.')
}
