//! Types that can be called: conversions and constructors.

use std::sync::Arc;

use ecow::EcoVec;

use super::Function;
use super::python::integer;
use crate::expr::args::{Args, Arity, bind_named, check_count};
use crate::expr::display;
use crate::expr::interp::Interp;
use crate::expr::iter::{Cursor, Iter, IterKind};
use crate::expr::numeric::{Num, ParsedInt, float_to_int, parse_float, parse_int};
use crate::expr::stop::{Eval, Stop};
use crate::expr::value::{Dict, DictMap, Key, List, Range, Set, SetMap, Slice, Tuple, Type, Value};

/// Types that have a name in expressions: name, type, parameters, description.
pub(super) static NAMED: &[(&str, Type, &str, &str)] = &[
    ("bool", Type::Bool, "x=False", "True or False, whichever x counts as."),
    ("complex", Type::Complex, "real=0, imag=0", "A complex number from two numbers or a text."),
    ("dict", Type::Dict, "iterable=(), **entries", "A dictionary from pairs, another dictionary or names."),
    ("dotify", Type::YamlDict, "dict", "The dictionary with its entries as attributes: d.key."),
    ("enumerate", Type::Enumerate, "iterable, start=0", "Pairs of index and item."),
    ("filter", Type::Filter, "function, iterable", "The items for which the function is true."),
    ("float", Type::Float, "x=0", "A floating point number from a number or text."),
    ("frozenset", Type::FrozenSet, "iterable=()", "A set that cannot be changed."),
    ("int", Type::Int, "x=0, base=10", "A whole number from a number (cut off) or text."),
    ("list", Type::List, "iterable=()", "A list of the items."),
    ("map", Type::Map, "function, *iterables", "The function's results for each item."),
    ("range", Type::Range, "start=0, stop, step=1", "The whole numbers from start up to stop, without stop."),
    ("reversed", Type::Reversed, "sequence", "The items from last to first."),
    ("set", Type::Set, "iterable=()", "The distinct items."),
    ("slice", Type::Slice, "start, stop, step=None", "What stands between the brackets of s[a:b:c]."),
    ("str", Type::Str, "object=''", "The text of any value."),
    ("tuple", Type::Tuple, "iterable=()", "A tuple of the items."),
    ("type", Type::Type, "object", "The type of a value."),
    ("zip", Type::Zip, "*iterables, strict=False", "Tuples of the items at the same place."),
];

/// The type with a name in expressions; `dotify` has its name in another namespace.
pub(super) fn named(name: &str) -> Option<Type> {
    NAMED.iter().find(|named| named.0 == name && name != "dotify").map(|named| named.1)
}

/// The types whose deprecated bare name is a function, sorted by name.
pub(super) static CONSTRUCTORS: &[Function] = &[
    Function {
        name: "dotify",
        owner: "xacro",
        params: "",
        doc: "",
        arity: Arity::Any,
        run: |interp, _, args| construct(interp, Type::YamlDict, copy(args)),
    },
    Function {
        name: "range",
        owner: "xacro",
        params: "",
        doc: "",
        arity: Arity::Any,
        run: |interp, _, args| construct(interp, Type::Range, copy(args)),
    },
];

fn copy(args: &Args) -> Args {
    Args { pos: args.pos.clone(), named: args.named.clone() }
}

/// `kind(*args)`; no argument is unknown.
pub(crate) fn construct(interp: &mut Interp, kind: Type, args: Args) -> Eval {
    match kind {
        Type::Int => int(bind_int(args)?),
        Type::Str => text(interp, args),
        Type::Dict => Ok(Value::Dict(Dict::new(entries(interp, args)?, false))),
        Type::YamlDict => Ok(Value::Dict(Dict::new(entries(interp, args)?, true))),
        Type::Complex => super::math::complex(&bind_named("complex", &["real", "imag"], 0, 2, args)?),
        Type::Enumerate if args.pos.is_empty() && args.named.is_empty() => {
            Err(Stop::typ("enumerate() missing required argument 'iterable'"))
        }
        Type::Enumerate => enumerate(interp, &bind_named("enumerate", &["iterable", "start"], 1, 2, args)?),
        Type::Zip => zip(interp, &args),
        _ => {
            if !args.named.is_empty() {
                return Err(Stop::typ(format!("{}() takes no keyword arguments", kind.name())));
            }
            positional(interp, kind, &args)
        }
    }
}

/// Constructors without named arguments.
fn positional(interp: &mut Interp, kind: Type, args: &Args) -> Eval {
    let name = kind.name();
    let (min, max) = match kind {
        Type::Map | Type::Type => (0, usize::MAX),
        Type::Range | Type::Slice => (1, 3),
        Type::Filter => (2, 2),
        Type::Reversed => (1, 1),
        _ => (0, 1),
    };
    check_count(name, args.len(), min, max)?;
    match kind {
        Type::Bool => Ok(Value::Bool(args.get(0).map_or(Ok(false), |value| interp.truth(value))?)),
        Type::Float => args.get(0).map_or(Ok(0.0), float).map(Value::Float),
        Type::List | Type::YamlList => {
            Ok(Value::List(List::new(items(interp, args)?, kind == Type::YamlList)))
        }
        Type::Tuple => match args.at(0) {
            Value::Tuple(_) => Ok(args.at(0).clone()),
            _ => Ok(Value::Tuple(Tuple::new(items(interp, args)?))),
        },
        Type::Set | Type::FrozenSet => {
            let keys = items(interp, args)?.into_iter().map(Key::new).collect::<Eval<SetMap>>()?;
            Ok(Value::Set(Set::new(keys, kind == Type::FrozenSet)))
        }
        Type::Range => range(args),
        Type::Slice => Ok(slice(args)),
        Type::Map => map(interp, args),
        Type::Filter => filter(interp, args),
        Type::Reversed => reversed(interp, args.at(0)),
        Type::Type => match args.pos.as_slice() {
            [value] => Ok(Value::Type(Type::of(value))),
            _ => Err(Stop::typ("type() takes 1 or 3 arguments")),
        },
        Type::NoneType => Ok(Value::None),
        _ => Err(Stop::typ(format!("cannot create '{name}' instances"))),
    }
}

fn items(interp: &mut Interp, args: &Args) -> Eval<EcoVec<Value>> {
    args.get(0).map_or_else(|| Ok(EcoVec::new()), |value| interp.collect(value))
}

fn bind_int(args: Args) -> Eval<Args> {
    let given = args.len();
    if given > 2 {
        return Err(Stop::typ(format!("int() takes at most 2 arguments ({given} given)")));
    }
    // Only the base has a name.
    bind_named("int", &["", "base"], 0, 2, args)
}

fn int(args: Args) -> Eval {
    let Some(value) = args.get(0) else {
        return match args.get(1) {
            Some(_) => Err(Stop::typ("int() missing string argument")),
            None => Ok(Value::Int(0)),
        };
    };
    let Some(base) = args.get(1) else { return int_of(value) };
    let base = integer(base)?;
    let valid = base == 0 || (2..=36).contains(&base);
    match value {
        _ if !valid => Err(Stop::value("int() base must be >= 2 and <= 36, or 0")),
        Value::Str(text) => int_of_text(text, u32::try_from(base).unwrap_or(10), value),
        _ => Err(Stop::typ("int() can't convert non-string with explicit base")),
    }
}

/// `int(value)`
fn int_of(value: &Value) -> Eval {
    match value {
        Value::Int(_) | Value::Big(_) => Ok(value.clone()),
        Value::Bool(b) => Ok(Value::Int(i64::from(*b))),
        Value::Float(f) => float_to_int(*f),
        Value::Str(text) => int_of_text(text, 10, value),
        Value::Bytes(bytes) => int_of_text(&String::from_utf8_lossy(bytes), 10, value),
        other => {
            let kind = other.type_name();
            let wanted = "a string, a bytes-like object or a real number";
            Err(Stop::typ(format!("int() argument must be {wanted}, not '{kind}'")))
        }
    }
}

fn int_of_text(text: &str, base: u32, value: &Value) -> Eval {
    match parse_int(text, base) {
        ParsedInt::Int(int) => Ok(int),
        ParsedInt::TooLong(digits) => Err(Stop::value(format!(
            "Exceeds the limit (4300 digits) for integer string conversion: value has {digits} digits; \
             use sys.set_int_max_str_digits() to increase the limit"
        ))),
        ParsedInt::Invalid => {
            let shown: String = display::repr_of(value)?.chars().take(200).collect();
            Err(Stop::value(format!("invalid literal for int() with base {base}: {shown}")))
        }
    }
}

/// `float(value)`
pub(crate) fn float(value: &Value) -> Eval<f64> {
    let text = match value {
        Value::Str(text) => text.clone(),
        Value::Bytes(bytes) => String::from_utf8_lossy(bytes).into(),
        other => match Num::of(other).map(Num::float).transpose()?.flatten() {
            Some(float) => return Ok(float),
            None => {
                let kind = other.type_name();
                return Err(Stop::typ(format!(
                    "float() argument must be a string or a real number, not '{kind}'"
                )));
            }
        },
    };
    match parse_float(&text) {
        Some(float) => Ok(float),
        None => {
            let shown = display::repr_of(value)?;
            Err(Stop::value(format!("could not convert string to float: {shown}")))
        }
    }
}

/// `str(object, encoding, errors)`
fn text(interp: &mut Interp, args: Args) -> Eval {
    let args = bind_named("str", &["object", "encoding", "errors"], 0, 3, args)?;
    let Some(value) = args.get(0) else { return Ok(Value::from("")) };
    if args.get(1).is_none() && args.get(2).is_none() {
        let text = display::text_of(value)?;
        interp.budget.text(text.len() as u128)?;
        return Ok(Value::Str(text));
    }
    match value {
        Value::Bytes(bytes) => crate::expr::methods::decode(bytes, args.get(1), args.get(2)),
        Value::Str(_) => Err(Stop::typ("decoding str is not supported")),
        other => {
            let kind = other.type_name();
            Err(Stop::typ(format!("decoding to str: need a bytes-like object, {kind} found")))
        }
    }
}

/// The entries `dict(...)` gets.
fn entries(interp: &mut Interp, args: Args) -> Eval<DictMap> {
    check_count("dict", args.len(), 0, 1)?;
    let mut map = DictMap::default();
    if let Some(source) = args.get(0) {
        add_entries(interp, &mut map, source)?;
    }
    map.extend(args.named.into_iter().map(|(name, value)| (Key::text(name), value)));
    Ok(map)
}

/// What `dict.update(source)` adds.
pub(crate) fn add_entries(interp: &mut Interp, map: &mut DictMap, source: &Value) -> Eval<()> {
    if let Value::Dict(dict) = source {
        let other = dict.snapshot();
        interp.budget.items(other.len() as u128)?;
        map.extend(other.iter().map(|(key, value)| (key.clone(), value.clone())));
        return Ok(());
    }
    let mut cursor = interp.iter(source)?;
    let mut place = 0;
    while let Some(pair) = interp.next(&mut cursor)? {
        interp.budget.items(1)?;
        let pair = interp.collect(&pair).map_err(|stop| match stop {
            Stop::Raise(_) => {
                Stop::typ(format!("cannot convert dictionary update sequence element #{place} to a sequence"))
            }
            Stop::Unknown => Stop::Unknown,
        })?;
        let [key, value] = pair.as_slice() else {
            let len = pair.len();
            return Err(Stop::value(format!(
                "dictionary update sequence element #{place} has length {len}; 2 is required"
            )));
        };
        map.insert(Key::new(key.clone())?, value.clone());
        place += 1;
    }
    Ok(())
}

fn range(args: &Args) -> Eval {
    let number = |place: usize| -> Eval<i128> {
        let value = args.at(place);
        let limit = || Stop::budget("range bounds of more than 120 bits are not supported");
        let number = integer(value)?;
        if number.unsigned_abs() >> 120 == 0 { Ok(number) } else { Err(limit()) }
    };
    let (start, stop, step) = match args.len() {
        1 => (0, number(0)?, 1),
        2 => (number(0)?, number(1)?, 1),
        _ => (number(0)?, number(1)?, number(2)?),
    };
    if step == 0 {
        return Err(Stop::value("range() arg 3 must not be zero"));
    }
    Ok(Value::Range(Arc::new(Range { start, stop, step })))
}

fn slice(args: &Args) -> Value {
    let part = |place: usize| args.at(place).clone();
    let slice = match args.len() {
        1 => Slice { start: Value::None, stop: part(0), step: Value::None },
        _ => Slice { start: part(0), stop: part(1), step: part(2) },
    };
    Value::Slice(Arc::new(slice))
}

fn map(interp: &mut Interp, args: &Args) -> Eval {
    let [function, sources @ ..] = args.pos.as_slice() else {
        return Err(Stop::typ("map() must have at least two arguments."));
    };
    if sources.is_empty() {
        return Err(Stop::typ("map() must have at least two arguments."));
    }
    let sources = sources.iter().map(|source| interp.iter(source)).collect::<Eval<Vec<_>>>()?;
    let cursor = Cursor::Map { function: function.clone(), sources };
    Ok(Value::Iter(Iter::new(IterKind::Map, cursor)))
}

fn filter(interp: &mut Interp, args: &Args) -> Eval {
    let source = Box::new(interp.iter(args.at(1))?);
    let cursor = Cursor::Filter { function: args.at(0).clone(), source };
    Ok(Value::Iter(Iter::new(IterKind::Filter, cursor)))
}

fn zip(interp: &mut Interp, args: &Args) -> Eval {
    if let Some((name, _)) = args.named.iter().find(|(name, _)| name != "strict") {
        return Err(Stop::typ(format!("'{name}' is an invalid keyword argument for zip()")));
    }
    let strict = args.named("strict").map_or(Ok(false), |value| interp.truth(value))?;
    let sources = args.pos.iter().map(|source| interp.iter(source)).collect::<Eval<Vec<_>>>()?;
    Ok(Value::Iter(Iter::new(IterKind::Zip, Cursor::Zip { sources, strict })))
}

fn enumerate(interp: &mut Interp, args: &Args) -> Eval {
    let count = match args.get(1) {
        None => Value::Int(0),
        Some(value) => {
            integer(value)?;
            value.clone()
        }
    };
    let source = Box::new(interp.iter(args.at(0))?);
    Ok(Value::Iter(Iter::new(IterKind::Enumerate, Cursor::Enumerate { count, source })))
}

fn reversed(interp: &mut Interp, value: &Value) -> Eval {
    let cursor = match value {
        Value::List(list) => {
            let cursor = Cursor::ListBack(list.clone(), list.len());
            return Ok(Value::Iter(Iter::new(IterKind::Other("list_reverseiterator"), cursor)));
        }
        Value::Range(range) => {
            let len = range.len();
            let next = range.nth(len.saturating_sub(1));
            let cursor = Cursor::Range { next, step: -range.step, left: len };
            return Ok(Value::Iter(Iter::new(IterKind::Other("range_iterator"), cursor)));
        }
        Value::Tuple(_) | Value::Str(_) | Value::Bytes(_) | Value::Dict(_) | Value::View(_) => {
            let mut items = interp.collect(value)?;
            items.make_mut().reverse();
            Cursor::Items(items, 0)
        }
        other => return Err(Stop::typ(format!("'{}' object is not reversible", other.type_name()))),
    };
    let kind = match value {
        Value::Dict(_) => IterKind::Other("dict_reversekeyiterator"),
        _ => IterKind::Reversed,
    };
    Ok(Value::Iter(Iter::new(kind, cursor)))
}
