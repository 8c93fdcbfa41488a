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
