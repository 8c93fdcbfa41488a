//! Where each element of a growing list stands, so that none is added twice.
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

/// The places of the elements of a list, by their hash. The list of the next expansion has most of its elements at the same places:
/// it shares the table, and has one of its own for those that it adds. What the shared one says of elements that the list has no more
/// is not true, so a place counts only where the list has the element there.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    shared: Arc<HashTable<u32>>,
    own: HashTable<u32>,
}

impl Places {
    /// With more elements of its own than this part of the shared ones, a table is built again.
    const MOST_OWN: usize = 16;
    /// Up to so many, it has few in any case.
    const FEW: usize = 256;

    /// The place of an element with a hash, where the list has it.
    pub fn find(&self, hash: u64, has: impl Fn(usize) -> bool) -> Option<usize> {
        let is_there = |&place: &u32| has(place as usize);
        let own = self.own.find(hash, is_there);
        let found = own.or_else(|| self.shared.find(hash, is_there));
        found.map(|&place| place as usize)
    }

    /// Note an element that is added to a list; with the hashes of those that it has.
    pub fn add(&mut self, hash: u64, place: usize, hash_of: impl Fn(usize) -> u64) {
        // lists are shorter than the limits of an expansion
        let place = u32::try_from(place).unwrap_or(u32::MAX);
        let hash_of = |&place: &u32| hash_of(place as usize);
        self.own.insert_unique(hash, place, hash_of);
    }

    /// The list is complete and has so many elements: what it has of its own is shared from now on, unless it is little.
    pub fn finish(&mut self, len: usize, hash_of: impl Fn(usize) -> u64) {
        let hash_of = |&place: &u32| hash_of(place as usize);
        self.own.shrink_to_fit(hash_of);
        if self.own.len() <= Self::FEW.max(self.shared.len() / Self::MOST_OWN) {
            return;
        }
        if self.shared.is_empty() {
            self.shared = Arc::new(std::mem::take(&mut self.own));
        } else {
            let mut all = HashTable::with_capacity(len);
            for place in 0..u32::try_from(len).unwrap_or(u32::MAX) {
                all.insert_unique(hash_of(&place), place, hash_of);
            }
            (self.shared, self.own) = (Arc::new(all), HashTable::new());
        }
    }
}

/// The hash of what tells an element from others.
pub(super) fn hash_of(key: impl Hash) -> u64 {
    let mut hasher = FxHasher::default();
    key.hash(&mut hasher);
    hasher.finish()
}
