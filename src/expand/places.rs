//! Where each element of a growing list stands, so that none is added twice.
use std::hash::Hash;
use std::sync::Arc;

use base::FastMap;

/// The place of each element of a list. The list of the next expansion has most of its elements at the same places: it shares
/// the table, and has one of its own for those that it adds. What the shared one says of elements that the list has no more is
/// not true, so a place counts only where the list has the element there.
#[derive(Clone, Debug)]
pub(super) struct Places<K> {
    shared: Arc<FastMap<K, u32>>,
    own: FastMap<K, u32>,
}

impl<K> Default for Places<K> {
    fn default() -> Self {
        Self {
            shared: Arc::default(),
            own: FastMap::default(),
        }
    }
}

impl<K: Clone + Eq + Hash> Places<K> {
    /// With more elements of its own than this part of the shared ones, a table is built again.
    const MOST_OWN: usize = 16;
    /// Up to so many, it has few in any case.
    const FEW: usize = 256;

    /// The place of an element, at which the list has to have it.
    pub fn find(&self, key: &K, has: impl Fn(usize) -> bool) -> Option<usize> {
        let found = [self.own.get(key), self.shared.get(key)];
        let mut places = found.into_iter().flatten().map(|&place| place as usize);
        places.find(|&place| has(place))
    }

    /// Note an element that is added to the list.
    pub fn add(&mut self, key: K, place: usize) {
        // lists are shorter than the limits of an expansion
        self.own
            .insert(key, u32::try_from(place).unwrap_or(u32::MAX));
    }

    /// The list is complete: what it has of its own is shared from now on, unless it is little.
    pub fn finish(&mut self, all: impl ExactSizeIterator<Item = K>) {
        if self.own.len() <= Self::FEW.max(self.shared.len() / Self::MOST_OWN) {
            self.own.shrink_to_fit();
            return;
        }
        if self.shared.is_empty() {
            self.own.shrink_to_fit();
            self.shared = Arc::new(std::mem::take(&mut self.own));
        } else {
            self.own = FastMap::default();
            self.shared = Arc::new(all.zip(0..).collect());
        }
    }
}
