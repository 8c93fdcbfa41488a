//! The numeric tower: bool, int of any size, float, complex.

use std::borrow::Cow;
use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_traits::{FromPrimitive, Signed, ToPrimitive};

use super::Value;
use super::stop::{Eval, Stop};

/// A number seen without its `bool`-ness.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Num<'a> {
    Int(i64),
    Big(&'a BigInt),
    Float(f64),
    Complex(f64, f64),
}

impl<'a> Num<'a> {
    /// The number a value is, if it is one.
    pub(crate) fn of(value: &'a Value) -> Option<Self> {
        Some(match value {
            Value::Int(i) => Self::Int(*i),
            Value::Bool(b) => Self::Int(i64::from(*b)),
            Value::Float(f) => Self::Float(*f),
            Value::Big(b) => Self::Big(b),
            Value::Complex(re, im) => Self::Complex(*re, *im),
            _ => return None,
        })
    }

    /// As an integer of any size, if it is one.
    pub(crate) fn big(self) -> Option<Cow<'a, BigInt>> {
        match self {
            Self::Int(i) => Some(Cow::Owned(BigInt::from(i))),
            Self::Big(b) => Some(Cow::Borrowed(b)),
            _ => None,
        }
    }

    /// As a float; integers beyond its range are an error, complex numbers have none.
    pub(crate) fn float(self) -> Eval<Option<f64>> {
        Ok(Some(match self {
            Self::Int(i) => i as f64,
            Self::Big(b) => big_to_f64(b)?,
            Self::Float(f) => f,
            Self::Complex(..) => return Ok(None),
        }))
    }

    /// As a complex number.
    pub(crate) fn complex(self) -> Eval<(f64, f64)> {
        match self {
            Self::Complex(re, im) => Ok((re, im)),
            real => Ok((real.float()?.unwrap_or(f64::NAN), 0.0)),
        }
    }

    /// Python's `bool()`.
    pub(crate) fn truth(self) -> bool {
        match self {
            Self::Int(i) => i != 0,
            Self::Big(_) => true,
            Self::Float(f) => f != 0.0,
            Self::Complex(re, im) => re != 0.0 || im != 0.0,
        }
    }

    /// Exact comparison of real numbers; none for NaN and for complex numbers.
    pub(crate) fn compare(self, other: Num<'_>) -> Option<Ordering> {
        use Num::{Big, Float, Int};
        match (self, other) {
            (Int(a), Int(b)) => Some(a.cmp(&b)),
            (Float(a), Float(b)) => a.partial_cmp(&b),
            (Int(a), Float(b)) => compare_int_float(a, b),
            (Float(a), Int(b)) => compare_int_float(b, a).map(Ordering::reverse),
            (Big(a), Big(b)) => Some(a.cmp(b)),
            (Big(a), Int(_)) => Some(sign_order(a)),
            (Int(_), Big(b)) => Some(sign_order(b).reverse()),
            (Big(a), Float(b)) => compare_big_float(a, b),
            (Float(a), Big(b)) => compare_big_float(b, a).map(Ordering::reverse),
            _ => None,
        }
    }

    /// Python's `==`.
    pub(crate) fn equals(self, other: Num<'_>) -> bool {
        match (self, other) {
            (Self::Complex(re, im), Num::Complex(re2, im2)) => re == re2 && im == im2,
            (Self::Complex(re, im), real) => im == 0.0 && Num::Float(re).equals(real),
            (real, Num::Complex(re, im)) => im == 0.0 && real.equals(Num::Float(re)),
            (a, b) => a.compare(b) == Some(Ordering::Equal),
        }
    }
}

/// A big integer against any that fits an `i64`: its sign decides.
fn sign_order(big: &BigInt) -> Ordering {
    if big.is_negative() { Ordering::Less } else { Ordering::Greater }
}

fn compare_int_float(int: i64, float: f64) -> Option<Ordering> {
    if float.is_nan() {
        return None;
    }
    // 2**63 is a float; everything from there on is larger than any i64.
    if float >= 9_223_372_036_854_775_808.0 {
        return Some(Ordering::Less);
    }
    if float < -9_223_372_036_854_775_808.0 {
        return Some(Ordering::Greater);
    }
    let whole = float.trunc();
    let order = int.cmp(&(whole as i64));
    Some(order.then_with(|| 0.0.partial_cmp(&(float - whole)).unwrap_or(Ordering::Equal)))
}

fn compare_big_float(big: &BigInt, float: f64) -> Option<Ordering> {
    if float.is_nan() {
        return None;
    }
    if float.is_infinite() {
        return Some(if float > 0.0 { Ordering::Less } else { Ordering::Greater });
    }
    // A fraction cannot tip the balance: floats of this size are whole numbers.
    Some(big.cmp(&BigInt::from_f64(float.trunc())?))
}

/// Nearest float, or the error Python raises when there is none.
pub(crate) fn big_to_f64(big: &BigInt) -> Eval<f64> {
    match big.to_f64() {
        Some(f) if f.is_finite() => Ok(f),
        _ => Err(Stop::overflow("int too large to convert to float")),
    }
}

/// The integer a float is after cutting off its fraction.
pub(crate) fn float_to_int(float: f64) -> Eval {
    if float.is_nan() {
        return Err(Stop::value("cannot convert float NaN to integer"));
    }
    if float.is_infinite() {
        return Err(Stop::overflow("cannot convert float infinity to integer"));
    }
    Ok(whole_float_to_int(float))
}

/// The same for a float known to be finite.
pub(crate) fn whole_float_to_int(float: f64) -> Value {
    if float.abs() < 9.0e18 {
        return Value::Int(float as i64);
    }
    Value::int(BigInt::from_f64(float.trunc()).unwrap_or_default())
}

/// Sign and magnitude as Python's `sys.hash_info` prescribes: modulo the prime 2**61 - 1.
const HASH_MODULUS: u64 = (1 << 61) - 1;

/// Python's `hash()` of a number.
pub(crate) fn hash_num(number: Num<'_>) -> i64 {
    match number {
        Num::Int(i) => signed_hash(i.unsigned_abs() % HASH_MODULUS, i < 0),
        Num::Big(b) => {
            let rest = (b.magnitude() % HASH_MODULUS).to_u64().unwrap_or(0);
            signed_hash(rest, b.sign() == Sign::Minus)
        }
        Num::Float(f) => hash_float(f),
        Num::Complex(re, im) => {
            let sum = hash_float(re).wrapping_add(hash_float(im).wrapping_mul(1_000_003));
            if sum == -1 { -2 } else { sum }
        }
    }
}

fn hash_float(f: f64) -> i64 {
    if f.is_nan() {
        return 0;
    }
    if f.is_infinite() {
        return if f > 0.0 { 314_159 } else { -314_159 };
    }
    let (mantissa, exponent, negative) = decode(f);
    let shift = exponent.rem_euclid(61).unsigned_abs();
    let rest = (u128::from(mantissa) << shift) % u128::from(HASH_MODULUS);
    signed_hash(u64::try_from(rest).unwrap_or(0), negative)
}

fn signed_hash(rest: u64, negative: bool) -> i64 {
    let rest = i64::try_from(rest).unwrap_or(0);
    match if negative { -rest } else { rest } {
        -1 => -2,
        hash => hash,
    }
}

/// `f` as `mantissa * 2**exponent`, and whether it is negative.
pub(crate) fn decode(f: f64) -> (u64, i32, bool) {
    let bits = f.to_bits();
    let field = i32::try_from((bits >> 52) & 0x7ff).unwrap_or(0);
    let fraction = bits & ((1 << 52) - 1);
    let mantissa = if field == 0 { fraction } else { fraction | (1 << 52) };
    (mantissa, field.max(1) - 1075, bits >> 63 == 1)
}

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

/// Python's white space: that of `str.strip()`, `int()` and `float()`.
pub(crate) fn is_space(c: char) -> bool {
    c.is_whitespace() || ('\x1c'..='\x1f').contains(&c)
}

/// Decimal digits in ASCII, blanks at the ends cut off; `None` if a character can be in no number.
fn ascii_number(text: &str) -> Option<Cow<'_, str>> {
    let text = text.trim_matches(is_space);
    if text.is_ascii() {
        return Some(Cow::Borrowed(text));
    }
    let digit = |c: char| if c.is_ascii() { Some(c) } else { char::from_digit(decimal_digit(c)?, 10) };
    text.chars().map(digit).collect::<Option<String>>().map(Cow::Owned)
}

/// Underscores removed, if each stands between two digits of `radix`.
fn without_underscores(text: &str, is_digit: impl Fn(u8) -> bool) -> Option<Cow<'_, str>> {
    if !text.contains('_') {
        return Some(Cow::Borrowed(text));
    }
    let bytes = text.as_bytes();
    let between = |i: usize| {
        let before = i.checked_sub(1).and_then(|i| bytes.get(i));
        before.is_some_and(|&b| is_digit(b)) && bytes.get(i + 1).is_some_and(|&b| is_digit(b))
    };
    let fine = bytes.iter().enumerate().all(|(i, &b)| b != b'_' || between(i));
    fine.then(|| Cow::Owned(text.replace('_', "")))
}

/// Most digits a decimal text may have on its way to or from an integer.
pub(crate) const MAX_STR_DIGITS: usize = 4300;

/// What became of a text given to `int()`.
pub(crate) enum ParsedInt {
    Int(Value),
    TooLong(usize),
    Invalid,
}

/// `int(text, base)`; base 0 guesses from a prefix.
pub(crate) fn parse_int(text: &str, base: u32) -> ParsedInt {
    let Some(text) = ascii_number(text) else { return ParsedInt::Invalid };
    let (negative, digits) = match text.as_bytes().first() {
        Some(b'-') => (true, text.get(1..)),
        Some(b'+') => (false, text.get(1..)),
        _ => (false, Some(&*text)),
    };
    let digits = digits.unwrap_or("");
    let Some((base, digits)) = strip_prefix(digits, base) else { return ParsedInt::Invalid };
    let is_digit = |b: u8| char::from(b).is_digit(base);
    let Some(digits) = without_underscores(digits, is_digit) else { return ParsedInt::Invalid };
    if digits.is_empty() || !digits.bytes().all(is_digit) {
        return ParsedInt::Invalid;
    }
    if let Ok(small) = i64::from_str_radix(&digits, base) {
        return ParsedInt::Int(Value::Int(if negative { -small } else { small }));
    }
    if !base.is_power_of_two() && digits.len() > MAX_STR_DIGITS {
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
    let named = ["inf", "infinity", "nan"].iter().any(|word| unsigned.eq_ignore_ascii_case(word));
    let plain = unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && unsigned.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-'));
    if named || plain { text.parse().ok() } else { None }
}
