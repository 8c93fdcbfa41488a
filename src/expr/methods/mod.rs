//! Methods of values.

mod bytes;
mod dicts;
mod lists;
mod numbers;
mod sets;
mod text;
mod text_case;
mod text_layout;
mod text_search;
mod text_split;

pub(crate) use bytes::decode;

use super::args::Arity;
use super::builtins::{Function, argument_type, find as find_in};
use super::stop::{Eval, Stop};
use super::value::{Type, Value};

/// Methods with names, arities and code, in the order of names.
macro_rules! methods {
    ($owner:literal: $($name:literal $arity:expr => $run:expr,)*) => {
        &[$(crate::builtins::Function::method($owner, $name, $arity, $run),)*]
    };
}
use methods;

/// Between so many positional arguments.
const fn up_to(min: usize, max: usize) -> Arity {
    Arity::Range(min, max)
}

/// Arguments by position or name, none of them required.
const fn optional(names: &'static [&'static str]) -> Arity {
    Arity::Named {
        names,
        required: 0,
        positional: names.len(),
    }
}

fn table(kind: Type) -> &'static [Function] {
    match kind {
        Type::Str => text::METHODS,
        Type::List | Type::YamlList => lists::LIST,
        Type::Tuple => lists::TUPLE,
        Type::Range => lists::RANGE,
        Type::Dict | Type::YamlDict => dicts::METHODS,
        Type::DictKeys | Type::DictItems => dicts::VIEW,
        Type::Set => sets::SET,
        Type::FrozenSet => sets::FROZEN,
        Type::Int | Type::Bool => numbers::INT,
        Type::Float => numbers::FLOAT,
        Type::Complex => numbers::COMPLEX,
        Type::Bytes => bytes::METHODS,
        Type::Slice => lists::SLICE,
        Type::Date | Type::DateTime => numbers::DATE,
        _ => &[],
    }
}

/// Functions that are called on a type rather than on one of its values.
fn class_table(kind: Type) -> &'static [Function] {
    match kind {
        Type::Str => text::CLASS,
        Type::Dict | Type::YamlDict => dicts::CLASS,
        Type::Int | Type::Bool => numbers::INT_CLASS,
        Type::Float => numbers::FLOAT_CLASS,
        Type::Bytes => bytes::CLASS,
        _ => &[],
    }
}

/// The method `name` of a value; for a type, one of its class methods.
pub(crate) fn find(value: &Value, name: &str) -> Option<&'static Function> {
    match value {
        Value::Type(kind) => find_in(class_table(*kind), name),
        Value::Unknown | Value::Module(_) | Value::Scope(_) => None,
        other => {
            let kind = Type::of(other);
            find_in(table(kind), name).or_else(|| find_in(class_table(kind), name))
        }
    }
}

/// The method that the values of a type have.
pub(crate) fn of_type(kind: Type, name: &str) -> Option<&'static Function> {
    find_in(table(kind), name)
}

/// The names of the methods of a type, for completion.
pub fn method_names(kind: Type) -> impl Iterator<Item = &'static str> {
    table(kind)
        .iter()
        .chain(class_table(kind))
        .map(|function| function.name)
}

/// A string argument; `what` starts the message of the error, as in `replace() argument 1`.
fn string<'a>(value: &'a Value, what: &str) -> Eval<&'a str> {
    match value {
        Value::Str(text) => Ok(text),
        other => {
            let (kind, named) = (other.type_name(), argument_type(other));
            Err(Stop::typ(match what {
                "" => format!("must be str, not {kind}"),
                what => format!("{what} must be str, not {named}"),
            }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_sorted() {
        let kinds = [
            Type::Str,
            Type::List,
            Type::Tuple,
            Type::Range,
            Type::Dict,
            Type::DictKeys,
            Type::Set,
            Type::FrozenSet,
            Type::Int,
            Type::Float,
            Type::Complex,
            Type::Bytes,
            Type::Slice,
            Type::Date,
        ];
        for kind in kinds {
            for table in [table(kind), class_table(kind)] {
                assert!(table.is_sorted_by_key(|function| function.name), "{kind:?}");
            }
        }
    }
}
