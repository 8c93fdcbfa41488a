//! Searching and replacing in strings.

use super::string;
use crate::args::Args;
use crate::builtins::index_sized;
use crate::interp::Interp;
use crate::ops::clamp_index;
use crate::stop::{Eval, Stop};
use crate::value::{Str, Value};

/// The part of a text between two optional character indices, and the index at which it starts.
struct SearchWindow<'a> {
    text: &'a str,
    first: usize,
}

fn byte_offset(text: &str, chars: usize) -> usize {
    if text.is_ascii() {
        return chars.min(text.len());
    }
    text.char_indices()
        .nth(chars)
        .map_or(text.len(), |(at, _)| at)
}

/// None if the indices leave nothing, not even room for an empty string.
fn window<'a>(
    text: &'a str,
    start: Option<&Value>,
    end: Option<&Value>,
) -> Eval<Option<SearchWindow<'a>>> {
    if start.is_none() && end.is_none() {
        return Ok(Some(SearchWindow { text, first: 0 }));
    }
    let len = text.chars().count();
    let first = clamp_index(start, len, 0)?;
    let last = clamp_index(end, len, len)?.min(len);
    if first > last {
        return Ok(None);
    }
    let part = text
        .get(byte_offset(text, first)..byte_offset(text, last))
        .unwrap_or("");
    Ok(Some(SearchWindow { text: part, first }))
}

/// One to three arguments, none by name.
fn check_args(args: &Args, name: &str) -> Eval<()> {
    if let [_, ..] = args.named.as_slice() {
        return Err(Stop::typ(format!(
            "str.{name}() takes no keyword arguments"
        )));
    }
    let given = args.len();
    match given {
        0 => Err(Stop::typ(format!(
            "{name}() takes at least 1 argument (0 given)"
        ))),
        1..=3 => Ok(()),
        _ => Err(Stop::typ(format!(
            "{name}() takes at most 3 arguments ({given} given)"
        ))),
    }
}

/// `find`, `rfind`, `index`, `rindex`
pub(super) fn find(interp: &mut Interp, text: &Value, args: &Args, name: &str) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    check_args(args, name)?;
    let window = window(text, args.get(1), args.get(2))?;
    let part = string(args.at(0), "")?;
    interp.budget.steps(text.len() as u64 / 256)?;
    let place = window.and_then(|window| {
        let at = if name.starts_with('r') {
            window.text.rfind(part)
        } else {
            window.text.find(part)
        }?;
        Some(window.first + window.text.get(..at)?.chars().count())
    });
    match place {
        Some(place) => Ok(Value::Int(i64::try_from(place).unwrap_or(i64::MAX))),
        None if name.ends_with("index") => Err(Stop::value("substring not found")),
        None => Ok(Value::Int(-1)),
    }
}

pub(super) fn count(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    check_args(args, "count")?;
    let window = window(text, args.get(1), args.get(2))?;
    let part = string(args.at(0), "")?;
    interp.budget.steps(text.len() as u64 / 64)?;
    let count = window.map_or(0, |window| match part {
        "" => window.text.chars().count() + 1,
        part => window.text.matches(part).count(),
    });
    Ok(Value::Int(i64::try_from(count).unwrap_or(i64::MAX)))
}

/// `startswith`, `endswith`
pub(super) fn at_end(text: &Value, args: &Args, start: bool) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let name = if start { "startswith" } else { "endswith" };
    check_args(args, name)?;
    let window = window(text, args.get(1), args.get(2))?;
    let text = window.map(|window| window.text);
    match args.at(0) {
        Value::Str(part) => Ok(Value::Bool(is_at_end(text, part, start))),
        Value::Tuple(parts) => {
            for part in parts.items() {
                let Value::Str(part) = part.clone().known()? else {
                    let kind = part.type_name();
                    return Err(Stop::typ(format!(
                        "tuple for {name} must only contain str, not {kind}"
                    )));
                };
                if is_at_end(text, &part, start) {
                    return Ok(Value::Bool(true));
                }
            }
            Ok(Value::Bool(false))
        }
        other => {
            let kind = other.type_name();
            Err(Stop::typ(format!(
                "{name} first arg must be str or a tuple of str, not {kind}"
            )))
        }
    }
}

fn is_at_end(text: Option<&str>, part: &str, start: bool) -> bool {
    text.is_some_and(|text| {
        if start {
            text.starts_with(part)
        } else {
            text.ends_with(part)
        }
    })
}

pub(super) fn replace(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let old = string(args.at(0), "replace() argument 1")?;
    let new = string(args.at(1), "replace() argument 2")?;
    let limit = args.get(2).map_or(Ok(-1), index_sized)?;
    let limit = usize::try_from(limit).unwrap_or(usize::MAX);
    interp.budget.steps(text.len() as u64 / 64)?;
    let found = if old.is_empty() {
        text.chars().count() + 1
    } else {
        text.matches(old).count()
    };
    let grown = found.min(limit) as u128 * (new.len() as u128).saturating_sub(old.len() as u128);
    interp.budget.text(text.len() as u128 + grown)?;
    Ok(Value::Str(Str::from(text.replacen(old, new, limit))))
}
