//! The expression language between `${` and `}`: splitter, parser, values, evaluator.

pub mod ast;
mod escape;
mod host;
mod lexer;
mod number;
mod parser;
mod report;
mod substitution;
mod syntax;
mod template;
mod value;
pub mod visit;

pub use host::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId};
pub use substitution::{Subst, SubstArg, SubstError, parse_substitution, resolve};
pub use syntax::{ExprError, ExprErrorKind, NameUse, Parsed, is_identifier, is_python_space, names, parse};
pub use template::{Code, Template, Token, split};
pub use value::{Value,Budget,evaluate,display,literal,truth,global_symbol,math_symbol,python_builtin,parse_int,parse_float};
