//! Operators.

mod compare;
pub(crate) mod complex;
pub(crate) mod float;
pub(crate) mod int;
mod sequence;
pub(crate) mod sets;
mod subscript;

pub(crate) use compare::{compare, contains, identical_or_equal, sort_before};
pub(crate) use sequence::repeat_text;
pub(crate) use subscript::{as_index, clamp_index, key_error, slice_bounds, subscript};

use super::ast::{BinOp, UnaryOp};
use super::format;
use super::interp::Interp;
use super::numeric::Num;
use super::stop::{Eval, Stop};
use super::value::{Dict, Value};

/// `a op b`
pub(crate) fn binary(interp: &mut Interp, op: BinOp, a: &Value, b: &Value) -> Eval {
    match (a, b) {
        (Value::Float(x), Value::Float(y)) => return float::binary(op, *x, *y),
        (Value::Int(x), Value::Int(y)) => {
            if let Some(value) = int::fast(op, *x, *y) {
                return Ok(value);
            }
        }
        (Value::Unknown, _) | (_, Value::Unknown) => return Err(Stop::Unknown),
        (Value::Bool(x), Value::Bool(y)) => match op {
            BinOp::BitAnd => return Ok(Value::Bool(x & y)),
            BinOp::BitOr => return Ok(Value::Bool(x | y)),
            BinOp::BitXor => return Ok(Value::Bool(x ^ y)),
            _ => {}
        },
        _ => {}
    }
    if let (Some(x), Some(y)) = (Num::of(a), Num::of(b)) {
        return match numeric(interp, op, x, y)? {
            Some(value) => Ok(value),
            None => Err(unsupported(op, a, b)),
        };
    }
    if matches!(a, Value::Date(_)) || matches!(b, Value::Date(_)) {
        // Differences of dates are not modelled.
        return Err(Stop::Unknown);
    }
    match op {
        BinOp::Add => sequence::concat(interp, a, b),
        BinOp::Mul => sequence::repeat(interp, a, b),
        BinOp::Mod if matches!(a, Value::Str(_)) => format::percent(interp, a, b),
        BinOp::BitOr => union(interp, a, b),
        BinOp::Sub | BinOp::BitAnd | BinOp::BitXor => {
            sets::binary(interp, op, a, b).unwrap_or_else(|| Err(unsupported(op, a, b)))
        }
        _ => Err(unsupported(op, a, b)),
    }
}

/// Arithmetic of two numbers; none if the operator does not apply to them.
fn numeric(interp: &mut Interp, op: BinOp, x: Num<'_>, y: Num<'_>) -> Eval<Option<Value>> {
    if let (Some(a), Some(b)) = (x.big(), y.big()) {
        return int::binary(interp, op, &a, &b);
    }
    if matches!(
        op,
        BinOp::MatMul
            | BinOp::LShift
            | BinOp::RShift
            | BinOp::BitAnd
            | BinOp::BitOr
            | BinOp::BitXor
    ) {
        return Ok(None);
    }
    if matches!(x, Num::Complex(..)) || matches!(y, Num::Complex(..)) {
        if matches!(op, BinOp::FloorDiv | BinOp::Mod) {
            return Ok(None);
        }
        return complex::binary(op, x.complex()?, y.complex()?).map(Some);
    }
    match (x.float()?, y.float()?) {
        (Some(x), Some(y)) => float::binary(op, x, y).map(Some),
        _ => Ok(None),
    }
}

fn union(interp: &mut Interp, a: &Value, b: &Value) -> Eval {
    if let (Value::Dict(x), Value::Dict(y)) = (a, b) {
        let mut map = (*x.snapshot()).clone();
        map.extend(
            y.snapshot()
                .iter()
                .map(|(key, value)| (key.clone(), value.clone())),
        );
        return Ok(Value::Dict(Dict::new(map, false)));
    }
    sets::binary(interp, BinOp::BitOr, a, b).unwrap_or_else(|| Err(unsupported(BinOp::BitOr, a, b)))
}

fn symbol(op: BinOp) -> &'static str {
    match op {
        BinOp::Add => "+",
        BinOp::Sub => "-",
        BinOp::Mul => "*",
        BinOp::MatMul => "@",
        BinOp::Div => "/",
        BinOp::FloorDiv => "//",
        BinOp::Mod => "%",
        BinOp::Pow => "** or pow()",
        BinOp::LShift => "<<",
        BinOp::RShift => ">>",
        BinOp::BitAnd => "&",
        BinOp::BitOr => "|",
        BinOp::BitXor => "^",
    }
}

/// `unsupported operand type(s) for +: 'int' and 'str'`
pub(crate) fn unsupported(op: BinOp, a: &Value, b: &Value) -> Stop {
    unsupported_as(symbol(op), a, b)
}

/// The same with another name for the operator.
pub(crate) fn unsupported_as(symbol: &str, a: &Value, b: &Value) -> Stop {
    let (a, b) = (a.type_name(), b.type_name());
    Stop::typ(format!(
        "unsupported operand type(s) for {symbol}: '{a}' and '{b}'"
    ))
}

/// `-a`, `+a`, `~a`
pub(crate) fn unary(op: UnaryOp, value: &Value) -> Eval {
    if value.is_unknown() {
        return Err(Stop::Unknown);
    }
    let symbol = match op {
        UnaryOp::Neg => '-',
        UnaryOp::Pos => '+',
        UnaryOp::Invert => '~',
        UnaryOp::Not => return Ok(Value::Unknown),
    };
    let bad = || {
        Stop::typ(format!(
            "bad operand type for unary {symbol}: '{}'",
            value.type_name()
        ))
    };
    let number = Num::of(value).ok_or_else(bad)?;
    Ok(match (op, number) {
        (UnaryOp::Neg, Num::Float(f)) => Value::Float(-f),
        (UnaryOp::Neg, Num::Complex(re, im)) => Value::Complex(-re, -im),
        (UnaryOp::Neg, Num::Int(i)) => match i.checked_neg() {
            Some(negative) => Value::Int(negative),
            None => Value::int(-i128::from(i)),
        },
        (UnaryOp::Neg, Num::Big(big)) => Value::int(-big),
        (UnaryOp::Pos, Num::Int(i)) => Value::Int(i),
        (UnaryOp::Pos, _) => value.clone(),
        (_, Num::Int(i)) => Value::Int(!i),
        (_, Num::Big(big)) => Value::int(!big),
        _ => return Err(bad()),
    })
}
