//! Lists of which parts are shared with other lists, so that a copy with a few changes costs little.
#![allow(clippy::indexing_slicing)] // parts lie within their vectors
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use super::FastSet;

/// A list made of parts of vectors, which other lists may share, and of elements of its own behind them.
pub struct SharedVec<T> {
    parts: Vec<Part<T>>,
    /// How many elements the parts have.
    shared: usize,
    own: Vec<T>,
}

/// Elements that follow each other in a vector.
struct Part<T> {
    /// The index of the first one in the list, and in the vector.
    start: usize,
    at: usize,
    len: usize,
    items: Arc<Vec<T>>,
}

impl<T> Clone for Part<T> {
    fn clone(&self) -> Self {
        Self {
            items: Arc::clone(&self.items),
            ..*self
        }
    }
}

impl<T> Part<T> {
    fn end(&self) -> usize {
        self.start + self.len
    }

    fn slice(&self) -> &[T] {
        &self.items[self.at..self.at + self.len]
    }
}

impl<T> SharedVec<T> {
    /// Parts beyond which their elements are copied.
    const MOST_PARTS: usize = 48;
    /// A part of fewer elements is copied.
    const FEW: usize = 16;

    /// Without elements.
    pub const fn new() -> Self {
        Self {
            parts: Vec::new(),
            shared: 0,
            own: Vec::new(),
        }
    }

    /// How many elements there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.shared + self.own.len()
    }

    /// Whether there are none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The element at an index.
    #[inline]
    pub fn get(&self, index: usize) -> Option<&T> {
        match index.checked_sub(self.shared) {
            Some(own) => self.own.get(own),
            None => {
                let part = &self.parts[self.part(index)];
                Some(&part.items[index - part.start + part.at])
            }
        }
    }

    /// The part with an index that is shared.
    #[inline]
    fn part(&self, index: usize) -> usize {
        match self.parts.len() {
            1 => 0,
            _ => self.parts.partition_point(|part| part.end() <= index),
        }
    }

    /// The last element.
    pub fn last(&self) -> Option<&T> {
        self.get(self.len().checked_sub(1)?)
    }

    /// Add an element.
    #[inline]
    pub fn push(&mut self, value: T) {
        self.own.push(value);
    }

    /// Make room for so many more elements.
    pub fn reserve(&mut self, more: usize) {
        self.own.reserve(more);
    }

    /// Forget all elements.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// Make the elements of its own a part that other lists can share.
    pub fn seal(&mut self) {
        let mut items = std::mem::take(&mut self.own);
        if items.is_empty() {
            return;
        }
        items.shrink_to_fit();
        self.parts.push(Part {
            start: self.shared,
            at: 0,
            len: items.len(),
            items: Arc::new(items),
        });
        self.shared = self.parts.last().map_or(0, Part::end);
    }

    /// The elements in order.
    #[inline]
    pub fn iter(&self) -> SharedVecIter<'_, T> {
        self.range(0..self.len())
    }

    /// The elements of a range in order, as far as there are some.
    pub fn range(&self, range: Range<usize>) -> SharedVecIter<'_, T> {
        SharedVecIter {
            list: self,
            front: [].iter(),
            next: range.start.min(self.len()),
            end: range.end.min(self.len()),
        }
    }

    /// The index of the first element that is not `before`; those that are stand in front of the others.
    pub fn partition_point(&self, before: impl Fn(&T) -> bool) -> usize {
        let (mut start, mut end) = (0, self.len());
        while start < end {
            let middle = start + (end - start) / 2;
            if self.get(middle).is_some_and(&before) {
                start = middle + 1;
            } else {
                end = middle;
            }
        }
        start
    }

    /// The elements from an index on that follow each other in memory.
    fn slice_from(&self, index: usize) -> &[T] {
        match index.checked_sub(self.shared) {
            Some(own) => self.own.get(own..).unwrap_or_default(),
            None => {
                let part = &self.parts[self.part(index)];
                &part.slice()[index - part.start..]
            }
        }
    }

    /// Whether two lists have equally many elements, and each is the very one of the other list or `alike`.
    pub fn are_alike(one: &Self, other: &Self, alike: impl Fn(&T, &T) -> bool) -> bool {
        if one.len() != other.len() {
            return false;
        }
        let mut at = 0;
        while at < one.len() {
            let (a, b) = (one.slice_from(at), other.slice_from(at));
            let len = a.len().min(b.len());
            let (a, b) = (&a[..len], &b[..len]);
            if !(std::ptr::eq(a, b) || a.iter().zip(b).all(|(a, b)| alike(a, b))) {
                return false;
            }
            at += len;
        }
        true
    }
}

impl<T: Clone> SharedVec<T> {
    /// Add a part of another list. What that has sealed is shared.
    pub fn extend_from(&mut self, other: &Self, range: Range<usize>) {
        let range = range.start.min(other.len())..range.end.min(other.len());
        let is_scattered = self.parts.len() + other.parts.len() > Self::MOST_PARTS;
        let mut at = range.start;
        while at < range.end {
            let slice = other.slice_from(at);
            let slice = &slice[..slice.len().min(range.end - at)];
            if is_scattered || slice.len() < Self::FEW || at >= other.shared {
                self.own.extend_from_slice(slice);
            } else {
                self.seal();
                let part = &other.parts[other.part(at)];
                self.parts.push(Part {
                    start: self.shared,
                    at: part.at + at - part.start,
                    len: slice.len(),
                    items: Arc::clone(&part.items),
                });
                self.shared += slice.len();
            }
            at += slice.len();
        }
    }

    /// The list is complete: what it has of its own may be shared. Where little of what its parts keep in memory belongs to it,
    /// they are copied.
    pub fn finish(&mut self) {
        self.seal();
        let mut seen = FastSet::default();
        let kept = self.parts.iter();
        let kept = kept.filter(|part| seen.insert(Arc::as_ptr(&part.items)));
        let kept: usize = kept.map(|part| part.items.len()).sum();
        if kept > 2 * self.len() + 1000 || self.parts.len() > Self::MOST_PARTS {
            let all: Vec<T> = self.iter().cloned().collect();
            *self = Self::from(all);
        }
        self.seal();
    }

    /// An element, to be changed. One that is shared becomes one of this list alone.
    pub fn get_mut(&mut self, index: usize) -> Option<&mut T> {
        if let Some(own) = index.checked_sub(self.shared) {
            return self.own.get_mut(own);
        }
        let place = self.part(index);
        if Arc::get_mut(&mut self.parts[place].items).is_none() {
            self.isolate(place, index);
        }
        let place = self.part(index);
        let part = &mut self.parts[place];
        let inside = index - part.start + part.at;
        Arc::get_mut(&mut part.items)?.get_mut(inside)
    }

    /// Give an element of a part a vector of its own.
    fn isolate(&mut self, place: usize, index: usize) {
        let part = self.parts[place].clone();
        let before = index - part.start;
        let one = Part {
            start: index,
            at: 0,
            len: 1,
            items: Arc::new(vec![part.slice()[before].clone()]),
        };
        let first = Part {
            len: before,
            ..part.clone()
        };
        let rest = Part {
            start: index + 1,
            at: part.at + before + 1,
            len: part.len - before - 1,
            ..part
        };
        let split = [first, one, rest].into_iter().filter(|part| part.len > 0);
        self.parts.splice(place..=place, split);
    }
}

impl<T> Default for SharedVec<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T> From<Vec<T>> for SharedVec<T> {
    fn from(own: Vec<T>) -> Self {
        Self { own, ..Self::new() }
    }
}

impl<T> FromIterator<T> for SharedVec<T> {
    fn from_iter<S: IntoIterator<Item = T>>(values: S) -> Self {
        Self::from(Vec::from_iter(values))
    }
}

impl<T: Clone> Clone for SharedVec<T> {
    fn clone(&self) -> Self {
        Self {
            parts: self.parts.clone(),
            shared: self.shared,
            own: self.own.clone(),
        }
    }
}

impl<T: fmt::Debug> fmt::Debug for SharedVec<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

impl<'a, T> IntoIterator for &'a SharedVec<T> {
    type Item = &'a T;
    type IntoIter = SharedVecIter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Elements of a [`SharedVec`] in order.
pub struct SharedVecIter<'a, T> {
    list: &'a SharedVec<T>,
    front: std::slice::Iter<'a, T>,
    /// What follows them.
    next: usize,
    end: usize,
}

impl<T> Clone for SharedVecIter<'_, T> {
    fn clone(&self) -> Self {
        Self {
            front: self.front.clone(),
            ..*self
        }
    }
}

impl<T> fmt::Debug for SharedVecIter<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SharedVecIter({} left)", self.len())
    }
}

impl<'a, T> SharedVecIter<'a, T> {
    /// Go on to the elements that follow those in front, and take the first.
    #[cold]
    fn next_slice(&mut self) -> Option<&'a T> {
        if self.next >= self.end {
            return None;
        }
        let slice = self.list.slice_from(self.next);
        let slice = &slice[..slice.len().min(self.end - self.next)];
        self.next += slice.len();
        self.front = slice.iter();
        self.front.next()
    }
}

impl<'a, T> Iterator for SharedVecIter<'a, T> {
    type Item = &'a T;

    #[inline]
    fn next(&mut self) -> Option<&'a T> {
        match self.front.next() {
            None => self.next_slice(),
            value => value,
        }
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let len = self.front.len() + self.end.saturating_sub(self.next);
        (len, Some(len))
    }

    fn nth(&mut self, skipped: usize) -> Option<&'a T> {
        let front = self.front.len();
        if skipped >= front {
            self.front = [].iter();
            self.next = (self.next + skipped - front).min(self.end);
            return self.next();
        }
        self.front.nth(skipped)
    }
}

impl<'a, T> DoubleEndedIterator for SharedVecIter<'a, T> {
    fn next_back(&mut self) -> Option<&'a T> {
        if self.next < self.end {
            self.end -= 1;
            return self.list.get(self.end);
        }
        self.front.next_back()
    }
}

impl<T> ExactSizeIterator for SharedVecIter<'_, T> {}

#[cfg(test)]
mod tests {
    use super::SharedVec;

    /// Numbers that look like chance.
    fn next(state: &mut u64, below: usize) -> usize {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) as usize % below.max(1)
    }

    fn check_same(list: &SharedVec<usize>, expected: &[usize]) {
        assert_eq!(list.len(), expected.len());
        assert_eq!(list.iter().copied().collect::<Vec<_>>(), expected);
        let backwards: Vec<usize> = list.iter().rev().copied().collect();
        assert!(backwards.iter().eq(expected.iter().rev()));
        assert_eq!(list.last(), expected.last());
        for at in 0..=expected.len() {
            assert_eq!(list.get(at), expected.get(at));
            let rest: Vec<usize> = list.iter().skip(at).copied().collect();
            assert_eq!(rest, expected.get(at..).unwrap_or_default());
        }
    }

    #[test]
    fn a_list_says_what_a_vector_says() {
        let mut state = 7;
        let mut older: (SharedVec<usize>, Vec<usize>) = Default::default();
        for round in 0..300 {
            let (mut list, mut vector) = (SharedVec::new(), Vec::new());
            for step in 0..next(&mut state, 6) {
                let (from, count) = (next(&mut state, 90), next(&mut state, 70));
                let end = (from + count).min(older.1.len());
                list.extend_from(&older.0, from..from + count);
                vector.extend_from_slice(older.1.get(from..end).unwrap_or_default());
                for number in 0..next(&mut state, 30) {
                    list.push(round * 1000 + step * 100 + number);
                    vector.push(round * 1000 + step * 100 + number);
                }
                let changed = next(&mut state, vector.len() + 1);
                if let Some(value) = list.get_mut(changed) {
                    *value = round;
                    vector[changed] = round;
                }
            }
            check_same(&older.0, &older.1);
            check_same(&list, &vector);
            assert!(SharedVec::are_alike(
                &list,
                &vector.iter().copied().collect(),
                |a, b| a == b
            ));
            list.finish();
            check_same(&list, &vector);
            older = (list, vector);
        }
    }

    #[test]
    fn what_is_shared_is_not_compared() {
        let mut one: SharedVec<usize> = (0..100).collect();
        one.finish();
        let mut other = SharedVec::new();
        other.extend_from(&one, 0..100);
        assert!(SharedVec::are_alike(&one, &other, |_, _| false));
        if let Some(value) = other.get_mut(50) {
            *value = 0;
        }
        assert!(!SharedVec::are_alike(&one, &other, |a, b| a == b));
        assert_eq!((one.get(50), other.get(50)), (Some(&50), Some(&0)));
    }
}
