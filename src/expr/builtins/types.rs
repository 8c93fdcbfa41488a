//! Types that can be called: conversions and constructors.

use ecow::EcoVec;

use super::Function;
use super::convert::{bind_int, entries, float, int, text};
use super::iterators::{enumerate, filter, map, range, reversed, slice, zip};
use crate::args::{Args, Arity, bind_named, check_count};
use crate::interp::Interp;
use crate::stop::{Eval, Stop};
use crate::value::{Dict, Key, List, Set, SetMap, Tuple, Type, Value};

/// Types that have a name in expressions: name, type, parameters, description.
pub(super) static NAMED: &[(&str, Type, &str, &str)] = &[
    (
        "bool",
        Type::Bool,
        "x=False",
        "True or False, whichever x counts as.",
    ),
    (
        "complex",
        Type::Complex,
        "real=0, imag=0",
        "A complex number from two numbers or a text.",
    ),
    (
        "dict",
        Type::Dict,
        "iterable=(), **entries",
        "A dictionary from pairs, another dictionary or names.",
    ),
    (
        "dotify",
        Type::YamlDict,
        "dict",
        "The dictionary with its entries as attributes: d.key.",
    ),
    (
        "enumerate",
        Type::Enumerate,
        "iterable, start=0",
        "Pairs of index and item.",
    ),
    (
        "filter",
        Type::Filter,
        "function, iterable",
        "The items for which the function is true.",
    ),
    (
        "float",
        Type::Float,
        "x=0",
        "A floating point number from a number or text.",
    ),
    (
        "frozenset",
        Type::FrozenSet,
        "iterable=()",
        "A set that cannot be changed.",
    ),
    (
        "int",
        Type::Int,
        "x=0, base=10",
        "A whole number from a number (cut off) or text.",
    ),
    ("list", Type::List, "iterable=()", "A list of the items."),
    (
        "map",
        Type::Map,
        "function, *iterables",
        "The function's results for each item.",
    ),
    (
        "range",
        Type::Range,
        "start=0, stop, step=1",
        "The whole numbers from start up to stop, without stop.",
    ),
    (
        "reversed",
        Type::Reversed,
        "sequence",
        "The items from last to first.",
    ),
    ("set", Type::Set, "iterable=()", "The distinct items."),
    (
        "slice",
        Type::Slice,
        "start, stop, step=None",
        "The slice between the brackets of s[a:b:c].",
    ),
    ("str", Type::Str, "object=''", "The text of any value."),
    ("tuple", Type::Tuple, "iterable=()", "A tuple of the items."),
    ("type", Type::Type, "object", "The type of a value."),
    (
        "zip",
        Type::Zip,
        "*iterables, strict=False",
        "Tuples of the items at the same place.",
    ),
];

/// The type with a name in expressions; `dotify` has its name in another namespace.
pub(super) fn named(name: &str) -> Option<Type> {
    NAMED
        .iter()
        .find(|named| named.0 == name && name != "dotify")
        .map(|named| named.1)
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
    Args {
        pos: args.pos.clone(),
        named: args.named.clone(),
    }
}

/// `kind(*args)`; no argument is unknown.
pub(crate) fn construct(interp: &mut Interp, kind: Type, args: Args) -> Eval {
    match kind {
        Type::Int => int(bind_int(args)?),
        Type::Str => text(interp, args),
        Type::Dict => Ok(Value::Dict(Dict::new(entries(interp, args)?, false))),
        Type::YamlDict => Ok(Value::Dict(Dict::new(entries(interp, args)?, true))),
        Type::Complex => {
            super::complex::construct(&bind_named("complex", &["real", "imag"], 0, 2, args)?)
        }
        Type::Enumerate if args.pos.is_empty() && args.named("iterable").is_none() => {
            if let Some((name, _)) = args.named.iter().find(|(name, _)| name != "start") {
                return Err(Stop::typ(format!(
                    "'{name}' is an invalid keyword argument for enumerate()"
                )));
            }
            Err(Stop::typ(
                "enumerate() missing required argument 'iterable'",
            ))
        }
        Type::Enumerate => enumerate(
            interp,
            &bind_named("enumerate", &["iterable", "start"], 1, 2, args)?,
        ),
        Type::Zip => zip(interp, &args),
        _ => {
            if !args.named.is_empty() && kind == Type::Type {
                return Err(Stop::typ("type() takes 1 or 3 arguments"));
            }
            if !args.named.is_empty() {
                return Err(Stop::typ(format!(
                    "{}() takes no keyword arguments",
                    kind.name()
                )));
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
        Type::Bool => Ok(Value::Bool(
            args.get(0).map_or(Ok(false), |value| interp.truth(value))?,
        )),
        Type::Float => args.get(0).map_or(Ok(0.0), float).map(Value::Float),
        Type::List | Type::YamlList => Ok(Value::List(List::new(
            items(interp, args)?,
            kind == Type::YamlList,
        ))),
        Type::Tuple => match args.at(0) {
            Value::Tuple(_) => Ok(args.at(0).clone()),
            _ => Ok(Value::Tuple(Tuple::new(items(interp, args)?))),
        },
        Type::Set | Type::FrozenSet => {
            let keys = items(interp, args)?
                .into_iter()
                .map(Key::new)
                .collect::<Eval<SetMap>>()?;
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
    args.get(0)
        .map_or_else(|| Ok(EcoVec::new()), |value| interp.collect(value))
}
