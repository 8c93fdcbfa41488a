//! `str.format`, `str.format_map` and f-strings.

use super::value::format;
use crate::args::Args;
use crate::ast::FPart;
use crate::host::ErrorKind;
use crate::interp::Interp;
use crate::ops;
use crate::quote;
use crate::stop::{Eval, Stop};
use crate::value::{Str, Value};

/// An f-string.
pub(crate) fn fstring(interp: &mut Interp, parts: &[FPart]) -> Eval<Str> {
    let mut out = Str::new();
    for part in parts {
        match part {
            FPart::Text(text) => out.push_str(text),
            FPart::Field {
                value,
                conversion,
                spec,
                debug,
            } => {
                out.push_str(debug.as_deref().unwrap_or(""));
                let value = interp.eval(value)?.known()?;
                let spec = fstring(interp, spec)?;
                // The debugging form shows the repr unless told otherwise.
                let conversion = conversion.or((debug.is_some() && spec.is_empty()).then_some('r'));
                let value = convert(interp, value, conversion)?;
                out.push_str(&format(interp, &value, &spec)?);
            }
        }
        interp.budget.grown(out.len())?;
    }
    Ok(out)
}

/// `!s`, `!r`, `!a`
fn convert(interp: &mut Interp, value: Value, conversion: Option<char>) -> Eval {
    Ok(match conversion {
        None => value,
        Some('s') => Value::Str(interp.text(&value)?),
        Some('r') => Value::Str(interp.repr(&value)?),
        Some('a') => Value::Str(ascii(&interp.repr(&value)?)),
        Some(other) if other.is_ascii_graphic() => {
            return Err(Stop::value(format!("Unknown conversion specifier {other}")));
        }
        Some(other) => {
            return Err(Stop::value(format!(
                "Unknown conversion specifier \\x{:x}",
                u32::from(other)
            )));
        }
    })
}

/// Python's `ascii()` of a text that is a `repr` already.
pub(crate) fn ascii(text: &str) -> Str {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_ascii() {
            out.push(c)
        } else {
            quote::push_escape(&mut out, c)
        }
    }
    out.into()
}

/// `text.format(*args, **named)`
pub(crate) fn str_format(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    expand(interp, text, FieldSource::Args(args))
}

/// `text.format_map(mapping)`
pub(crate) fn str_format_map(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    expand(interp, text, FieldSource::Mapping(args.at(0)))
}

fn expand(interp: &mut Interp, text: &Value, source: FieldSource<'_>) -> Eval {
    let text: Vec<char> = text.as_str().ok_or(Stop::Unknown)?.chars().collect();
    let mut template = FormatString {
        source,
        next: 0,
        numbered: None,
    };
    template.expand(interp, &text, 2).map(Value::from)
}

/// Where the fields find their values.
#[derive(Clone, Copy)]
enum FieldSource<'a> {
    Args(&'a Args),
    Mapping(&'a Value),
}

struct FormatString<'a> {
    source: FieldSource<'a>,
    /// The number of the next field without one.
    next: usize,
    /// Whether fields carry numbers; the two ways cannot be mixed.
    numbered: Option<bool>,
}

/// What stands between the braces.
struct Field<'t> {
    name: &'t [char],
    conversion: Option<char>,
    spec: &'t [char],
    /// Whether a `:` was there.
    behind: usize,
}

impl FormatString<'_> {
    /// The text with its fields filled in; `depth` more levels of nesting are allowed.
    fn expand(&mut self, interp: &mut Interp, text: &[char], depth: u32) -> Eval<String> {
        if depth == 0 {
            return Err(Stop::value("Max string recursion exceeded"));
        }
        let mut out = String::new();
        let mut at = 0;
        while let Some(&c) = text.get(at) {
            let doubled = text.get(at + 1) == Some(&c);
            match c {
                '{' | '}' if doubled => {
                    out.push(c);
                    at += 2;
                }
                '}' => return Err(Stop::value("Single '}' encountered in format string")),
                '{' if at + 1 == text.len() => {
                    return Err(Stop::value("Single '{' encountered in format string"));
                }
                '{' => {
                    let field = parse_field(text, at + 1)?;
                    let text = self.field(interp, &field, depth)?;
                    interp.budget.grown(out.len() + text.len())?;
                    out.push_str(&text);
                    at = field.behind;
                }
                c => {
                    out.push(c);
                    at += 1;
                }
            }
        }
        interp.budget.text(out.len() as u128)?;
        Ok(out)
    }

    fn field(&mut self, interp: &mut Interp, field: &Field<'_>, depth: u32) -> Eval<Str> {
        let value = self.value(interp, field.name)?;
        let value = convert(interp, value, field.conversion)?;
        let spec = if field.spec.contains(&'{') {
            self.expand(interp, field.spec, depth - 1)?
        } else {
            field.spec.iter().collect()
        };
        format(interp, &value, &spec)
    }

    /// The value of `name.attribute[index]`.
    fn value(&mut self, interp: &mut Interp, name: &[char]) -> Eval {
        let end = name
            .iter()
            .position(|c| matches!(c, '.' | '['))
            .unwrap_or(name.len());
        let (first, mut path) = name.split_at(end);
        let first: String = first.iter().collect();
        let mut value = self.first(interp, &first)?.known()?;
        while let Some((&separator, rest)) = path.split_first() {
            interp.budget.step()?;
            let close = if separator == '[' {
                rest.iter()
                    .position(|&c| c == ']')
                    .ok_or_else(|| Stop::value("Missing ']' in format string"))?
            } else {
                rest.iter()
                    .position(|c| matches!(c, '.' | '['))
                    .unwrap_or(rest.len())
            };
            let part: String = rest.iter().take(close).collect();
            if part.is_empty() {
                return Err(Stop::value("Empty attribute in format string"));
            }
            value = if separator == '[' {
                index(interp, &value, &part)?
            } else {
                attribute(interp, &value, &part)?
            };
            path = rest
                .get(close + usize::from(separator == '[')..)
                .unwrap_or(&[]);
            if separator == '[' && !matches!(path.first(), None | Some('.' | '[')) {
                return Err(Stop::value(
                    "Only '.' or '[' may follow ']' in format field specifier",
                ));
            }
        }
        Ok(value)
    }

    fn first(&mut self, interp: &mut Interp, name: &str) -> Eval {
        let number = parse_number(name)?;
        let numbered = number.is_some();
        if name.is_empty() || numbered {
            if let FieldSource::Mapping(_) = self.source {
                return Err(Stop::value("Format string contains positional fields"));
            }
            if self.numbered.is_some_and(|before| before != numbered) {
                let (from, to) = if numbered {
                    ("automatic field numbering", "manual field specification")
                } else {
                    ("manual field specification", "automatic field numbering")
                };
                return Err(Stop::value(format!("cannot switch from {from} to {to}")));
            }
            self.numbered = Some(numbered);
        }
        let place = match (number, name) {
            (Some(number), _) => number,
            (None, "") => {
                self.next += 1;
                self.next - 1
            }
            (None, name) => return self.named(interp, name),
        };
        match self.source {
            FieldSource::Args(args) => args.pos.get(place).cloned().ok_or_else(|| {
                Stop::index(format!(
                    "Replacement index {place} out of range for positional args tuple"
                ))
            }),
            FieldSource::Mapping(_) => Err(Stop::Unknown),
        }
    }

    fn named(&self, interp: &mut Interp, name: &str) -> Eval {
        match self.source {
            FieldSource::Args(args) => args
                .named(name)
                .cloned()
                .ok_or_else(|| ops::key_error(&Value::from(name))),
            FieldSource::Mapping(mapping) => ops::subscript(interp, mapping, &Value::from(name)),
        }
    }
}

/// A field name made of digits.
fn parse_number(text: &str) -> Eval<Option<usize>> {
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
        return Ok(None);
    }
    let number = text
        .parse::<i64>()
        .ok()
        .and_then(|number| usize::try_from(number).ok());
    number
        .map(Some)
        .ok_or_else(|| Stop::value("Too many decimal digits in format string"))
}

fn index(interp: &mut Interp, value: &Value, part: &str) -> Eval {
    let key = match parse_number(part)? {
        Some(number) => Value::Int(i64::try_from(number).unwrap_or(i64::MAX)),
        None => Value::from(part),
    };
    ops::subscript(interp, value, &key)
}

fn attribute(interp: &mut Interp, value: &Value, name: &str) -> Eval {
    if name.starts_with("__") {
        return Err(Stop::new(
            ErrorKind::ForbiddenName,
            format!("Use of invalid name(s):  {name}"),
        ));
    }
    let at = interp.at;
    interp.attribute(value, name, at)
}

/// The field that starts behind an opening brace.
fn parse_field(text: &[char], start: usize) -> Eval<Field<'_>> {
    let rest = text.get(start..).unwrap_or(&[]);
    let mut brackets = false;
    let name_end = rest.iter().position(|&c| {
        match c {
            '[' => brackets = true,
            ']' => brackets = false,
            _ => {}
        }
        c == '{' || (!brackets && matches!(c, '}' | ':' | '!'))
    });
    let name_end = name_end.ok_or_else(|| Stop::value("expected '}' before end of string"))?;
    let name = rest.get(..name_end).unwrap_or(&[]);
    let (conversion, behind) = match rest.get(name_end) {
        Some('{') => return Err(Stop::value("unexpected '{' in field name")),
        Some('!') => {
            let Some(&conversion) = rest.get(name_end + 1) else {
                return Err(Stop::value(
                    "end of string while looking for conversion specifier",
                ));
            };
            match rest.get(name_end + 2) {
                None => return Err(Stop::value("unmatched '{' in format spec")),
                Some(':' | '}') => (Some(conversion), name_end + 2),
                Some(_) => return Err(Stop::value("expected ':' after conversion specifier")),
            }
        }
        _ => (None, name_end),
    };
    if rest.get(behind) == Some(&'}') {
        return Ok(Field {
            name,
            conversion,
            spec: &[],
            behind: start + behind + 1,
        });
    }
    let mut open = 1;
    let spec = rest.get(behind + 1..).unwrap_or(&[]);
    let end = spec.iter().position(|&c| {
        match c {
            '{' => open += 1,
            '}' => open -= 1,
            _ => {}
        }
        open == 0
    });
    let end = end.ok_or_else(|| Stop::value("unmatched '{' in format spec"))?;
    let spec = spec.get(..end).unwrap_or(&[]);
    Ok(Field {
        name,
        conversion,
        spec,
        behind: start + behind + 1 + end + 1,
    })
}
