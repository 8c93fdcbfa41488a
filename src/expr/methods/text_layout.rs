//! Padding, stripping and translating of strings.

use super::string;
use crate::args::Args;
use crate::builtins::{index_sized, integer};
use crate::interp::Interp;
use crate::numeric::is_space;
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::{Dict, DictMap, Key, Str, Value};

/// Where padding goes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum PaddingSide {
    Left,
    Right,
    Both,
}

/// How many characters are missing to the width asked for.
fn missing(interp: &mut Interp, text: &str, width: &Value, unit: usize) -> Eval<u64> {
    let width = index_sized(width)?;
    let missing = width.saturating_sub(text.chars().count() as i128).max(0);
    interp
        .budget
        .text(text.len() as u128 + missing.unsigned_abs() * unit as u128)?;
    Ok(u64::try_from(missing).unwrap_or(0))
}

/// `center`, `ljust`, `rjust`
pub(super) fn pad(interp: &mut Interp, text: &Value, args: &Args, side: PaddingSide) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    index_sized(args.at(0))?;
    let fill = match args.get(1) {
        None => " ",
        Some(Value::Str(fill)) if fill.chars().count() == 1 => fill,
        Some(Value::Str(_)) => {
            return Err(Stop::typ(
                "The fill character must be exactly one character long",
            ));
        }
        Some(other) => {
            let kind = other.type_name();
            return Err(Stop::typ(format!(
                "The fill character must be a unicode character, not {kind}"
            )));
        }
    };
    let missing = missing(interp, text, args.at(0), fill.len())?;
    let left = match side {
        PaddingSide::Left => missing,
        PaddingSide::Right => 0,
        // An odd one goes left when the width is odd.
        PaddingSide::Both => missing / 2 + (missing & (missing + text.chars().count() as u64) & 1),
    };
    let mut out = ops::repeat_text(interp, fill, left)?;
    out.push_str(text);
    out.push_str(&ops::repeat_text(interp, fill, missing - left)?);
    Ok(Value::Str(out))
}

pub(super) fn zfill(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let missing = missing(interp, text, args.at(0), 1)?;
    let (sign, digits) = text.split_at(usize::from(text.starts_with(['+', '-'])));
    let mut out = Str::from(sign);
    out.push_str(&ops::repeat_text(interp, "0", missing)?);
    out.push_str(digits);
    Ok(Value::Str(out))
}

/// `strip`, `lstrip`, `rstrip`
pub(super) fn strip(text: &Value, args: &Args, name: &str) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let chars = match args.get(0) {
        None | Some(Value::None) => None,
        Some(Value::Str(chars)) => Some(chars.as_str()),
        Some(_) => return Err(Stop::typ(format!("{name} arg must be None or str"))),
    };
    let drop = |c: char| chars.map_or_else(|| is_space(c), |chars| chars.contains(c));
    Ok(Value::from(match name {
        "lstrip" => text.trim_start_matches(drop),
        "rstrip" => text.trim_end_matches(drop),
        _ => text.trim_matches(drop),
    }))
}

/// `removeprefix`, `removesuffix`
pub(super) fn remove(text: &Value, args: &Args, prefix: bool) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let name = if prefix {
        "removeprefix() argument"
    } else {
        "removesuffix() argument"
    };
    let part = string(args.at(0), name)?;
    let rest = if prefix {
        text.strip_prefix(part)
    } else {
        text.strip_suffix(part)
    };
    Ok(Value::from(rest.unwrap_or(text)))
}

pub(super) fn expand_tabs(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let size = args.get(0).map_or(Ok(8), integer)?;
    let size = usize::try_from(size.max(0)).unwrap_or(usize::MAX);
    let tabs = text.bytes().filter(|&b| b == b'\t').count();
    interp
        .budget
        .text(text.len() as u128 + tabs as u128 * size as u128)?;
    let mut out = String::with_capacity(text.len());
    let mut column = 0;
    for c in text.chars() {
        match c {
            '\t' if size == 0 => {}
            '\t' => {
                let blanks = size - column % size;
                out.extend(std::iter::repeat_n(' ', blanks));
                column += blanks;
            }
            c => {
                out.push(c);
                column = if matches!(c, '\n' | '\r') {
                    0
                } else {
                    column + 1
                };
            }
        }
    }
    Ok(Value::from(out))
}

/// `str.maketrans`
pub(super) fn make_translation(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let mut map = DictMap::default();
    if args.len() == 1 {
        let Value::Dict(dict) = args.at(0) else {
            return Err(Stop::typ(
                "if you give only one argument to maketrans it must be a dict",
            ));
        };
        for (key, value) in dict.entries() {
            let key = match &key {
                Value::Str(text) => {
                    let mut chars = text.chars();
                    match (chars.next(), chars.next()) {
                        (Some(c), None) => code_key(c)?,
                        _ => {
                            return Err(Stop::value(
                                "string keys in translate table must be of length 1",
                            ));
                        }
                    }
                }
                Value::Int(_) | Value::Bool(_) | Value::Big(_) => Key::new(key)?,
                _ => {
                    return Err(Stop::typ(
                        "keys in translate table must be strings or integers",
                    ));
                }
            };
            map.insert(key, value);
        }
        return Ok(Value::Dict(Dict::new(map, false)));
    }
    let to = string(args.at(1), "maketrans() argument 2")?;
    let gone = args
        .get(2)
        .map_or(Ok(""), |gone| string(gone, "maketrans() argument 3"))?;
    let Value::Str(from) = args.at(0) else {
        return Err(Stop::typ(
            "first maketrans argument must be a string if there is a second argument",
        ));
    };
    if from.chars().count() != to.chars().count() {
        return Err(Stop::value(
            "the first two maketrans arguments must have equal length",
        ));
    }
    for (a, b) in from.chars().zip(to.chars()) {
        map.insert(code_key(a)?, Value::Int(i64::from(u32::from(b))));
    }
    for c in gone.chars() {
        map.insert(code_key(c)?, Value::None);
    }
    Ok(Value::Dict(Dict::new(map, false)))
}

/// The number of a character, as the tables of `translate` have it.
fn code_key(c: char) -> Eval<Key> {
    Key::new(Value::Int(i64::from(u32::from(c))))
}

pub(super) fn translate(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        interp.budget.step()?;
        let code = Value::Int(i64::from(u32::from(c)));
        let mapped = match ops::subscript(interp, args.at(0), &code) {
            Ok(mapped) => mapped,
            Err(stop) if is_lookup(&stop) => code,
            Err(stop) => return Err(stop),
        };
        match mapped {
            Value::None => {}
            Value::Str(text) => {
                interp.budget.text(text.len() as u128)?;
                interp.budget.grown(out.len() + text.len())?;
                out.push_str(&text);
            }
            Value::Int(code) => match u32::try_from(code).ok().and_then(char::from_u32) {
                Some(c) => out.push(c),
                None => return Err(Stop::value("character mapping must be in range(0x110000)")),
            },
            Value::Unknown => return Err(Stop::Unknown),
            _ => {
                return Err(Stop::typ(
                    "character mapping must return integer, None or str",
                ));
            }
        }
    }
    Ok(Value::from(out))
}

fn is_lookup(stop: &Stop) -> bool {
    use crate::host::ErrorKind::{Index, Key};
    stop.is(&Key) || stop.is(&Index)
}
