//! The types of values.

use super::{Value, ViewKind};
use crate::iter::IterKind;

/// A Python type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Type {
    NoneType,
    Ellipsis,
    Bool,
    Int,
    Float,
    Complex,
    Str,
    Bytes,
    List,
    YamlList,
    Tuple,
    Dict,
    YamlDict,
    Set,
    FrozenSet,
    Range,
    Slice,
    DictKeys,
    DictValues,
    DictItems,
    Map,
    Filter,
    Zip,
    Enumerate,
    Reversed,
    Generator,
    Iterator(&'static str),
    Type,
    Builtin,
    Method,
    MethodDescriptor,
    Function,
    Date,
    DateTime,
    NameSpace,
}

impl Type {
    /// The type of `value`; that of an unknown value is arbitrary.
    pub(crate) fn of(value: &Value) -> Self {
        match value {
            Value::Unknown | Value::None => Self::NoneType,
            Value::Ellipsis => Self::Ellipsis,
            Value::Bool(_) => Self::Bool,
            Value::Int(_) | Value::Big(_) => Self::Int,
            Value::Float(_) => Self::Float,
            Value::Complex(..) => Self::Complex,
            Value::Str(_) => Self::Str,
            Value::Bytes(_) => Self::Bytes,
            Value::List(list) if list.is_yaml() => Self::YamlList,
            Value::List(_) => Self::List,
            Value::Tuple(_) => Self::Tuple,
            Value::Dict(dict) if dict.is_yaml() => Self::YamlDict,
            Value::Dict(_) => Self::Dict,
            Value::Set(set) if set.is_frozen() => Self::FrozenSet,
            Value::Set(_) => Self::Set,
            Value::Range(_) => Self::Range,
            Value::Slice(_) => Self::Slice,
            Value::View(view) => match view.kind {
                ViewKind::Keys => Self::DictKeys,
                ViewKind::Values => Self::DictValues,
                ViewKind::Items => Self::DictItems,
            },
            Value::Iter(iter) => of_iterator(iter.kind()),
            Value::Type(_) => Self::Type,
            Value::Builtin(builtin)
                if builtin.deprecated.is_some() || builtin.function.is_python() =>
            {
                Self::Function
            }
            Value::Builtin(_) => Self::Builtin,
            Value::Method(method) if method.unbound => Self::MethodDescriptor,
            Value::Method(_) => Self::Builtin,
            Value::Lambda(_) => Self::Function,
            Value::Date(date) if date.time.is_some() => Self::DateTime,
            Value::Date(_) => Self::Date,
            Value::Scope(_) | Value::Module(_) => Self::NameSpace,
        }
    }

    /// Its name as error messages show it.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoneType => "NoneType",
            Self::Ellipsis => "ellipsis",
            Self::Bool => "bool",
            Self::Int => "int",
            Self::Float => "float",
            Self::Complex => "complex",
            Self::Str => "str",
            Self::Bytes => "bytes",
            Self::List => "list",
            Self::YamlList => "YamlListWrapper",
            Self::Tuple => "tuple",
            Self::Dict => "dict",
            Self::YamlDict => "YamlDictWrapper",
            Self::Set => "set",
            Self::FrozenSet => "frozenset",
            Self::Range => "range",
            Self::Slice => "slice",
            Self::DictKeys => "dict_keys",
            Self::DictValues => "dict_values",
            Self::DictItems => "dict_items",
            Self::Map => "map",
            Self::Filter => "filter",
            Self::Zip => "zip",
            Self::Enumerate => "enumerate",
            Self::Reversed => "reversed",
            Self::Generator => "generator",
            Self::Iterator(name) => name,
            Self::Type => "type",
            Self::Builtin => "builtin_function_or_method",
            Self::Method => "method",
            Self::MethodDescriptor => "method_descriptor",
            Self::Function => "function",
            Self::Date => "datetime.date",
            Self::DateTime => "datetime.datetime",
            Self::NameSpace => "NameSpace",
        }
    }

    /// What `repr()` shows between `<class '` and `'>`.
    pub(crate) fn qualified_name(self) -> String {
        match self {
            Self::YamlList | Self::YamlDict | Self::NameSpace => format!("xacro.{}", self.name()),
            other => other.name().to_owned(),
        }
    }

    /// Python's `issubclass`.
    pub(crate) fn is_subclass(self, other: Type) -> bool {
        self == other
            || matches!(
                (self, other),
                (Self::Bool, Self::Int)
                    | (Self::YamlList, Self::List)
                    | (Self::YamlDict | Self::NameSpace, Self::Dict)
                    | (Self::DateTime, Self::Date)
            )
    }
}

fn of_iterator(kind: IterKind) -> Type {
    match kind {
        IterKind::Map => Type::Map,
        IterKind::Filter => Type::Filter,
        IterKind::Zip => Type::Zip,
        IterKind::Enumerate => Type::Enumerate,
        IterKind::Reversed => Type::Reversed,
        IterKind::Generator => Type::Generator,
        IterKind::Other(name) => Type::Iterator(name),
    }
}
