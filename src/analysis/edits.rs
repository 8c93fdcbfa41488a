//! Edits of a text since some moment, and where what stood in it then stands now.

use base::TextRange;

/// The edits, in the order in which they came.
#[derive(Default)]
pub(super) struct Edits(Vec<Replaced>);

/// One of them: the bytes that were replaced, and how many bytes took their place.
#[derive(Clone, Copy)]
struct Replaced {
    range: TextRange,
    new_len: u32,
}

impl Edits {
    /// Whether the text is as it was.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Bytes of the text as it is now are replaced by so many others.
    pub fn note(&mut self, range: TextRange, new_len: u32) {
        match self.0.last_mut() {
            // a word that is typed is one edit: what follows from them is asked for each finding
            Some(last) if last.touches(range) => last.extend(range, new_len),
            _ => self.0.push(Replaced { range, new_len }),
        }
    }

    /// Where a range of the text as it was stands now; none when an edit touched it.
    pub fn moved(&self, range: TextRange) -> Option<TextRange> {
        self.0.iter().try_fold(range, |range, &Replaced { range: old, new_len }| {
            if range.end < old.start {
                return Some(range);
            }
            let shift = |offset: u32| offset - old.len() + new_len;
            (range.start > old.end).then(|| TextRange::new(shift(range.start), shift(range.end)))
        })
    }
}

impl Replaced {
    /// Whether a later edit goes on where this one was.
    fn touches(self, later: TextRange) -> bool {
        later.start <= self.range.start + self.new_len && later.end >= self.range.start
    }

    /// This edit and a later one that touches it, as one edit.
    fn extend(&mut self, later: TextRange, new_len: u32) {
        let end = self.range.start + self.new_len;
        let start = self.range.start.min(later.start);
        self.range = TextRange::new(start, self.range.end + later.end.saturating_sub(end));
        self.new_len = end.max(later.end) - start - later.len() + new_len;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::Edits;
    use base::TextRange;

    proptest! {
        /// What is said to have moved reads as before.
        #[test]
        fn what_moved_reads_as_before(
            edits in prop::collection::vec((0usize..60, 0usize..6, "[A-Z]{0,5}"), 0..12),
            start in 0usize..60,
            len in 0usize..6,
        ) {
            // every byte of the old text occurs once, and new ones are letters
            let old: Vec<char> = ('\u{4e00}'..).take(60).collect();
            let mut text = old.clone();
            let mut noted = Edits::default();
            for (at, cut, new) in edits {
                let (at, cut) = (at.min(text.len()), cut.min(text.len() - at.min(text.len())));
                text.splice(at..at + cut, new.chars());
                noted.note(TextRange::new(at as u32, (at + cut) as u32), new.len() as u32);
            }
            let (start, end) = (start, (start + len).min(old.len()));
            if let Some(moved) = noted.moved(TextRange::new(start as u32, end as u32)) {
                prop_assert_eq!(&text[moved.start as usize..moved.end as usize], &old[start..end]);
            }
        }
    }

    #[test]
    fn a_word_that_is_typed_and_taken_back_is_one_edit() {
        let mut edits = Edits::default();
        for (at, new) in [(10, 1), (11, 1), (12, 1)] {
            edits.note(TextRange::new(at, at), new);
        }
        for at in [12, 11, 10] {
            edits.note(TextRange::new(at, at + 1), 0);
        }
        assert_eq!(edits.0.len(), 1);
        assert_eq!(edits.moved(TextRange::new(2, 9)), Some(TextRange::new(2, 9)));
        assert_eq!(edits.moved(TextRange::new(8, 12)), None);
        assert_eq!(edits.moved(TextRange::new(11, 15)), Some(TextRange::new(11, 15)));
    }
}
