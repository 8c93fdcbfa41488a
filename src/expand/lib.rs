//! Expansion: what xacro does, exactly, with every result knowing where it came from.
//!
//! One in-order, depth-first pass turns parsed files into one [`XTree`]. The pass never stops at
//! an error: what cannot be computed becomes an unknown value that flows on quietly, so one run
//! reports every cause once.

mod advice;
mod argument;
mod attributes;
mod binding;
mod comments;
mod compact;
mod control;
mod definition;
mod element;
mod evaluations;
mod expansion;
mod functions;
mod include;
mod kind;
mod late;
mod load;
mod machine;
mod macros;
mod meant;
mod memo;
mod origin;
mod params;
mod probe;
mod problem;
mod property;
mod record;
mod replay;
#[cfg(test)]
mod replay_tests;
mod report;
mod request;
mod resolve;
mod scope;
mod slips;
mod source_map;
mod stack;
mod substitution;
mod symbols;
mod text;
mod tree;
#[cfg(debug_assertions)]
mod verify;
mod watch;
mod write;
mod yaml_value;

pub use argument::{argument, is_partial};
pub use evaluations::{Evaluation, Evaluations};
pub use expansion::{Expansion, FileUse};
pub use kind::ProblemKind;
pub use machine::{expand, expand_again};
pub use origin::{FileIdx, Frame, FrameId, FrameKind, Origin, Source, SrcId};
pub use params::parse as parse_params;
pub use probe::Probe;
pub use problem::{Detail, Outside, Place, Problem, Severity, Step};
pub use record::{Read, Record};
pub use request::{Forced, Limits, Request, World};
pub use resolve::{BindingInfo, BindingKind};
pub use scope::Param;
pub use slips::meant_number;
pub use source_map::{MapEntry, MapKind};
pub use stack::{large_stacks, on_first_thread, spawn_on_large_stack};
pub use symbols::{Definition, DefinitionId, SourceRange, SymbolKind, Symbols, Use, UseKind};
pub use tree::{Attrs, Piece, XAttr, XId, XKind, XNode, XTree};
pub use write::{Written, banner, write, write_mapped};
pub use yaml_value::file_value as yaml_value;
