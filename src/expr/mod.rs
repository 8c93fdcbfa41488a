//! The expression language between `${` and `}`: splitter, parser, values, evaluator.

mod args;
pub mod ast;
mod attribute;
mod budget;
mod builtins;
mod call;
pub mod display;
mod eval;
mod float_repr;
mod format;
mod generator;
mod host;
mod interp;
mod iter;
pub mod literal;
mod methods;
mod numeric;
mod ops;
mod stop;
mod value;

pub use budget::Budget;
pub use builtins::{GlobalSymbol, SymbolKind, global_symbols, is_global_symbol};
pub use host::{ErrorKind, EvalError, Host, HostFn, Lookup, ScopeId};
pub use interp::evaluate;
pub use methods::method_names;
pub use value::{DateValue, Dict, List, Module, Range, Set, Slice, Str, Tuple, Type, Value, View, ViewKind};
