//! Where each element of a growing list stands, so that none is added twice.
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use hashbrown::HashTable;
use rustc_hash::FxHasher;

/// The places of the elements of a list, by their hash. The list of the next expansion has most of its elements at the same places:
/// it shares the table, and has one of its own for those that it adds. What the tables say of elements that the list has no more
/// is not true, so a place counts only where the list has the element there.
#[derive(Clone, Debug, Default)]
pub(super) struct Places {
    shared: Arc<HashTable<Place>>,
    own: HashTable<Place>,
}

/// A place, with the hash of the element: the list may not have it yet when a table grows.
#[derive(Clone, Copy, Debug)]
struct Place {
    hash: ShortHash,
    place: u32,
}

/// The hash of what tells an element from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ShortHash(u32);

impl ShortHash {
    /// The hash of a key.
    pub fn of(key: impl Hash) -> Self {
        let mut hasher = FxHasher::default();
        key.hash(&mut hasher);
        Self((hasher.finish() >> 32) as u32)
    }

    /// The same for tables, which take the bits at both ends.
    fn wide(self) -> u64 {
        u64::from(self.0) << 32 | u64::from(self.0)
    }
}

impl Places {
    /// With more elements of its own than this part of the shared ones, a table is built again.
    const MOST_OWN: usize = 16;
    /// Up to so many, it has few in any case.
    const FEW: usize = 256;

    /// The place of an element with a hash, where the list has it.
    pub fn find(&self, hash: ShortHash, has: impl Fn(usize) -> bool) -> Option<usize> {
        let is_it = |one: &Place| one.hash == hash && has(one.place as usize);
        let own = self.own.find(hash.wide(), is_it);
        let found = own.or_else(|| self.shared.find(hash.wide(), is_it));
        found.map(|one| one.place as usize)
    }

    /// Note an element that is added to a list.
    pub fn add(&mut self, hash: ShortHash, place: usize) {
        insert(&mut self.own, hash, place);
    }

    /// The list is complete, and these are the hashes of all: what it has of its own is shared from now on, unless it is little.
    pub fn finish(&mut self, all: impl ExactSizeIterator<Item = ShortHash>) {
        if self.own.len() <= Self::FEW.max(self.shared.len() / Self::MOST_OWN) {
            self.own.shrink_to_fit(|one| one.hash.wide());
            return;
        }
        let mut table = HashTable::with_capacity(all.len());
        for (place, hash) in all.enumerate() {
            insert(&mut table, hash, place);
        }
        (self.shared, self.own) = (Arc::new(table), HashTable::new());
    }
}

fn insert(table: &mut HashTable<Place>, hash: ShortHash, place: usize) {
    // lists are shorter than the limits of an expansion
    let place = u32::try_from(place).unwrap_or(u32::MAX);
    table.insert_unique(hash.wide(), Place { hash, place }, |one| one.hash.wide());
}

#[cfg(test)]
mod tests {
    use super::{Places, ShortHash};

    #[test]
    fn what_a_list_gets_back_later_is_known_whatever_was_added_before() {
        let mut list: Vec<usize> = (0..1000).collect();
        let mut places = Places::default();
        for &one in &list {
            places.add(ShortHash::of(one), one);
        }
        places.finish(list.iter().map(ShortHash::of));
        // the list of the next expansion: a part is other, and what stands behind it comes last
        let rest = list.split_off(600);
        list.truncate(500);
        for one in 5000..5100 {
            assert_eq!(find(&places, &list, one), None);
            places.add(ShortHash::of(one), list.len());
            list.push(one);
        }
        list.extend(rest);
        for (place, one) in list.iter().enumerate() {
            assert_eq!(find(&places, &list, *one), Some(place));
        }
        assert_eq!(find(&places, &list, 550), None);
    }

    fn find(places: &Places, list: &[usize], one: usize) -> Option<usize> {
        places.find(ShortHash::of(one), |place| list.get(place) == Some(&one))
    }
}
