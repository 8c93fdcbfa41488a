//! Taking strings apart and putting them together.

use super::string;
use crate::args::Args;
use crate::builtins::{index_sized, integer};
use crate::interp::Interp;
use crate::numeric::is_space;
use crate::stop::{Eval, Stop};
use crate::value::{Str, Value};

/// `split`, `rsplit`
pub(super) fn split(interp: &mut Interp, text: &Value, args: &Args, from_right: bool) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let limit = args.get(1).map_or(Ok(-1), index_sized)?;
    let limit = usize::try_from(limit).unwrap_or(usize::MAX);
    let separator = match args.get(0) {
        None | Some(Value::None) => None,
        Some(Value::Str(separator)) if separator.is_empty() => {
            return Err(Stop::value("empty separator"));
        }
        Some(Value::Str(separator)) => Some(separator.as_str()),
        Some(other) => {
            let kind = other.type_name();
            return Err(Stop::typ(format!("must be str or None, not {kind}")));
        }
    };
    interp.budget.steps(text.len() as u64 / 64)?;
    let most = match separator {
        Some(separator) => text.len() / separator.len() + 1,
        None => text.len() / 2 + 1,
    };
    interp
        .budget
        .clone()
        .items(most.min(limit.saturating_add(1)) as u128)?;
    let pieces: Vec<&str> = match (separator, from_right) {
        (Some(separator), false) => text.splitn(limit.saturating_add(1), separator).collect(),
        (Some(separator), true) => {
            let mut pieces: Vec<&str> = text.rsplitn(limit.saturating_add(1), separator).collect();
            pieces.reverse();
            pieces
        }
        (None, false) => words(text, limit),
        (None, true) => words_from_right(text, limit),
    };
    interp.budget.items(pieces.len() as u128)?;
    Ok(Value::list(pieces.into_iter().map(Value::from)))
}

fn words(text: &str, limit: usize) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text.trim_start_matches(is_space);
    while !rest.is_empty() {
        if words.len() == limit {
            words.push(rest);
            break;
        }
        let end = rest.find(is_space).unwrap_or(rest.len());
        let (word, more) = rest.split_at(end);
        words.push(word);
        rest = more.trim_start_matches(is_space);
    }
    words
}

fn words_from_right(text: &str, limit: usize) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text.trim_end_matches(is_space);
    while !rest.is_empty() {
        if words.len() == limit {
            words.push(rest);
            break;
        }
        let gap = rest.char_indices().rev().find(|&(_, c)| is_space(c));
        let start = gap.map_or(0, |(at, c)| at + c.len_utf8());
        let (more, word) = rest.split_at(start);
        words.push(word);
        rest = more.trim_end_matches(is_space);
    }
    words.reverse();
    words
}

/// The line ends of `str.splitlines`.
fn is_line_end(c: char) -> bool {
    matches!(
        c,
        '\n' | '\r' | '\x0b' | '\x0c' | '\x1c'..='\x1e' | '\u{85}' | '\u{2028}' | '\u{2029}'
    )
}

pub(super) fn lines(interp: &mut Interp, text: &Value, args: &Args) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let keep = args.get(0).map_or(Ok(0), integer)? != 0;
    let mut lines = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let end = rest.find(is_line_end).unwrap_or(rest.len());
        let after = rest.get(end..).unwrap_or("");
        let width = if after.starts_with("\r\n") {
            2
        } else {
            after.chars().next().map_or(0, char::len_utf8)
        };
        interp.budget.items(1)?;
        lines.push(Value::from(
            rest.get(..if keep { end + width } else { end })
                .unwrap_or(""),
        ));
        rest = rest.get(end + width..).unwrap_or("");
    }
    Ok(Value::list(lines))
}

/// `partition`, `rpartition`
pub(super) fn partition(text: &Value, args: &Args, from_right: bool) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    let separator = string(args.at(0), "")?;
    if separator.is_empty() {
        return Err(Stop::value("empty separator"));
    }
    let found = if from_right {
        text.rsplit_once(separator)
    } else {
        text.split_once(separator)
    };
    let parts = match found {
        Some((before, after)) => [before, separator, after],
        None if from_right => ["", "", text],
        None => [text, "", ""],
    };
    Ok(Value::tuple_from(parts.map(Value::from)))
}

pub(super) fn join(interp: &mut Interp, separator: &Value, args: &Args) -> Eval {
    let separator = separator.as_str().ok_or(Stop::Unknown)?;
    let items = match args.at(0) {
        // A list from YAML is read past its wrapper.
        Value::List(list) => list.snapshot(),
        other => {
            if interp.iter(other).is_err() {
                return Err(Stop::typ("can only join an iterable"));
            }
            interp.collect(other)?
        }
    };
    let mut length = 0;
    for (i, item) in items.iter().enumerate() {
        match item {
            Value::Str(text) => length += text.len() as u128 + separator.len() as u128,
            Value::Unknown => return Err(Stop::Unknown),
            other => {
                let kind = other.type_name();
                return Err(Stop::typ(format!(
                    "sequence item {i}: expected str instance, {kind} found"
                )));
            }
        }
    }
    interp.budget.steps(items.len() as u64)?;
    interp.budget.text(length)?;
    let mut out = Str::new();
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            out.push_str(separator);
        }
        out.push_str(item.as_str().unwrap_or(""));
    }
    Ok(Value::Str(out))
}
