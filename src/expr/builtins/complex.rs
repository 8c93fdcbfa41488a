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
    let part = |value: Option<&Value>, place: &str| match value {
        None => Ok((0.0, 0.0)),
        Some(value) => match Num::of(value) {
            Some(number) => number.complex(),
            None => {
                let kind = value.type_name();
                let a = if place == "first" {
                    "a string or a number"
                } else {
                    "a number"
                };
                Err(Stop::typ(format!(
                    "complex() {place} argument must be {a}, not '{kind}'"
                )))
            }
        },
    };
    let (re, im) = (part(first, "first")?, part(second, "second")?);
    // A complex argument brings along a part for the other side: x + (a + bj)j.
    let is_complex = |value| matches!(value, Some(&Value::Complex(..)));
    let real = if is_complex(second) {
        re.0 - im.1
    } else {
        re.0
    };
    let imaginary = if is_complex(first) { re.1 + im.0 } else { im.0 };
    Ok(Value::Complex(real, imaginary))
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
    let imaginary = |part: &str| match part {
        "" | "+" => Some(1.0),
        "-" => Some(-1.0),
        part => parse_float(part),
    };
    // The last sign that does not belong to an exponent separates the parts.
    let sign = body.char_indices().rev().find(|&(i, c)| {
        let exponent = body
            .get(..i)
            .is_some_and(|before| before.ends_with(['e', 'E']));
        i > 0 && (c == '+' || c == '-') && !exponent
    });
    match sign {
        Some((at, _)) => Some((parse_float(body.get(..at)?)?, imaginary(body.get(at..)?)?)),
        None => Some((0.0, imaginary(body)?)),
    }
}
