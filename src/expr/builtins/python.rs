//! The functions of the `python` namespace that are no types.

use super::{Function, sorting};
use crate::args::{Args, Arity};
use crate::ast::BinOp;
use crate::host::ErrorKind;
use crate::interp::Interp;
use crate::numeric::Num;
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::{Dict, DictMap, Key, List, Type, Value, hash_value};

const fn function(
    name: &'static str,
    params: &'static str,
    arity: Arity,
    run: super::BuiltinFn,
    doc: &'static str,
) -> Function {
    Function {
        name,
        owner: "",
        params,
        doc,
        arity,
        run,
    }
}

/// All names in the order in which the reference lists them.
pub(super) static NAMES: &[&str] = &[
    "sorted",
    "range",
    "list",
    "dict",
    "map",
    "len",
    "str",
    "float",
    "int",
    "bool",
    "True",
    "False",
    "min",
    "max",
    "round",
    "abs",
    "all",
    "any",
    "complex",
    "divmod",
    "enumerate",
    "filter",
    "frozenset",
    "hash",
    "isinstance",
    "issubclass",
    "ord",
    "repr",
    "reversed",
    "slice",
    "set",
    "sum",
    "tuple",
    "type",
    "vars",
    "zip",
];

/// Sorted by name.
pub(super) static FUNCTIONS: &[Function] = &[
    function("abs", "x", Arity::One, abs, "The absolute value."),
    function(
        "all",
        "iterable",
        Arity::One,
        all,
        "Whether every item is true.",
    ),
    function(
        "any",
        "iterable",
        Arity::One,
        any,
        "Whether at least one item is true.",
    ),
    function(
        "divmod",
        "a, b",
        Arity::Range(2, 2),
        divmod,
        "Quotient and remainder as a tuple.",
    ),
    function(
        "hash",
        "object",
        Arity::One,
        hash,
        "An integer that is equal for equal values.",
    ),
    function(
        "isinstance",
        "object, type",
        Arity::Range(2, 2),
        isinstance,
        "Whether a value is of a type.",
    ),
    function(
        "issubclass",
        "type, parent",
        Arity::Range(2, 2),
        issubclass,
        "Whether a type derives from another.",
    ),
    function("len", "object", Arity::One, len, "The number of items."),
    function(
        "max",
        "*values, key=None, default",
        Arity::Any,
        |i, _, a| sorting::extreme(i, a, true),
        "The largest value.",
    ),
    function(
        "min",
        "*values, key=None, default",
        Arity::Any,
        |i, _, a| sorting::extreme(i, a, false),
        "The smallest value.",
    ),
    function(
        "ord",
        "character",
        Arity::One,
        ord,
        "The code of a character.",
    ),
    function(
        "repr",
        "object",
        Arity::One,
        repr,
        "The text of a value as it is written in an expression.",
    ),
    function(
        "round",
        "number, ndigits=None",
        Arity::Named {
            names: &["number", "ndigits"],
            required: 1,
            positional: 2,
        },
        super::rounding::round,
        "The number rounded, halves to the even side.",
    ),
    function(
        "sorted",
        "iterable, *, key=None, reverse=False",
        Arity::Any,
        sorting::sorted,
        "The items in ascending order.",
    ),
    function(
        "sum",
        "iterable, start=0",
        Arity::Named {
            names: &["", "start"],
            required: 1,
            positional: 2,
        },
        sum,
        "The sum of the items.",
    ),
    function(
        "vars",
        "object",
        Arity::Range(0, 1),
        vars,
        "The attributes of an object.",
    ),
];

/// The integer a value stands for, clipped to an `i128`.
pub(crate) fn integer(value: &Value) -> Eval<i128> {
    ops::as_index(value).ok_or_else(|| {
        Stop::typ(format!(
            "'{}' object cannot be interpreted as an integer",
            value.type_name()
        ))
    })
}

/// An integer that fits an index or count of CPython.
pub(crate) fn index_sized(value: &Value) -> Eval<i128> {
    let number = integer(value)?;
    match i64::try_from(number) {
        Ok(_) => Ok(number),
        Err(_) => Err(Stop::overflow(
            "Python int too large to convert to C ssize_t",
        )),
    }
}

/// The type of an argument as messages about a wrong one name it.
pub(crate) fn argument_type(value: &Value) -> &'static str {
    match value {
        Value::None => "None",
        other => other.type_name(),
    }
}

fn abs(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let value = args.at(0);
    match Num::of(value) {
        Some(Num::Int(i)) => Ok(i
            .checked_abs()
            .map_or_else(|| Value::int(i128::from(i).abs()), Value::Int)),
        Some(Num::Big(big)) => Ok(Value::int(num_bigint::BigInt::from(
            big.magnitude().clone(),
        ))),
        Some(Num::Float(f)) => Ok(Value::Float(f.abs())),
        Some(Num::Complex(re, im)) => {
            let length = crate::elementary::hypot(re, im);
            if length.is_infinite() && re.is_finite() && im.is_finite() {
                return Err(Stop::overflow("absolute value too large"));
            }
            Ok(Value::Float(length))
        }
        None => Err(Stop::typ(format!(
            "bad operand type for abs(): '{}'",
            value.type_name()
        ))),
    }
}

fn all(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    holds_for_all(interp, args.at(0), true)
}

fn any(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    Ok(match holds_for_all(interp, args.at(0), false)? {
        Value::Bool(none) => Value::Bool(!none),
        other => other,
    })
}

/// Whether every item has the truth `expected`.
fn holds_for_all(interp: &mut Interp, iterable: &Value, expected: bool) -> Eval {
    let mut cursor = interp.iter(iterable)?;
    while let Some(item) = interp.next(&mut cursor)? {
        if interp.truth(&item)? != expected {
            return Ok(Value::Bool(false));
        }
    }
    Ok(Value::Bool(true))
}

fn divmod(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (a, b) = (args.at(0), args.at(1));
    let (Some(x), Some(y)) = (Num::of(a), Num::of(b)) else {
        return Err(ops::unsupported_as("divmod()", a, b));
    };
    if let (Some(x), Some(y)) = (x.big(), y.big()) {
        if *y == num_bigint::BigInt::ZERO {
            return Err(Stop::zero("integer division or modulo by zero"));
        }
        interp.budget.steps(x.bits() / 64 * (y.bits() / 64) / 32)?;
        let (quotient, rest) = ops::int::div_mod(&x, &y);
        return Ok(Value::tuple_from([Value::int(quotient), Value::int(rest)]));
    }
    let (Some(x), Some(y)) = (x.float()?, y.float()?) else {
        return Err(ops::unsupported_as("divmod()", a, b));
    };
    if y == 0.0 {
        return Err(Stop::zero("float divmod()"));
    }
    let (quotient, rest) = ops::float::div_mod(x, y);
    Ok(Value::tuple_from([
        Value::Float(quotient),
        Value::Float(rest),
    ]))
}

fn hash(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let key = Key::new(args.at(0).clone())?;
    Ok(Value::Int(hash_value(key.value())))
}

fn isinstance(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let message = "isinstance() arg 2 must be a type, a tuple of types, or a union";
    is_one_of(Type::of(args.at(0)), args.at(1), message, 0).map(Value::Bool)
}

fn issubclass(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let Value::Type(kind) = args.at(0) else {
        return Err(Stop::typ("issubclass() arg 1 must be a class"));
    };
    let message = "issubclass() arg 2 must be a class, a tuple of classes, or a union";
    is_one_of(*kind, args.at(1), message, 0).map(Value::Bool)
}

fn is_one_of(kind: Type, wanted: &Value, message: &str, depth: u32) -> Eval<bool> {
    match wanted {
        Value::Unknown => Err(Stop::Unknown),
        Value::Type(wanted) => Ok(kind.is_subclass(*wanted)),
        Value::Tuple(tuple) if depth < 50 => {
            for wanted in tuple.items() {
                if is_one_of(kind, wanted, message, depth + 1)? {
                    return Ok(true);
                }
            }
            Ok(false)
        }
        _ => Err(Stop::typ(message)),
    }
}

fn len(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let value = args.at(0);
    let count = match value {
        Value::Str(text) => {
            interp.budget.steps(text.len() as u64 / 256)?;
            text.chars().count() as u128
        }
        Value::Bytes(bytes) => bytes.len() as u128,
        Value::List(list) => list.len() as u128,
        Value::Tuple(tuple) => tuple.items().len() as u128,
        Value::Dict(dict) => dict.len() as u128,
        Value::View(view) => view.dict.len() as u128,
        Value::Set(set) => set.len() as u128,
        Value::Range(range) => range.len(),
        Value::Scope(_) | Value::Module(_) => interp.entries(value)?.len() as u128,
        other => {
            return Err(Stop::typ(format!(
                "object of type '{}' has no len()",
                other.type_name()
            )));
        }
    };
    match i64::try_from(count) {
        Ok(count) => Ok(Value::Int(count)),
        Err(_) => Err(Stop::overflow(
            "Python int too large to convert to C ssize_t",
        )),
    }
}

fn ord(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (code, len) = match args.at(0) {
        Value::Str(text) => (text.chars().next().map(u32::from), text.chars().count()),
        Value::Bytes(bytes) => (bytes.first().map(|&b| u32::from(b)), bytes.len()),
        other => {
            let kind = other.type_name();
            return Err(Stop::typ(format!(
                "ord() expected string of length 1, but {kind} found"
            )));
        }
    };
    match code {
        Some(code) if len == 1 => Ok(Value::Int(i64::from(code))),
        _ => Err(Stop::typ(format!(
            "ord() expected a character, but string of length {len} found"
        ))),
    }
}

fn repr(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    interp.repr(args.at(0)).map(Value::Str)
}

fn sum(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let mut cursor = interp.iter(args.at(0))?;
    let mut total = args.get(1).cloned().unwrap_or(Value::Int(0));
    match &total {
        Value::Str(_) => {
            return Err(Stop::typ(
                "sum() can't sum strings [use ''.join(seq) instead]",
            ));
        }
        Value::Bytes(_) => {
            return Err(Stop::typ(
                "sum() can't sum bytes [use b''.join(seq) instead]",
            ));
        }
        _ => {}
    }
    while let Some(item) = interp.next(&mut cursor)? {
        total = ops::binary(interp, BinOp::Add, &total, &item)?;
    }
    Ok(total)
}

fn vars(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    match args.get(0) {
        Some(Value::List(list)) if list.is_yaml() => {
            Ok(Value::Dict(Dict::new(DictMap::default(), false)))
        }
        Some(Value::Dict(dict)) if dict.is_yaml() => {
            Ok(Value::Dict(Dict::new(DictMap::default(), false)))
        }
        Some(Value::Scope(_) | Value::Module(_) | Value::Lambda(_)) => {
            Ok(Value::Dict(Dict::new(DictMap::default(), false)))
        }
        // Without an argument it shows the properties, which only the host knows.
        None => Err(Stop::Unknown),
        Some(_) => Err(Stop::typ("vars() argument must have __dict__ attribute")),
    }
}

/// A new list, for callers that gathered items.
pub(super) fn list_of(items: impl IntoIterator<Item = Value>) -> Value {
    Value::List(List::new(items.into_iter().collect(), false))
}

/// Whether an error is the one of a sequence that is empty.
pub(super) fn empty_sequence(name: &str) -> Stop {
    Stop::new(
        ErrorKind::Value,
        format!("{name}() arg is an empty sequence"),
    )
}
