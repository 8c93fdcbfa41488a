//! Formatting of integers, and the layout all numbers share.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

use super::spec::Spec;
use crate::display::big_text;
use crate::interp::Interp;
use crate::stop::{Eval, Stop};

/// A number ready for layout.
#[derive(Debug, Default)]
pub(super) struct NumberParts {
    pub(super) negative: bool,
    /// `0x` and the like.
    pub(super) prefix: &'static str,
    /// Digits before the point.
    pub(super) whole: String,
    /// The point and everything behind it.
    pub(super) rest: String,
    /// Whether grouping and zero padding apply (not to `inf`).
    pub(super) is_number: bool,
}

/// An integer as the specification asks.
pub(super) fn format(interp: &mut Interp, number: &BigInt, spec: &Spec) -> Eval<String> {
    if spec.precision.is_some() {
        return Err(Stop::value(
            "Precision not allowed in integer format specifier",
        ));
    }
    if spec.no_negative_zero {
        return Err(Stop::value(
            "Negative zero coercion (z) not allowed in integer format specifier",
        ));
    }
    let kind = spec.kind.unwrap_or('d');
    if kind == 'c' {
        return character(interp, number, spec);
    }
    let (prefix, whole) = digits(number, kind)?;
    let prefix = if spec.alternate { prefix } else { "" };
    let group = if matches!(kind, 'b' | 'o' | 'x' | 'X') {
        4
    } else {
        3
    };
    let parts = NumberParts {
        negative: number.is_negative(),
        prefix,
        whole,
        rest: String::new(),
        is_number: true,
    };
    lay_out(interp, &parts, spec, group)
}

/// Prefix of the alternate form, and the digits.
fn digits(number: &BigInt, kind: char) -> Eval<(&'static str, String)> {
    let magnitude = number.magnitude();
    Ok(match kind {
        'b' => ("0b", format!("{magnitude:b}")),
        'o' => ("0o", format!("{magnitude:o}")),
        'x' => ("0x", format!("{magnitude:x}")),
        'X' => ("0X", format!("{magnitude:X}")),
        _ => ("", big_text(&BigInt::from(magnitude.clone()))?),
    })
}

fn character(interp: &mut Interp, number: &BigInt, spec: &Spec) -> Eval<String> {
    if spec.sign.is_some() {
        return Err(Stop::value(
            "Sign not allowed with integer format specifier 'c'",
        ));
    }
    if spec.alternate {
        return Err(Stop::value(
            "Alternate form (#) not allowed with integer format specifier 'c'",
        ));
    }
    if number.to_i64().is_none() {
        return Err(Stop::overflow("Python int too large to convert to C long"));
    }
    let code = number.to_u32().filter(|&code| code < 0x11_0000);
    let code = code.ok_or_else(|| Stop::overflow("%c arg not in range(0x110000)"))?;
    let whole = char::from_u32(code).unwrap_or('\u{fffd}').to_string();
    lay_out(
        interp,
        &NumberParts {
            whole,
            ..NumberParts::default()
        },
        spec,
        3,
    )
}

/// Digits in groups, at least `width` characters with their separators.
fn grouped(digits: &str, separator: char, group: usize, width: usize) -> String {
    let mut reversed = String::new();
    let mut count = 0;
    let mut source = digits.chars().rev();
    loop {
        let next = source.next();
        if next.is_none() && reversed.len() >= width {
            break;
        }
        if count > 0 && count % group == 0 {
            reversed.push(separator);
        }
        reversed.push(next.unwrap_or('0'));
        count += 1;
    }
    reversed.chars().rev().collect()
}

/// Sign, padding and grouping.
pub(super) fn lay_out(
    interp: &mut Interp,
    parts: &NumberParts,
    spec: &Spec,
    group: usize,
) -> Eval<String> {
    let unpadded = parts.whole.len() + parts.rest.len() + 8;
    interp
        .budget
        .text(spec.width.max(unpadded) as u128 * spec.fill.len_utf8() as u128 * 2)?;
    let sign = match (parts.negative, spec.sign) {
        (true, _) => "-",
        (false, Some('+')) => "+",
        (false, Some(' ')) => " ",
        _ => "",
    };
    let head = sign.len() + parts.prefix.len();
    let align = spec.align.unwrap_or('>');
    let zeros = align == '=' && spec.fill == '0' && parts.is_number;
    let whole = match spec.grouping {
        Some(separator) if parts.is_number => {
            let width = if zeros {
                spec.width.saturating_sub(head + parts.rest.chars().count())
            } else {
                0
            };
            grouped(&parts.whole, separator, group, width)
        }
        _ => parts.whole.clone(),
    };
    let length = head + whole.chars().count() + parts.rest.chars().count();
    let missing = spec.width.saturating_sub(length);
    let (left, inner, right) = match align {
        '<' => (0, 0, missing),
        '^' => (missing / 2, 0, missing - missing / 2),
        '=' => (0, missing, 0),
        _ => (missing, 0, 0),
    };
    let mut out = String::new();
    out.extend(std::iter::repeat_n(spec.fill, left));
    out.push_str(sign);
    out.push_str(parts.prefix);
    out.extend(std::iter::repeat_n(spec.fill, inner));
    out.push_str(&whole);
    out.push_str(&parts.rest);
    out.extend(std::iter::repeat_n(spec.fill, right));
    Ok(out)
}
