//! `|`, `&`, `-`, `^` and order of sets and dict views.

use std::sync::Arc;

use crate::ast::BinOp;
use crate::interp::Interp;
use crate::stop::Eval;
use crate::value::{Key, Set, SetMap, Value, ViewKind};

/// The elements of a set or set-like view; `None` for anything else, an error for unhashable ones.
pub(crate) fn elements(value: &Value) -> Option<Eval<Arc<SetMap>>> {
    match value {
        Value::Set(set) => Some(Ok(set.snapshot())),
        Value::View(view) => match view.kind {
            ViewKind::Values => None,
            ViewKind::Keys => Some(Ok(Arc::new(view.dict.snapshot().keys().cloned().collect()))),
            ViewKind::Items => {
                let pair = |(key, value)| Key::new(Value::tuple_from([key, value]));
                Some(
                    view.dict
                        .entries()
                        .into_iter()
                        .map(pair)
                        .collect::<Eval<SetMap>>()
                        .map(Arc::new),
                )
            }
        },
        _ => None,
    }
}

/// A set operator; none if neither operand takes part in one. A dict view combines with anything iterable.
pub(super) fn binary(interp: &mut Interp, op: BinOp, a: &Value, b: &Value) -> Option<Eval> {
    let frozen = matches!(a, Value::Set(set) if set.is_frozen());
    let with_view = is_set_view(a) || is_set_view(b);
    let x = operand(interp, a, with_view)?;
    let y = operand(interp, b, with_view)?;
    Some(x.and_then(|x| y.map(|y| Value::Set(Set::new(combine(op, &x, &y), frozen)))))
}

fn is_set_view(value: &Value) -> bool {
    matches!(value, Value::View(view) if view.kind != ViewKind::Values)
}

/// The elements of an operand; beside a view, which `with_view` says there is, anything iterable has some.
fn operand(interp: &mut Interp, value: &Value, with_view: bool) -> Option<Eval<Arc<SetMap>>> {
    match elements(value) {
        None if with_view => Some(collected(interp, value)),
        found => found,
    }
}

fn collected(interp: &mut Interp, value: &Value) -> Eval<Arc<SetMap>> {
    let items = interp.collect(value)?;
    items
        .into_iter()
        .map(Key::new)
        .collect::<Eval<SetMap>>()
        .map(Arc::new)
}

/// The elements of `x op y`.
pub(crate) fn combine(op: BinOp, x: &SetMap, y: &SetMap) -> SetMap {
    match op {
        BinOp::BitOr => x.union(y).cloned().collect(),
        BinOp::BitAnd => x.intersection(y).cloned().collect(),
        BinOp::Sub => x.difference(y).cloned().collect(),
        _ => x.symmetric_difference(y).cloned().collect(),
    }
}
