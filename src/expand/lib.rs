//! Expansion: what xacro does, exactly, with every result knowing where it came from.
//!
//! One in-order, depth-first pass turns parsed files into one [`XTree`]. The pass never stops at
//! an error: what cannot be computed becomes an unknown value that flows on quietly, so one run
//! reports every cause once.

mod advice;
mod argument;
mod attributes;
mod before;
mod binding;
mod binding_info;
mod checkpoint;
mod checkpoints;
mod comments;
mod compact;
mod control;
mod definition;
mod element;
mod escape;
mod evaluations;
mod expander;
mod expansion;
mod flow;
mod forward_refs;
mod functions;
mod include;
mod journal;
mod kind;
mod load;
mod macro_table;
mod macros;
mod meant;
mod memo;
mod names;
mod node;
mod notes;
mod origin;
mod params;
mod part;
mod parts;
mod places;
mod plain;
mod probe;
mod problem;
mod problems;
mod property;
mod record;
mod recording;
mod rejoin;
mod replay;
#[cfg(test)]
mod replay_tests;
mod report;
mod request;
mod resolve;
mod resume;
mod same;
mod scope;
mod slips;
mod source_map;
mod split_text;
mod stack;
mod state;
mod substitution;
mod symbols;
mod tag;
mod text;
mod tree;
mod undefined;
#[cfg(debug_assertions)]
mod verify;
mod write;
mod yaml_value;

pub use argument::{blamed_argument, depends_on_parameter};
pub use binding_info::{BindingId, BindingInfo, BindingKind};
pub use evaluations::{Evaluation, Evaluations};
pub use expander::{expand, expand_again};
pub use expansion::{Expansion, FileUse, NameIndex, Probe};
pub use kind::ProblemKind;
pub use macro_table::MacroParam;
pub use memo::StepKey;
pub use node::{Attrs, Piece, XAttr, XId, XKind, XNode};
pub use origin::{FileIdx, Frame, FrameId, FrameKind, Origin, SourceItem, SrcId};
pub use params::parse as parse_params;
pub use problem::{Detail, FileRange, Outside, Problem, Severity, TraceStep};
pub use record::{Read, Record};
pub use request::{Forced, Request, Sources};
pub use slips::meant_number;
pub use source_map::{MapEntry, MapKind};
pub use stack::{LARGE_STACK, on_first_thread, on_large_thread, spawn_on_large_stack};
pub use symbols::{Definition, DefinitionId, SourceRange, SymbolKind, Symbols, Use, UseKind};
pub use tree::XTree;
pub use write::{Written, banner, write, write_lined, write_mapped};
pub use yaml_value::file_value as yaml_value;
