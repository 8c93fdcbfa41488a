//! From raw text to its value: references, line ends, white space in attributes.

use std::borrow::Cow;
use std::ops::Range;

use super::chars::{is_legal, name_char, skip_name};
use super::entities::{Entities, EntityFault};
use base::limits::VALUE_BYTES;

/// A `&` and what follows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reference<'t> {
    /// Not a reference: the offset of the first byte that does not fit.
    Bad(usize),
    /// A character, `None` when XML forbids it, and the offset behind the `;`.
    Char(Option<char>, usize),
    /// A named entity.
    Entity { name: &'t str, end: usize },
}

/// Read the reference whose `&` stands at `at`.
pub(super) fn read_reference(text: &str, at: usize) -> Reference<'_> {
    let bytes = text.as_bytes();
    let after = at + 1;
    if bytes.get(after) != Some(&b'#') {
        if name_char(text, after, true) == 0 {
            return Reference::Bad(after);
        }
        let end = skip_name(text, after);
        return match (bytes.get(end), text.get(after..end)) {
            (Some(b';'), Some(name)) => Reference::Entity { name, end: end + 1 },
            _ => Reference::Bad(end),
        };
    }
    let (radix, start) = if bytes.get(after + 1) == Some(&b'x') {
        (16, after + 2)
    } else {
        (10, after + 1)
    };
    let mut end = start;
    let mut code = 0u32;
    while let Some(digit) = bytes.get(end).and_then(|b| (*b as char).to_digit(radix)) {
        code = code.saturating_mul(radix).saturating_add(digit);
        end += 1;
    }
    if end == start || bytes.get(end) != Some(&b';') {
        return Reference::Bad(end);
    }
    Reference::Char(char::from_u32(code).filter(|&c| is_legal(c)), end + 1)
}

/// The references of `text` with their offsets.
pub(super) fn references(text: &str) -> impl Iterator<Item = (usize, Reference<'_>)> {
    memchr::memchr_iter(b'&', text.as_bytes()).map(move |at| (at, read_reference(text, at)))
}

/// Where text stands, which decides what becomes of its white space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TextContext {
    /// In an element: line ends become LF.
    Text,
    /// In an attribute: white space becomes blanks.
    Attribute,
    /// In an entity that is used in an element: as it is.
    Replacement,
}

impl TextContext {
    fn new(is_attr: bool) -> Self {
        if is_attr {
            TextContext::Attribute
        } else {
            TextContext::Text
        }
    }
}

/// A piece of a value.
pub(super) enum ValuePiece<'t> {
    /// As written.
    Text(&'t str),
    /// Written in another way.
    Char(char),
    /// The value of an entity.
    Entity(&'t str),
}

/// The pieces of the value of raw text, each with the raw range it comes from.
pub(super) fn pieces(
    raw: &str,
    place: TextContext,
) -> impl Iterator<Item = (ValuePiece<'_>, Range<usize>)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let start = at;
        while at < raw.len() {
            if let Some((piece, end)) = special(raw, at, place) {
                if at > start {
                    break;
                }
                at = end;
                return Some((piece, start..end));
            }
            at += 1;
        }
        let text = raw.get(start..at).filter(|text| !text.is_empty())?;
        Some((ValuePiece::Text(text), start..at))
    })
}

/// The piece at `at`, if it does not stand for itself, and the offset behind it.
fn special(raw: &str, at: usize, place: TextContext) -> Option<(ValuePiece<'_>, usize)> {
    let bytes = raw.as_bytes();
    match bytes.get(at)? {
        b'&' => match read_reference(raw, at) {
            Reference::Char(Some(c), end) => Some((ValuePiece::Char(c), end)),
            Reference::Entity { name, end } => Some((ValuePiece::Entity(name), end)),
            Reference::Char(None, _) | Reference::Bad(_) => None,
        },
        b'\r' if place != TextContext::Replacement => {
            let len = if bytes.get(at + 1) == Some(&b'\n') {
                2
            } else {
                1
            };
            Some((
                ValuePiece::Char(if place == TextContext::Attribute {
                    ' '
                } else {
                    '\n'
                }),
                at + len,
            ))
        }
        b'\n' | b'\t' if place == TextContext::Attribute => Some((ValuePiece::Char(' '), at + 1)),
        _ => None,
    }
}

/// The value of raw text or of a raw attribute value. A reference without a value stays as written, apart
/// from those to external entities, which are empty.
pub fn decode<'t>(raw: &'t str, entities: &Entities, is_attr: bool) -> Cow<'t, str> {
    let mut out = String::with_capacity(raw.len());
    for (piece, range) in pieces(raw, TextContext::new(is_attr)) {
        push(&mut out, &piece, raw, range, entities, is_attr);
        if out.len() > VALUE_BYTES.max(raw.len()) {
            break;
        }
    }
    Cow::Owned(out)
}

fn push(
    out: &mut String,
    piece: &ValuePiece<'_>,
    raw: &str,
    range: Range<usize>,
    entities: &Entities,
    is_attr: bool,
) {
    match *piece {
        ValuePiece::Text(text) => out.push_str(text),
        ValuePiece::Char(c) => out.push(c),
        ValuePiece::Entity(name) => match entities.value(name, is_attr) {
            Ok(value) => out.push_str(&value),
            Err(EntityFault::ExternalInAttribute) => {}
            Err(_) => out.push_str(raw.get(range).unwrap_or("")),
        },
    }
}

/// The offset in raw text that made the byte at `decoded_offset` of its value; inside the value of a
/// reference: the offset of its `&`. Offsets behind the end give the end.
pub fn source_offset(
    raw: &str,
    entities: &Entities,
    is_attr: bool,
    decoded_offset: usize,
) -> usize {
    source_offsets(raw, entities, is_attr)(decoded_offset)
}

/// The same for many offsets: one pass, as long as each is behind the one before.
pub fn source_offsets(raw: &str, entities: &Entities, is_attr: bool) -> impl FnMut(usize) -> usize {
    let place = TextContext::new(is_attr);
    let (mut rest, mut out) = (pieces(raw, place), String::new());
    // the piece reached: where it stands, whether it stands for itself, and where its value begins and ends
    let (mut start, mut is_text, mut begin, mut end) = (0, false, 0, 0);
    move |offset| {
        if offset < begin {
            (rest, begin, end) = (pieces(raw, place), 0, 0);
        }
        while offset >= end {
            let Some((piece, range)) = rest.next() else {
                return raw.len();
            };
            out.clear();
            (start, is_text) = (range.start, matches!(piece, ValuePiece::Text(_)));
            push(&mut out, &piece, raw, range, entities, is_attr);
            (begin, end) = (end, end + out.len());
        }
        if is_text {
            start + (offset - begin)
        } else {
            start
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_follow_xml() {
        let none = Entities::default();
        for (raw, text, attribute) in [
            ("a&amp;b&lt;c&#65;&#x42;", "a&b<cAB", "a&b<cAB"),
            ("a\r\nb\rc\n\td", "a\nb\nc\n\td", "a b c  d"),
            ("&#10;&#9;&#13;", "\n\t\r", "\n\t\r"),
            (
                "& &; &x &#; &#x; &#xG; &unknown;",
                "& &; &x &#; &#x; &#xG; &unknown;",
                "& &; &x &#; &#x; &#xG; &unknown;",
            ),
            ("é&quot;😀&apos;&gt;", "é\"😀'>", "é\"😀'>"),
        ] {
            assert_eq!(decode(raw, &none, false), text, "{raw:?} as text");
            assert_eq!(decode(raw, &none, true), attribute, "{raw:?} as attribute");
        }
    }

    #[test]
    fn decoded_offsets_lead_back_to_the_source() {
        let raw = "ab&amp;c\r\nd&#65;";
        let none = Entities::default();
        assert_eq!(decode(raw, &none, false), "ab&c\ndA");
        let offsets: Vec<usize> = (0..8)
            .map(|at| source_offset(raw, &none, false, at))
            .collect();
        assert_eq!(offsets, [0, 1, 2, 7, 8, 10, 11, 16]);
        let mut at = source_offsets(raw, &none, false);
        assert_eq!([0, 2, 2, 5, 9, 3, 7].map(&mut at), [0, 2, 2, 10, 16, 7, 16]);
    }
}
