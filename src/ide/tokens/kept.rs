//! The pieces of parts of a file that an edit does not change are not looked for again.
use std::hash::BuildHasher;
use std::sync::Arc;

use super::names::{KnownName, KnownNames};
use super::{Collector, HighlightToken};
use crate::context::Cx;
use base::TextRange;
use xml::Item;

/// What is made of the pieces of each part of a file, and what they rest on.
pub struct KeptTokens<T> {
    /// In the order of the file, as it was the last time.
    parts: Vec<KeptPart<T>>,
    /// A hash of the names of all properties.
    properties: u64,
}

impl<T> Default for KeptTokens<T> {
    fn default() -> Self {
        Self {
            parts: Vec::new(),
            properties: 0,
        }
    }
}

struct KeptPart<T> {
    item: Arc<Item>,
    made: T,
    /// The names in it, by their places from its start.
    names: Box<[KnownName]>,
    rests_on_properties: bool,
    rests_on_robot: bool,
}

impl<T: PartialEq> KeptTokens<T> {
    /// What is made of the pieces of all parts of a file, in order; `make` takes the text of a part and its pieces, whose
    /// ranges count from its start. Parts in front of what was edited and after it, whose names are the same, are taken
    /// over, unless their pieces rest on what the robot is.
    pub fn renew(
        &mut self,
        cx: &Cx<'_>,
        make: impl Fn(&str, &[HighlightToken]) -> T,
    ) -> impl Iterator<Item = &T> {
        let names = KnownNames::of(cx, TextRange::new(0, u32::MAX));
        let properties = hash_of(&names);
        let has_same_properties = properties == self.properties;
        let parts: Vec<(u32, &Arc<Item>)> = cx.source.document.parts().collect();
        let before = aligned(std::mem::take(&mut self.parts), &parts);
        let mut rest = names.all();
        let mut all = Vec::with_capacity(parts.len());
        for (&(base, item), before) in parts.iter().zip(before) {
            let end = base + item.len();
            let own = rest
                .iter()
                .take_while(|(place, _)| place.start < end)
                .count();
            let (own, others) = rest.split_at(own);
            rest = others;
            let kept = before.filter(|kept| {
                !kept.rests_on_robot
                    && (!kept.rests_on_properties || has_same_properties)
                    && same_names(&kept.names, own, base)
            });
            all.push(kept.unwrap_or_else(|| find(cx, &names, (base, item), own, &make)));
        }
        debug_assert!(all.iter().zip(&parts).all(|(kept, &part)| {
            let fresh = find(cx, &names, part, &[], &make);
            kept.made == fresh.made
        }));
        (self.parts, self.properties) = (all, properties);
        self.parts.iter().map(|part| &part.made)
    }
}

/// The parts from before, at the places where they are now: those in front of what was edited, and those after it.
fn aligned<T>(before: Vec<KeptPart<T>>, parts: &[(u32, &Arc<Item>)]) -> Vec<Option<KeptPart<T>>> {
    let is_same =
        |(kept, (_, item)): &(&KeptPart<T>, &(u32, &Arc<Item>))| Arc::ptr_eq(&kept.item, item);
    let front = before.iter().zip(parts).take_while(is_same).count();
    let room = before.len().min(parts.len()) - front;
    let from_end = before.iter().rev().zip(parts.iter().rev());
    let end = match front {
        // the first part defines entities
        0 => 0,
        _ => from_end.take(room).take_while(is_same).count(),
    };
    let edited = front..before.len() - end;
    let mut aligned: Vec<_> = before.into_iter().map(Some).collect();
    let others = std::iter::repeat_with(|| None).take(parts.len() - front - end);
    aligned.splice(edited, others);
    aligned
}

/// The pieces of a part that begins at `base`.
fn find<'a, T>(
    cx: &Cx<'a>,
    names: &KnownNames<'a>,
    (base, item): (u32, &Arc<Item>),
    own: &[KnownName],
    make: impl Fn(&str, &[HighlightToken]) -> T,
) -> KeptPart<T> {
    let mut collector = Collector::new(cx, names);
    let mut tokens = collector.part(base, item);
    for token in &mut tokens {
        token.range = from_start(token.range, base);
    }
    KeptPart {
        item: item.clone(),
        made: make(item.text(), &tokens),
        names: own
            .iter()
            .map(|(place, kind)| (from_start(*place, base), *kind))
            .collect(),
        rests_on_properties: collector.rests_on_properties.get(),
        rests_on_robot: collector.rests_on_robot.get(),
    }
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
