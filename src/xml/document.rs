//! A document: header, items, footer.

use std::ops::Range;
use std::sync::Arc;

use super::chunks::Chunks;
use super::entities::Entities;
use super::item::Item;
use super::item_run::ItemRun;
use super::line_table::LineTable;
use super::node::{Node, Siblings};
use super::parse::{Footer, Header, ItemParser, ParseStep, RootState};
use base::limits::XML_BYTES;
use base::{FastMap, TextRange, last_line_start, line_end};

/// A parsed file. Clones share their items; an edit re-parses the items it touches.
#[derive(Clone)]
pub struct Document {
    pub(super) header: Arc<Item>,
    pub(super) items: Chunks,
    pub(super) footer: Footer,
    pub(super) context: Arc<HeaderContext>,
    pub(super) lines: LineTable,
}

/// What the header says about the rest.
pub(super) struct HeaderContext {
    pub(super) root: RootState,
    pub(super) root_name: Box<str>,
    pub(super) entities: Arc<Entities>,
    pub(super) namespaces: FastMap<Box<str>, Box<str>>,
}

/// Which part of a document an offset lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DocumentPart {
    /// The prolog and the root's start tag.
    Header,
    /// The item with this number.
    Item(usize),
    /// Behind the last item.
    Footer,
}

/// Where an offset lies.
#[derive(Clone, Copy, Debug)]
pub struct DocumentPosition<'a> {
    /// Which part.
    pub part: DocumentPart,
    /// Absolute offset of the part.
    pub start: u32,
    /// Its text and tree.
    pub item: &'a Arc<Item>,
}

impl Document {
    /// Parse a whole file. Never fails: what is wrong is in [`errors`](Self::errors).
    /// Of a text longer than 1 GiB only that much is read.
    pub fn parse(text: &str) -> Document {
        let text = text
            .get(..text.floor_char_boundary(XML_BYTES))
            .unwrap_or("");
        let mut parser = ItemParser::new(text, "", true);
        let header = parser.header();
        let mut items = Vec::new();
        let footer = match header.root {
            RootState::Open => loop {
                match parser.step() {
                    ParseStep::Item(item) => items.push(Arc::new(item)),
                    ParseStep::Footer(footer) => break footer,
                }
            },
            RootState::Missing | RootState::Empty => parser.bare_footer(),
        };
        let (header, context) = HeaderContext::split(header);
        Document {
            header,
            items: Chunks::new(items),
            footer,
            context: Arc::new(context),
            lines: LineTable::default(),
        }
    }

    /// Length in bytes.
    #[allow(clippy::len_without_is_empty)] // nobody asks
    pub fn len(&self) -> u32 {
        self.header.len() + self.items.bytes() + self.footer.item.len()
    }

    /// The whole text.
    pub fn text(&self) -> String {
        let mut text = String::with_capacity(self.len() as usize);
        text.extend(self.parts().map(|(_, item)| item.text()));
        text
    }

    /// The text of `range`; what lies outside of the document is left away.
    pub fn slice(&self, range: TextRange) -> String {
        let mut out = String::new();
        let place = self.item_at(range.start);
        let mut start = place.start;
        for item in self.parts_from(place.part) {
            if start >= range.end {
                break;
            }
            let from = range.start.saturating_sub(start);
            let to = (range.end - start).min(item.len());
            out.push_str(TextRange::new(from, to).slice(item.text()));
            start += item.len();
        }
        out
    }

    /// The text in front of and behind `range`, on each side about `most` bytes.
    pub fn beside(&self, range: TextRange, most: u32) -> (String, String) {
        let wide = TextRange::new(
            range.start.saturating_sub(most),
            range.end.saturating_add(most),
        );
        let (start, end) = self.whole_characters(wide);
        (
            self.slice(TextRange::new(start, range.start)),
            self.slice(TextRange::new(range.end, end)),
        )
    }

    /// The line around an offset, and the offset in it; none when it has more than `most` bytes.
    pub fn line_around(&self, offset: u32, most: u32) -> Option<(String, usize)> {
        let (mut line, behind) = self.beside(TextRange::empty(offset), most.saturating_add(1));
        if line.ends_with('\r') && behind.starts_with('\n') {
            return self
                .line_around(offset - 1, most)
                .map(|(line, inside)| (line, inside + 1));
        }
        if let Some(start) = last_line_start(&line) {
            line.drain(..start);
        }
        let inside = line.len();
        line.push_str(behind.get(..line_end(&behind)).unwrap_or(""));
        (line.len() <= most as usize).then_some((line, inside))
    }

    /// The prolog (declaration, comments, instructions, DOCTYPE) and, as last node, the root's start tag.
    pub fn header(&self) -> &Arc<Item> {
        &self.header
    }

    /// Trailing text and comments inside the root, its end tag, and what follows.
    pub fn footer(&self) -> &Arc<Item> {
        &self.footer.item
    }

    /// Absolute offset of the footer.
    pub fn footer_start(&self) -> u32 {
        self.header.len() + self.items.bytes()
    }

    /// The number of items.
    pub fn item_count(&self) -> usize {
        self.items.count()
    }

    /// The item with this number and its absolute offset.
    pub fn item(&self, index: usize) -> Option<(u32, &Arc<Item>)> {
        let item = self.items.get(index)?;
        Some((self.header.len() + self.items.at_index(index).bytes, item))
    }

    /// The items that an older state of this document does not have; none when its header or footer differs.
    pub fn items_not_in(&self, older: &Document) -> Option<Range<usize>> {
        let same_ends = Arc::ptr_eq(older.header(), self.header())
            && Arc::ptr_eq(older.footer(), self.footer());
        let (start, kept) = older.items.shared(&self.items);
        same_ends.then(|| start..self.item_count() - kept)
    }

    /// The children of the root in order, each an element with the text and comments before it, with their
    /// absolute offsets.
    pub fn items(&self) -> impl Iterator<Item = (u32, &Arc<Item>)> {
        let mut next = self.header.len();
        self.items.iter_from(0).map(move |item| {
            let start = next;
            next += item.len();
            (start, item)
        })
    }

    /// The items in rows, with the absolute offsets of their first ones.
    pub fn item_runs(&self) -> impl Iterator<Item = (u32, &ItemRun)> {
        let start = self.header.len();
        self.items
            .runs()
            .map(move |(base, run)| (start + base, run))
    }

    /// How the first line of this text ends; with a line feed when there is one line only.
    pub fn line_end(&self) -> &'static str {
        let mut parts = self.parts().map(|(_, item)| item.text());
        let first = parts.find_map(|text| text.get(..text.find('\n')?));
        if first.is_some_and(|line| line.ends_with('\r')) {
            "\r\n"
        } else {
            "\n"
        }
    }

    /// Header, items, footer, with their absolute offsets.
    pub fn parts(&self) -> impl Iterator<Item = (u32, &Arc<Item>)> {
        let footer = std::iter::once((self.footer_start(), &self.footer.item));
        std::iter::once((0, &self.header))
            .chain(self.items())
            .chain(footer)
    }

    pub(super) fn parts_from(&self, part: DocumentPart) -> impl Iterator<Item = &Arc<Item>> {
        let (header, index) = match part {
            DocumentPart::Header => (Some(&self.header), 0),
            DocumentPart::Item(index) => (None, index),
            DocumentPart::Footer => (None, usize::MAX),
        };
        header
            .into_iter()
            .chain(self.items.iter_from(index))
            .chain(std::iter::once(&self.footer.item))
    }

    /// The characters from `offset` on, which must be the start of one.
    pub(super) fn chars_from(&self, offset: u32) -> impl Iterator<Item = char> {
        let place = self.item_at(offset);
        let mut skip = (offset - place.start) as usize;
        self.parts_from(place.part).flat_map(move |item| {
            item.text()
                .get(std::mem::take(&mut skip)..)
                .unwrap_or("")
                .chars()
        })
    }

    /// The part that holds the byte at `offset`.
    pub fn item_at(&self, offset: u32) -> DocumentPosition<'_> {
        let head = self.header.len();
        if offset < head || self.context.root == RootState::Missing {
            return DocumentPosition {
                part: DocumentPart::Header,
                start: 0,
                item: &self.header,
            };
        }
        let mark = self.items.at_offset(offset - head);
        match self.items.get(mark.index) {
            Some(item) => DocumentPosition {
                part: DocumentPart::Item(mark.index),
                start: head + mark.bytes,
                item,
            },
            None => DocumentPosition {
                part: DocumentPart::Footer,
                start: head + mark.bytes,
                item: &self.footer.item,
            },
        }
    }

    /// The root element, without its children: these are in the items.
    pub fn root(&self) -> Option<Node<'_>> {
        self.header.element()
    }

    /// Whether the root is `<robot/>`.
    pub fn root_is_closed_empty(&self) -> bool {
        self.context.root == RootState::Empty
    }

    /// The root's end tag; absolute.
    pub fn root_end_tag(&self) -> Option<TextRange> {
        self.footer
            .root_end
            .map(|range| range.shift(self.footer_start()))
    }

    /// The nodes of the footer that are inside the root.
    pub fn footer_content(&self) -> Siblings<'_> {
        Siblings::new(&self.footer.item, 0, self.footer.inner)
    }

    /// The nodes behind the root's end tag.
    pub fn epilog(&self) -> Siblings<'_> {
        Siblings::new(
            &self.footer.item,
            self.footer.inner,
            self.footer.item.nodes.len() as u32,
        )
    }

    /// The entities the document declares.
    pub fn entities(&self) -> &Entities {
        &self.context.entities
    }

    /// The same, to keep.
    pub fn shared_entities(&self) -> Arc<Entities> {
        Arc::clone(&self.context.entities)
    }
}

impl HeaderContext {
    pub(super) fn split(header: Header) -> (Arc<Item>, HeaderContext) {
        let Header {
            item,
            root,
            root_name,
            entities,
            namespaces,
        } = header;
        (
            item,
            HeaderContext {
                root,
                root_name,
                entities: Arc::new(entities),
                namespaces,
            },
        )
    }
}
