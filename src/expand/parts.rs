//! The nodes of finished documents, which share what is the same in both: a document after an edit has few nodes of its own.
//!
//! A document is a list of parts, one behind the other. A part of its own holds links as they are. One that was taken over holds
//! whole children of the root element with the links of the document that they were made in: they are moved when they are read,
//! and those that lead out of the part are those of its neighbors.
#![allow(clippy::indexing_slicing)] // ids are made by a document only and never outlive it
use std::ops::Range;
use std::sync::Arc;

use super::node::{Links, XId, XKind, XNode};
use base::{FastSet, Id};

/// Nodes that follow each other.
#[derive(Clone, Debug)]
pub(super) struct Part {
    /// The number of the first node.
    start: usize,
    len: usize,
    /// The number that it had in the document that the nodes were made in.
    made: usize,
    /// Where it stands among these nodes.
    at: usize,
    nodes: Arc<Vec<XNode>>,
    /// The first and the last child of the root element.
    tops: Option<(XId, XId)>,
    /// Whether one of these may be text.
    has_text: bool,
    is_own: bool,
}

impl Part {
    /// Nodes that were made for this document, from a number on.
    pub fn own(start: usize, nodes: Vec<XNode>, tops: Option<(XId, XId)>) -> Self {
        let node = |id: XId| nodes.get(id.index().checked_sub(start)?);
        let first = tops.map(|(first, _)| first);
        let mut all = std::iter::successors(first, |&id| node(id)?.next.some());
        let is_text = |kind: XKind| matches!(kind, XKind::Text | XKind::CData);
        Self {
            has_text: all.any(|id| node(id).is_some_and(|node| is_text(node.kind))),
            start,
            len: nodes.len(),
            made: start,
            at: 0,
            nodes: Arc::new(nodes),
            tops,
            is_own: true,
        }
    }

    /// The same nodes behind others.
    pub fn placed(self, start: usize) -> Self {
        let by = start as i64 - self.start as i64;
        Self {
            start,
            tops: self.tops.map(|(a, b)| (a.moved(by), b.moved(by))),
            is_own: false,
            ..self
        }
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn tops(&self) -> Option<(XId, XId)> {
        self.tops
    }

    #[inline]
    fn node(&self, id: XId) -> &XNode {
        &self.nodes[id.index() - self.start + self.at]
    }

    fn end(&self) -> usize {
        self.start + self.len
    }

    /// The number of a node of the part, from that which it was made with.
    #[inline]
    fn below(&self, made: XId) -> Option<XId> {
        let by = self.start as i64 - self.made as i64;
        made.some().map(|made| made.moved(by))
    }

    /// The same; none of a node outside.
    fn number(&self, made: XId) -> Option<XId> {
        let inside = made.index().checked_sub(self.made)?;
        (inside < self.len).then(|| XId::from_index(self.start + inside))
    }
}

/// All nodes of a finished document.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts {
    list: Vec<Part>,
    /// The root element, parent of what stands at the top of a part that was taken over.
    root: Option<XId>,
}

impl Parts {
    /// Parts beyond which a document is copied as a whole.
    const MOST: usize = 48;

    pub fn new(list: Vec<Part>, root: Option<XId>) -> Self {
        Self { list, root }
    }

    #[inline]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    pub fn len(&self) -> usize {
        self.list.last().map_or(0, Part::end)
    }

    #[inline]
    fn part(&self, id: XId) -> &Part {
        let behind = match self.list.len() {
            1 => 1,
            _ => self.list.partition_point(|part| part.start <= id.index()),
        };
        &self.list[behind - 1]
    }

    #[inline]
    pub fn node(&self, id: XId) -> &XNode {
        self.part(id).node(id)
    }

    /// The parent of a node.
    #[inline]
    pub fn parent(&self, id: XId) -> Option<XId> {
        let part = self.part(id);
        let made = part.node(id).parent;
        if part.is_own {
            return made.some();
        }
        part.number(made).or(self.root)
    }

    /// The first child of a node.
    #[inline]
    pub fn first(&self, id: XId) -> Option<XId> {
        let part = self.part(id);
        part.below(part.node(id).first)
    }

    /// The last child of a node.
    #[inline]
    pub fn last(&self, id: XId) -> Option<XId> {
        let part = self.part(id);
        part.below(part.node(id).last)
    }

    /// The sibling in front of a node.
    #[inline]
    pub fn prev(&self, id: XId) -> Option<XId> {
        let part = self.part(id);
        match part.tops {
            Some((first, _)) if first == id && !part.is_own => {
                let before = self
                    .list
                    .iter()
                    .rev()
                    .filter(|other| other.start < part.start);
                before.filter_map(Part::tops).map(|(_, last)| last).next()
            }
            _ => part.below(part.node(id).prev),
        }
    }

    /// The sibling behind a node.
    #[inline]
    pub fn next(&self, id: XId) -> Option<XId> {
        let part = self.part(id);
        match part.tops {
            Some((_, last)) if last == id && !part.is_own => {
                let behind = self.list.iter().filter(|other| other.start > part.start);
                behind.filter_map(Part::tops).map(|(first, _)| first).next()
            }
            _ => part.below(part.node(id).next),
        }
    }

    /// Whether a child of the root element may be text.
    pub fn has_text(&self) -> bool {
        self.list.iter().any(|part| part.has_text)
    }

    /// The numbers of nodes that are the very same in another document, each range whole children of the root element.
    pub fn same_in(&self, other: &Self) -> Vec<Range<XId>> {
        let overlap = |own: &Part, other: &Part| {
            let is_one = Arc::ptr_eq(&own.nodes, &other.nodes)
                && own.start + other.at == other.start + own.at
                && !(own.is_own && other.is_own);
            let from = own.start.max(other.start);
            let to = own.end().min(other.end());
            (is_one && from < to).then(|| XId::from_index(from)..XId::from_index(to))
        };
        let all = self.list.iter();
        all.flat_map(|own| other.list.iter().filter_map(|other| overlap(own, other)))
            .collect()
    }

    /// Where the links of a node lead.
    pub fn links(&self, id: XId) -> Links {
        Links {
            parent: self.parent(id),
            first: self.first(id),
            last: self.last(id),
            prev: self.prev(id),
            next: self.next(id),
        }
    }

    /// The parts with whole children of the root element, the last of which is `last`.
    pub fn slice(&self, range: Range<XId>, last: XId) -> Vec<Part> {
        if range.is_empty() {
            return Vec::new();
        }
        if self.is_scattered() {
            return vec![self.copy(range, last)];
        }
        let (first, end) = (range.start.index(), range.end.index());
        let overlap = |part: &Part| {
            let (from, to) = (first.max(part.start), end.min(part.end()));
            let (own_first, own_last) = part.tops?;
            let skipped = from.checked_sub(part.start)?;
            (from < to).then(|| Part {
                start: from,
                len: to - from,
                made: part.made + skipped,
                at: part.at + skipped,
                nodes: Arc::clone(&part.nodes),
                tops: Some((
                    if from == first {
                        range.start
                    } else {
                        own_first
                    },
                    if to == end { last } else { own_last },
                )),
                has_text: part.has_text,
                is_own: false,
            })
        };
        self.list.iter().filter_map(overlap).collect()
    }

    /// Whether there are too many parts, or too little of what they keep in memory is part of the document.
    fn is_scattered(&self) -> bool {
        if self.list.len() > Self::MOST {
            return true;
        }
        let mut seen = FastSet::default();
        let kept = self
            .list
            .iter()
            .filter(|part| seen.insert(Arc::as_ptr(&part.nodes)));
        let kept: usize = kept.map(|part| part.nodes.len()).sum();
        kept > 2 * self.len() + 1000
    }

    /// Whole children of the root element as nodes of their own.
    fn copy(&self, range: Range<XId>, last: XId) -> Part {
        let (first, end) = (range.start.index(), range.end.index());
        let nodes = (first..end).map(XId::from_index).map(|id| {
            let mut node = self.node(id).clone();
            node.set_links(self.links(id));
            node
        });
        Part::own(first, nodes.collect(), Some((range.start, last)))
    }
}
