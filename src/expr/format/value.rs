//! `format(value, spec)` for any value.

use super::spec::{Spec, parse, unknown_code};
use super::{float, int};
use crate::interp::Interp;
use crate::numeric::Num;
use crate::stop::{Eval, Stop};
use crate::value::{Str, Value};

/// `format(value, spec)`
pub(super) fn format(interp: &mut Interp, value: &Value, spec: &str) -> Eval<Str> {
    if value.is_unknown() {
        return Err(Stop::Unknown);
    }
    if spec.is_empty() {
        return interp.text(value);
    }
    let kind = value.type_name();
    let text = match (value, Num::of(value)) {
        (Value::Str(text), _) => format_text(interp, text, &parse(spec, kind, false)?)?,
        (_, Some(number)) => format_number(interp, number, &parse(spec, kind, true)?, kind)?,
        (Value::Date(_), _) => return Err(Stop::Unknown),
        _ => {
            return Err(Stop::typ(format!(
                "unsupported format string passed to {kind}.__format__"
            )));
        }
    };
    Ok(text.into())
}

fn format_number(interp: &mut Interp, number: Num<'_>, spec: &Spec, kind: &str) -> Eval<String> {
    match number {
        Num::Complex(re, im) => float::format_complex(interp, re, im, spec),
        Num::Float(f) => float::format(interp, f, spec, kind),
        integer => match spec.kind {
            Some('e' | 'E' | 'f' | 'F' | 'g' | 'G' | '%') => {
                let f = integer.float()?.unwrap_or(f64::NAN);
                float::format(interp, f, spec, kind)
            }
            Some(code) if !"bcdnoxX".contains(code) => Err(unknown_code(code, kind)),
            _ => int::format(interp, &integer.big().unwrap_or_default(), spec),
        },
    }
}

fn format_text(interp: &mut Interp, text: &str, spec: &Spec) -> Eval<String> {
    if let Some(code) = spec.kind.filter(|&code| code != 's') {
        return Err(unknown_code(code, "str"));
    }
    match spec.sign {
        Some(' ') => return Err(Stop::value("Space not allowed in string format specifier")),
        Some(_) => return Err(Stop::value("Sign not allowed in string format specifier")),
        None => {}
    }
    if spec.no_negative_zero {
        return Err(Stop::value(
            "Negative zero coercion (z) not allowed in string format specifier",
        ));
    }
    if spec.alternate {
        return Err(Stop::value(
            "Alternate form (#) not allowed in string format specifier",
        ));
    }
    if spec.align == Some('=') {
        return Err(Stop::value(
            "'=' alignment not allowed in string format specifier",
        ));
    }
    let text: String = text
        .chars()
        .take(spec.precision.unwrap_or(usize::MAX))
        .collect();
    let parts = int::NumberParts {
        whole: text,
        ..int::NumberParts::default()
    };
    let align = spec.align.or(Some('<'));
    int::lay_out(
        interp,
        &parts,
        &Spec {
            align,
            ..spec.clone()
        },
        3,
    )
}
