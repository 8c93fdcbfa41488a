//! Why an evaluation stops early: an exception, or an operand that is unknown.

use super::{ErrorKind, EvalError};
use base::TextRange;

/// What interrupts the evaluation of a node.
#[derive(Clone, Debug)]
pub(crate) enum Stop {
    /// An operand is [`Value::Unknown`](super::Value::Unknown): the node's value is unknown too.
    Unknown,
    /// A Python exception.
    Raise(Box<EvalError>),
}

/// The result of most steps of the evaluator.
pub(crate) type Eval<T = super::Value> = Result<T, Stop>;

impl Stop {
    /// An exception of class `kind` whose place is not known yet.
    pub(crate) fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self::Raise(Box::new(EvalError::new(kind, message)))
    }

    /// `TypeError`
    pub(crate) fn typ(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Type, message)
    }

    /// `ValueError`
    pub(crate) fn value(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Value, message)
    }

    /// `OverflowError`
    pub(crate) fn overflow(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Overflow, message)
    }

    /// `IndexError`
    pub(crate) fn index(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Index, message)
    }

    /// `ZeroDivisionError`
    pub(crate) fn zero(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::ZeroDivision, message)
    }

    /// A limit of ours was hit.
    pub(crate) fn budget(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Budget, message)
    }

    /// Too deeply nested data or calls.
    pub(crate) fn recursion(what: &str) -> Self {
        Self::new(
            ErrorKind::Recursion,
            format!("maximum recursion depth exceeded{what}"),
        )
    }

    /// The same, placed at `range` if it has no place yet.
    pub(crate) fn at(self, range: TextRange) -> Self {
        match self {
            Self::Raise(error) => Self::Raise(Box::new(error.at(range))),
            other => other,
        }
    }

    /// Whether this is an exception of class `kind`.
    pub(crate) fn is(&self, kind: &ErrorKind) -> bool {
        matches!(self, Self::Raise(error) if error.kind == *kind)
    }
}

impl From<EvalError> for Stop {
    fn from(error: EvalError) -> Self {
        Self::Raise(Box::new(error))
    }
}
