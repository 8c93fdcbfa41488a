//! Formatting of floats and complex numbers.

use super::int::{NumberParts, lay_out};
use super::spec::{Spec, unknown_code};
use crate::float_repr;
use crate::interp::Interp;
use crate::stop::{Eval, Stop};

/// A float as the specification asks.
pub(super) fn format(
    interp: &mut Interp,
    number: f64,
    spec: &Spec,
    type_name: &str,
) -> Eval<String> {
    let parts = parts(interp, number, spec, type_name)?;
    lay_out(interp, &parts, spec, 3)
}

fn parts(interp: &mut Interp, number: f64, spec: &Spec, type_name: &str) -> Eval<NumberParts> {
    let percent = spec.kind == Some('%');
    let number = if percent { number * 100.0 } else { number };
    let style = match spec.kind {
        None => Style::Repr,
        Some('e' | 'E') => Style::Scientific,
        Some('f' | 'F' | '%') => Style::Fixed,
        Some('g' | 'G' | 'n') => Style::General,
        Some(other) => return Err(unknown_code(other, type_name)),
    };
    let text = digits(interp, number.abs(), style, spec.precision, spec.alternate)?;
    let text = if spec.kind.is_some_and(|kind| kind.is_ascii_uppercase()) {
        text.to_ascii_uppercase()
    } else {
        text
    };
    let mut negative = number.is_sign_negative() && !number.is_nan();
    if spec.no_negative_zero
        && !text
            .bytes()
            .take_while(|b| !matches!(b, b'e' | b'E'))
            .any(|b| matches!(b, b'1'..=b'9' | b'n' | b'N'))
    {
        negative = false;
    }
    let end = text
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(text.len());
    let is_number = number.is_finite();
    let (whole, rest) = if is_number {
        text.split_at(end)
    } else {
        (text.as_str(), "")
    };
    let rest = format!("{rest}{}", if percent { "%" } else { "" });
    Ok(NumberParts {
        negative,
        prefix: "",
        whole: whole.to_owned(),
        rest,
        is_number,
    })
}

/// How the digits of a float are shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// `1e-05`
    Scientific,
    /// `0.00001`
    Fixed,
    /// Whichever is shorter, without trailing zeros.
    General,
    /// Like general, but at least one digit behind the point; without precision the shortest that reads back.
    Repr,
}

/// The text of a float that is not negative.
pub(super) fn digits(
    interp: &mut Interp,
    magnitude: f64,
    style: Style,
    precision: Option<usize>,
    alternate: bool,
) -> Eval<String> {
    if !magnitude.is_finite() {
        return Ok(float_repr::repr(magnitude));
    }
    let places = precision.unwrap_or(6);
    if places > i32::MAX as usize {
        return Err(Stop::value("precision too big"));
    }
    interp.budget.text(places as u128 + 320)?;
    Ok(match style {
        Style::Fixed => {
            let text = float_repr::fixed(magnitude, places);
            if alternate && places == 0 {
                text + "."
            } else {
                text
            }
        }
        Style::Scientific => {
            let (digits, point) = float_repr::digits_scientific(magnitude, places);
            let text =
                float_repr::scientific(&digits, if magnitude == 0.0 { 1 } else { point }, 'e');
            if alternate && places == 0 {
                text.replacen('e', ".e", 1)
            } else {
                text
            }
        }
        Style::Repr if precision.is_none() => shortest(magnitude, alternate),
        Style::General | Style::Repr => general(magnitude, places.max(1), style, alternate),
    })
}

/// The shortest text; the alternate form always has a point.
fn shortest(magnitude: f64, alternate: bool) -> String {
    let text = float_repr::repr(magnitude);
    if alternate && !text.contains('.') {
        text.replacen('e', ".e", 1)
    } else {
        text
    }
}

/// `%g` with so many significant digits.
fn general(magnitude: f64, significant: usize, style: Style, alternate: bool) -> String {
    let (digits, point) = float_repr::digits_scientific(magnitude, significant - 1);
    let point = if magnitude == 0.0 { 1 } else { point };
    let limit = i32::try_from(significant).unwrap_or(i32::MAX);
    // The form with a point behind all digits would claim one digit more than asked for.
    let limit = if style == Style::Repr {
        limit - 1
    } else {
        limit
    };
    let scientific = point <= -4 || point > limit;
    let digits = if alternate {
        digits.as_str()
    } else {
        digits.trim_end_matches('0')
    };
    let digits = if digits.is_empty() { "0" } else { digits };
    if scientific {
        let text = float_repr::scientific(digits, point, 'e');
        return if alternate && digits.len() == 1 {
            text.replacen('e', ".e", 1)
        } else {
            text
        };
    }
    plain(digits, point, style == Style::Repr, alternate)
}

/// Digits in plain notation with the point behind `point` of them.
fn plain(digits: &str, point: i32, keep_fraction: bool, keep_point: bool) -> String {
    let Ok(before) = usize::try_from(point) else {
        return format!("0.{}{digits}", "0".repeat(point.unsigned_abs() as usize));
    };
    if before == 0 {
        return format!("0.{digits}");
    }
    if before < digits.len() {
        let (whole, fraction) = digits.split_at(before);
        return format!("{whole}.{fraction}");
    }
    let zeros = "0".repeat(before - digits.len());
    let tail = match (keep_fraction, keep_point) {
        (true, _) => ".0",
        (false, true) => ".",
        _ => "",
    };
    format!("{digits}{zeros}{tail}")
}

/// A complex number as the specification asks.
pub(super) fn format_complex(interp: &mut Interp, re: f64, im: f64, spec: &Spec) -> Eval<String> {
    if let Some(code) = spec.kind.filter(|code| !"eEfFgGn".contains(*code)) {
        return Err(unknown_code(code, "complex"));
    }
    if spec.fill == '0' {
        return Err(Stop::value(
            "Zero padding is not allowed in complex format specifier",
        ));
    }
    if spec.align == Some('=') {
        return Err(Stop::value(
            "'=' alignment flag is not allowed in complex format specifier",
        ));
    }
    let bare = Spec {
        width: 0,
        align: None,
        fill: ' ',
        kind: spec.kind.or(Some('g')),
        ..spec.clone()
    };
    let own = spec.kind.is_none();
    let signed = Spec {
        sign: Some('+'),
        ..bare.clone()
    };
    let imaginary = complex_part(interp, im, &signed, own);
    let text = if own && re == 0.0 && re.is_sign_positive() {
        format!("{}j", complex_part(interp, im, &bare, own)?)
    } else if own {
        format!("({}{}j)", complex_part(interp, re, &bare, own)?, imaginary?)
    } else {
        format!("{}{}j", complex_part(interp, re, &bare, own)?, imaginary?)
    };
    lay_out(
        interp,
        &NumberParts {
            whole: text,
            ..NumberParts::default()
        },
        &Spec {
            sign: None,
            grouping: None,
            ..spec.clone()
        },
        3,
    )
}

/// A part of a complex number; without a precision in a style of its own where the specification names none.
fn complex_part(interp: &mut Interp, value: f64, spec: &Spec, own: bool) -> Eval<String> {
    if !own || spec.precision.is_some() {
        return format(interp, value, spec, "complex");
    }
    let text = float_repr::repr(value.abs());
    let point = if spec.alternate { "." } else { "" };
    let text = text
        .strip_suffix(".0")
        .map_or(text.clone(), |whole| format!("{whole}{point}"));
    let parts = NumberParts {
        negative: value.is_sign_negative(),
        whole: text,
        is_number: false,
        ..NumberParts::default()
    };
    lay_out(interp, &parts, spec, 3)
}
