//! Values that are plain data.
use expr::Value;

/// Whether a value is plain data that never changes: neither a container, which can be changed in place, nor a function.
pub(super) fn is_plain(value: &Value) -> bool {
    use Value::{Big, Bool, Float, Int, None, Str};
    matches!(value, None | Bool(_) | Int(_) | Big(_) | Float(_) | Str(_))
}

/// Whether two plain values are the same, of the same type.
pub(super) fn is_same_value(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::None, Value::None) | (Value::Unknown, Value::Unknown) => true,
        (Value::Bool(a), Value::Bool(b)) => a == b,
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Big(a), Value::Big(b)) => a == b,
        (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
        (Value::Str(a), Value::Str(b)) => a == b,
        _ => false,
    }
}

/// How many levels and elements of a container are looked at.
const DEPTH: usize = 4;
const ELEMENTS: usize = 64;

/// Whether a value changes only by what counts as a change in place ([`expr::changes_in_place`]): plain data, and containers of
/// it.
pub(super) fn holds_still(value: &Value) -> bool {
    holds_still_inside(value, DEPTH)
}

fn holds_still_inside(value: &Value, depth: usize) -> bool {
    let all = |values: &[Value]| {
        depth > 0
            && values.len() <= ELEMENTS
            && values
                .iter()
                .all(|value| holds_still_inside(value, depth - 1))
    };
    match value {
        Value::Unknown => true,
        // sets hold what can be hashed
        Value::Set(_) => true,
        Value::List(list) => list.is_yaml() || all(&list.items()),
        Value::Tuple(tuple) => all(tuple.items()),
        Value::Dict(dict) => {
            dict.is_yaml() || {
                let values: Vec<Value> =
                    dict.entries().into_iter().map(|(_, value)| value).collect();
                all(&values)
            }
        }
        value => is_plain(value),
    }
}
