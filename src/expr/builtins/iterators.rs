//! Ranges, slices and the iterators over other iterables.

use std::sync::Arc;

use super::python::integer;
use crate::args::Args;
use crate::ast::UnaryOp;
use crate::interp::Interp;
use crate::iter::{Iter, IterKind, IterState};
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::{Range, Slice, Value};

pub(super) fn range(args: &Args) -> Eval {
    let (start, stop, step) = match args.len() {
        1 => (0, bound(args, 0)?, 1),
        2 => (bound(args, 0)?, bound(args, 1)?, 1),
        _ => (bound(args, 0)?, bound(args, 1)?, bound(args, 2)?),
    };
    if step == 0 {
        return Err(Stop::value("range() arg 3 must not be zero"));
    }
    Ok(Value::Range(Arc::new(Range { start, stop, step })))
}

fn bound(args: &Args, place: usize) -> Eval<i128> {
    let number = integer(args.at(place))?;
    if number.unsigned_abs() >> 120 != 0 {
        return Err(Stop::budget(
            "range bounds of more than 120 bits are not supported",
        ));
    }
    Ok(number)
}

pub(super) fn slice(args: &Args) -> Value {
    let slice = match args.len() {
        1 => Slice {
            start: Value::None,
            stop: args.at(0).clone(),
            step: Value::None,
        },
        _ => Slice {
            start: args.at(0).clone(),
            stop: args.at(1).clone(),
            step: args.at(2).clone(),
        },
    };
    Value::Slice(Arc::new(slice))
}

pub(super) fn map(interp: &mut Interp, args: &Args) -> Eval {
    let [function, sources @ ..] = args.pos.as_slice() else {
        return Err(Stop::typ("map() must have at least two arguments."));
    };
    if sources.is_empty() {
        return Err(Stop::typ("map() must have at least two arguments."));
    }
    let sources = sources
        .iter()
        .map(|source| interp.iter(source))
        .collect::<Eval<Vec<_>>>()?;
    let cursor = IterState::Map {
        function: function.clone(),
        sources,
    };
    Ok(Value::Iter(Iter::new(IterKind::Map, cursor)))
}

pub(super) fn filter(interp: &mut Interp, args: &Args) -> Eval {
    let source = Box::new(interp.iter(args.at(1))?);
    let cursor = IterState::Filter {
        function: args.at(0).clone(),
        source,
    };
    Ok(Value::Iter(Iter::new(IterKind::Filter, cursor)))
}

pub(super) fn zip(interp: &mut Interp, args: &Args) -> Eval {
    if let Some((name, _)) = args.named.iter().find(|(name, _)| name != "strict") {
        return Err(Stop::typ(format!(
            "'{name}' is an invalid keyword argument for zip()"
        )));
    }
    let strict = args
        .named("strict")
        .map_or(Ok(false), |value| interp.truth(value))?;
    let sources = args
        .pos
        .iter()
        .map(|source| interp.iter(source))
        .collect::<Eval<Vec<_>>>()?;
    Ok(Value::Iter(Iter::new(
        IterKind::Zip,
        IterState::Zip { sources, strict },
    )))
}

pub(super) fn enumerate(interp: &mut Interp, args: &Args) -> Eval {
    let count = match args.get(1) {
        None => Value::Int(0),
        Some(value) => {
            let _: i128 = integer(value)?;
            ops::unary(UnaryOp::Pos, value)?
        }
    };
    let source = Box::new(interp.iter(args.at(0))?);
    Ok(Value::Iter(Iter::new(
        IterKind::Enumerate,
        IterState::Enumerate { count, source },
    )))
}

pub(super) fn reversed(interp: &mut Interp, value: &Value) -> Eval {
    let cursor = match value {
        Value::List(list) => {
            let cursor = IterState::ListBack(list.clone(), list.len());
            return Ok(Value::Iter(Iter::new(
                IterKind::Other("list_reverseiterator"),
                cursor,
            )));
        }
        Value::Range(range) => {
            let len = range.len();
            let next = range.nth(len.saturating_sub(1));
            let cursor = IterState::Range {
                next,
                step: -range.step,
                left: len,
            };
            return Ok(Value::Iter(Iter::new(
                IterKind::Other("range_iterator"),
                cursor,
            )));
        }
        Value::Tuple(_)
        | Value::Str(_)
        | Value::Bytes(_)
        | Value::Dict(_)
        | Value::View(_)
        | Value::Module(_)
        | Value::Scope(_) => {
            let mut items = interp.collect(value)?;
            items.make_mut().reverse();
            IterState::Items(items, 0)
        }
        other => {
            return Err(Stop::typ(format!(
                "'{}' object is not reversible",
                other.type_name()
            )));
        }
    };
    let kind = match value {
        Value::Dict(_) => IterKind::Other("dict_reversekeyiterator"),
        _ => IterKind::Reversed,
    };
    Ok(Value::Iter(Iter::new(kind, cursor)))
}
