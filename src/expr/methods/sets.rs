//! Methods of sets.

use super::methods;
use crate::args::Args;
use crate::args::Arity::{One, Positional, Zero};
use crate::ast::BinOp;
use crate::builtins::Function;
use crate::host::ErrorKind;
use crate::interp::Interp;
use crate::ops::{key_error, sets::combine};
use crate::stop::{Eval, Stop};
use crate::value::{Key, Set, SetMap, Value};

/// Sorted by name.
pub(super) static SET: &[Function] = methods! { "set":
    "add" One => add,
    "clear" Zero => |_, s, _| this(s)?.edit(|items| { items.clear(); Ok(Value::None) }),
    "copy" Zero => copy,
    "difference" Positional => |i, s, a| fold(i, s, a, BinOp::Sub),
    "difference_update" Positional => |i, s, a| update(i, s, a, BinOp::Sub),
    "discard" One => |_, s, a| { this(s)?.edit(|items| Key::sought(a.at(0)).map(|key| items.shift_remove(&key)))?; Ok(Value::None) },
    "intersection" Positional => |i, s, a| fold(i, s, a, BinOp::BitAnd),
    "intersection_update" Positional => |i, s, a| update(i, s, a, BinOp::BitAnd),
    "isdisjoint" One => |i, s, a| relation(i, s, a, SetMap::is_disjoint),
    "issubset" One => |i, s, a| relation(i, s, a, SetMap::is_subset),
    "issuperset" One => |i, s, a| relation(i, s, a, SetMap::is_superset),
    "pop" Zero => pop,
    "remove" One => remove,
    "symmetric_difference" One => |i, s, a| fold(i, s, a, BinOp::BitXor),
    "symmetric_difference_update" One => |i, s, a| update(i, s, a, BinOp::BitXor),
    "union" Positional => |i, s, a| fold(i, s, a, BinOp::BitOr),
    "update" Positional => |i, s, a| update(i, s, a, BinOp::BitOr),
};

/// Sorted by name.
pub(super) static FROZEN: &[Function] = methods! { "frozenset":
    "copy" Zero => copy,
    "difference" Positional => |i, s, a| fold(i, s, a, BinOp::Sub),
    "intersection" Positional => |i, s, a| fold(i, s, a, BinOp::BitAnd),
    "isdisjoint" One => |i, s, a| relation(i, s, a, SetMap::is_disjoint),
    "issubset" One => |i, s, a| relation(i, s, a, SetMap::is_subset),
    "issuperset" One => |i, s, a| relation(i, s, a, SetMap::is_superset),
    "symmetric_difference" One => |i, s, a| fold(i, s, a, BinOp::BitXor),
    "union" Positional => |i, s, a| fold(i, s, a, BinOp::BitOr),
};

fn this(value: &Value) -> Eval<&Set> {
    match value {
        Value::Set(set) => Ok(set),
        _ => Err(Stop::Unknown),
    }
}

fn keys(interp: &mut Interp, value: &Value) -> Eval<SetMap> {
    if let Value::Set(set) = value {
        return Ok((*set.snapshot()).clone());
    }
    let mut keys = SetMap::default();
    let mut cursor = interp.iter(value)?;
    while let Some(item) = interp.next(&mut cursor)? {
        interp.budget.items(1)?;
        keys.insert(Key::new(item)?);
    }
    Ok(keys)
}

/// This set combined with all arguments.
fn combined(interp: &mut Interp, set: &Value, args: &Args, op: BinOp) -> Eval<SetMap> {
    let mut result = (*this(set)?.snapshot()).clone();
    for other in &args.pos {
        let other = keys(interp, other)?;
        interp
            .budget
            .items(result.len() as u128 + other.len() as u128)?;
        result = combine(op, &result, &other);
    }
    Ok(result)
}

fn fold(interp: &mut Interp, set: &Value, args: &Args, op: BinOp) -> Eval {
    let result = combined(interp, set, args, op)?;
    Ok(Value::Set(Set::new(result, this(set)?.is_frozen())))
}

fn update(interp: &mut Interp, set: &Value, args: &Args, op: BinOp) -> Eval {
    let result = combined(interp, set, args, op)?;
    this(set)?.edit(|items| *items = result);
    Ok(Value::None)
}

fn relation(
    interp: &mut Interp,
    set: &Value,
    args: &Args,
    holds: fn(&SetMap, &SetMap) -> bool,
) -> Eval {
    let other = keys(interp, args.at(0))?;
    Ok(Value::Bool(holds(&this(set)?.snapshot(), &other)))
}

fn add(interp: &mut Interp, set: &Value, args: &Args) -> Eval {
    interp.budget.items(1)?;
    let key = Key::new(args.at(0).clone())?;
    this(set)?.edit(|items| items.insert(key));
    Ok(Value::None)
}

fn copy(_: &mut Interp, set: &Value, _: &Args) -> Eval {
    let set = this(set)?;
    Ok(Value::Set(Set::new(
        (*set.snapshot()).clone(),
        set.is_frozen(),
    )))
}

fn remove(_: &mut Interp, set: &Value, args: &Args) -> Eval {
    let key = Key::sought(args.at(0))?;
    if this(set)?.edit(|items| items.shift_remove(&key)) {
        Ok(Value::None)
    } else {
        Err(key_error(args.at(0)))
    }
}

/// Takes the element that Python would find first.
fn pop(_: &mut Interp, set: &Value, _: &Args) -> Eval {
    let set = this(set)?;
    let Some(first) = set.ordered().into_iter().next() else {
        return Err(Stop::new(ErrorKind::Key, "'pop from an empty set'"));
    };
    let key = Key::new(first.clone())?;
    set.edit(|items| items.shift_remove(&key));
    Ok(first)
}
