//! The list of items: two levels, so that an edit copies a chunk and not the list.

use std::ops::Range;
use std::sync::Arc;

use super::error::Condition;
use super::item::Item;
use super::item_run::ItemRun;

/// Items per chunk when a list is built.
const TARGET: usize = 64;
/// Chunks above this are cut again.
const MAX: usize = 128;

/// A persistent list of items with offsets and lines.
#[derive(Clone, Default)]
pub(super) struct Chunks {
    list: Vec<Chunk>,
}

/// Some items in a row, and sums over them.
#[derive(Clone)]
struct Chunk {
    items: Arc<ItemRun>,
    bytes: u32,
    lines: u32,
    /// Whether an item depends on text behind its end.
    far: bool,
    /// Whether an item has errors that do not depend on the prefixes the root declares.
    has_errors: bool,
    /// Prefixes the root must declare for the rest.
    prefixes: Vec<Box<str>>,
}

/// A position in the list: an item, and the bytes and line ends before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct ChunkPosition {
    pub(super) index: usize,
    pub(super) bytes: u32,
    pub(super) lines: u32,
}

impl Chunk {
    fn new(items: Vec<Arc<Item>>) -> Self {
        let mut chunk = Self {
            items: Arc::new(ItemRun::new(items)),
            bytes: 0,
            lines: 0,
            far: false,
            has_errors: false,
            prefixes: Vec::new(),
        };
        chunk.sum();
        chunk
    }

    fn sum(&mut self) {
        self.bytes = self.items.iter().map(|item| item.len()).sum();
        self.lines = self.items.iter().map(|item| item.lines).sum();
        self.far = self.items.iter().any(|item| item.lookahead() > item.len());
        self.has_errors = false;
        self.prefixes.clear();
        for item in self.items.iter() {
            for stored in item.errors() {
                if stored.condition != Condition::UnlessBound {
                    self.has_errors = true;
                    continue;
                }
                let prefix = stored.error.range.slice(item.text());
                if !self.prefixes.iter().any(|known| **known == *prefix) {
                    self.prefixes.push(prefix.into());
                }
            }
        }
    }
}

impl Chunks {
    pub(super) fn new(items: Vec<Arc<Item>>) -> Self {
        Self { list: cut(items) }
    }

    pub(super) fn count(&self) -> usize {
        self.list.iter().map(|chunk| chunk.items.len()).sum()
    }

    pub(super) fn bytes(&self) -> u32 {
        self.list.iter().map(|chunk| chunk.bytes).sum()
    }

    pub(super) fn lines(&self) -> u32 {
        self.list.iter().map(|chunk| chunk.lines).sum()
    }

    /// The last place where `before` still holds of what lies before it; chunks first, then items.
    /// `before` must be true at the start and must not become true again once it is false.
    fn seek(&self, before: impl Fn(ChunkPosition) -> bool) -> ChunkPosition {
        let mut mark = ChunkPosition::default();
        for chunk in &self.list {
            let next = ChunkPosition {
                index: mark.index + chunk.items.len(),
                bytes: mark.bytes + chunk.bytes,
                lines: mark.lines + chunk.lines,
            };
            if before(next) {
                mark = next;
                continue;
            }
            for item in chunk.items.iter() {
                let next = ChunkPosition {
                    index: mark.index + 1,
                    bytes: mark.bytes + item.len(),
                    lines: mark.lines + item.lines,
                };
                if !before(next) {
                    return mark;
                }
                mark = next;
            }
        }
        mark
    }

    /// The item that holds byte `offset`; behind the last one for offsets beyond.
    pub(super) fn at_offset(&self, offset: u32) -> ChunkPosition {
        self.seek(|mark| mark.bytes <= offset)
    }

    /// The item in which line `line` (counted from the start of the list) begins: the one with the line end
    /// before it, for lines from 1.
    pub(super) fn at_line(&self, line: u32) -> ChunkPosition {
        self.seek(|mark| mark.lines < line)
    }

    /// The item with this number.
    pub(super) fn at_index(&self, index: usize) -> ChunkPosition {
        self.seek(|mark| mark.index <= index)
    }

    pub(super) fn get(&self, index: usize) -> Option<&Arc<Item>> {
        self.iter_from(index).next()
    }

    /// The items from `index` on.
    pub(super) fn iter_from(&self, index: usize) -> impl Iterator<Item = &Arc<Item>> {
        let mut skip = index;
        let mut first = self.list.len();
        for (at, chunk) in self.list.iter().enumerate() {
            if skip < chunk.items.len() {
                first = at;
                break;
            }
            skip -= chunk.items.len();
        }
        let chunks = self.list.get(first..).unwrap_or(&[]);
        chunks
            .iter()
            .flat_map(|chunk| chunk.items.iter())
            .skip(skip)
    }

    /// The chunks with the offsets of their first items.
    pub(super) fn runs(&self) -> impl Iterator<Item = (u32, &ItemRun)> {
        let mut next = 0;
        self.list.iter().map(move |chunk| {
            let start = next;
            next += chunk.bytes;
            (start, &*chunk.items)
        })
    }

    /// The items, with their offsets, of the chunks that may have errors if `bound` says which prefixes the
    /// root declares.
    pub(super) fn iter_with_errors(
        &self,
        bound: impl Fn(&str) -> bool,
    ) -> impl Iterator<Item = (u32, &Arc<Item>)> {
        let mut next = 0;
        let chunks = self.list.iter().filter_map(move |chunk| {
            let start = next;
            next += chunk.bytes;
            let may_have_errors =
                chunk.has_errors || !chunk.prefixes.iter().all(|prefix| bound(prefix));
            may_have_errors.then_some((start, chunk))
        });
        chunks.flat_map(|(mut start, chunk)| {
            chunk.items.iter().map(move |item| {
                let at = start;
                start += item.len();
                (at, item)
            })
        })
    }

    /// The items before `index`, last first.
    pub(super) fn iter_before(&self, index: usize) -> impl Iterator<Item = &Arc<Item>> {
        let mut left = index;
        let mut heads: Vec<&[Arc<Item>]> = Vec::new();
        for chunk in &self.list {
            if left == 0 {
                break;
            }
            let take = left.min(chunk.items.len());
            heads.extend(chunk.items.get(..take));
            left -= take;
        }
        heads.into_iter().rev().flat_map(|items| items.iter().rev())
    }

    /// The first item that depends on the byte at `offset`.
    pub(super) fn first_reaching(&self, offset: u32) -> Option<ChunkPosition> {
        let mut mark = ChunkPosition::default();
        for chunk in &self.list {
            let end = mark.bytes + chunk.bytes;
            if !chunk.far && end <= offset {
                mark.index += chunk.items.len();
                mark.bytes = end;
                continue;
            }
            for item in chunk.items.iter() {
                if mark.bytes > offset {
                    return None;
                }
                if mark.bytes.saturating_add(item.lookahead()) > offset {
                    return Some(mark);
                }
                mark.index += 1;
                mark.bytes += item.len();
            }
        }
        None
    }

    /// How many items two lists share at their starts, and behind these at their ends. Lists of which one came out
    /// of the other by edits share most chunks, and these are not looked into.
    pub(super) fn shared(&self, other: &Self) -> (usize, usize) {
        let same = |(a, b): &(&Chunk, &Chunk)| Arc::ptr_eq(&a.items, &b.items);
        let same_item = |(a, b): &(&Arc<Item>, &Arc<Item>)| Arc::ptr_eq(a, b);
        let count = |(chunk, _): (&Chunk, &Chunk)| chunk.items.len();
        let whole: usize = self
            .list
            .iter()
            .zip(&other.list)
            .take_while(same)
            .map(count)
            .sum();
        let more = self
            .iter_from(whole)
            .zip(other.iter_from(whole))
            .take_while(same_item)
            .count();
        let start = whole + more;
        let (own, others) = (self.count(), other.count());
        let back = self.list.iter().rev().zip(other.list.iter().rev());
        let whole: usize = back.take_while(same).map(count).sum();
        let behind = self
            .iter_before(own - whole)
            .zip(other.iter_before(others - whole));
        let end = whole + behind.take_while(same_item).count();
        (start, end.min(own - start).min(others - start))
    }

    /// Replace the items of `range` by `new`.
    pub(super) fn splice(&mut self, range: Range<usize>, new: Vec<Arc<Item>>) {
        let (first, before) = self.locate(range.start);
        let (mut last, behind) = self.locate(range.end);
        if let Some(chunk) = self.list.get_mut(first).filter(|chunk| {
            first == last && chunk.items.len() - (behind - before) + new.len() <= MAX
        }) {
            Arc::make_mut(&mut chunk.items).splice(before..behind, new);
            chunk.sum();
            return;
        }
        let mut items: Vec<Arc<Item>> = Vec::with_capacity(before + new.len() + MAX);
        if let Some(chunk) = self.list.get(first) {
            items.extend(chunk.items.iter().take(before).cloned());
        }
        items.extend(new);
        if let Some(chunk) = self.list.get(last) {
            items.extend(chunk.items.iter().skip(behind).cloned());
            last += 1;
        }
        self.list.splice(first..last, cut(items));
    }

    /// The chunk of item `index`, and its place in the chunk.
    fn locate(&self, index: usize) -> (usize, usize) {
        let mut left = index;
        for (at, chunk) in self.list.iter().enumerate() {
            if left < chunk.items.len() {
                return (at, left);
            }
            left -= chunk.items.len();
        }
        (self.list.len(), 0)
    }
}

fn cut(items: Vec<Arc<Item>>) -> Vec<Chunk> {
    if items.is_empty() {
        return Vec::new();
    }
    if items.len() <= MAX {
        return vec![Chunk::new(items)];
    }
    items
        .chunks(TARGET)
        .map(|part| Chunk::new(part.to_vec()))
        .collect()
}
