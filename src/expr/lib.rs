//! The expression language between `${` and `}`: splitter, parser, values, evaluator.

mod args;
pub mod ast;
mod attribute;
mod budget;
mod builtins;
mod call;
pub mod display;
#[cfg(test)]
mod dump;
mod elementary;
mod escape;
mod eval;
mod float_repr;
mod format;
mod generator;
mod host;
mod interp;
mod iter;
mod lambda;
mod lexer;
pub mod literal;
mod methods;
mod number;
mod numeric;
mod ops;
mod parser;
mod quote;
mod report;
mod stop;
mod substitution;
mod syntax;
mod template;
mod token;
mod value;
pub mod visit;
mod words;

pub use attribute::is_namespace_attribute;
pub use budget::Budget;
pub use builtins::{
    BuiltinKind, GlobalSymbol, eval_symbol, global_symbol, global_symbols, is_global_symbol,
    module_symbol,
};
pub use host::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId};
pub use interp::evaluate;
pub use methods::method_names;
pub use substitution::{Subst, SubstArg, SubstError, parse_substitution, resolve_substitution};
pub use syntax::{
    ExprError, ExprErrorKind, NameUse, Parsed, is_identifier, is_python_space, names, normalized,
    parse,
};
pub use template::{Code, Template, TemplateToken, split};
pub use value::{
    DateValue, Dict, DictView, List, Module, Range, Set, Slice, Str, Tuple, Type, Value, ViewKind,
    changes_in_place,
};

pub use words::{WordKind, words};

#[cfg(test)]
mod eval_tests;
