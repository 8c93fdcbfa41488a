//! Methods of lists, tuples, ranges and slices.

use super::{methods, up_to};
use crate::args::Arity::{Any, One, Zero};
use crate::args::{Args, check_count};
use crate::builtins::{Function, index_sized, integer, sort};
use crate::display;
use crate::interp::Interp;
use crate::ops::{as_index, clamp_index, identical_or_equal, slice_bounds};
use crate::stop::{Eval, Stop};
use crate::value::{List, Value};

/// Sorted by name.
pub(super) static LIST: &[Function] = methods! { "list":
    "append" One => append,
    "clear" Zero => |_, s, _| this(s)?.edit(|items| { items.clear(); Ok(Value::None) }),
    "copy" Zero => |_, s, _| Ok(Value::List(this(s)?.copied(false))),
    "count" One => |i, s, a| count(i, &this(s)?.snapshot(), a.at(0)),
    "extend" One => extend,
    "index" up_to(1, 3) => list_index,
    "insert" up_to(2, 2) => insert,
    "pop" up_to(0, 1) => pop,
    "remove" One => remove,
    "reverse" Zero => |_, s, _| this(s)?.edit(|items| { items.make_mut().reverse(); Ok(Value::None) }),
    "sort" Any => list_sort,
};

/// Sorted by name.
pub(super) static TUPLE: &[Function] = methods! { "tuple":
    "count" One => |i, s, a| count(i, items(s), a.at(0)),
    "index" up_to(1, 3) => |i, s, a| match index(i, items(s), a)? {
        Some(place) => Ok(place),
        None => Err(Stop::value("tuple.index(x): x not in tuple")),
    },
};

/// Sorted by name.
pub(super) static RANGE: &[Function] = methods! { "range":
    "count" One => |i, s, a| Ok(Value::Int(i64::from(crate::ops::contains(i, s, a.at(0))?))),
    "index" One => range_index,
};

/// Sorted by name.
pub(super) static SLICE: &[Function] = methods! { "slice":
    "indices" One => indices,
};

fn this(value: &Value) -> Eval<&List> {
    match value {
        Value::List(list) => Ok(list),
        _ => Err(Stop::Unknown),
    }
}

fn items(value: &Value) -> &[Value] {
    match value {
        Value::Tuple(tuple) => tuple.items(),
        _ => &[],
    }
}

fn append(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    interp.budget.items(1)?;
    let item = args.pos.first().cloned().unwrap_or_default();
    this(list)?.edit(|items| items.push(item));
    Ok(Value::None)
}

fn extend(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let list = this(list)?;
    let more = interp.collect(args.at(0))?;
    interp
        .budget
        .items(more.len() as u128 + list.len() as u128)?;
    list.edit(|items| items.extend(more));
    Ok(Value::None)
}

fn insert(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let list = this(list)?;
    interp.budget.items(1)?;
    interp.budget.steps(list.len() as u64 / 16)?;
    let place = index_sized(args.at(0))?;
    let item = args.pos.get(1).cloned().unwrap_or_default();
    list.edit(|items| {
        let len = items.len() as i128;
        let place = if place < 0 {
            (place + len).max(0)
        } else {
            place.min(len)
        };
        items.insert(usize::try_from(place).unwrap_or(0), item);
    });
    Ok(Value::None)
}

fn pop(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let list = this(list)?;
    let place = args.get(0).map_or(Ok(-1), index_sized)?;
    interp.budget.steps(if place == -1 {
        1
    } else {
        list.len() as u64 / 16
    })?;
    list.edit(|items| {
        let len = items.len();
        let place = if place < 0 {
            place.saturating_add(len as i128)
        } else {
            place
        };
        match usize::try_from(place) {
            Ok(place) if place < len => Ok(items.remove(place)),
            _ if len == 0 => Err(Stop::index("pop from empty list")),
            _ => Err(Stop::index("pop index out of range")),
        }
    })
}

fn remove(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let list = this(list)?;
    for (place, item) in list.snapshot().iter().enumerate() {
        interp.budget.step()?;
        if identical_or_equal(interp, item, args.at(0))? {
            list.edit(|items| (place < items.len()).then(|| items.remove(place)));
            return Ok(Value::None);
        }
    }
    Err(Stop::value("list.remove(x): x not in list"))
}

fn list_sort(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let given = args.len() + args.named.len();
    if given > 2 {
        return Err(Stop::typ(format!(
            "sort() takes at most 2 arguments ({given} given)"
        )));
    }
    if !args.pos.is_empty() {
        return Err(Stop::typ("sort() takes no positional arguments"));
    }
    let list = this(list)?;
    let items = list.snapshot().into_iter().collect();
    let options = Args {
        pos: Vec::new(),
        named: args.named.clone(),
    };
    let sorted = sort(interp, items, options)?;
    list.edit(|items| *items = sorted.into_iter().collect());
    Ok(Value::None)
}

fn list_index(interp: &mut Interp, list: &Value, args: &Args) -> Eval {
    let items = this(list)?.snapshot();
    match index(interp, &items, args)? {
        Some(place) => Ok(place),
        None => Err(Stop::value(format!(
            "{} is not in list",
            display::shown(args.at(0))?
        ))),
    }
}

/// The place of the first argument between the optional others.
fn index(interp: &mut Interp, items: &[Value], args: &Args) -> Eval<Option<Value>> {
    if args
        .pos
        .iter()
        .skip(1)
        .any(|bound| as_index(bound).is_none())
    {
        return Err(Stop::typ(
            "slice indices must be integers or have an __index__ method",
        ));
    }
    let start = clamp_index(args.get(1), items.len(), 0)?;
    let end = clamp_index(args.get(2), items.len(), items.len())?;
    for (place, item) in items.iter().enumerate().take(end).skip(start) {
        interp.budget.step()?;
        if identical_or_equal(interp, item, args.at(0))? {
            return Ok(Some(Value::Int(i64::try_from(place).unwrap_or(i64::MAX))));
        }
    }
    Ok(None)
}

fn count(interp: &mut Interp, items: &[Value], wanted: &Value) -> Eval {
    let mut count = 0;
    for item in items {
        interp.budget.step()?;
        count += i64::from(identical_or_equal(interp, item, wanted)?);
    }
    Ok(Value::Int(count))
}

fn range_index(interp: &mut Interp, value: &Value, args: &Args) -> Eval {
    let Value::Range(range) = value else {
        return Err(Stop::Unknown);
    };
    if let Some(number) = as_index(args.at(0)) {
        return match range.position(number) {
            Some(place) => Ok(Value::int(place)),
            None => Err(Stop::value(format!(
                "{} is not in range",
                display::shown(args.at(0))?
            ))),
        };
    }
    let mut cursor = interp.iter(value)?;
    let mut place = 0;
    while let Some(item) = interp.next(&mut cursor)? {
        if identical_or_equal(interp, &item, args.at(0))? {
            return Ok(Value::Int(place));
        }
        place += 1;
    }
    Err(Stop::value("sequence.index(x): x not in sequence"))
}

fn indices(_: &mut Interp, slice: &Value, args: &Args) -> Eval {
    let Value::Slice(slice) = slice else {
        return Err(Stop::Unknown);
    };
    check_count("indices", args.len(), 1, 1)?;
    let len = integer(args.at(0))?;
    let Ok(len) = usize::try_from(len) else {
        return Err(Stop::value("length should not be negative"));
    };
    let bounds = slice_bounds(slice, len)?;
    Ok(Value::tuple_from(
        [bounds.start, bounds.stop, bounds.step].map(Value::wide),
    ))
}
