//! The expression language between `${` and `}`: splitter, parser, values, evaluator.

pub mod ast;
#[cfg(test)]
mod dump;
mod escape;
mod host;
mod lexer;
mod number;
mod parser;
mod report;
mod substitution;
mod syntax;
mod template;
mod token;
mod value;
pub mod visit;

pub use host::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId};
pub use substitution::{Subst, SubstArg, SubstError, parse_substitution, resolve_substitution};
pub use syntax::{ExprError, ExprErrorKind, NameUse, Parsed, is_identifier, is_python_space, names, parse};
pub use template::{Code, Template, Token, split};
pub use value::Value;
