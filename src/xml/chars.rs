//! Which characters XML allows, and where.
#![allow(clippy::indexing_slicing)] // tables of 256 entries indexed by a byte

use super::name_table::{NAME_REST, NAME_START};

/// May begin a name.
const START: u8 = 1;
/// May follow in a name.
const NAME: u8 = 2;
/// White space: blank, TAB, LF, CR.
const SPACE: u8 = 4;
/// Ends the fast scan of character data.
const TEXT_STOP: u8 = 8;
/// Ends the fast scan of an attribute value.
const VALUE_STOP: u8 = 16;

const CLASS: [u8; 256] = {
    let mut table = [0; 256];
    let mut at = 0;
    while at < 256 {
        let b = at as u8;
        table[at] = match b {
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => START | NAME,
            b'0'..=b'9' | b'-' | b'.' => NAME,
            b' ' => SPACE,
            b'\t' | b'\n' => SPACE | VALUE_STOP,
            b'\r' => SPACE | VALUE_STOP | TEXT_STOP,
            b'<' | b'&' | b'$' => TEXT_STOP | VALUE_STOP,
            b'"' | b'\'' => VALUE_STOP,
            _ => 0,
        };
        at += 1;
    }
    table
};

pub(super) fn is_space(b: u8) -> bool {
    CLASS[b as usize] & SPACE != 0
}

/// Whether a scan of character data must look closer at this byte: `< & $` and CR.
pub(super) fn stops_text(b: u8) -> bool {
    CLASS[b as usize] & TEXT_STOP != 0
}

/// Whether a scan of an attribute value must look closer: quotes, `< & $`, TAB, LF, CR.
pub(super) fn stops_value(b: u8) -> bool {
    CLASS[b as usize] & VALUE_STOP != 0
}

/// Length in bytes of the name character at `at`, 0 when there is none. The colon is no name character
/// here: namespaces give it a grammar of its own.
pub(super) fn name_char(text: &str, at: usize, first: bool) -> usize {
    let Some(&b) = text.as_bytes().get(at) else {
        return 0;
    };
    if b < 0x80 {
        return usize::from(CLASS[b as usize] & if first { START } else { NAME } != 0);
    }
    let Some(c) = text.get(at..).and_then(|rest| rest.chars().next()) else {
        return 0;
    };
    let known = in_table(c, NAME_START) || (!first && in_table(c, NAME_REST));
    if known { c.len_utf8() } else { 0 }
}

/// Offset behind the run of ASCII name characters at `at`; where no name may begin, `at` itself.
#[inline]
pub(super) fn skip_ascii_name(bytes: &[u8], at: usize) -> usize {
    match bytes.get(at) {
        Some(&b) if CLASS[b as usize] & START != 0 => {}
        _ => return at,
    }
    let rest = bytes.get(at..).unwrap_or(&[]);
    at + rest
        .iter()
        .position(|&b| CLASS[b as usize] & NAME == 0)
        .unwrap_or(rest.len())
}

/// Offset behind the run of name characters at `at`, without regard to colons.
pub(super) fn skip_name(text: &str, mut at: usize) -> usize {
    loop {
        match name_char(text, at, false) {
            0 => return at,
            n => at += n,
        }
    }
}

fn in_table(c: char, table: &[(u16, u16)]) -> bool {
    let Ok(c) = u16::try_from(c as u32) else {
        return false;
    };
    let at = table.partition_point(|&(_, last)| last < c);
    table.get(at).is_some_and(|&(first, _)| first <= c)
}

/// Offset of the first character of `text` that XML forbids everywhere: control characters other than
/// TAB, LF, CR, and U+FFFE, U+FFFF.
pub(super) fn first_illegal(text: &str) -> Option<usize> {
    if !may_be_illegal(text.as_bytes()) {
        return None;
    }
    text.char_indices()
        .find(|&(_, c)| !is_legal(c))
        .map(|(at, _)| at)
}

/// Whether XML 1.0 allows this character at all.
pub(super) fn is_legal(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..)
}

/// A quick look without branches, so that the compiler can do many bytes at a time.
/// 0xEF leads U+F000 to U+FFFF, among them the two forbidden ones.
fn may_be_illegal(bytes: &[u8]) -> bool {
    bytes.chunks(256).any(|chunk| {
        chunk.iter().fold(false, |bad, &b| {
            bad | ((b < 0x20) & (b != b'\n') & (b != b'\t') & (b != b'\r')) | (b == 0xEF)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_fourth_edition() {
        for (text, first, rest) in [
            ("a", true, true),
            ("_", true, true),
            ("-", false, true),
            ("7", false, true),
            (":", false, false),
            ("é", true, true),
            ("中", true, true),
            ("·", false, true),
            ("×", false, false),
            ("😀", false, false),
        ] {
            assert_eq!(name_char(text, 0, true) > 0, first, "{text} first");
            assert_eq!(name_char(text, 0, false) > 0, rest, "{text} later");
        }
    }

    #[test]
    fn forbidden_characters_are_found() {
        assert_eq!(first_illegal("abc\t\r\n\u{7f}\u{85}\u{FFFD}😀"), None);
        assert_eq!(first_illegal("é\u{0}"), Some(2));
        assert_eq!(first_illegal("a\u{1f}b"), Some(1));
        assert_eq!(first_illegal("a\u{FFFE}"), Some(1));
    }
}
