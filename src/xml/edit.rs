//! Edits: parse again what an edit touches, keep the rest.

use std::collections::VecDeque;
use std::sync::Arc;

use super::document::{Document, DocumentPart, HeaderContext};
use super::item::Item;
use super::line_table::LineTable;
use super::parse::{Footer, Header, ItemParser, ParseStep, RootState};
use base::TextRange;
use base::limits::XML_BYTES;

impl Document {
    /// Replace the bytes of `range`. A range that does not fit is cut to the text and widened to whole
    /// characters. An edit that would make the document longer than 1 GiB does nothing.
    pub fn edit(&mut self, range: TextRange, replacement: &str) {
        let (start, end) = self.whole_characters(range);
        if self.len() as usize - (end - start) as usize + replacement.len() > XML_BYTES {
            return;
        }
        match self.reparse(start, end, replacement) {
            Some(change) => self.apply(change),
            None => {
                let mut text = self.text();
                text.replace_range(start as usize..end as usize, replacement);
                *self = Document::parse(&text);
            }
        }
    }

    /// Parse what the edit touches. `None` if that may be everything.
    fn reparse(&self, start: u32, end: u32, replacement: &str) -> Option<DocumentChange> {
        if self.context.root != RootState::Open {
            return None;
        }
        let (first, offset) = self.first_dirty(start);
        let mut window = EditWindow::new(self.parts_from(first), self.number(first), offset);
        window.fill(end);
        window.replace(start, end, replacement);
        let header = if first == DocumentPart::Header {
            Some(window.header())
        } else {
            None
        };
        let name = header
            .as_ref()
            .map_or(&self.context.root_name, |header| &header.root_name);
        if header
            .as_ref()
            .is_some_and(|header| header.root != RootState::Open)
            || (*name != self.context.root_name && !self.fits_any_root_name())
        {
            return None;
        }
        let (items, rest) = window.run(name);
        Some(DocumentChange {
            header,
            first: self.number(first).saturating_sub(1),
            items,
            rest,
        })
    }

    fn apply(&mut self, change: DocumentChange) {
        self.lines = LineTable::default();
        let mut renamed = false;
        if let Some(header) = change.header {
            let (header, context) = HeaderContext::split(header);
            renamed = context.root_name != self.context.root_name;
            (self.header, self.context) = (header, Arc::new(context));
        }
        self.replace_items(change.first, change.items, change.rest);
        if renamed {
            // Only the root's end tag knows its name.
            let part = self.item_count() + 1;
            let window = EditWindow::new(
                self.parts_from(DocumentPart::Footer),
                part,
                self.footer_start(),
            );
            let (items, rest) = window.forced().run(&self.context.root_name);
            self.replace_items(part - 1, items, rest);
        }
    }

    fn replace_items(&mut self, first: usize, items: Vec<Arc<Item>>, rest: Rest) {
        let end = match rest {
            Rest::Kept(part) => part - 1,
            Rest::Footer(footer) => {
                self.footer = footer;
                self.item_count()
            }
        };
        self.items.splice(first..end.max(first), items);
    }

    /// The number of a part: 0 for the header, items from 1, then the footer.
    fn number(&self, part: DocumentPart) -> usize {
        match part {
            DocumentPart::Header => 0,
            DocumentPart::Item(index) => index + 1,
            DocumentPart::Footer => self.item_count() + 1,
        }
    }

    /// Whether no item depends on the name of the root.
    fn fits_any_root_name(&self) -> bool {
        self.items.iter_from(0).all(|item| {
            item.extra
                .as_ref()
                .is_none_or(|extra| !extra.needs_root_name)
        })
    }

    /// The range, cut to the text and widened to character boundaries.
    pub(super) fn whole_characters(&self, range: TextRange) -> (u32, u32) {
        let len = self.len();
        let (mut start, mut end) = (range.start.min(len), range.end.min(len));
        while !self.is_char_boundary(start) {
            start -= 1;
        }
        while !self.is_char_boundary(end) {
            end += 1;
        }
        (start, end.max(start))
    }

    fn is_char_boundary(&self, offset: u32) -> bool {
        let place = self.item_at(offset);
        place
            .item
            .text()
            .is_char_boundary((offset - place.start) as usize)
    }

    /// The first part that a change of the text from `offset` on touches, and its offset.
    fn first_dirty(&self, offset: u32) -> (DocumentPart, u32) {
        if self.header.lookahead() > offset {
            return (DocumentPart::Header, 0);
        }
        let head = self.header.len();
        if let Some(mark) = self.items.first_reaching(offset - head) {
            return (DocumentPart::Item(mark.index), head + mark.bytes);
        }
        let place = self.item_at(offset);
        (place.part, place.start)
    }
}

/// What an edit does to a document.
struct DocumentChange {
    header: Option<Header>,
    /// The first item to replace.
    first: usize,
    items: Vec<Arc<Item>>,
    rest: Rest,
}

/// What follows the items parsed again.
enum Rest {
    /// The old parts from this number on are still right.
    Kept(usize),
    /// All was parsed.
    Footer(Footer),
}

/// A range of edited text that grows part by part as the parser asks for more.
struct EditWindow<I: Iterator> {
    text: String,
    /// Where old parts begin in the text, behind the edit: offset and number.
    bounds: VecDeque<(usize, usize)>,
    parts: std::iter::Peekable<I>,
    /// Number of the next part to append.
    next: usize,
    /// Offset of the window in the old text.
    offset: u32,
    is_final: bool,
    /// No old part may be kept.
    forced: bool,
}

impl<'d, I: Iterator<Item = &'d Arc<Item>>> EditWindow<I> {
    fn new(parts: I, next: usize, offset: u32) -> Self {
        // Nothing can go before the header.
        let bounds = (next > 0).then_some((0, next)).into_iter().collect();
        Self {
            text: String::new(),
            bounds,
            parts: parts.peekable(),
            next,
            offset,
            is_final: false,
            forced: false,
        }
    }

    fn forced(mut self) -> Self {
        self.forced = true;
        self
    }

    fn push_part(&mut self) {
        let Some(part) = self.parts.next() else {
            return;
        };
        self.text.push_str(part.text());
        self.next += 1;
        self.is_final = self.parts.peek().is_none();
        if !self.is_final {
            self.bounds.push_back((self.text.len(), self.next));
        }
    }

    /// Append parts until the window covers the old text up to `end`.
    fn fill(&mut self, end: u32) {
        while self.offset as usize + self.text.len() < end as usize && self.parts.peek().is_some() {
            self.push_part();
        }
        self.is_final = self.parts.peek().is_none();
    }

    /// Append at least as much again.
    fn extend(&mut self) {
        let wanted = 2 * self.text.len() + 1;
        while self.text.len() < wanted && self.parts.peek().is_some() {
            self.push_part();
        }
        self.is_final = self.parts.peek().is_none();
    }

    /// Make the edit; `start` and `end` are offsets in the old text.
    fn replace(&mut self, start: u32, end: u32, replacement: &str) {
        let (start, end) = ((start - self.offset) as usize, (end - self.offset) as usize);
        self.text.replace_range(start..end, replacement);
        self.bounds.retain_mut(|(at, _)| {
            let keep = *at >= end;
            if keep {
                *at = *at - (end - start) + replacement.len();
            }
            keep
        });
    }

    fn drop_front(&mut self, len: usize) {
        self.text.drain(..len);
        self.bounds.retain_mut(|(at, _)| {
            let keep = *at >= len;
            *at = at.saturating_sub(len);
            keep
        });
    }

    /// The number of the old part that begins at `at`.
    fn part_at(&mut self, at: usize) -> Option<usize> {
        while self.bounds.front().is_some_and(|&(bound, _)| bound < at) {
            self.bounds.pop_front();
        }
        self.bounds
            .front()
            .filter(|&&(bound, _)| bound == at && !self.forced)
            .map(|&(_, part)| part)
    }

    /// Parse the header and move behind it.
    fn header(&mut self) -> Header {
        loop {
            let mut parser = ItemParser::new(&self.text, "", self.is_final);
            let header = parser.header();
            if !parser.needs_more_input() {
                let done = parser.pos();
                self.drop_front(done);
                return header;
            }
            self.extend();
        }
    }

    /// Parse until an old part can follow, or to the end.
    fn run(mut self, root_name: &str) -> (Vec<Arc<Item>>, Rest) {
        let mut items = Vec::new();
        loop {
            let text = std::mem::take(&mut self.text);
            let mut parser = ItemParser::new(&text, root_name, self.is_final);
            let mut done = 0;
            loop {
                if let Some(part) = self.part_at(done) {
                    return (items, Rest::Kept(part));
                }
                if done == text.len() && !self.is_final {
                    break;
                }
                let step = parser.step();
                if parser.needs_more_input() {
                    break;
                }
                done = parser.pos();
                match step {
                    ParseStep::Item(item) => items.push(Arc::new(item)),
                    ParseStep::Footer(footer) => return (items, Rest::Footer(footer)),
                }
            }
            self.text = text;
            self.drop_front(done);
            self.extend();
        }
    }
}
