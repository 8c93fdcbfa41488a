//! A list whose elements the model of the next expansion may share.
use std::sync::Arc;

/// Elements in document order. They are shared: what an expansion took over from the one before is not read off it again.
#[derive(Debug)]
pub struct SharedList<T>(Vec<Arc<T>>);

impl<T> SharedList<T> {
    /// Without elements.
    pub const fn new() -> Self {
        Self(Vec::new())
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
        let mut pairs = one.0.iter().zip(&other.0);
        one.len() == other.len()
            && pairs.all(|(one, other)| Arc::ptr_eq(one, other) || alike(one, other))
    }

    pub(super) fn push(&mut self, value: Arc<T>) {
        self.0.push(value);
    }

    /// The element at an index, to be shared.
    pub(super) fn shared(&self, index: usize) -> Option<&Arc<T>> {
        self.0.get(index)
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

    fn into_iter(self) -> SharedIter<'a, T> {
        self.iter()
    }
}

/// The elements of a [`SharedList`] in order.
#[derive(Debug)]
pub struct SharedIter<'a, T>(std::slice::Iter<'a, Arc<T>>);

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
}

impl<T> DoubleEndedIterator for SharedIter<'_, T> {
    #[inline]
    fn next_back(&mut self) -> Option<Self::Item> {
        self.0.next_back().map(Arc::as_ref)
    }
}

impl<T> ExactSizeIterator for SharedIter<'_, T> {}
