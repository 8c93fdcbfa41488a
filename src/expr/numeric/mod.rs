//! The numeric tower: bool, int of any size, float, complex.

mod hash;
mod text;

use std::borrow::Cow;
use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{FromPrimitive, Signed, ToPrimitive};

use super::Value;
use super::stop::{Eval, Stop};
pub(crate) use hash::hash_num;
pub(crate) use text::{ParsedInt, decimal_digit, is_space, parse_float, parse_int};

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
    if big.is_negative() {
        Ordering::Less
    } else {
        Ordering::Greater
    }
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
        return Some(if float > 0.0 {
            Ordering::Less
        } else {
            Ordering::Greater
        });
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

/// `f` as `mantissa * 2**exponent`, and whether it is negative.
pub(crate) fn decode(f: f64) -> (u64, i32, bool) {
    let bits = f.to_bits();
    let field = i32::try_from((bits >> 52) & 0x7ff).unwrap_or(0);
    let fraction = bits & ((1 << 52) - 1);
    let mantissa = if field == 0 {
        fraction
    } else {
        fraction | (1 << 52)
    };
    (mantissa, field.max(1) - 1075, bits >> 63 == 1)
}
