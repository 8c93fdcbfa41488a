//! A list whose elements the model of the next expansion may share.
use std::ops::Range;
use std::sync::Arc;

use base::{SharedVec, SharedVecIter};

/// Elements in document order. They are shared: what an expansion took over from the one before is not read off it again.
#[derive(Debug)]
pub struct SharedList<T>(SharedVec<Arc<T>>);

impl<T> SharedList<T> {
    /// Without elements.
    pub const fn new() -> Self {
        Self(SharedVec::new())
    }

    /// The elements in order.
    #[inline]
    pub fn iter(&self) -> SharedIter<'_, T> {
        SharedIter(self.0.iter())
    }

    /// The element at an index.
    #[inline]
    pub fn get(&self, index: usize) -> Option<&T> {
        self.0.get(index).map(Arc::as_ref)
    }

    /// How many there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether two lists have equally many elements, and each is the very one of the other list or `alike`.
    pub(super) fn are_alike(one: &Self, other: &Self, alike: impl Fn(&T, &T) -> bool) -> bool {
        SharedVec::are_alike(&one.0, &other.0, |one, other| {
            Arc::ptr_eq(one, other) || alike(one, other)
        })
    }

    pub(super) fn push(&mut self, value: Arc<T>) {
        self.0.push(value);
    }

    /// Add the elements of another list with keys in a range; keys rise.
    pub(super) fn add_range<K: Ord>(
        &mut self,
        other: &Self,
        range: &Range<K>,
        key: impl Fn(&T) -> K,
    ) {
        let start = other.0.partition_point(|one| key(one) < range.start);
        let end = other.0.partition_point(|one| key(one) < range.end);
        self.0.extend_from(&other.0, start..end);
    }

    /// The list is complete: others may share it.
    pub(super) fn finish(&mut self) {
        self.0.finish();
    }

    /// The element at an index, to be shared.
    pub(super) fn shared(&self, index: usize) -> Option<&Arc<T>> {
        self.0.get(index)
    }

    /// The index of the first element with a key that is not smaller; keys rise.
    pub fn position<K: Ord>(&self, least: &K, key: impl Fn(&T) -> K) -> usize {
        self.0.partition_point(|one| key(one) < *least)
    }
}

impl<T> Default for SharedList<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> Clone for SharedList<T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<'a, T> IntoIterator for &'a SharedList<T> {
    type Item = &'a T;
    type IntoIter = SharedIter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The elements of a [`SharedList`] in order.
#[derive(Debug)]
pub struct SharedIter<'a, T>(SharedVecIter<'a, Arc<T>>);

impl<T> Clone for SharedIter<'_, T> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<'a, T> Iterator for SharedIter<'a, T> {
    type Item = &'a T;

    #[inline]
    fn next(&mut self) -> Option<&'a T> {
        self.0.next().map(Arc::as_ref)
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }

    fn nth(&mut self, skipped: usize) -> Option<&'a T> {
        self.0.nth(skipped).map(Arc::as_ref)
    }
}

impl<T> DoubleEndedIterator for SharedIter<'_, T> {
    #[inline]
    fn next_back(&mut self) -> Option<Self::Item> {
        self.0.next_back().map(Arc::as_ref)
    }
}

impl<T> ExactSizeIterator for SharedIter<'_, T> {}
