//! The pieces of parts of a file that an edit does not change are not looked for again.
use std::hash::BuildHasher;
use std::sync::Arc;

use super::names::{KnownName, KnownNames};
use super::{Collector, HighlightToken};
use crate::context::Cx;
use base::{FastMap, TextRange};
use expand::SymbolKind;
use xml::Item;

/// The pieces of a part of a file.
#[derive(Clone)]
pub struct PartTokens {
    /// The part; what its document has in front of it moves it.
    pub item: Arc<Item>,
    /// Its pieces in order; their ranges count from its start.
    pub tokens: Arc<[HighlightToken]>,
}

/// The pieces of all parts of a file, and what they rest on.
#[derive(Default)]
pub struct KeptTokens {
    /// By the address of the part, which is held so that no other one gets it.
    parts: FastMap<usize, KeptPart>,
    /// The first part, which defines entities.
    header: Option<Arc<Item>>,
    /// A hash of the names of all properties.
    properties: u64,
}

struct KeptPart {
    found: PartTokens,
    /// The names in it, by their places from its start.
    names: Vec<(TextRange, SymbolKind)>,
    rests_on_properties: bool,
}

impl KeptTokens {
    /// The pieces of all parts of a file in order. Parts that were there the last time, and whose names are the same, have the same
    /// pieces, unless they rest on what the robot is.
    pub fn renew(&mut self, cx: &Cx<'_>) -> Vec<PartTokens> {
        let names = KnownNames::of(cx, TextRange::new(0, u32::MAX));
        let properties = hash_of(&names);
        let document = &cx.source.document;
        let header = document.parts().next().map(|(_, item)| item.clone());
        let is_same = |a: &Arc<Item>| header.as_ref().is_some_and(|b| Arc::ptr_eq(a, b));
        if !self.header.as_ref().is_some_and(is_same) {
            self.parts.clear();
        }
        let mut before = std::mem::take(&mut self.parts);
        let mut all = Vec::with_capacity(document.item_count() + 2);
        for (base, item) in document.parts() {
            let address = Arc::as_ptr(item).addr();
            let own = names.within(TextRange::new(base, base + item.len()));
            let kept = before.remove(&address).filter(|kept| {
                (!kept.rests_on_properties || properties == self.properties)
                    && same_names(&kept.names, own, base)
            });
            let (found, part) = match kept {
                Some(kept) => (kept.found.clone(), Some(kept)),
                None => find(cx, &names, base, item, own),
            };
            self.parts.extend(part.map(|part| (address, part)));
            all.push(found);
        }
        (self.header, self.properties) = (header, properties);
        debug_assert_eq!(joined(&all), super::tokens(cx, TextRange::new(0, u32::MAX)));
        all
    }
}

/// The pieces of all parts, with their places in the file.
fn joined(parts: &[PartTokens]) -> Vec<HighlightToken> {
    let mut start = 0;
    let mut all = Vec::new();
    for PartTokens { item, tokens } in parts {
        let shifted = |token: &HighlightToken| HighlightToken {
            range: token.range.shift(start),
            ..*token
        };
        all.extend(tokens.iter().map(shifted));
        start += item.len();
    }
    all
}

/// The pieces of a part, and what is kept of them.
fn find<'a>(
    cx: &Cx<'a>,
    names: &KnownNames<'a>,
    base: u32,
    item: &Arc<Item>,
    own: &[KnownName],
) -> (PartTokens, Option<KeptPart>) {
    let mut collector = Collector::new(cx, names);
    let mut tokens = collector.part(base, item);
    for token in &mut tokens {
        token.range = from_start(token.range, base);
    }
    let found = PartTokens {
        item: item.clone(),
        tokens: tokens.into(),
    };
    let kept = KeptPart {
        found: found.clone(),
        names: own
            .iter()
            .map(|(place, kind)| (from_start(*place, base), *kind))
            .collect(),
        rests_on_properties: collector.rests_on_properties.get(),
    };
    (found, (!collector.rests_on_robot.get()).then_some(kept))
}

fn same_names(kept: &[KnownName], own: &[KnownName], base: u32) -> bool {
    let mut pairs = kept.iter().zip(own);
    kept.len() == own.len()
        && pairs.all(|(kept, (place, kind))| *kept == (from_start(*place, base), *kind))
}

fn from_start(range: TextRange, base: u32) -> TextRange {
    TextRange::new(range.start - base, range.end - base)
}

/// A hash of the names of all properties, whatever their order is.
fn hash_of(names: &KnownNames<'_>) -> u64 {
    let all = names.properties();
    let hashes = all.iter().map(|name| all.hasher().hash_one(name));
    hashes.fold(0, u64::wrapping_add)
}
