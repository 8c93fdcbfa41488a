//! Comparison operators.

use std::cmp::Ordering;

use super::sets::elements;
use crate::ast::CmpOp;
use crate::interp::Interp;
use crate::numeric::Num;
use crate::stop::{Eval, Stop};
use crate::value::{Key, SetMap, Slice, Value};

/// `a op b`
pub(crate) fn compare(interp: &mut Interp, op: CmpOp, a: &Value, b: &Value) -> Eval<bool> {
    if a.is_unknown() || b.is_unknown() {
        return Err(Stop::Unknown);
    }
    match op {
        CmpOp::Eq => equal(interp, a, b),
        CmpOp::Ne => Ok(!equal(interp, a, b)?),
        CmpOp::Is => Ok(a.same(b)),
        CmpOp::IsNot => Ok(!a.same(b)),
        CmpOp::In => contains(interp, b, a),
        CmpOp::NotIn => Ok(!contains(interp, b, a)?),
        CmpOp::Lt | CmpOp::Le | CmpOp::Gt | CmpOp::Ge => ordered(interp, op, a, b),
    }
}

/// `a == b`
pub(crate) fn equal(interp: &mut Interp, a: &Value, b: &Value) -> Eval<bool> {
    interp.budget.step()?;
    match (a, b) {
        (Value::Unknown, _) | (_, Value::Unknown) => Err(Stop::Unknown),
        (Value::Str(x), Value::Str(y)) => Ok(x == y),
        (Value::List(x), Value::List(y)) => equal_items(interp, &x.snapshot(), &y.snapshot()),
        (Value::Tuple(x), Value::Tuple(y)) => equal_items(interp, x.items(), y.items()),
        (Value::Dict(x), Value::Dict(y)) => {
            let (x, y) = (x.snapshot(), y.snapshot());
            if x.len() != y.len() {
                return Ok(false);
            }
            for (key, value) in x.iter() {
                let Some(other) = y.get(key) else {
                    return Ok(false);
                };
                if !identical_or_equal(interp, value, other)? {
                    return Ok(false);
                }
            }
            Ok(true)
        }
        (
            Value::Module(_) | Value::Scope(_),
            Value::Module(_) | Value::Scope(_) | Value::Dict(_),
        )
        | (Value::Dict(_), Value::Module(_) | Value::Scope(_))
            if !a.same(b) =>
        {
            let both = (interp.mapping(a)?, interp.mapping(b)?);
            let (Some(x), Some(y)) = both else {
                return Ok(false);
            };
            equal(interp, &Value::Dict(x), &Value::Dict(y))
        }
        (Value::Slice(x), Value::Slice(y)) => equal_items(interp, &slice_parts(x), &slice_parts(y)),
        _ => match (Num::of(a), Num::of(b)) {
            (Some(x), Some(y)) => Ok(x.equals(y)),
            (None, None) => equal_others(a, b),
            _ => Ok(false),
        },
    }
}

fn slice_parts(slice: &Slice) -> [Value; 3] {
    [slice.start.clone(), slice.stop.clone(), slice.step.clone()]
}

/// Sets and hashable objects.
fn equal_others(a: &Value, b: &Value) -> Eval<bool> {
    if let (Some(x), Some(y)) = (elements(a), elements(b)) {
        let (x, y) = (x?, y?);
        return Ok(x.len() == y.len() && x.iter().all(|item| y.contains(item)));
    }
    if let (Value::Type(x), Value::Type(y)) = (a, b) {
        return Ok(x == y);
    }
    match (Key::new(a.clone()), Key::new(b.clone())) {
        (Ok(x), Ok(y)) => Ok(x == y),
        _ => Ok(a.same(b)),
    }
}

fn equal_items(interp: &mut Interp, x: &[Value], y: &[Value]) -> Eval<bool> {
    if x.len() != y.len() {
        return Ok(false);
    }
    for (x, y) in x.iter().zip(y) {
        if !identical_or_equal(interp, x, y)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Containers take an item to be equal to itself, even a NaN, and do not look further into it.
pub(crate) fn identical_or_equal(interp: &mut Interp, a: &Value, b: &Value) -> Eval<bool> {
    if a.is_unknown() || b.is_unknown() {
        return Err(Stop::Unknown);
    }
    if a.same(b) {
        return Ok(true);
    }
    interp
        .down()
        .map_err(|_| Stop::recursion(" in comparison"))?;
    let result = equal(interp, a, b);
    interp.up();
    result
}

fn symbol(op: CmpOp) -> &'static str {
    match op {
        CmpOp::Lt => "<",
        CmpOp::Le => "<=",
        CmpOp::Gt => ">",
        CmpOp::Ge => ">=",
        _ => "==",
    }
}

fn holds(op: CmpOp, order: Option<Ordering>) -> bool {
    order.is_some_and(|order| match op {
        CmpOp::Lt => order.is_lt(),
        CmpOp::Le => order.is_le(),
        CmpOp::Gt => order.is_gt(),
        _ => order.is_ge(),
    })
}

/// `<`, `<=`, `>`, `>=`
fn ordered(interp: &mut Interp, op: CmpOp, a: &Value, b: &Value) -> Eval<bool> {
    interp.budget.step()?;
    let order = match (a, b) {
        (Value::Unknown, _) | (_, Value::Unknown) => return Err(Stop::Unknown),
        (Value::Complex(..), _) | (_, Value::Complex(..)) => return Err(unordered(op, a, b)),
        (Value::Str(x), Value::Str(y)) => Some(x.cmp(y)),
        (Value::Bytes(x), Value::Bytes(y)) => Some(x.cmp(y)),
        // The more special type is asked first.
        (Value::List(x), Value::List(y)) if y.is_yaml() && !x.is_yaml() => {
            return ordered_items(interp, reflected(op), &y.snapshot(), &x.snapshot());
        }
        (Value::List(x), Value::List(y)) => {
            return ordered_items(interp, op, &x.snapshot(), &y.snapshot());
        }
        (Value::Tuple(x), Value::Tuple(y)) => {
            return ordered_items(interp, op, x.items(), y.items());
        }
        (Value::Date(x), Value::Date(y)) => return ordered_dates(op, x, y),
        _ => match (Num::of(a), Num::of(b)) {
            (Some(x), Some(y)) => x.compare(y),
            _ => return subset(op, a, b).unwrap_or_else(|| Err(unordered(op, a, b))),
        },
    };
    Ok(holds(op, order))
}

fn unordered(op: CmpOp, a: &Value, b: &Value) -> Stop {
    let (symbol, a, b) = (symbol(op), a.type_name(), b.type_name());
    Stop::typ(format!(
        "'{symbol}' not supported between instances of '{a}' and '{b}'"
    ))
}

/// The operator with its sides exchanged.
fn reflected(op: CmpOp) -> CmpOp {
    match op {
        CmpOp::Lt => CmpOp::Gt,
        CmpOp::Le => CmpOp::Ge,
        CmpOp::Gt => CmpOp::Lt,
        CmpOp::Ge => CmpOp::Le,
        other => other,
    }
}

fn ordered_dates(
    op: CmpOp,
    x: &crate::value::DateValue,
    y: &crate::value::DateValue,
) -> Eval<bool> {
    if x.time.is_some() != y.time.is_some() {
        return Err(Stop::typ(
            "can't compare datetime.datetime to datetime.date",
        ));
    }
    if x.utc_offset.is_some() != y.utc_offset.is_some() {
        return Err(Stop::typ(
            "can't compare offset-naive and offset-aware datetimes",
        ));
    }
    Ok(holds(op, Some(x.instant().cmp(&y.instant()))))
}

/// The first pair that differs decides.
fn ordered_items(interp: &mut Interp, op: CmpOp, x: &[Value], y: &[Value]) -> Eval<bool> {
    for (x, y) in x.iter().zip(y) {
        if !identical_or_equal(interp, x, y)? {
            interp
                .down()
                .map_err(|_| Stop::recursion(" in comparison"))?;
            let result = ordered(interp, op, x, y);
            interp.up();
            return result;
        }
    }
    Ok(holds(op, Some(x.len().cmp(&y.len()))))
}

/// Order of sets is inclusion.
fn subset(op: CmpOp, a: &Value, b: &Value) -> Option<Eval<bool>> {
    let (x, y) = (elements(a)?, elements(b)?);
    Some(x.and_then(|x| y.map(|y| holds_for_sets(op, &x, &y))))
}

fn holds_for_sets(op: CmpOp, x: &SetMap, y: &SetMap) -> bool {
    match op {
        CmpOp::Lt => x.len() < y.len() && x.is_subset(y),
        CmpOp::Le => x.is_subset(y),
        CmpOp::Gt => x.len() > y.len() && x.is_superset(y),
        _ => x.is_superset(y),
    }
}

/// `a < b`, as sorting and `min` need it.
pub(crate) fn sort_before(interp: &mut Interp, a: &Value, b: &Value) -> Eval<bool> {
    match (a, b) {
        (Value::Int(x), Value::Int(y)) => Ok(x < y),
        _ => ordered(interp, CmpOp::Lt, a, b),
    }
}

/// `item in container`
pub(crate) fn contains(interp: &mut Interp, container: &Value, item: &Value) -> Eval<bool> {
    match container {
        Value::Str(text) => match item {
            Value::Str(part) => {
                interp.budget.steps(text.len() as u64 / 256)?;
                Ok(text.contains(part.as_str()))
            }
            other => {
                let kind = other.type_name();
                Err(Stop::typ(format!(
                    "'in <string>' requires string as left operand, not {kind}"
                )))
            }
        },
        Value::Bytes(bytes) => bytes_contain(bytes, item),
        Value::Dict(dict) => Ok(dict.get(&Key::new(item.clone())?).is_some()),
        Value::Module(_) | Value::Scope(_) => interp.namespace_holds(container, item),
        Value::Set(set) => Ok(set.snapshot().contains(&Key::sought(item)?)),
        Value::Range(range) if matches!(item, Value::Int(_) | Value::Bool(_) | Value::Big(_)) => {
            let number = super::as_index(item).unwrap_or(0);
            Ok(range.position(number).is_some())
        }
        Value::View(view) if view.kind == crate::value::ViewKind::Keys => {
            Ok(view.dict.get(&Key::new(item.clone())?).is_some())
        }
        _ => contains_item(interp, container, item),
    }
}

fn contains_item(interp: &mut Interp, container: &Value, item: &Value) -> Eval<bool> {
    let list;
    let mut cursor = match container {
        Value::List(plain) => {
            list = plain.snapshot();
            crate::iter::IterState::Items(list, 0)
        }
        other => interp.iter(other).map_err(|stop| match stop {
            Stop::Unknown => Stop::Unknown,
            _ => Stop::typ(format!(
                "argument of type '{}' is not iterable",
                other.type_name()
            )),
        })?,
    };
    while let Some(candidate) = interp.next(&mut cursor)? {
        if identical_or_equal(interp, &candidate, item)? {
            return Ok(true);
        }
    }
    Ok(false)
}

fn bytes_contain(bytes: &[u8], item: &Value) -> Eval<bool> {
    match item {
        Value::Bytes(part) => Ok(part.is_empty() || memchr::memmem::find(bytes, part).is_some()),
        Value::Int(_) | Value::Bool(_) => {
            let byte = super::as_index(item).and_then(|n| u8::try_from(n).ok());
            byte.map(|byte| bytes.contains(&byte))
                .ok_or_else(|| Stop::value("byte must be in range(0, 256)"))
        }
        other => Err(Stop::typ(format!(
            "a bytes-like object is required, not '{}'",
            other.type_name()
        ))),
    }
}
