//! Numbers from text: `int()` and `float()`.

use std::borrow::Cow;

use num_bigint::BigInt;

use crate::Value;
use base::limits::INTEGER_DIGITS;

/// The value of a decimal digit of any script.
///
/// Digits come in runs of ten from zero to nine; the zeros are those of Unicode 14.
pub(crate) fn decimal_digit(c: char) -> Option<u32> {
    if c.is_ascii() {
        return c.to_digit(10);
    }
    let code = u32::from(c);
    let after = ZEROS.partition_point(|&zero| zero <= code);
    let zero = *ZEROS.get(after.checked_sub(1)?)?;
    let last = if zero == MATHEMATICAL_ZERO { 50 } else { 10 };
    (code - zero < last).then(|| (code - zero) % 10)
}

/// Five alphabets of digits in a row start here.
const MATHEMATICAL_ZERO: u32 = 0x1d7ce;

const ZEROS: &[u32] = &[
    0x660,
    0x6f0,
    0x7c0,
    0x966,
    0x9e6,
    0xa66,
    0xae6,
    0xb66,
    0xbe6,
    0xc66,
    0xce6,
    0xd66,
    0xde6,
    0xe50,
    0xed0,
    0xf20,
    0x1040,
    0x1090,
    0x17e0,
    0x1810,
    0x1946,
    0x19d0,
    0x1a80,
    0x1a90,
    0x1b50,
    0x1bb0,
    0x1c40,
    0x1c50,
    0xa620,
    0xa8d0,
    0xa900,
    0xa9d0,
    0xa9f0,
    0xaa50,
    0xabf0,
    0xff10,
    0x104a0,
    0x10d30,
    0x11066,
    0x110f0,
    0x11136,
    0x111d0,
    0x112f0,
    0x11450,
    0x114d0,
    0x11650,
    0x116c0,
    0x11730,
    0x118e0,
    0x11950,
    0x11c50,
    0x11d50,
    0x11da0,
    0x16a60,
    0x16ac0,
    0x16b50,
    MATHEMATICAL_ZERO,
    0x1e140,
    0x1e2f0,
    0x1e950,
    0x1fbf0,
];

pub(crate) use crate::syntax::is_python_space as is_space;

/// Decimal digits in ASCII, blanks at the ends cut off; `None` if a character can be in no number.
fn ascii_number(text: &str) -> Option<Cow<'_, str>> {
    if text.is_ascii() {
        // The separators \x1c to \x1f are blanks only in texts that need translation.
        return Some(Cow::Borrowed(
            text.trim_matches([' ', '\t', '\n', '\x0b', '\x0c', '\r']),
        ));
    }
    let text = text.trim_matches(is_space);
    let digit = |c: char| {
        if c.is_ascii() {
            Some(c)
        } else {
            char::from_digit(decimal_digit(c)?, 10)
        }
    };
    text.chars()
        .map(digit)
        .collect::<Option<String>>()
        .map(Cow::Owned)
}

/// Underscores removed, if each stands between two digits of `radix`.
fn without_underscores(text: &str, is_digit: impl Fn(u8) -> bool) -> Option<Cow<'_, str>> {
    if !text.contains('_') {
        return Some(Cow::Borrowed(text));
    }
    let bytes = text.as_bytes();
    let fine = bytes
        .iter()
        .enumerate()
        .all(|(at, &b)| b != b'_' || is_between_digits(bytes, at, &is_digit));
    fine.then(|| Cow::Owned(text.replace('_', "")))
}

/// Whether a digit stands before the byte `at` and one behind it.
fn is_between_digits(bytes: &[u8], at: usize, is_digit: impl Fn(u8) -> bool) -> bool {
    let before = at.checked_sub(1).and_then(|before| bytes.get(before));
    before.is_some_and(|&b| is_digit(b)) && bytes.get(at + 1).is_some_and(|&b| is_digit(b))
}

/// What became of a text given to `int()`.
pub(crate) enum ParsedInt {
    Int(Value),
    TooLong(usize),
    Invalid,
}

/// `int(text, base)`; base 0 guesses from a prefix.
pub(crate) fn parse_int(text: &str, base: u32) -> ParsedInt {
    let Some(text) = ascii_number(text) else {
        return ParsedInt::Invalid;
    };
    let (negative, digits) = match text.as_bytes().first() {
        Some(b'-') => (true, text.get(1..)),
        Some(b'+') => (false, text.get(1..)),
        _ => (false, Some(&*text)),
    };
    let digits = digits.unwrap_or("");
    let Some((base, digits)) = strip_prefix(digits, base) else {
        return ParsedInt::Invalid;
    };
    let is_digit = |b: u8| char::from(b).is_digit(base);
    let Some(digits) = without_underscores(digits, is_digit) else {
        return ParsedInt::Invalid;
    };
    if digits.is_empty() || !digits.bytes().all(is_digit) {
        return ParsedInt::Invalid;
    }
    if let Ok(small) = i64::from_str_radix(&digits, base) {
        return ParsedInt::Int(Value::Int(if negative { -small } else { small }));
    }
    if !base.is_power_of_two() && digits.len() > INTEGER_DIGITS {
        return ParsedInt::TooLong(digits.len());
    }
    match BigInt::parse_bytes(digits.as_bytes(), base) {
        Some(big) => ParsedInt::Int(Value::int(if negative { -big } else { big })),
        None => ParsedInt::Invalid,
    }
}

/// The base and the digits behind a `0x`-like prefix.
fn strip_prefix(digits: &str, base: u32) -> Option<(u32, &str)> {
    let prefix = digits.get(..2).map(str::to_ascii_lowercase);
    let named = match prefix.as_deref() {
        Some("0x") => Some(16),
        Some("0o") => Some(8),
        Some("0b") => Some(2),
        _ => None,
    };
    if let Some(named) = named.filter(|&named| base == 0 || base == named) {
        let rest = digits.get(2..).unwrap_or("");
        return Some((named, rest.strip_prefix('_').unwrap_or(rest)));
    }
    if base != 0 {
        return Some((base, digits));
    }
    // Base 0 follows the source code: no leading zeros except in zero itself.
    let zero = digits.bytes().all(|b| b == b'0' || b == b'_');
    (zero || !digits.starts_with('0')).then_some((10, digits))
}

/// `float(text)`
pub(crate) fn parse_float(text: &str) -> Option<f64> {
    let text = ascii_number(text)?;
    let text = without_underscores(&text, |b| b.is_ascii_digit())?;
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(&text);
    let named = ["inf", "infinity", "nan"]
        .iter()
        .any(|word| unsigned.eq_ignore_ascii_case(word));
    let plain = unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && unsigned
            .bytes()
            .all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
    if named || plain {
        text.parse().ok()
    } else {
        None
    }
}
