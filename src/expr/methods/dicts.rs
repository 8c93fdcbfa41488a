//! Methods of dicts and their views.

use std::sync::Arc;

use super::{methods, up_to};
use crate::args::Arity::{Any, One, Zero};
use crate::args::{Args, check_count};
use crate::builtins::{Function, add_entries};
use crate::host::ErrorKind;
use crate::interp::Interp;
use crate::ops::{key_error, sets::elements};
use crate::stop::{Eval, Stop};
use crate::value::{Dict, DictMap, DictView, Key, Type, Value, ViewKind};

/// Sorted by name.
pub(super) static METHODS: &[Function] = methods! { "dict":
    "clear" Zero => |_, s, _| this(s)?.edit(|map| { map.clear(); Ok(Value::None) }),
    "copy" Zero => |_, s, _| Ok(Value::Dict(this(s)?.copied(false))),
    "get" up_to(1, 2) => get,
    "items" Zero => |_, s, _| view(s, ViewKind::Items),
    "keys" Zero => |_, s, _| view(s, ViewKind::Keys),
    "pop" up_to(1, 2) => pop,
    "popitem" Zero => pop_item,
    "setdefault" up_to(1, 2) => set_default,
    "update" Any => update,
    "values" Zero => |_, s, _| view(s, ViewKind::Values),
};

/// Sorted by name.
pub(super) static CLASS: &[Function] = methods! { "dict":
    "fromkeys" up_to(1, 2) => from_keys,
};

/// Sorted by name.
pub(super) static VIEW: &[Function] = methods! { "dict_keys":
    "isdisjoint" One => |i, s, a| {
        let mine = elements(s).unwrap_or(Err(Stop::Unknown))?;
        let mut cursor = i.iter(a.at(0))?;
        while let Some(item) = i.next(&mut cursor)? {
            if mine.contains(&Key::new(item)?) {
                return Ok(Value::Bool(false));
            }
        }
        Ok(Value::Bool(true))
    },
};

fn this(value: &Value) -> Eval<&Dict> {
    match value {
        Value::Dict(dict) => Ok(dict),
        _ => Err(Stop::Unknown),
    }
}

fn view(value: &Value, kind: ViewKind) -> Eval {
    Ok(Value::View(Arc::new(DictView {
        dict: this(value)?.clone(),
        kind,
    })))
}

fn get(_: &mut Interp, dict: &Value, args: &Args) -> Eval {
    let found = this(dict)?.get(&Key::new(args.at(0).clone())?);
    Ok(found.unwrap_or_else(|| args.at(1).clone()))
}

fn pop(interp: &mut Interp, dict: &Value, args: &Args) -> Eval {
    let dict = this(dict)?;
    if dict.is_empty() {
        // An empty dict does not even hash the key.
        return args.get(1).cloned().ok_or_else(|| key_error(args.at(0)));
    }
    let key = Key::new(args.at(0).clone())?;
    interp.budget.steps(dict.len() as u64 / 16)?;
    match (dict.edit(|map| map.shift_remove(&key)), args.get(1)) {
        (Some(value), _) => Ok(value),
        (None, Some(default)) => Ok(default.clone()),
        (None, None) => Err(key_error(args.at(0))),
    }
}

fn pop_item(_: &mut Interp, dict: &Value, _: &Args) -> Eval {
    match this(dict)?.edit(DictMap::pop) {
        Some((key, value)) => Ok(Value::tuple_from([key.into_value(), value])),
        None => Err(Stop::new(
            ErrorKind::Key,
            "'popitem(): dictionary is empty'",
        )),
    }
}

fn set_default(interp: &mut Interp, dict: &Value, args: &Args) -> Eval {
    interp.budget.items(1)?;
    let key = Key::new(args.at(0).clone())?;
    let default = args.pos.get(1).cloned().unwrap_or(Value::None);
    Ok(this(dict)?.edit(|map| map.entry(key).or_insert(default).clone()))
}

fn update(interp: &mut Interp, dict: &Value, args: &Args) -> Eval {
    let dict = this(dict)?;
    check_count("update", args.len(), 0, 1)?;
    let mut map = DictMap::default();
    if let Some(source) = args.get(0) {
        add_entries(interp, &mut map, source)?;
    }
    map.extend(
        args.named
            .iter()
            .map(|(name, value)| (Key::text(name.clone()), value.clone())),
    );
    dict.edit(|own| own.extend(map));
    Ok(Value::None)
}

fn from_keys(interp: &mut Interp, class: &Value, args: &Args) -> Eval {
    let mut map = DictMap::default();
    let mut cursor = interp.iter(args.at(0))?;
    while let Some(key) = interp.next(&mut cursor)? {
        interp.budget.items(1)?;
        map.insert(Key::new(key)?, args.at(1).clone());
    }
    let yaml = matches!(class, Value::Type(Type::YamlDict)) || Type::of(class) == Type::YamlDict;
    Ok(Value::Dict(Dict::new(map, yaml)))
}
