//! The values of expressions.

mod containers;
mod date;
mod iterative_drop;
mod key;
mod object;
mod types;

use std::sync::Arc;

use ecow::{EcoString, EcoVec};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

use super::host::ScopeId;
use super::stop::{Eval, Stop};
pub use containers::{Dict, List, Set, Tuple, changes_in_place};
pub(crate) use containers::{DictMap, SetMap};
pub use date::DateValue;
pub(crate) use date::{date_repr, date_text};
pub(crate) use iterative_drop::drop_iteratively;
pub(crate) use key::{Key, hash_value};
pub(crate) use object::{Bound, Closure, Locals};
pub use object::{DictView, Module, Range, Slice, ViewKind};
pub use types::Type;

use super::builtins::Function;
use super::iter::Iter;

/// A Python string; short ones live in the value itself.
pub type Str = EcoString;

/// A Python value.
///
/// Lists, dicts, sets and iterators are shared objects: a clone is the same object.
#[derive(Clone, Debug, Default)]
pub enum Value {
    /// The value of something that already failed: flows through everything and keeps later checks quiet.
    #[default]
    Unknown,
    /// `None`
    None,
    /// `...`
    Ellipsis,
    /// `True`, `False`
    Bool(bool),
    /// An integer that fits.
    Int(i64),
    /// An integer that does not fit [`Value::Int`].
    Big(Arc<BigInt>),
    /// A float, with `inf` and `nan`.
    Float(f64),
    /// A complex number.
    Complex(f64, f64),
    /// A string of Unicode characters.
    Str(Str),
    /// `bytes`
    Bytes(EcoVec<u8>),
    /// A list, from YAML or not.
    List(List),
    /// A tuple, which cannot change in place.
    Tuple(Tuple),
    /// A dict, from YAML or not.
    Dict(Dict),
    /// A set or frozenset.
    Set(Set),
    /// `range(…)`, whose numbers are not stored.
    Range(Arc<Range>),
    /// A slice object.
    Slice(Arc<Slice>),
    /// `d.keys()`, `d.values()`, `d.items()`
    View(Arc<DictView>),
    /// An iterator or generator.
    Iter(Iter),
    /// A type, such as `int`.
    Type(Type),
    /// A function of a global name.
    Builtin(Builtin),
    /// A method and the object it belongs to.
    Method(Arc<Bound>),
    /// A function literal and what it closes over.
    Lambda(Arc<Closure>),
    /// A date or date and time from YAML.
    Date(Arc<DateValue>),
    /// A property scope of the host (`ns=` of an include).
    Scope(ScopeId),
    /// `math`, `python` or `xacro`.
    Module(Module),
}

/// A function of the global names.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    /// Which.
    pub(crate) function: &'static Function,
    /// The namespace it should have been taken from, when it was taken from the bare name.
    pub(crate) deprecated: Option<&'static str>,
}

const _: () = {
    const fn shared<T: Send + Sync>() {}
    shared::<Value>();
};

impl Value {
    /// A string.
    pub fn str(text: impl Into<Str>) -> Self {
        Self::Str(text.into())
    }

    /// An integer of any size.
    pub fn int(number: impl Into<BigInt>) -> Self {
        let number = number.into();
        match number.to_i64() {
            Some(small) => Self::Int(small),
            None => Self::Big(Arc::new(number)),
        }
    }

    /// An integer.
    pub(crate) fn wide(number: i128) -> Self {
        i64::try_from(number).map_or_else(|_| Self::int(number), Self::Int)
    }

    /// A list; `yaml` gives its nested lists and dicts the behavior of values from a YAML file.
    pub fn list_from(items: impl IntoIterator<Item = Value>, yaml: bool) -> Self {
        Self::List(List::new(items.into_iter().collect(), yaml))
    }

    /// A dict; later entries replace earlier ones with an equal key, and entries whose key is not hashable are left out.
    /// `yaml` gives it dotted access.
    pub fn dict_from(entries: impl IntoIterator<Item = (Value, Value)>, yaml: bool) -> Self {
        let mut map = DictMap::default();
        for (key, value) in entries {
            if let Ok(key) = Key::new(key) {
                map.insert(key, value);
            }
        }
        Self::Dict(Dict::new(map, yaml))
    }

    /// A set; elements that are not hashable are left out.
    pub fn set_from(items: impl IntoIterator<Item = Value>) -> Self {
        Self::Set(Set::new(
            items
                .into_iter()
                .filter_map(|item| Key::new(item).ok())
                .collect(),
            false,
        ))
    }

    /// A tuple.
    pub fn tuple_from(items: impl IntoIterator<Item = Value>) -> Self {
        Self::Tuple(Tuple::new(items.into_iter().collect()))
    }

    pub(crate) fn list(items: impl IntoIterator<Item = Value>) -> Self {
        Self::list_from(items, false)
    }

    /// Whether this is [`Value::Unknown`].
    pub fn is_unknown(&self) -> bool {
        matches!(self, Self::Unknown)
    }

    /// The name of its type as error messages show it.
    pub fn type_name(&self) -> &'static str {
        Type::of(self).name()
    }

    /// The text of a string.
    pub fn as_str(&self) -> Option<&str> {
        match self {
            Self::Str(text) => Some(text),
            _ => None,
        }
    }

    /// What a Python program sees in a list or dict of a YAML file: nested plain containers become wrappers too.
    pub(crate) fn wrapped(self) -> Self {
        match self {
            Self::List(list) => Self::List(list.copied(true)),
            Self::Dict(dict) => Self::Dict(dict.copied(true)),
            other => other,
        }
    }

    /// Python's `is`; equal scalars count as one object, as equal constants do in CPython.
    pub(crate) fn same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::None, Self::None) | (Self::Ellipsis, Self::Ellipsis) => true,
            (Self::Bool(a), Self::Bool(b)) => a == b,
            (Self::Int(a), Self::Int(b)) => a == b,
            (Self::Str(a), Self::Str(b)) => a == b,
            (Self::Float(a), Self::Float(b)) => a.to_bits() == b.to_bits(),
            (Self::Type(a), Self::Type(b)) => a == b,
            (Self::Builtin(a), Self::Builtin(b)) => std::ptr::eq(a.function, b.function),
            (Self::Module(a), Self::Module(b)) => a == b,
            (Self::Scope(a), Self::Scope(b)) => a == b,
            _ => matches!((self.address(), other.address()), (Some(a), Some(b)) if a == b),
        }
    }

    /// The address of a shared object, which identifies it while it lives.
    pub(crate) fn address(&self) -> Option<usize> {
        Some(match self {
            Self::Big(x) => Arc::as_ptr(x) as usize,
            Self::List(x) => x.address(),
            Self::Tuple(x) => x.address(),
            Self::Dict(x) => x.address(),
            Self::Set(x) => x.address(),
            Self::Range(x) => Arc::as_ptr(x) as usize,
            Self::Slice(x) => Arc::as_ptr(x) as usize,
            Self::View(x) => Arc::as_ptr(x) as usize,
            Self::Iter(x) => x.address(),
            Self::Method(x) => Arc::as_ptr(x) as usize,
            Self::Lambda(x) => Arc::as_ptr(x) as usize,
            Self::Date(x) => Arc::as_ptr(x) as usize,
            _ => return None,
        })
    }

    /// The same, or a stop when it is unknown.
    pub(crate) fn known(self) -> Eval {
        if self.is_unknown() {
            Err(Stop::Unknown)
        } else {
            Ok(self)
        }
    }
}

impl From<bool> for Value {
    fn from(value: bool) -> Self {
        Self::Bool(value)
    }
}

impl From<i64> for Value {
    fn from(value: i64) -> Self {
        Self::Int(value)
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Float(value)
    }
}

impl From<&str> for Value {
    fn from(value: &str) -> Self {
        Self::Str(value.into())
    }
}

impl From<String> for Value {
    fn from(value: String) -> Self {
        Self::Str(value.into())
    }
}
