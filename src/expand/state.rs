//! The parts of the state of an expansion.
use std::path::Path;
use std::sync::Arc;

use ecow::EcoString;

use super::before::Before;
use super::binding_info::{BindingId, LazyUse};
use super::macro_table::{MacroDef, Macros, MacrosId};
use super::memo::{ArgumentValue, Recorder, StepResult};
use super::origin::{FileIdx, FrameId};
use super::request::Request;
use super::scope::Scopes;
use super::split_text::SplitText;
use super::undefined::Undefined;
use base::clock::Instant;
use base::limits::{self, EVAL_DEPTH};
use base::{FastMap, FastSet};
use expr::{Budget, ScopeId};

/// What names mean where something is evaluated, and the calls and includes that led there.
#[derive(Clone, Copy, Debug)]
pub(super) struct EvalContext {
    pub scope: ScopeId,
    pub macros: MacrosId,
    pub frame: FrameId,
}

/// Names and what they stand for.
pub(super) struct NameTables {
    pub scopes: Scopes,
    pub macros: Macros,
    /// Arguments: value (none when unknown) and binding.
    pub args: FastMap<EcoString, ArgumentValue>,
    /// Lazy properties being evaluated, outermost first.
    pub lazy_uses: Vec<LazyUse>,
    /// Bindings read since the mark of whoever is interested.
    pub reads: Vec<BindingId>,
    /// Problems about undefined names, in case they turn out to be defined later.
    pub undefined: Undefined,
    /// Names that undefined ones were compared with.
    pub compared: usize,
}

impl NameTables {
    pub(super) fn new() -> Self {
        Self {
            scopes: Scopes::new(),
            macros: Macros::new(),
            args: FastMap::default(),
            lazy_uses: Vec::new(),
            reads: Vec::new(),
            undefined: Undefined::default(),
            compared: 0,
        }
    }
}

/// A file being processed: what relative names are relative to.
#[derive(Clone, Debug)]
pub(super) struct IncludeFrame {
    pub name: String,
    pub file: Option<FileIdx>,
    /// How many conditions stood around the include.
    pub conditions: u32,
}

/// The files read so far.
pub(super) struct ReadFiles {
    /// Files being processed, the innermost last.
    pub open: Vec<IncludeFrame>,
    /// Files by absolute path.
    pub by_path: FastMap<Arc<Path>, FileIdx>,
    /// Files that are not well-formed.
    pub broken: FastSet<FileIdx>,
    /// Texts of macros in their split form, and their bytes.
    pub texts: FastMap<EcoString, Arc<SplitText>>,
    pub text_bytes: usize,
    /// How many more entries of folders may be read for includes with wildcards.
    pub glob_entries: usize,
    /// For each include being processed: whether it is optional.
    pub optional_includes: Vec<bool>,
}

impl ReadFiles {
    pub(super) fn new() -> Self {
        Self {
            open: Vec::new(),
            by_path: FastMap::default(),
            broken: FastSet::default(),
            texts: FastMap::default(),
            text_bytes: 0,
            glob_entries: limits::GLOB_ENTRIES,
            optional_includes: Vec::new(),
        }
    }
}

/// What keeps an expansion from running forever.
pub(super) struct Guards {
    pub budget: Budget,
    pub deadline: Instant,
    /// Nodes since the start.
    pub ticks: u32,
    /// Macros being expanded, and how many conditions stood around each call.
    pub calls: Vec<(usize, u32)>,
    /// Blocks inserted inside blocks.
    pub block_depth: u32,
    /// Elements open around the current one.
    pub nesting: u32,
}

impl Guards {
    pub(super) fn new(request: &Request) -> Self {
        let limits = &request.limits;
        Self {
            budget: Budget::new(limits.eval_steps, limits.output_bytes, EVAL_DEPTH),
            deadline: Instant::now() + limits.expand_time,
            ticks: 0,
            calls: Vec::new(),
            block_depth: 0,
            nesting: 0,
        }
    }
}

/// Whether evaluation goes on, and under which conditions.
#[derive(Clone, Copy, Default)]
pub(super) struct Flow {
    /// A limit was reached or the request was cancelled: wind up.
    pub stopped: bool,
    /// A file is missing inside an optional include: wind up until that include.
    pub unwinding: bool,
    /// Conditionals (and computed calls and includes) around the current element.
    pub conditions: u32,
    /// How many of these have an unknown value.
    pub unknown_conditions: u32,
}

/// What could not be decided or read.
#[derive(Clone, Copy, Default)]
pub(super) struct Gaps {
    /// An include is missing: undefined names then have a cause that was reported.
    pub include_missing: bool,
    /// The content of a condition or call is missing, because it could not be decided.
    pub content_lost: bool,
    /// How often that happened.
    pub losses: u32,
    /// A variable of the environment has one of several values.
    pub guessed: bool,
}

/// What is evaluated although the document does not need it.
#[derive(Default)]
pub(super) struct Probing {
    /// Macros that may be evaluated although nothing calls them.
    pub macros: Vec<(Arc<MacroDef>, EvalContext)>,
    /// Properties that nothing reads are being evaluated: what they read is not used by that.
    pub quiet: bool,
}

/// Macro calls of the root, kept for the next expansion or taken over from the last one.
pub(super) struct Steps<'w> {
    /// The last expansion of this root.
    pub before: Option<Before<'w>>,
    /// Whether steps are kept for the next expansion.
    pub keeps: bool,
    /// The steps so far.
    pub done: Vec<StepResult>,
    /// What the step that is evaluated now reads.
    pub recorder: Option<Recorder>,
    /// How many steps were taken over.
    pub taken_over: usize,
    /// How many nodes were not made since steps were taken over.
    pub nodes_left_out: usize,
}

impl<'w> Steps<'w> {
    pub(super) fn new(request: &Request, before: Option<Before<'w>>) -> Self {
        Self {
            before,
            keeps: request.keep && request.forced.is_empty(),
            done: Vec::new(),
            recorder: None,
            taken_over: 0,
            nodes_left_out: 0,
        }
    }
}
