//! Lists whose elements have numbers of a type of their own, so that a number of one list is not taken for one of another.

use std::fmt;
use std::marker::PhantomData;

/// The number of an element in an [`IdVec`]; implemented by [`ids!`](crate::ids).
pub trait Id: Copy {
    /// The number of the element at an index.
    fn from_index(index: usize) -> Self;

    /// The index of the element, for tables beside its list.
    fn index(self) -> usize;
}

/// Makes types of the form `struct Name(u32)` numbers of elements: implements [`Id`] for each of them.
///
/// An index that does not fit is the greatest number, which no list has an element for.
#[macro_export]
macro_rules! ids {
    ($($name:ident),+) => {
        $(impl $crate::Id for $name {
            #[inline]
            fn from_index(index: usize) -> Self {
                Self(u32::try_from(index).unwrap_or(u32::MAX))
            }

            #[inline]
            fn index(self) -> usize {
                self.0 as usize
            }
        })+
    };
}

/// A list of `T` whose elements are looked up by `I`.
#[derive(Clone)]
pub struct IdVec<I, T> {
    list: Vec<T>,
    id: PhantomData<fn(I) -> I>,
}

impl<I: Id, T> IdVec<I, T> {
    /// The element with a number.
    #[inline]
    pub fn get(&self, id: I) -> Option<&T> {
        self.list.get(id.index())
    }

    /// The element with a number, to be changed.
    #[inline]
    pub fn get_mut(&mut self, id: I) -> Option<&mut T> {
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

    /// The number of the first element that is wanted.
    #[inline]
    pub fn position(&self, is_wanted: impl FnMut(&T) -> bool) -> Option<I> {
        self.list.iter().position(is_wanted).map(I::from_index)
    }

    /// All elements with their numbers, in order.
    #[inline]
    pub fn iter_ids(&self) -> impl ExactSizeIterator<Item = (I, &T)> + DoubleEndedIterator + Clone {
        let numbered = self.list.iter().enumerate();
        numbered.map(|(index, value)| (I::from_index(index), value))
    }
}

impl<I, T> IdVec<I, T> {
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

    /// Make room for so many more elements.
    #[inline]
    pub fn reserve(&mut self, more: usize) {
        self.list.reserve(more);
    }

    /// The element that was added first.
    #[inline]
    pub fn first(&self) -> Option<&T> {
        self.list.first()
    }

    /// The element that was added last.
    #[inline]
    pub fn last(&self) -> Option<&T> {
        self.list.last()
    }

    /// The element that was added last, to be changed.
    #[inline]
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.list.last_mut()
    }

    /// The elements in order.
    #[inline]
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.list.iter()
    }

    /// The elements in order, to be changed.
    #[inline]
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
        self.list.iter_mut()
    }

    /// The elements without their numbers.
    #[inline]
    pub fn as_slice(&self) -> &[T] {
        &self.list
    }

    /// The elements without their numbers, to be changed.
    #[inline]
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.list
    }

    /// Add copies of some elements.
    pub fn extend_from_slice(&mut self, values: &[T])
    where
        T: Clone,
    {
        self.list.extend_from_slice(values);
    }

    /// Forget the elements behind the first `len`.
    #[inline]
    pub fn truncate(&mut self, len: usize) {
        self.list.truncate(len);
    }

    /// Forget all elements, and keep the room for them.
    #[inline]
    pub fn clear(&mut self) {
        self.list.clear();
    }

    /// Give back the room for more elements.
    pub fn shrink_to_fit(&mut self) {
        self.list.shrink_to_fit();
    }
}

impl<I, T> Default for IdVec<I, T> {
    #[inline]
    fn default() -> Self {
        Self::from(Vec::new())
    }
}

impl<I, T> From<Vec<T>> for IdVec<I, T> {
    #[inline]
    fn from(list: Vec<T>) -> Self {
        Self {
            list,
            id: PhantomData,
        }
    }
}

impl<I, T> FromIterator<T> for IdVec<I, T> {
    #[inline]
    fn from_iter<S: IntoIterator<Item = T>>(values: S) -> Self {
        Self::from(Vec::from_iter(values))
    }
}

impl<I, T> Extend<T> for IdVec<I, T> {
    #[inline]
    fn extend<S: IntoIterator<Item = T>>(&mut self, values: S) {
        self.list.extend(values);
    }
}

impl<'a, I, T> IntoIterator for &'a IdVec<I, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}

impl<I, T: fmt::Debug> fmt::Debug for IdVec<I, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.list.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::{Id, IdVec};

    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    struct WordId(u32);
    crate::ids!(WordId);

    #[test]
    fn elements_have_the_numbers_that_push_answers_with() {
        let mut words: IdVec<WordId, &str> = IdVec::default();
        let expected = words.next_id();
        let (arm, base) = (words.push("arm"), words.push("base"));
        assert_eq!((arm, base), (expected, WordId(1)));
        assert_eq!(
            (words.get(arm), words.get(base)),
            (Some(&"arm"), Some(&"base"))
        );
        let numbered: Vec<_> = words.iter_ids().collect();
        assert_eq!(numbered, [(arm, &"arm"), (base, &"base")]);
        assert_eq!(words.position(|word| word.len() == 4), Some(base));
    }

    #[test]
    fn a_number_without_an_element_gives_none() {
        let mut words: IdVec<WordId, &str> = ["arm"].into_iter().collect();
        let too_great = WordId::from_index(usize::MAX);
        assert_eq!(words.get(WordId(1)), None);
        assert_eq!(words.get_mut(too_great), None);
    }
}
