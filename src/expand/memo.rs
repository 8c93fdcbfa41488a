//! What a macro call of a root rests on and what it gave, so that it need not be evaluated again after an edit elsewhere.
//!
//! A call among the children of the root element is a step. While it is evaluated, everything is written down that it reads
//! from around it: properties, macros, arguments, packages, source items. Steps that do more than to add to the document,
//! or that read what may change in place, are not kept and are evaluated each time. `replay.rs` takes over the others.
use std::hash::{Hash, Hasher};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use ecow::EcoString;

use super::binding_info::{ArgumentValue, BindingId};
use super::checkpoint::ResumeState;
use super::node::XId;
use super::origin::{FrameId, SrcId};
use super::record::Read;
use super::request::Request;
use super::scope::{NamesRead, SrcRef};
use super::symbols::SymbolLog;
use base::{SharedVec, TextRange};
use expr::Value;
use xml::NodeId;

/// The steps of an expansion.
#[derive(Debug, Default)]
pub(super) struct Memo {
    /// What was asked for; the cancel flag is left out.
    pub request: Request,
    /// In document order.
    pub steps: SharedVec<StepResult>,
    /// Places between items to go on from.
    pub resume: Option<ResumeState>,
    /// How many of them were taken over from the expansion before, and how many items were not evaluated.
    pub taken_over: usize,
    pub left_out: usize,
}

/// What tells a step from others: an expansion that takes it over has the same one.
#[derive(Clone, Debug)]
pub struct StepKey(pub(super) Arc<StepMemo>);

impl PartialEq for StepKey {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for StepKey {}

impl Hash for StepKey {
    fn hash<H: Hasher>(&self, state: &mut H) {
        Arc::as_ptr(&self.0).hash(state);
    }
}

impl StepKey {
    /// The step itself.
    pub(super) fn memo(&self) -> &StepMemo {
        &self.0
    }
}

/// A step and its elements.
#[derive(Clone, Debug)]
pub(super) struct StepResult {
    pub step: StepKey,
    /// Its first element, and the node behind its last one.
    pub content: (XId, XId),
    /// Where its values begin in the list of evaluations; nothing refers to their numbers, so these may change.
    pub evaluations: usize,
}

/// What a step reads and what it gives. Numbers are those of the expansion it was made in.
#[derive(Debug)]
pub(super) struct StepMemo {
    /// The tag of the call.
    pub call: (SrcId, NodeId),
    pub reads: StepReads,
    /// What it adds to the lists of the expansion.
    pub frames: Range<usize>,
    pub bindings: Range<usize>,
    pub read_list: Range<usize>,
    pub evaluations: usize,
    pub symbols: SymbolLog,
    pub record: Vec<Read>,
    /// Lazy properties of the document that it evaluated.
    pub forced: Vec<ForcedProperty>,
    /// Whether an expression was evaluated in the scope of the document.
    pub evaluated: bool,
    /// How many scopes, macro tables and nodes it made.
    pub scopes: usize,
    pub tables: usize,
    pub nodes: usize,
    /// How many elements it adds to the root element.
    pub elements: usize,
    /// Steps and bytes of the budget that it used.
    pub spent: (u64, u64),
    /// Whether it moved the marker.
    pub moves_marker: bool,
}

impl StepMemo {
    /// Without the room its lists have left: there is one for each call, as long as the document is open.
    pub fn compact(mut self) -> Self {
        self.reads.names.shrink_to_fit();
        self.reads.macros.shrink_to_fit();
        self.reads.sources.shrink_to_fit();
        self.symbols.definitions.shrink_to_fit();
        self.symbols.uses.shrink_to_fit();
        self.forced.shrink_to_fit();
        self
    }
}

/// What a step reads from around it.
#[derive(Debug, Default)]
pub(super) struct StepReads {
    pub names: NamesRead,
    /// Macros of the document, each once.
    pub macros: Vec<(EcoString, Option<SrcRef>)>,
    /// Arguments: value and binding.
    pub args: Vec<(EcoString, Option<ArgumentValue>)>,
    /// Packages: name, the file that asks, the folder.
    pub packages: Vec<(EcoString, PathBuf, Option<PathBuf>)>,
    /// Items whose text was evaluated.
    pub sources: Vec<SrcId>,
    /// Frames that what it gives refers to.
    pub frames: Vec<FrameId>,
}

/// A lazy property of the document that was evaluated.
#[derive(Debug)]
pub(super) struct ForcedProperty {
    pub name: EcoString,
    pub info: BindingId,
    pub value: Value,
    pub reads: TextRange,
}

/// What is written down of the step that is evaluated now, beside what the scopes and macros write down themselves.
#[derive(Debug, Default)]
pub(super) struct Recorder {
    pub reads: StepReads,
    pub forced: Vec<ForcedProperty>,
    /// It does something that cannot be taken over.
    pub unclear: bool,
}
