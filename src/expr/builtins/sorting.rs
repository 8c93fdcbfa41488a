//! `sorted`, `min`, `max` and `list.sort`.

use super::python::{empty_sequence, list_of};
use crate::expr::args::{Args, bind_named, check_count};
use crate::expr::interp::Interp;
use crate::expr::ops::sort_before;
use crate::expr::stop::{Eval, Stop};
use crate::expr::value::Value;

/// `sorted(iterable, key=None, reverse=False)`
pub(super) fn sorted(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    check_count("sorted", args.len(), 1, 1)?;
    let items = interp.collect(args.at(0))?.into_iter().collect();
    let options = Args { pos: Vec::new(), named: args.named.clone() };
    Ok(list_of(sort(interp, items, options)?))
}

/// Sort stably as `key` and `reverse` in `options` ask for.
pub(crate) fn sort(interp: &mut Interp, items: Vec<Value>, options: Args) -> Eval<Vec<Value>> {
    let options = bind_named("sort", &["key", "reverse"], 0, 0, options)?;
    let reverse = match options.get(1) {
        None => false,
        Some(value) => super::python::integer(value)? != 0,
    };
    let mut keyed = Vec::with_capacity(items.len());
    for item in items {
        let key = key_of(interp, options.get(0), &item)?;
        keyed.push((key, item));
    }
    // Reversing before and after keeps equal items in their order.
    if reverse {
        keyed.reverse();
    }
    let mut sorted = merge_sort(interp, keyed)?;
    if reverse {
        sorted.reverse();
    }
    Ok(sorted.into_iter().map(|(_, item)| item).collect())
}

fn key_of(interp: &mut Interp, key: Option<&Value>, item: &Value) -> Eval {
    match key {
        None | Some(Value::None) => Ok(item.clone()),
        Some(function) => interp.apply(function, vec![item.clone()]),
    }
}

type Keyed = (Value, Value);

/// The comparison may fail or contradict itself, which the standard library's sort does not allow.
fn merge_sort(interp: &mut Interp, mut items: Vec<Keyed>) -> Eval<Vec<Keyed>> {
    if items.len() < 2 {
        if let Some((key, _)) = items.first().filter(|(key, _)| key.is_unknown()) {
            return Err(key.clone().known().err().unwrap_or(Stop::Unknown));
        }
        return Ok(items);
    }
    let right = items.split_off(items.len() / 2);
    let left = merge_sort(interp, items)?;
    let right = merge_sort(interp, right)?;
    let mut merged = Vec::with_capacity(left.len() + right.len());
    let (mut left, mut right) = (left.into_iter().peekable(), right.into_iter().peekable());
    while let (Some((a, _)), Some((b, _))) = (left.peek(), right.peek()) {
        let from_right = sort_before(interp, b, a)?;
        merged.extend(if from_right { right.next() } else { left.next() });
    }
    merged.extend(left);
    merged.extend(right);
    Ok(merged)
}

/// `min(...)`, `max(...)`
pub(super) fn extreme(interp: &mut Interp, args: &Args, largest: bool) -> Eval {
    let name = if largest { "max" } else { "min" };
    if let Some((wrong, _)) = args.named.iter().find(|(given, _)| given != "key" && given != "default") {
        return Err(Stop::typ(format!("'{wrong}' is an invalid keyword argument for {name}()")));
    }
    let default = args.named("default");
    let candidates = match args.pos.as_slice() {
        [] => return Err(Stop::typ(format!("{name} expected at least 1 argument, got 0"))),
        [iterable] => iterable.clone(),
        _ if default.is_some() => {
            return Err(Stop::typ(format!(
                "Cannot specify a default for {name}() with multiple positional arguments"
            )));
        }
        values => Value::tuple_from(values.to_vec()),
    };
    let mut cursor = interp.iter(&candidates)?;
    let mut best: Option<(Value, Value)> = None;
    while let Some(item) = interp.next(&mut cursor)? {
        let key = key_of(interp, args.named("key"), &item)?.known()?;
        let better = match &best {
            None => true,
            Some((best, _)) if largest => sort_after(interp, &key, best)?,
            Some((best, _)) => sort_before(interp, &key, best)?,
        };
        if better {
            best = Some((key, item));
        }
    }
    match (best, default) {
        (Some((_, item)), _) => Ok(item),
        (None, Some(default)) => Ok(default.clone()),
        (None, None) => Err(empty_sequence(name)),
    }
}

/// `a > b`, whose message names that operator.
fn sort_after(interp: &mut Interp, a: &Value, b: &Value) -> Eval<bool> {
    crate::expr::ops::compare(interp, crate::expr::ast::CmpOp::Gt, a, b)
}
