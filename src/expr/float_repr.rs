//! Python's `repr()` of floats and the decimal digits behind it.

/// The shortest text that reads back as the same float, in Python's notation.
pub(crate) fn repr(value: f64) -> String {
    let mut text = String::new();
    push_repr(&mut text, value);
    text
}

/// Append what [`repr`] gives.
pub(crate) fn push_repr(out: &mut String, value: f64) {
    let magnitude = value.abs();
    if (1e-4..1e16).contains(&magnitude) || value == 0.0 {
        return out.push_str(ryu::Buffer::new().format_finite(value));
    }
    if value.is_nan() {
        return out.push_str("nan");
    }
    if value < 0.0 {
        out.push('-');
    }
    if value.is_infinite() {
        return out.push_str("inf");
    }
    let (digits, point) = shortest(magnitude);
    out.push_str(&scientific(&digits, point, 'e'));
}

/// The shortest digits of a positive finite float, and the place of the decimal point counted from their start.
pub(crate) fn shortest(magnitude: f64) -> (String, i32) {
    split_scientific(&format!("{magnitude:e}"))
}

/// `d.ddde±xx` of digits whose decimal point stands behind `point` of them.
pub(crate) fn scientific(digits: &str, point: i32, letter: char) -> String {
    let (first, rest) = digits.split_at(digits.len().min(1));
    let dot = if rest.is_empty() { "" } else { "." };
    let exponent = point - 1;
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{first}{dot}{rest}{letter}{sign}{:02}", exponent.abs())
}

/// Digits and decimal point of Rust's `1.25e-7`.
fn split_scientific(text: &str) -> (String, i32) {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    (
        mantissa.replace('.', ""),
        exponent.parse::<i32>().unwrap_or(0) + 1,
    )
}

/// Precision behind which the digits of every double are zeros.
const EXACT: usize = 1100;

/// Correctly rounded to `precision` digits behind the first one: the digits and the place of the point.
pub(crate) fn digits_scientific(magnitude: f64, precision: usize) -> (String, i32) {
    let exact = precision.min(EXACT);
    let (mut digits, point) = split_scientific(&format!("{magnitude:.exact$e}"));
    digits.extend(std::iter::repeat_n('0', precision - exact));
    (digits, point)
}

/// Correctly rounded to `precision` digits behind the point, plain notation.
pub(crate) fn fixed(magnitude: f64, precision: usize) -> String {
    let exact = precision.min(EXACT);
    let mut text = format!("{magnitude:.exact$}");
    text.extend(std::iter::repeat_n('0', precision - exact));
    text
}
