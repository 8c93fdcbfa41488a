//! Conversions to int, float, str and dict.

use super::python::{argument_type, integer};
use crate::args::{Args, bind_named, check_count};
use crate::display;
use crate::interp::Interp;
use crate::numeric::{Num, ParsedInt, float_to_int, parse_float, parse_int};
use crate::stop::{Eval, Stop};
use crate::value::{DictMap, Key, Value};

pub(super) fn bind_int(args: Args) -> Eval<Args> {
    let given = args.len() + args.named.len();
    if given > 2 {
        return Err(Stop::typ(format!(
            "int() takes at most 2 arguments ({given} given)"
        )));
    }
    // Only the base has a name.
    bind_named("int", &["", "base"], 0, 2, args)
}

pub(super) fn int(args: Args) -> Eval {
    let Some(value) = args.get(0) else {
        return match args.get(1) {
            Some(_) => Err(Stop::typ("int() missing string argument")),
            None => Ok(Value::Int(0)),
        };
    };
    let Some(base) = args.get(1) else {
        return int_of(value);
    };
    let base = integer(base)?;
    let valid = base == 0 || (2..=36).contains(&base);
    match value {
        _ if !valid => Err(Stop::value("int() base must be >= 2 and <= 36, or 0")),
        Value::Str(text) => int_of_text(text, u32::try_from(base).unwrap_or(10), value),
        _ => Err(Stop::typ(
            "int() can't convert non-string with explicit base",
        )),
    }
}

/// `int(value)`
fn int_of(value: &Value) -> Eval {
    match value {
        Value::Int(_) | Value::Big(_) => Ok(value.clone()),
        Value::Bool(b) => Ok(Value::Int(i64::from(*b))),
        Value::Float(f) => float_to_int(*f),
        Value::Str(text) => int_of_text(text, 10, value),
        Value::Bytes(bytes) => int_of_text(&String::from_utf8_lossy(bytes), 10, value),
        other => {
            let kind = other.type_name();
            let wanted = "a string, a bytes-like object or a real number";
            Err(Stop::typ(format!(
                "int() argument must be {wanted}, not '{kind}'"
            )))
        }
    }
}

fn int_of_text(text: &str, base: u32, value: &Value) -> Eval {
    match parse_int(text, base) {
        ParsedInt::Int(int) => Ok(int),
        ParsedInt::TooLong(digits) => Err(Stop::value(format!(
            "Exceeds the limit (4300 digits) for integer string conversion: value has {digits} digits; \
             use sys.set_int_max_str_digits() to increase the limit"
        ))),
        ParsedInt::Invalid => {
            let shown: String = display::shown(value)?.chars().take(200).collect();
            Err(Stop::value(format!(
                "invalid literal for int() with base {base}: {shown}"
            )))
        }
    }
}

/// `float(value)`
pub(crate) fn float(value: &Value) -> Eval<f64> {
    let text = match value {
        Value::Str(text) => text.clone(),
        Value::Bytes(bytes) => String::from_utf8_lossy(bytes).into(),
        other => match Num::of(other).map(Num::float).transpose()?.flatten() {
            Some(float) => return Ok(float),
            None => {
                let kind = other.type_name();
                return Err(Stop::typ(format!(
                    "float() argument must be a string or a real number, not '{kind}'"
                )));
            }
        },
    };
    match parse_float(&text) {
        Some(float) => Ok(float),
        None => {
            let shown = display::shown(value)?;
            Err(Stop::value(format!(
                "could not convert string to float: {shown}"
            )))
        }
    }
}

/// `str(object, encoding, errors)`
pub(super) fn text(interp: &mut Interp, args: Args) -> Eval {
    let args = bind_named("str", &["object", "encoding", "errors"], 0, 3, args)?;
    for (place, name) in [(1, "encoding"), (2, "errors")] {
        if let Some(other) = args.get(place).filter(|value| value.as_str().is_none()) {
            let kind = argument_type(other);
            return Err(Stop::typ(format!(
                "str() argument '{name}' must be str, not {kind}"
            )));
        }
    }
    let Some(value) = args.get(0) else {
        return Ok(Value::from(""));
    };
    if args.get(1).is_none() && args.get(2).is_none() {
        return interp.text(value).map(Value::Str);
    }
    match value {
        Value::Bytes(bytes) => crate::methods::decode(bytes, args.get(1), args.get(2)),
        Value::Str(_) => Err(Stop::typ("decoding str is not supported")),
        other => {
            let kind = other.type_name();
            Err(Stop::typ(format!(
                "decoding to str: need a bytes-like object, {kind} found"
            )))
        }
    }
}

/// The entries `dict(...)` gets.
pub(super) fn entries(interp: &mut Interp, args: Args) -> Eval<DictMap> {
    check_count("dict", args.len(), 0, 1)?;
    let mut map = DictMap::default();
    if let Some(source) = args.get(0) {
        add_entries(interp, &mut map, source)?;
    }
    map.extend(
        args.named
            .into_iter()
            .map(|(name, value)| (Key::text(name), value)),
    );
    Ok(map)
}

/// What `dict.update(source)` adds.
pub(crate) fn add_entries(interp: &mut Interp, map: &mut DictMap, source: &Value) -> Eval<()> {
    if let Some(dict) = interp.mapping(source)? {
        let other = dict.snapshot();
        interp.budget.items(other.len() as u128)?;
        map.extend(
            other
                .iter()
                .map(|(key, value)| (key.clone(), value.clone())),
        );
        return Ok(());
    }
    let mut cursor = interp.iter(source)?;
    let mut place = 0;
    while let Some(pair) = interp.next(&mut cursor)? {
        interp.budget.items(1)?;
        let pair = interp.collect(&pair).map_err(|stop| match stop {
            Stop::Raise(_) => Stop::typ(format!(
                "cannot convert dictionary update sequence element #{place} to a sequence"
            )),
            Stop::Unknown => Stop::Unknown,
        })?;
        let [key, value] = pair.as_slice() else {
            let len = pair.len();
            return Err(Stop::value(format!(
                "dictionary update sequence element #{place} has length {len}; 2 is required"
            )));
        };
        map.insert(Key::new(key.clone())?, value.clone());
        place += 1;
    }
    Ok(())
}
