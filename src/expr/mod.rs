//! The expression language between `${` and `}`: splitter, parser, values, evaluator.

pub mod ast;
mod host;
mod value;

pub use host::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId};
pub use value::Value;
