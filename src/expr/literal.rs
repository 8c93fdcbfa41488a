//! How xacro reads literals from attribute text and booleans from values.

use super::numeric::{Num, ParsedInt, parse_float, parse_int};
use super::stop::Stop;
use super::{EvalError, Value};

/// The literal rule for properties, parameters and their defaults.
///
/// One pair of single quotes makes a string; text with an underscore is a string; then integer, float, boolean are
/// tried, and what is left is a string.
pub fn from_text(text: &str) -> Value {
    if let Some(inner) = text
        .strip_prefix('\'')
        .and_then(|rest| rest.strip_suffix('\''))
    {
        return Value::from(inner);
    }
    if !may_be_literal(text) {
        return Value::from(text);
    }
    if let ParsedInt::Int(int) = parse_int(text, 10) {
        return int;
    }
    if let Some(float) = parse_float(text) {
        return Value::Float(float);
    }
    match text {
        "true" | "True" => Value::Bool(true),
        "false" | "False" => Value::Bool(false),
        _ => Value::from(text),
    }
}

/// Python's `int(text)`; none if it fails.
pub fn int(text: &str) -> Option<Value> {
    match parse_int(text, 10) {
        ParsedInt::Int(int) => Some(int),
        ParsedInt::TooLong(_) | ParsedInt::Invalid => None,
    }
}

/// Python's `float(text)`; none if it fails.
pub fn float(text: &str) -> Option<Value> {
    parse_float(text).map(Value::Float)
}

/// Python's `float(value)`; an unknown value gives not-a-number.
///
/// # Errors
/// The exception Python raises.
pub fn float_of(value: &Value) -> Result<f64, EvalError> {
    match super::builtins::float(value) {
        Ok(number) => Ok(number),
        Err(Stop::Unknown) => Ok(f64::NAN),
        Err(Stop::Raise(error)) => Err(*error),
    }
}

/// A quick look that sends most names and formulas away.
fn may_be_literal(text: &str) -> bool {
    let first = text
        .trim_start_matches(super::numeric::is_space)
        .chars()
        .next();
    let hopeful = |c: char| c.is_ascii_digit() || !c.is_ascii() || "+-.iInNtTfF".contains(c);
    first.is_some_and(hopeful) && !text.contains('_')
}

/// The value of a condition or of a boolean attribute; none if it is not a boolean.
///
/// Strings are `true`, `True`, `false`, `False` or an integer; any other value has its Python truth.
pub fn boolean(value: &Value) -> Option<bool> {
    let Value::Str(text) = value else {
        return truth(value);
    };
    match text.as_str() {
        "true" | "True" => Some(true),
        "false" | "False" => Some(false),
        other => match parse_int(other, 10) {
            ParsedInt::Int(int) => truth(&int),
            ParsedInt::TooLong(_) | ParsedInt::Invalid => None,
        },
    }
}

/// Python's `bool()`; none for an unknown value.
pub fn truth(value: &Value) -> Option<bool> {
    Some(match value {
        Value::Unknown => return None,
        Value::None => false,
        Value::Str(text) => !text.is_empty(),
        Value::Bytes(bytes) => !bytes.is_empty(),
        Value::List(list) => !list.is_empty(),
        Value::Tuple(tuple) => !tuple.items().is_empty(),
        Value::Dict(dict) => !dict.is_empty(),
        Value::View(view) => !view.dict.is_empty(),
        Value::Set(set) => !set.is_empty(),
        Value::Range(range) => !range.is_empty(),
        other => Num::of(other).is_none_or(Num::truth),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::display::repr;
    use crate::format::ascii;

    /// Texts as JSON with the literal and the boolean that the reference takes them for.
    #[test]
    fn texts_are_read_as_by_the_reference() {
        for line in include_str!("testdata/literals.txt").lines() {
            let columns: Vec<&str> = line.split('\t').collect();
            let [text, literal, expected] = columns[..] else {
                panic!("{line}")
            };
            let text: String = serde_json::from_str(text).unwrap();
            let value = from_text(&text);
            let shown = match &value {
                Value::Big(big) if big.bits() > 13_000 => "int".to_owned(),
                other => ascii(&repr(other).unwrap()).to_string(),
            };
            assert_eq!(shown, literal, "{text:?}");
            let truth = match boolean(&Value::from(text.as_str())) {
                Some(true) => "True",
                Some(false) => "False",
                None => "None",
            };
            assert_eq!(truth, expected, "{text:?} as a boolean");
        }
    }

    #[test]
    fn other_values_have_their_truth() {
        assert_eq!(boolean(&Value::Float(0.0)), Some(false));
        assert_eq!(boolean(&Value::Float(f64::NAN)), Some(true));
        assert_eq!(boolean(&Value::None), Some(false));
        assert_eq!(boolean(&Value::list([])), Some(false));
        assert_eq!(boolean(&Value::Unknown), None);
    }
}
