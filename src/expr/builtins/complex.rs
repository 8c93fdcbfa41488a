//! `complex()`

use crate::args::Args;
use crate::numeric::{Num, is_space, parse_float};
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// `complex(real, imag)`
pub(super) fn construct(args: &Args) -> Eval {
    let (first, second) = (args.get(0), args.get(1));
    if let Some(Value::Str(text)) = first {
        if second.is_some() {
            return Err(Stop::typ(
                "complex() can't take second arg if first is a string",
            ));
        }
        let malformed = || Stop::value("complex() arg is a malformed string");
        return parse_complex(text)
            .map(|(re, im)| Value::Complex(re, im))
            .ok_or_else(malformed);
    }
    if let Some(Value::Str(_)) = second {
        return Err(Stop::typ("complex() second arg can't be a string"));
    }
    let re = argument(first, "first", "a string or a number")?;
    let im = argument(second, "second", "a number")?;
    // A complex argument brings along a part for the other side: x + (a + bj)j.
    let real = if is_complex(second) {
        re.0 - im.1
    } else {
        re.0
    };
    let imaginary = if is_complex(first) { re.1 + im.0 } else { im.0 };
    Ok(Value::Complex(real, imaginary))
}

/// Both parts of an argument, which has to be `wanted`; zero when there is none.
fn argument(value: Option<&Value>, place: &str, wanted: &str) -> Eval<(f64, f64)> {
    let Some(value) = value else {
        return Ok((0.0, 0.0));
    };
    match Num::of(value) {
        Some(number) => number.complex(),
        None => {
            let kind = value.type_name();
            Err(Stop::typ(format!(
                "complex() {place} argument must be {wanted}, not '{kind}'"
            )))
        }
    }
}

fn is_complex(value: Option<&Value>) -> bool {
    matches!(value, Some(Value::Complex(..)))
}

fn parse_complex(text: &str) -> Option<(f64, f64)> {
    let text = text.trim_matches(is_space);
    let text = match text.strip_prefix('(') {
        Some(inner) => inner.strip_suffix(')')?.trim_matches(is_space),
        None => text,
    };
    let Some(body) = text.strip_suffix(['j', 'J']) else {
        return parse_float(text).map(|re| (re, 0.0));
    };
    // The last sign that does not belong to an exponent separates the parts.
    let sign = body.char_indices().rev().find(|&(i, c)| {
        let exponent = body
            .get(..i)
            .is_some_and(|before| before.ends_with(['e', 'E']));
        i > 0 && (c == '+' || c == '-') && !exponent
    });
    match sign {
        Some((at, _)) => Some((
            parse_float(body.get(..at)?)?,
            imaginary_part(body.get(at..)?)?,
        )),
        None => Some((0.0, imaginary_part(body)?)),
    }
}

/// What stands in front of the `j`; a sign alone, or nothing, is a one.
fn imaginary_part(text: &str) -> Option<f64> {
    match text {
        "" | "+" => Some(1.0),
        "-" => Some(-1.0),
        number => parse_float(number),
    }
}
