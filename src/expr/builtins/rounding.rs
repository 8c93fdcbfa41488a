//! `round()`

use std::cmp::Ordering;

use num_bigint::BigInt;

use super::python::integer;
use crate::args::Args;
use crate::float_repr;
use crate::interp::Interp;
use crate::numeric::{Num, decode, float_to_int};
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// `round(number, ndigits)`
pub(super) fn round(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let value = args.at(0);
    let digits = match args.get(1) {
        None | Some(Value::None) => None,
        Some(digits) => Some(digits),
    };
    match (Num::of(value), digits) {
        (Some(Num::Float(f)), None) => float_to_int(f.round_ties_even()),
        (Some(Num::Float(f)), Some(digits)) => round_float(f, integer(digits)?).map(Value::Float),
        (Some(Num::Int(i)), None) => Ok(Value::Int(i)),
        (Some(Num::Big(_)), None) => Ok(value.clone()),
        (Some(Num::Int(_) | Num::Big(_)), Some(digits)) => {
            round_int(interp, value, integer(digits)?)
        }
        _ => {
            let kind = value.type_name();
            Err(Stop::typ(format!(
                "type {kind} doesn't define __round__ method"
            )))
        }
    }
}

/// An integer rounded to a power of ten, halves to even.
fn round_int(interp: &mut Interp, value: &Value, digits: i128) -> Eval {
    let Some(number) = Num::of(value).and_then(Num::big) else {
        return Ok(Value::Unknown);
    };
    if digits >= 0 {
        return Ok(Value::int(number.into_owned()));
    }
    // Python computes the power of ten whatever the number is; a decimal digit has 3.32 bits.
    interp
        .budget
        .int_bits(digits.unsigned_abs().saturating_mul(10) / 3)?;
    // Far beyond the number's own digits the result is zero.
    if digits < -(i128::from(number.bits()) / 3 + 2) {
        return Ok(Value::Int(0));
    }
    let unit = BigInt::from(10).pow(u32::try_from(digits.unsigned_abs()).unwrap_or(0));
    let (mut quotient, rest) = ops::int::div_mod(&number, &unit);
    match (&rest * 2u32).cmp(&unit) {
        Ordering::Greater => quotient += 1,
        Ordering::Equal if quotient.bit(0) => quotient += 1,
        _ => {}
    }
    Ok(Value::int(quotient * unit))
}

/// `round(f, digits)`: the decimal text of `f` is exact, so it is rounded once.
fn round_float(f: f64, digits: i128) -> Eval<f64> {
    // More digits change nothing, fewer leave nothing.
    if !f.is_finite() || f == 0.0 || digits > 323 {
        return Ok(f);
    }
    if digits < -308 {
        return Ok(0.0 * f);
    }
    let rounded = match usize::try_from(digits) {
        Ok(digits) => float_repr::fixed(f, digits).parse(),
        Err(_) => Ok(round_to_tens(f, usize::try_from(-digits).unwrap_or(0))),
    };
    match rounded {
        Ok(rounded) if rounded.is_infinite() => {
            Err(Stop::overflow("rounded value too large to represent"))
        }
        Ok(rounded) => Ok(rounded),
        Err(_) => Ok(f),
    }
}

/// `f` rounded to a multiple of ten to the power of `places`, halves to even.
fn round_to_tens(f: f64, places: usize) -> f64 {
    let (mantissa, exponent, negative) = decode(f);
    let unit = BigInt::from(10).pow(u32::try_from(places).unwrap_or(0));
    // Scaled by a power of two so that everything is whole.
    let down = u64::try_from(-exponent).unwrap_or(0);
    let up = u64::try_from(exponent).unwrap_or(0);
    let (value, unit) = (BigInt::from(mantissa) << up, unit << down);
    let (mut quotient, rest) = (&value / &unit, &value % &unit);
    let twice: BigInt = rest * 2;
    if twice > unit || (twice == unit && quotient.bit(0)) {
        quotient += 1;
    }
    let text = format!("{quotient}e{places}");
    let rounded: f64 = text.parse().unwrap_or(f64::NAN);
    if negative { -rounded } else { rounded }
}
