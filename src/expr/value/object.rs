//! The less common objects.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::iterative_drop::{drop_iteratively, is_nested};
use super::{Dict, Str, Value};
use crate::ast;
use crate::builtins::Function;
use crate::host::ScopeId;

/// `range(start, stop, step)`
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// First number.
    pub start: i128,
    /// Number behind the last.
    pub stop: i128,
    /// Distance, not zero.
    pub step: i128,
}

impl Range {
    /// How many numbers it has.
    pub fn len(&self) -> u128 {
        let (low, high) = if self.step > 0 {
            (self.start, self.stop)
        } else {
            (self.stop, self.start)
        };
        if low >= high {
            return 0;
        }
        (high.abs_diff(low) - 1) / self.step.unsigned_abs() + 1
    }

    /// Whether it has none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The number at `index`; the caller has checked that it exists.
    pub(crate) fn nth(&self, index: u128) -> i128 {
        self.at(i128::try_from(index).unwrap_or(i128::MAX))
    }

    /// The number `place` steps behind the start, which may lie outside.
    pub(crate) fn at(&self, place: i128) -> i128 {
        self.start.saturating_add(self.step.saturating_mul(place))
    }

    /// Place of `number`, if it is one of the range's.
    pub(crate) fn position(&self, number: i128) -> Option<u128> {
        let inside = if self.step > 0 {
            self.start <= number && number < self.stop
        } else {
            self.stop < number && number <= self.start
        };
        let distance = number.abs_diff(self.start);
        let step = self.step.unsigned_abs();
        (inside && distance.is_multiple_of(step)).then(|| distance / step)
    }
}

/// `slice(start, stop, step)`
#[derive(Clone, Debug, Default)]
pub struct Slice {
    /// First index or `None`.
    pub start: Value,
    /// Index behind the last or `None`.
    pub stop: Value,
    /// Step or `None`.
    pub step: Value,
}

/// A live view of a dict.
#[derive(Clone, Debug)]
pub struct DictView {
    /// Of what.
    pub dict: Dict,
    /// What it shows.
    pub kind: ViewKind,
}

/// What a dict view shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum ViewKind {
    Keys,
    Values,
    Items,
}

/// The namespaces of global names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Module {
    Math,
    Python,
    Xacro,
}

impl Module {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Math => "math",
            Self::Python => "python",
            Self::Xacro => "xacro",
        }
    }
}

/// A method with its object; for a type as `receiver`, the plain function found on it.
#[derive(Debug)]
pub struct Bound {
    /// The object.
    pub(crate) receiver: Value,
    /// The method.
    pub(crate) function: &'static Function,
    /// Whether the first argument of a call is the object (`str.upper`).
    pub(crate) unbound: bool,
}

impl Drop for Bound {
    fn drop(&mut self) {
        if is_nested(&self.receiver) {
            drop_iteratively(std::mem::take(&mut self.receiver));
        }
    }
}

/// A function literal, the values of its defaults and the variables around it.
#[derive(Debug)]
pub struct Closure {
    pub(crate) lambda: Arc<ast::Lambda>,
    /// One per parameter that has a default.
    pub(crate) defaults: Vec<Option<Value>>,
    pub(crate) env: Option<Arc<Locals>>,
    /// The evaluation whose text the lambda stands in.
    pub(crate) home: u64,
    /// The host's scope in which its free names are looked up.
    pub(crate) scope: Option<ScopeId>,
}

impl Drop for Closure {
    fn drop(&mut self) {
        drop_iteratively((std::mem::take(&mut self.defaults), self.env.take()));
    }
}

/// Local variables of a lambda call, a comprehension or a whole evaluation.
#[derive(Debug)]
pub(crate) struct Locals {
    pub(crate) parent: Option<Arc<Locals>>,
    /// A comprehension: `:=` inside binds in the frame around it.
    pub(crate) comprehension: bool,
    vars: Mutex<Vec<(Str, Value)>>,
}

impl Locals {
    pub(crate) fn new(
        parent: Option<Arc<Locals>>,
        comprehension: bool,
        vars: Vec<(Str, Value)>,
    ) -> Self {
        Self {
            parent,
            comprehension,
            vars: Mutex::new(vars),
        }
    }

    fn vars(&self) -> MutexGuard<'_, Vec<(Str, Value)>> {
        self.vars.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The value of `name` in this frame alone.
    pub(crate) fn get(&self, name: &str) -> Option<Value> {
        self.vars()
            .iter()
            .find(|(n, _)| n == name)
            .map(|(_, value)| value.clone())
    }

    /// Bind `name` in this frame.
    pub(crate) fn set(&self, name: &Str, value: Value) {
        let mut vars = self.vars();
        let old = match vars.iter_mut().find(|(n, _)| n == name) {
            Some((_, slot)) => std::mem::replace(slot, value),
            None => {
                vars.push((name.clone(), value));
                return;
            }
        };
        // The old value may hold this frame: let go of the lock before it is dropped.
        drop(vars);
        drop(old);
    }
}

impl Drop for Locals {
    fn drop(&mut self) {
        let vars = std::mem::take(&mut *self.vars());
        drop_iteratively((vars, self.parent.take()));
    }
}
