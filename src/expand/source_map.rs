//! Which part of the printed document came from which text of the source.
use super::escape::escape;
use super::node::{XAttr, XId};
use super::origin::Origin;
use base::TextRange;

/// What an entry of the map is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum MapKind {
    /// A whole element.
    Element,
    /// Its start tag.
    StartTag,
    /// An attribute with name and quotes.
    Attribute,
    /// A part of the value of an attribute.
    Piece,
    /// Character data.
    Text,
    /// A comment.
    Comment,
}

/// A part of the printed document, and the text it came from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapEntry {
    /// Bytes of the printed document.
    pub out: TextRange,
    /// What it is.
    pub kind: MapKind,
    /// The node it belongs to.
    pub node: XId,
    /// The text of the source.
    pub origin: Origin,
    /// What expressions read for a piece: see [`Expansion::read_in`](super::Expansion::read_in).
    pub reads: TextRange,
}

/// Collects entries while a document is printed.
#[derive(Debug, Default)]
pub(super) struct MapBuilder {
    entries: Vec<MapEntry>,
    /// Entries of the elements that are open.
    open: Vec<usize>,
    attribute: usize,
}

impl MapBuilder {
    pub fn finish(self) -> Vec<MapEntry> {
        self.entries
    }

    pub fn add(&mut self, start: usize, end: usize, node: XId, kind: MapKind, origin: Origin) {
        let out = TextRange::new(start as u32, end as u32);
        self.entries.push(MapEntry {
            out,
            kind,
            node,
            origin,
            reads: TextRange::default(),
        });
    }

    /// An element begins; its start tag with it.
    pub fn open(&mut self, start: usize, node: XId, origin: Origin) {
        self.open.push(self.entries.len());
        self.add(start, start, node, MapKind::Element, origin);
        self.add(start, start, node, MapKind::StartTag, origin);
    }

    /// The start tag of the innermost open element ends.
    pub fn start_tag(&mut self, end: usize) {
        let entry = self.open.last().map(|&element| element + 1);
        self.end(entry, end);
    }

    /// The innermost open element ends.
    pub fn close(&mut self, end: usize) {
        let entry = self.open.pop();
        self.end(entry, end);
    }

    /// The attribute that was written last ends.
    pub fn close_attribute(&mut self, end: usize) {
        self.end(Some(self.attribute), end);
    }

    fn end(&mut self, entry: Option<usize>, end: usize) {
        if let Some(entry) = entry.and_then(|entry| self.entries.get_mut(entry)) {
            entry.out.end = end as u32;
        }
    }

    /// Write the value of an attribute that begins at `start`, part by part.
    pub fn attribute(&mut self, start: usize, node: XId, attr: &XAttr, out: &mut String) {
        self.attribute = self.entries.len();
        self.add(start, start, node, MapKind::Attribute, attr.origin);
        // text between expressions: what is written between them in the source
        let (mut at, mut source) = (0, attr.origin.range.start);
        for piece in &attr.pieces {
            let range = TextRange::new(source, piece.source.range.start.max(source));
            self.part(
                node,
                TextRange::new(at, piece.out.start).slice(&attr.value),
                Origin {
                    range,
                    ..attr.origin
                },
                out,
            );
            self.part(node, piece.out.slice(&attr.value), piece.source, out);
            if let Some(last) = self
                .entries
                .last_mut()
                .filter(|_| piece.out.start < piece.out.end)
            {
                last.reads = piece.reads;
            }
            (at, source) = (piece.out.end, piece.source.range.end);
        }
        let range = TextRange::new(source, attr.origin.range.end.max(source));
        self.part(
            node,
            TextRange::new(at, attr.value.len() as u32).slice(&attr.value),
            Origin {
                range,
                ..attr.origin
            },
            out,
        );
    }

    fn part(&mut self, node: XId, text: &str, origin: Origin, out: &mut String) {
        if text.is_empty() {
            return;
        }
        let start = out.len();
        escape(out, text);
        self.add(start, out.len(), node, MapKind::Piece, origin);
    }
}
