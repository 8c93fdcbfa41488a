//! `text % values`

use super::float::{self, Style};
use super::template::ascii;
use crate::builtins::integer;
use crate::display;
use crate::interp::Interp;
use crate::numeric::{Num, float_to_int};
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// `format % values`
pub(crate) fn percent(interp: &mut Interp, format: &Value, values: &Value) -> Eval {
    let format: Vec<char> = format.as_str().ok_or(Stop::Unknown)?.chars().collect();
    let mut run = PercentFormatter::new(&format, values);
    let mut out = String::new();
    while let Some(c) = run.next() {
        if c != '%' {
            out.push(c);
            continue;
        }
        let directive = run.directive(interp)?;
        let text = run.convert(interp, &directive)?;
        interp
            .budget
            .text(text.len().max(directive.width) as u128 * 2)?;
        interp.budget.grown(out.len() + text.len())?;
        out.push_str(&text);
    }
    run.finish()?;
    interp.budget.text(out.len() as u128)?;
    Ok(Value::from(out))
}

#[derive(Default)]
struct ConversionSpec {
    left: bool,
    plus: bool,
    blank: bool,
    alternate: bool,
    zero: bool,
    width: usize,
    precision: Option<usize>,
    kind: char,
    /// Place of the type character.
    place: usize,
}

struct PercentFormatter<'a> {
    format: &'a [char],
    at: usize,
    values: &'a Value,
    /// The values one after the other; a single value is one that can be used once.
    items: Vec<Value>,
    used: usize,
    by_key: bool,
}

impl<'a> PercentFormatter<'a> {
    fn new(format: &'a [char], values: &'a Value) -> Self {
        let items = match values {
            Value::Tuple(tuple) => tuple.items().to_vec(),
            other => vec![other.clone()],
        };
        Self {
            format,
            at: 0,
            values,
            items,
            used: 0,
            by_key: false,
        }
    }

    fn next(&mut self) -> Option<char> {
        let c = self.format.get(self.at).copied()?;
        self.at += 1;
        Some(c)
    }

    fn need(&mut self) -> Eval<char> {
        self.next().ok_or_else(|| Stop::value("incomplete format"))
    }

    fn value(&mut self) -> Eval {
        let value = self.items.get(self.used).cloned();
        self.used += 1;
        value
            .ok_or_else(|| Stop::typ("not enough arguments for format string"))?
            .known()
    }

    /// Whether values can be taken by key.
    fn is_mapping(&self) -> bool {
        !matches!(self.values, Value::Tuple(_) | Value::Str(_))
            && matches!(
                self.values,
                Value::Dict(_)
                    | Value::Module(_)
                    | Value::Scope(_)
                    | Value::List(_)
                    | Value::Range(_)
                    | Value::Bytes(_)
            )
    }

    /// A mapping or list need not be used up.
    fn finish(&self) -> Eval<()> {
        let optional = self.by_key || self.is_mapping();
        if self.used < self.items.len() && !optional {
            return Err(Stop::typ(
                "not all arguments converted during string formatting",
            ));
        }
        Ok(())
    }

    fn directive(&mut self, interp: &mut Interp) -> Eval<ConversionSpec> {
        let mut directive = ConversionSpec::default();
        let mut c = self.need()?;
        if c == '(' {
            self.keyed(interp)?;
            c = self.need()?;
        }
        loop {
            match c {
                '-' => directive.left = true,
                '+' => directive.plus = true,
                ' ' => directive.blank = true,
                '#' => directive.alternate = true,
                '0' => directive.zero = true,
                _ => break,
            }
            c = self.need()?;
        }
        if c == '*' {
            let width = self.star("* wants int")?;
            directive.left |= width < 0;
            directive.width = usize::try_from(width.unsigned_abs()).unwrap_or(usize::MAX);
            c = self.need()?;
        } else {
            (directive.width, c) = self.number(c, "width too big")?;
        }
        if c == '.' {
            c = self.need()?;
            if c == '*' {
                let precision = self.star("* wants int")?;
                directive.precision = Some(usize::try_from(precision).unwrap_or(0));
                c = self.need()?;
            } else {
                let precision;
                (precision, c) = self.number(c, "precision too big")?;
                directive.precision = Some(precision);
            }
        }
        if matches!(c, 'h' | 'l' | 'L') {
            c = self.need()?;
        }
        (directive.kind, directive.place) = (c, self.at - 1);
        Ok(directive)
    }

    /// Take the value under the key in parentheses as the only one left.
    fn keyed(&mut self, interp: &mut Interp) -> Eval<()> {
        if !self.is_mapping() {
            return Err(Stop::typ("format requires a mapping"));
        }
        let start = self.at;
        let mut open = 1;
        while open > 0 {
            match self.next() {
                Some('(') => open += 1,
                Some(')') => open -= 1,
                Some(_) => {}
                None => return Err(Stop::value("incomplete format key")),
            }
        }
        let key: String = self
            .format
            .get(start..self.at - 1)
            .unwrap_or(&[])
            .iter()
            .collect();
        self.by_key = true;
        self.items = vec![ops::subscript(interp, self.values, &Value::from(key))?.known()?];
        self.used = 0;
        Ok(())
    }

    fn star(&mut self, message: &str) -> Eval<i128> {
        let value = self.value()?;
        let number = ops::as_index(&value).ok_or_else(|| Stop::typ(message))?;
        match i32::try_from(number) {
            Ok(_) => Ok(number),
            Err(_) => Err(Stop::overflow("Python int too large to convert to C int")),
        }
    }

    /// A number that starts with `c`, and the character behind it.
    fn number(&mut self, mut c: char, too_big: &str) -> Eval<(usize, char)> {
        let mut number = 0usize;
        while let Some(digit) = c.to_digit(10) {
            number = number.saturating_mul(10).saturating_add(digit as usize);
            if number > i32::MAX as usize {
                return Err(Stop::value(too_big));
            }
            c = self.need()?;
        }
        Ok((number, c))
    }

    fn convert(&mut self, interp: &mut Interp, directive: &ConversionSpec) -> Eval<String> {
        if directive.kind == '%' {
            return Ok("%".to_owned());
        }
        let value = self.value()?;
        match directive.kind {
            's' | 'r' | 'a' => text(interp, &value, directive),
            'd' | 'i' | 'u' | 'o' | 'x' | 'X' => whole(interp, &value, directive),
            'e' | 'E' | 'f' | 'F' | 'g' | 'G' => real(interp, &value, directive),
            'c' => character(interp, &value, directive),
            other => {
                let shown = if (' '..='\u{7e}').contains(&other) {
                    other
                } else {
                    '?'
                };
                let (code, place) = (u32::from(other), directive.place);
                Err(Stop::value(format!(
                    "unsupported format character '{shown}' (0x{code:x}) at index {place}"
                )))
            }
        }
    }
}

/// Text padded to the width.
fn padded(interp: &mut Interp, text: String, directive: &ConversionSpec) -> Eval<String> {
    let missing = if directive.width == 0 {
        0
    } else {
        directive.width.saturating_sub(text.chars().count())
    };
    if missing == 0 {
        return Ok(text);
    }
    interp.budget.text(directive.width as u128)?;
    let blanks = " ".repeat(missing);
    Ok(if directive.left {
        text + &blanks
    } else {
        blanks + &text
    })
}

fn text(interp: &mut Interp, value: &Value, directive: &ConversionSpec) -> Eval<String> {
    let text = match directive.kind {
        's' => interp.text(value)?,
        'r' => interp.repr(value)?,
        _ => ascii(&interp.repr(value)?),
    };
    let text = match directive.precision {
        Some(precision) => text.chars().take(precision).collect(),
        None => text.to_string(),
    };
    padded(interp, text, directive)
}

fn character(interp: &mut Interp, value: &Value, directive: &ConversionSpec) -> Eval<String> {
    let text = match value {
        Value::Str(text) if text.chars().count() == 1 => text.to_string(),
        Value::Int(_) | Value::Big(_) | Value::Bool(_) => {
            let code = u32::try_from(integer(value)?)
                .ok()
                .filter(|&code| code < 0x11_0000);
            let code = code.ok_or_else(|| Stop::overflow("%c arg not in range(0x110000)"))?;
            char::from_u32(code).unwrap_or('\u{fffd}').to_string()
        }
        _ => return Err(Stop::typ("%c requires int or char")),
    };
    padded(interp, text, directive)
}

/// Sign and digits, with zeros between them if asked for.
fn number(
    interp: &mut Interp,
    negative: bool,
    prefix: &str,
    digits: &str,
    directive: &ConversionSpec,
) -> Eval<String> {
    let sign = match () {
        () if negative => "-",
        () if directive.plus => "+",
        () if directive.blank => " ",
        () => "",
    };
    let head = format!("{sign}{prefix}");
    let missing = directive.width.saturating_sub(head.len() + digits.len());
    if directive.zero && !directive.left {
        interp.budget.text(directive.width as u128)?;
        return Ok(format!("{head}{}{digits}", "0".repeat(missing)));
    }
    padded(interp, format!("{head}{digits}"), directive)
}

fn whole(interp: &mut Interp, value: &Value, directive: &ConversionSpec) -> Eval<String> {
    let kind = directive.kind;
    let decimal = matches!(kind, 'd' | 'i' | 'u');
    let value = match value {
        Value::Float(f) if decimal => float_to_int(*f)?,
        other => other.clone(),
    };
    let Some(big) = Num::of(&value).and_then(Num::big) else {
        let (wanted, got) = (
            if decimal {
                "a real number"
            } else {
                "an integer"
            },
            value.type_name(),
        );
        return Err(Stop::typ(format!(
            "%{kind} format: {wanted} is required, not {got}"
        )));
    };
    let magnitude = big.magnitude();
    let (prefix, mut digits) = match kind {
        'o' => ("0o", format!("{magnitude:o}")),
        'x' => ("0x", format!("{magnitude:x}")),
        'X' => ("0X", format!("{magnitude:X}")),
        _ => (
            "",
            display::big_text(&num_bigint::BigInt::from(magnitude.clone()))?,
        ),
    };
    let prefix = if directive.alternate { prefix } else { "" };
    if let Some(precision) = directive
        .precision
        .filter(|&precision| precision > digits.len())
    {
        interp.budget.text(precision as u128)?;
        digits.insert_str(0, &"0".repeat(precision - digits.len()));
    }
    number(
        interp,
        big.sign() == num_bigint::Sign::Minus,
        prefix,
        &digits,
        directive,
    )
}

fn real(interp: &mut Interp, value: &Value, directive: &ConversionSpec) -> Eval<String> {
    let float = match Num::of(value).map(Num::float).transpose()?.flatten() {
        Some(float) => float,
        None => {
            return Err(Stop::typ(format!(
                "must be real number, not {}",
                value.type_name()
            )));
        }
    };
    let style = match directive.kind.to_ascii_lowercase() {
        'e' => Style::Scientific,
        'f' => Style::Fixed,
        _ => Style::General,
    };
    let text = float::digits(
        interp,
        float.abs(),
        style,
        directive.precision,
        directive.alternate,
    )?;
    let text = if directive.kind.is_ascii_uppercase() {
        text.to_ascii_uppercase()
    } else {
        text
    };
    let negative = float.is_sign_negative() && !float.is_nan();
    number(interp, negative, "", &text, directive)
}
