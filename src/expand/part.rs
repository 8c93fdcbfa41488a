//! Parts of lists.
use std::ops::Range;

/// A part of a list; nothing of one that is shorter.
pub(super) fn part<T>(list: &[T], range: Range<usize>) -> &[T] {
    list.get(range).unwrap_or_default()
}
