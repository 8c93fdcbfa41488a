//! Lists with parts that other lists share, whose elements have numbers of a type of their own.
use std::fmt;
use std::marker::PhantomData;

use super::id_vec::Id;
use super::shared_vec::{SharedVec, SharedVecIter};

/// A [`SharedVec`] whose elements are looked up by `I`.
pub struct SharedIdVec<I, T> {
    list: SharedVec<T>,
    id: PhantomData<fn(I) -> I>,
}

impl<I: Id, T> SharedIdVec<I, T> {
    /// The element with a number.
    #[inline]
    pub fn get(&self, id: I) -> Option<&T> {
        self.list.get(id.index())
    }

    /// The element with a number, to be changed.
    pub fn get_mut(&mut self, id: I) -> Option<&mut T>
    where
        T: Clone,
    {
        self.list.get_mut(id.index())
    }

    /// Add an element; answers with its number.
    #[inline]
    pub fn push(&mut self, value: T) -> I {
        let id = self.next_id();
        self.list.push(value);
        id
    }

    /// The number that the next element gets.
    #[inline]
    pub fn next_id(&self) -> I {
        I::from_index(self.list.len())
    }

    /// All elements with their numbers, in order.
    pub fn iter_ids(&self) -> impl ExactSizeIterator<Item = (I, &T)> + DoubleEndedIterator + Clone {
        let numbered = self.list.iter().enumerate();
        numbered.map(|(index, value)| (I::from_index(index), value))
    }
}

impl<I, T> SharedIdVec<I, T> {
    /// The elements without their numbers.
    #[inline]
    pub fn list(&self) -> &SharedVec<T> {
        &self.list
    }

    /// The elements without their numbers, to be added to.
    #[inline]
    pub fn list_mut(&mut self) -> &mut SharedVec<T> {
        &mut self.list
    }

    /// How many elements there are.
    #[inline]
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there are no elements.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The elements in order.
    #[inline]
    pub fn iter(&self) -> SharedVecIter<'_, T> {
        self.list.iter()
    }
}

impl<I, T> Default for SharedIdVec<I, T> {
    fn default() -> Self {
        Self {
            list: SharedVec::default(),
            id: PhantomData,
        }
    }
}

impl<I, T: Clone> Clone for SharedIdVec<I, T> {
    fn clone(&self) -> Self {
        Self {
            list: self.list.clone(),
            id: PhantomData,
        }
    }
}

impl<I, T: fmt::Debug> fmt::Debug for SharedIdVec<I, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.list.fmt(f)
    }
}

impl<'a, I, T> IntoIterator for &'a SharedIdVec<I, T> {
    type Item = &'a T;
    type IntoIter = SharedVecIter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
