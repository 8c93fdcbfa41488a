//! `+` and `*` of strings, lists, tuples and bytes.

use ecow::EcoVec;

use super::{as_index, unsupported};
use crate::ast::BinOp;
use crate::interp::Interp;
use crate::stop::{Eval, Stop};
use crate::value::{List, Str, Tuple, Value};

/// `a + b`
pub(super) fn concat(interp: &mut Interp, a: &Value, b: &Value) -> Eval {
    match (a, b) {
        (Value::Str(x), Value::Str(y)) => {
            interp.budget.text(x.len() as u128 + y.len() as u128)?;
            let mut text = x.clone();
            text.push_str(y);
            Ok(Value::Str(text))
        }
        (Value::List(x), Value::List(y)) => {
            let items = joined(interp, x.snapshot(), &y.snapshot())?;
            Ok(Value::List(List::new(items, false)))
        }
        (Value::Tuple(x), Value::Tuple(y)) => Ok(Value::Tuple(Tuple::new(joined(
            interp,
            x.snapshot(),
            y.items(),
        )?))),
        (Value::Bytes(x), Value::Bytes(y)) => {
            interp.budget.text(x.len() as u128 + y.len() as u128)?;
            let mut bytes = x.clone();
            bytes.extend_from_slice(y);
            Ok(Value::Bytes(bytes))
        }
        (Value::Str(_) | Value::List(_) | Value::Tuple(_), _) => {
            let kind = match a {
                Value::Str(_) => "str",
                Value::List(_) => "list",
                _ => "tuple",
            };
            let other = b.type_name();
            Err(Stop::typ(format!(
                "can only concatenate {kind} (not \"{other}\") to {kind}"
            )))
        }
        (Value::Bytes(_), _) => Err(Stop::typ(format!(
            "can't concat {} to bytes",
            b.type_name()
        ))),
        _ => Err(unsupported(BinOp::Add, a, b)),
    }
}

fn joined(interp: &mut Interp, mut items: EcoVec<Value>, more: &[Value]) -> Eval<EcoVec<Value>> {
    interp
        .budget
        .items(items.len() as u128 + more.len() as u128)?;
    items.extend(more.iter().cloned());
    Ok(items)
}

fn is_sequence(value: &Value) -> bool {
    matches!(
        value,
        Value::Str(_) | Value::List(_) | Value::Tuple(_) | Value::Bytes(_)
    )
}

/// `a * b`
pub(super) fn repeat(interp: &mut Interp, a: &Value, b: &Value) -> Eval {
    let (sequence, count) = match (is_sequence(a), is_sequence(b)) {
        (true, _) => (a, b),
        (false, true) => (b, a),
        _ => return Err(unsupported(BinOp::Mul, a, b)),
    };
    let Some(count) = as_index(count) else {
        let kind = count.type_name();
        return Err(Stop::typ(format!(
            "can't multiply sequence by non-int of type '{kind}'"
        )));
    };
    let Ok(count) = i64::try_from(count) else {
        return Err(Stop::overflow(
            "cannot fit 'int' into an index-sized integer",
        ));
    };
    let count = u64::try_from(count).unwrap_or(0);
    Ok(match sequence {
        Value::Str(text) => Value::Str(repeat_text(interp, text, count)?),
        Value::Bytes(bytes) => {
            interp
                .budget
                .text(bytes.len() as u128 * u128::from(count))?;
            Value::Bytes(cycle(bytes, count))
        }
        Value::List(list) => Value::List(List::new(
            repeat_items(interp, &list.snapshot(), count)?,
            false,
        )),
        Value::Tuple(tuple) => {
            Value::Tuple(Tuple::new(repeat_items(interp, tuple.items(), count)?))
        }
        _ => return Err(unsupported(BinOp::Mul, a, b)),
    })
}

/// `text` so many times.
pub(crate) fn repeat_text(interp: &mut Interp, text: &str, count: u64) -> Eval<Str> {
    interp.budget.text(text.len() as u128 * u128::from(count))?;
    if text.is_empty() {
        return Ok(Str::new());
    }
    Ok(text.repeat(usize::try_from(count).unwrap_or(0)).into())
}

fn repeat_items(interp: &mut Interp, items: &[Value], count: u64) -> Eval<EcoVec<Value>> {
    interp
        .budget
        .items(items.len() as u128 * u128::from(count))?;
    Ok(cycle(items, count))
}

/// The caller has checked the size of the result.
fn cycle<T: Clone>(items: &[T], count: u64) -> EcoVec<T> {
    let len = items
        .len()
        .saturating_mul(usize::try_from(count).unwrap_or(0));
    items.iter().cycle().take(len).cloned().collect()
}
