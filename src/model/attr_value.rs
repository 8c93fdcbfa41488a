//! Values of attributes with their source, and the numbers in them.

use std::ops::{Deref, Range};
use std::sync::Arc;

use ecow::EcoString;

use base::TextRange;
use expand::{BindingId, Expansion, Origin, Piece, XAttr, XId, XKind, XTree};

/// The value of an attribute, and where it stands in the source; shared with the expanded document.
#[derive(Clone, Debug)]
pub struct AttrValue {
    /// The attributes of an element, not empty.
    attrs: Arc<[XAttr]>,
    index: u32,
}

impl Deref for AttrValue {
    type Target = XAttr;

    #[allow(clippy::indexing_slicing)] // both ways to make a text give the place of an attribute that is there
    fn deref(&self) -> &XAttr {
        &self.attrs[self.index as usize]
    }
}

impl AttrValue {
    /// An attribute of an element.
    pub fn attr(tree: &XTree, element: XId, name: &str) -> Option<Self> {
        let (attrs, index) = tree.get(element).attrs.find(name)?;
        Some(Self {
            attrs,
            index: index as u32,
        })
    }

    /// False when a part of the value could not be computed: no rule may draw a conclusion from it.
    pub fn is_known(&self) -> bool {
        self.pieces.iter().all(|piece| !piece.unknown)
    }

    /// Whether a part of the value could not be computed, or perhaps was to be: in `{prefix}tcp` a `$` is missing.
    pub fn is_doubtful(&self) -> bool {
        !self.is_known() || self.value.contains('{') && self.is_literal()
    }

    /// Whether a doubtful value may turn out to be `name`: what is known of it fits.
    pub fn may_be(&self, name: &str) -> bool {
        let mut known: Vec<&str> = Vec::new();
        let mut start = 0;
        for piece in self.pieces.iter().filter(|piece| piece.unknown) {
            known.push(
                self.value
                    .get(start..piece.out.start as usize)
                    .unwrap_or(""),
            );
            start = piece.out.end as usize;
        }
        let end = self.value.get(start..).unwrap_or("");
        let Some((begin, middle)) = known.split_first() else {
            return self.is_doubtful() || self.value == name;
        };
        let inner = name
            .strip_prefix(begin)
            .and_then(|rest| rest.strip_suffix(end));
        let mut parts = middle.iter();
        // the known parts in between stand in this order
        inner.is_some_and(|inner| {
            parts
                .try_fold(inner, |rest, part| {
                    rest.split_once(part).map(|(_, behind)| behind)
                })
                .is_some()
        })
    }

    /// Whether the source holds the value itself, not an expression.
    pub fn is_literal(&self) -> bool {
        self.pieces.is_empty()
    }

    /// The first text inside an element that is not blank, without the blanks around it.
    pub fn content(tree: &XTree, element: XId) -> Option<Self> {
        let texts = tree
            .children(element)
            .map(|id| tree.get(id))
            .filter(|node| node.kind == XKind::Text);
        let node = texts
            .into_iter()
            .find(|node| !node.text.trim_matches(is_blank).is_empty())?;
        let value: EcoString = node.text.trim_matches(is_blank).into();
        let literal = node.origin.range.len() as usize == node.text.len();
        let mut origin = node.origin;
        if literal {
            let before = node.text.len() - node.text.trim_start_matches(is_blank).len();
            let start = origin.range.start + before as u32;
            origin.range = TextRange::new(start, start + value.len() as u32);
        }
        let pieces = if literal {
            Box::default()
        } else {
            Box::new([made(&value, origin)]) as Box<[Piece]>
        };
        let attr = XAttr {
            name: EcoString::new(),
            value,
            origin,
            pieces,
        };
        Some(Self {
            attrs: Arc::new([attr]),
            index: 0,
        })
    }

    /// The value, when all of it is known and it is not empty.
    pub fn name(&self) -> Option<&EcoString> {
        (self.is_known() && !self.value.is_empty()).then_some(&self.value)
    }

    /// The value as a finite decimal number; none when it is unknown or no such number.
    pub fn number(&self) -> Option<f64> {
        if self.is_known() {
            decimal(self.value.trim_matches(is_blank))
        } else {
            None
        }
    }

    /// The value as `N` finite decimal numbers; none when it is unknown or something else.
    pub fn numbers<const N: usize>(&self) -> Option<[f64; N]> {
        if !self.is_known() {
            return None;
        }
        let mut numbers = self.words().map(|range| decimal(self.value.get(range)?));
        let mut found = [0.0; N];
        for slot in &mut found {
            *slot = numbers.next()??;
        }
        numbers.next().is_none().then_some(found)
    }

    /// Byte ranges of the words of the value.
    pub fn words(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let text = self.value.as_str();
        let word = move |word: &[u8]| {
            let start = word.as_ptr() as usize - text.as_ptr() as usize;
            start..start + word.len()
        };
        // blanks are ASCII: what stands between them are whole characters
        text.as_bytes()
            .split(|&byte| is_blank(byte.into()))
            .filter(|word| !word.is_empty())
            .map(word)
    }

    /// Whether the source spells the part `range` of the value: no expression had a hand in it.
    pub fn is_written(&self, range: Range<usize>) -> bool {
        let (start, end) = (range.start as u32, range.end as u32);
        !self
            .pieces
            .iter()
            .any(|piece| piece.out.start < end && start < piece.out.end)
    }

    /// Where the part `range` of the value stands in the source: that text itself when it is written there,
    /// the expression that made it, or the whole value when it comes from several places.
    pub fn part(&self, range: Range<usize>) -> Origin {
        let (start, end) = (range.start as u32, range.end as u32);
        let same_length = self.origin.range.len() as usize == self.value.len();
        if self.is_literal() {
            // entities make the text in the source longer than the value
            return if same_length {
                self.in_origin(start, end)
            } else {
                self.origin
            };
        }
        let touches = |piece: &&Piece| piece.out.start < end && start < piece.out.end;
        let mut touching = self.pieces.iter().filter(touches);
        match (touching.next(), touching.next()) {
            (Some(piece), None) if piece.out.start <= start && end <= piece.out.end => piece.source,
            (None, _) => self.written(start, end).map_or(self.origin, |start| {
                self.in_origin(start, start + (end - range.start as u32))
            }),
            _ => self.origin,
        }
    }

    /// The place in the source that is `start` to `end` bytes behind the beginning of the value.
    fn in_origin(&self, start: u32, end: u32) -> Origin {
        let base = self.origin.range.start;
        Origin {
            range: TextRange::new(base + start, base + end),
            ..self.origin
        }
    }

    /// What the expressions read that made the part `range` of the value: numbers of
    /// [`NameIndex::bindings`](expand::NameIndex::bindings).
    pub fn reads<'t>(
        &'t self,
        expansion: &'t Expansion,
        range: Range<usize>,
    ) -> impl Iterator<Item = BindingId> + 't {
        let (start, end) = (range.start as u32, range.end as u32);
        let touching = self
            .pieces
            .iter()
            .filter(move |piece| piece.out.start < end && start < piece.out.end);
        touching.flat_map(|piece| expansion.index.read_in(piece.reads).iter().copied())
    }

    /// The offset in the source of a part that no expression made.
    fn written(&self, start: u32, end: u32) -> Option<u32> {
        let next = self.pieces.iter().find(|piece| end <= piece.out.start);
        match next {
            Some(next) => {
                let ahead = next.out.start - start;
                next.source
                    .range
                    .start
                    .checked_sub(self.origin.range.start)?
                    .checked_sub(ahead)
            }
            None => {
                let behind = self.value.len() as u32 - start;
                self.origin.range.len().checked_sub(behind)
            }
        }
    }
}

/// A text that expressions made as a whole; what could not be computed reads `?`.
fn made(value: &str, source: Origin) -> Piece {
    let out = TextRange::new(0, value.len() as u32);
    Piece {
        out,
        source,
        reads: TextRange::default(),
        unknown: value.contains('?'),
    }
}

/// What separates the numbers of a vector.
fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r')
}

/// Whether a text is such a number as [`decimal`] reads.
pub fn is_decimal(text: &str) -> bool {
    let digits = text.trim_start_matches(['+', '-']);
    // without an exponent, and with at most one sign and point, nothing can go wrong
    let is_plain = text.len() - digits.len() <= 1
        && digits.len() < 100
        && digits
            .bytes()
            .all(|byte| byte.is_ascii_digit() || byte == b'.')
        && digits.bytes().filter(|byte| *byte == b'.').count() <= 1
        && digits.bytes().any(|byte| byte != b'.');
    is_plain || decimal(text).is_some()
}

/// A finite decimal number: digits with an optional point, sign and exponent.
pub fn decimal(text: &str) -> Option<f64> {
    let admitted =
        |byte: u8| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'e' | b'E');
    let number: f64 = text.bytes().all(admitted).then(|| text.parse().ok())??;
    number.is_finite().then_some(number)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{decimal, is_decimal};

    proptest! {
        #[test]
        fn a_decimal_is_what_can_be_read_as_one(text in "[-+.0-9eE]{0,8}|[-+]?[0-9]{0,120}|.{0,6}") {
            prop_assert_eq!(is_decimal(&text), decimal(&text).is_some());
        }
    }

    #[test]
    fn only_plain_finite_decimals_are_numbers() {
        assert_eq!(
            ["1", "-.5", "+2.", "1e-3"].map(decimal),
            [Some(1.0), Some(-0.5), Some(2.0), Some(0.001)]
        );
        let others = [
            "", "1,5", "0.1 m", "0x1", "nan", "inf", "1e999", "1_0", "e", "--1",
        ];
        assert!(others.iter().all(|text| decimal(text).is_none()));
    }
}
