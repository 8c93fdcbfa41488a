//! The parts of the state of an expansion.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::before::Before;
use super::checkpoint::{Checkpoint, Resumption, TakenOver};
use super::journal::Journal;
use super::macro_table::MacroDef;
use super::memo::{Recorder, StepResult};
use super::names::EvalContext;
use super::origin::FileIdx;
use super::request::Request;
use super::scope::PropertyScope;
use super::split_text::SplitText;
use base::clock::Instant;
use base::limits::{self, EVAL_DEPTH};
use base::{FastMap, FastSet, SharedVec};
use expr::{Budget, ScopeId};

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
    /// Steps and bytes that there were at the start.
    pub start: (u64, u64),
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
            start: (limits.eval_steps, limits.output_bytes),
            deadline: Instant::now() + limits.expand_time,
            ticks: 0,
            calls: Vec::new(),
            block_depth: 0,
            nesting: 0,
        }
    }
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
    pub done: SharedVec<StepResult>,
    /// What the step that is evaluated now reads.
    pub recorder: Option<Recorder>,
    /// How many steps were taken over.
    pub taken_over: usize,
    /// How many nodes were not made since steps were taken over.
    pub nodes_left_out: usize,
    /// Places between the items of the root.
    pub checkpoints: SharedVec<Checkpoint>,
    /// What changed of what was there.
    pub journal: Journal,
    /// The last expansion, where this one goes on from it.
    pub resumed: Option<Resumption>,
    /// How many items were not evaluated.
    pub left_out: usize,
    /// What was taken over from it.
    pub rest: TakenOver,
    /// Packages that were asked for: name, the file that asks, the folder.
    pub packages: Vec<(EcoString, PathBuf, Option<PathBuf>)>,
    /// Scopes with properties that nothing had evaluated at the end of the items, and macros that were defined until then.
    pub open_scopes: Vec<(ScopeId, PropertyScope)>,
    pub probed: Vec<(Arc<MacroDef>, EvalContext)>,
}

impl<'w> Steps<'w> {
    pub(super) fn new(request: &Request, before: Option<Before<'w>>) -> Self {
        Self {
            before,
            keeps: request.keep && request.forced.is_empty(),
            done: SharedVec::new(),
            recorder: None,
            taken_over: 0,
            nodes_left_out: 0,
            checkpoints: SharedVec::new(),
            journal: Journal::default(),
            resumed: None,
            left_out: 0,
            rest: TakenOver::default(),
            packages: Vec::new(),
            open_scopes: Vec::new(),
            probed: Vec::new(),
        }
    }
}
