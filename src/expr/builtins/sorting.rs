//! `sorted`, `min`, `max` and `list.sort`.

use super::python::{empty_sequence, list_of};
use crate::args::{Args, bind_named, check_count};
use crate::interp::Interp;
use crate::ops::sort_before;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// `sorted(iterable, key=None, reverse=False)`
pub(super) fn sorted(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    check_count("sorted", args.len(), 1, 1)?;
    let items = interp.collect(args.at(0))?.into_iter().collect();
    let options = Args {
        pos: Vec::new(),
        named: args.named.clone(),
    };
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

/// Lists up to this length are sorted by insertion.
const SHORT: usize = 64;

/// Stable. The comparison may fail or contradict itself, which the standard library's sort does not allow.
fn merge_sort(interp: &mut Interp, mut items: Vec<Keyed>) -> Eval<Vec<Keyed>> {
    if items.len() < SHORT {
        return insertion_sort(interp, items);
    }
    let right = items.split_off(items.len() / 2);
    let left = merge_sort(interp, items)?;
    let right = merge_sort(interp, right)?;
    let mut merged = Vec::with_capacity(left.len() + right.len());
    let (mut left, mut right) = (left.into_iter().peekable(), right.into_iter().peekable());
    while let (Some((a, _)), Some((b, _))) = (left.peek(), right.peek()) {
        let from_right = sort_before(interp, b, a)?;
        merged.extend(if from_right {
            right.next()
        } else {
            left.next()
        });
    }
    merged.extend(left);
    merged.extend(right);
    Ok(merged)
}

/// Compares in the order CPython does for short lists, so that the first pair that cannot be compared is the same.
fn insertion_sort(interp: &mut Interp, mut items: Vec<Keyed>) -> Eval<Vec<Keyed>> {
    let sorted = run_length(interp, &mut items)?;
    let rest = items.split_off(sorted);
    for (sorted, item) in (sorted..).zip(rest) {
        let (mut low, mut high) = (0, sorted);
        while low < high {
            let middle = low + (high - low) / 2;
            let Some((key, _)) = items.get(middle) else {
                break;
            };
            if sort_before(interp, &item.0, key)? {
                high = middle
            } else {
                low = middle + 1
            }
        }
        items.insert(low, item);
    }
    Ok(items)
}

/// How many items at the start are in order; a falling start is turned around.
fn run_length(interp: &mut Interp, items: &mut [Keyed]) -> Eval<usize> {
    let mut falling = false;
    let mut length = items.len().min(1);
    while let (Some((before, _)), Some((key, _))) =
        (items.get(length.wrapping_sub(1)), items.get(length))
    {
        let less = sort_before(interp, key, before)?;
        if length == 1 {
            falling = less;
        } else if less != falling {
            break;
        }
        length += 1;
    }
    if falling && let Some(run) = items.get_mut(..length) {
        run.reverse();
    }
    Ok(length)
}

/// `min(...)`, `max(...)`
pub(super) fn extreme(interp: &mut Interp, args: &Args, largest: bool) -> Eval {
    let name = if largest { "max" } else { "min" };
    if args.pos.is_empty() {
        return Err(Stop::typ(format!(
            "{name} expected at least 1 argument, got 0"
        )));
    }
    if let Some((wrong, _)) = args
        .named
        .iter()
        .find(|(given, _)| given != "key" && given != "default")
    {
        return Err(Stop::typ(format!(
            "'{wrong}' is an invalid keyword argument for {name}()"
        )));
    }
    let default = args.named("default");
    let candidates = match args.pos.as_slice() {
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
    crate::ops::compare(interp, crate::ast::CmpOp::Gt, a, b)
}
