//! Methods of numbers and dates.

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{One as _, Signed, Zero as _};

use super::{methods, up_to};
use crate::args::Arity::{Any, One, Zero};
use crate::args::{Args, bind_named};
use crate::builtins::{Function, argument_type, index_sized, integer};
use crate::display;
use crate::interp::Interp;
use crate::numeric::{Num, decode};
use crate::ops::int::scale_by;
use crate::stop::{Eval, Stop};
use crate::value::{Value, date_text};

/// Sorted by name.
pub(super) static INT: &[Function] = methods! { "int":
    "as_integer_ratio" Zero => |_, s, _| Ok(Value::tuple_from([Value::int(big(s)), Value::Int(1)])),
    "bit_count" Zero => |_, s, _| Ok(Value::int(big(s).magnitude().count_ones())),
    "bit_length" Zero => |_, s, _| Ok(Value::int(big(s).bits())),
    "conjugate" Zero => |_, s, _| Ok(Value::int(big(s))),
    "to_bytes" Any => to_bytes,
};

/// Sorted by name.
pub(super) static INT_CLASS: &[Function] = methods! { "int":
    "from_bytes" Any => from_bytes,
};

/// Sorted by name.
pub(super) static FLOAT: &[Function] = methods! { "float":
    "as_integer_ratio" Zero => |_, s, _| ratio(float(s)?),
    "conjugate" Zero => |_, s, _| Ok(s.clone()),
    "hex" Zero => |_, s, _| Ok(Value::from(hex(float(s)?))),
    "is_integer" Zero => |_, s, _| { let f = float(s)?; Ok(Value::Bool(f.is_finite() && f == f.floor())) },
};

/// Sorted by name.
pub(super) static FLOAT_CLASS: &[Function] = methods! { "float":
    "fromhex" One => from_hex,
};

/// Sorted by name.
pub(super) static COMPLEX: &[Function] = methods! { "complex":
    "conjugate" Zero => |_, s, _| match s {
        Value::Complex(re, im) => Ok(Value::Complex(*re, -im)),
        _ => Err(Stop::Unknown),
    },
};

/// Sorted by name.
pub(super) static DATE: &[Function] = methods! { "datetime.date":
    "isoformat" up_to(0, 1) => |_, s, _| match s {
        Value::Date(date) => Ok(Value::from(date_text(date, "T"))),
        _ => Err(Stop::Unknown),
    },
};

fn big(value: &Value) -> BigInt {
    Num::of(value)
        .and_then(Num::big)
        .map(std::borrow::Cow::into_owned)
        .unwrap_or_default()
}

fn float(value: &Value) -> Eval<f64> {
    match value {
        Value::Float(f) => Ok(*f),
        _ => Err(Stop::Unknown),
    }
}

/// Whether the byte order is the one with the most significant byte first.
fn is_big_endian(value: Option<&Value>, function: &str) -> Eval<bool> {
    match value {
        None => Ok(true),
        Some(Value::Str(order)) if order == "big" => Ok(true),
        Some(Value::Str(order)) if order == "little" => Ok(false),
        Some(Value::Str(_)) => Err(Stop::value("byteorder must be either 'little' or 'big'")),
        Some(other) => {
            let kind = argument_type(other);
            Err(Stop::typ(format!(
                "{function}() argument 'byteorder' must be str, not {kind}"
            )))
        }
    }
}

fn is_signed(interp: &mut Interp, args: &Args) -> Eval<bool> {
    args.get(2).map_or(Ok(false), |value| interp.truth(value))
}

fn rebind(name: &str, names: &[&str], required: usize, args: &Args) -> Eval<Args> {
    bind_named(
        name,
        names,
        required,
        2,
        Args {
            pos: args.pos.clone(),
            named: args.named.clone(),
        },
    )
}

fn to_bytes(interp: &mut Interp, number: &Value, args: &Args) -> Eval {
    let args = rebind("to_bytes", &["length", "byteorder", "signed"], 0, args)?;
    let length = args.get(0).map_or(Ok(1), index_sized)?;
    let big_endian = is_big_endian(args.get(1), "to_bytes")?;
    let Ok(length) = u64::try_from(length) else {
        return Err(Stop::value("length argument must be non-negative"));
    };
    let number = big(number);
    let signed = is_signed(interp, &args)?;
    if number.is_negative() && !signed {
        return Err(Stop::overflow("can't convert negative int to unsigned"));
    }
    interp.budget.text(u128::from(length))?;
    let length = usize::try_from(length).unwrap_or(0);
    let mut bytes = if signed {
        number.to_signed_bytes_le()
    } else {
        number.magnitude().to_bytes_le()
    };
    if number.is_zero() {
        bytes.clear();
    }
    if bytes.len() > length {
        return Err(Stop::overflow("int too big to convert"));
    }
    bytes.resize(length, if number.is_negative() { 0xff } else { 0 });
    if big_endian {
        bytes.reverse();
    }
    Ok(Value::Bytes(bytes.into_iter().collect()))
}

fn from_bytes(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let args = rebind("from_bytes", &["bytes", "byteorder", "signed"], 1, args)?;
    let big_endian = is_big_endian(args.get(1), "from_bytes")?;
    let mut bytes: Vec<u8> = match args.at(0) {
        Value::Bytes(bytes) => bytes.to_vec(),
        other if matches!(other, Value::Str(_)) || interp.iter(other).is_err() => {
            let kind = other.type_name();
            return Err(Stop::typ(format!(
                "cannot convert '{kind}' object to bytes"
            )));
        }
        other => {
            let items = interp.collect(other)?;
            let byte = |item: &Value| {
                u8::try_from(integer(item)?)
                    .map_err(|_| Stop::value("bytes must be in range(0, 256)"))
            };
            items.iter().map(byte).collect::<Eval<_>>()?
        }
    };
    interp.budget.int_bits(bytes.len() as u128 * 8)?;
    if big_endian {
        bytes.reverse();
    }
    let signed = is_signed(interp, &args)?;
    Ok(Value::int(if signed {
        BigInt::from_signed_bytes_le(&bytes)
    } else {
        BigInt::from(BigUint::from_bytes_le(&bytes))
    }))
}

fn ratio(f: f64) -> Eval {
    if f.is_nan() {
        return Err(Stop::value("cannot convert NaN to integer ratio"));
    }
    if f.is_infinite() {
        return Err(Stop::overflow("cannot convert Infinity to integer ratio"));
    }
    let (mantissa, exponent, negative) = decode(f);
    let zeros = if mantissa == 0 {
        0
    } else {
        mantissa
            .trailing_zeros()
            .min((-exponent).max(0).unsigned_abs())
    };
    let sign = if negative { Sign::Minus } else { Sign::Plus };
    let top = BigInt::from_biguint(sign, BigUint::from(mantissa >> zeros));
    let down = -exponent - i32::try_from(zeros).unwrap_or(0);
    let (top, bottom) = match u32::try_from(down) {
        Ok(down) if mantissa != 0 => (top, BigInt::one() << down),
        Ok(_) => (BigInt::ZERO, BigInt::one()),
        Err(_) => (top << down.unsigned_abs(), BigInt::one()),
    };
    Ok(Value::tuple_from([Value::int(top), Value::int(bottom)]))
}

fn hex(f: f64) -> String {
    let sign = if f.is_sign_negative() && !f.is_nan() {
        "-"
    } else {
        ""
    };
    if !f.is_finite() {
        return display::to_str(&Value::Float(f))
            .unwrap_or_default()
            .to_string();
    }
    if f == 0.0 {
        return format!("{sign}0x0.0p+0");
    }
    let (mantissa, exponent, _) = decode(f);
    // A subnormal number has no leading one.
    let (whole, fraction) = (mantissa >> 52, mantissa & ((1 << 52) - 1));
    format!("{sign}0x{whole}.{fraction:013x}p{:+}", exponent + 52)
}

fn from_hex(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let Value::Str(text) = args.at(0) else {
        return Err(Stop::typ("bad argument type for built-in operation"));
    };
    let invalid = || Stop::value("invalid hexadecimal floating-point string");
    let text = text.trim_matches(|c: char| c.is_ascii_whitespace() || c == '\x0b');
    let (negative, rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let magnitude = match rest.to_ascii_lowercase().as_str() {
        "inf" | "infinity" => f64::INFINITY,
        "nan" => f64::NAN,
        rest => hex_magnitude(rest).ok_or_else(invalid)?,
    };
    if magnitude.is_infinite() && !rest.to_ascii_lowercase().starts_with("inf") {
        return Err(Stop::overflow(
            "hexadecimal value too large to represent as a float",
        ));
    }
    Ok(Value::Float(if negative { -magnitude } else { magnitude }))
}

/// Lower-case text without sign.
fn hex_magnitude(text: &str) -> Option<f64> {
    let text = text.strip_prefix("0x").unwrap_or(text);
    let (digits, exponent) = match text.split_once('p') {
        Some((digits, exponent)) => (digits, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let (mut mantissa, mut dropped, mut sticky) = (0u64, 0i64, false);
    for c in whole.chars().chain(fraction.chars()) {
        let digit = u64::from(c.to_digit(16)?);
        if mantissa >> 58 == 0 {
            mantissa = mantissa << 4 | digit;
        } else {
            dropped += 1;
            sticky |= digit != 0;
        }
    }
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    let shift = exponent.checked_add((dropped - i64::try_from(fraction.len()).ok()?) * 4)?;
    // One more bit remembers whether something was cut off.
    Some(scale_by(
        mantissa << 1 | u64::from(sticky),
        shift.clamp(-10_000, 10_000) - 1,
    ))
}
