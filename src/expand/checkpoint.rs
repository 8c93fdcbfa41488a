//! Where the expansion of a root stood between its items. After an edit, the next expansion goes on from the last place in front
//! of the first item that is another one, and is done at the first place behind the last such item where everything stands as it
//! did.
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use ecow::EcoString;

use super::binding_info::ArgumentValue;
use super::flow::Gaps;
use super::journal::Change;
use super::macro_table::{MacroDef, MacroTable};
use super::names::EvalContext;
use super::node::{Attrs, XId};
use super::scope::PropertyScope;
use base::{FastMap, SharedVec};
use expr::ScopeId;

/// A place in front of an item.
#[derive(Clone, Debug)]
pub(super) struct Checkpoint {
    /// The item behind it, counted from the first below the root element.
    pub item: usize,
    /// The last element or comment in front of it, below the root element.
    pub last: Option<XId>,
    pub numbers: Numbers,
    pub lengths: Lengths,
    pub state: Around,
    /// Whether the document is complete since the checkpoint before.
    pub is_complete: bool,
    /// Names were asked for that nobody had defined: who defines them later has to know.
    pub has_undefined: bool,
    /// How often somebody reported something or asked what is reported.
    pub touched: u64,
    /// How often values had been changed in place, by whomever.
    pub in_place: u64,
    /// How many names undefined ones were compared with.
    pub compared: usize,
    /// How many more entries of folders may be read.
    pub glob_entries: usize,
}

/// What there is of everything that something refers to by number: behind a checkpoint, items give the same only if these are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Numbers {
    pub frames: usize,
    pub bindings: usize,
    pub reads: usize,
    pub definitions: usize,
    pub scopes: usize,
    pub tables: usize,
    pub files: usize,
    pub sources: usize,
}

/// How long the lists are that nothing refers into, and what was used up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lengths {
    pub evaluations: usize,
    pub uses: usize,
    /// Definitions that turned out to be conditional.
    pub conditional: usize,
    pub record: usize,
    pub messages: usize,
    pub includes: usize,
    pub problems: usize,
    pub changes: usize,
    /// Changes that cannot be taken back.
    pub unclear: usize,
    /// Macros to be looked into at the end.
    pub macros: usize,
    pub steps: usize,
    pub nodes: usize,
    /// Steps and bytes of the budget.
    pub spent: (u64, u64),
}

/// What else the items behind a checkpoint depend on.
#[derive(Clone, Debug)]
pub(super) struct Around {
    pub gaps: Gaps,
    pub eval_comments: bool,
    /// Whether the root element has no content yet, not even blank text.
    pub is_empty: bool,
    /// Whether the marker of comments stands behind the last element or comment.
    pub has_marker: bool,
    /// See [`PropertyScope::evaluated`], of the document.
    pub evaluated: Option<usize>,
    /// The attributes of the root element.
    pub attrs: Attrs,
}

/// What the next expansion of the same root goes on from.
#[derive(Debug)]
pub(super) struct ResumeState {
    /// In order.
    pub checkpoints: SharedVec<Checkpoint>,
    pub changes: SharedVec<Change>,
    /// How often something changed at the end in a way that cannot be taken back, and in place.
    pub unclear: usize,
    pub in_place: u64,
    /// Names as they were at the end.
    pub top: PropertyScope,
    pub macros: MacroTable,
    pub args: FastMap<EcoString, ArgumentValue>,
    /// Scopes with lazy properties that nothing had evaluated, and those around them.
    pub scopes: Vec<(ScopeId, PropertyScope)>,
    /// Macros to be looked into at the end.
    pub probed: Vec<(Arc<MacroDef>, EvalContext)>,
    /// Packages that were asked for: name, the file that asks, the folder.
    pub packages: Vec<(EcoString, PathBuf, Option<PathBuf>)>,
}

impl Lengths {
    /// How long the lists are when what lies between two checkpoints is added.
    pub fn and_between(self, from: &Self, to: &Self) -> Self {
        Self {
            evaluations: self.evaluations + to.evaluations - from.evaluations,
            uses: self.uses + to.uses - from.uses,
            conditional: self.conditional + to.conditional - from.conditional,
            record: self.record + to.record - from.record,
            messages: self.messages + to.messages - from.messages,
            includes: self.includes + to.includes - from.includes,
            problems: self.problems + to.problems - from.problems,
            changes: self.changes + to.changes - from.changes,
            unclear: self.unclear + to.unclear - from.unclear,
            macros: self.macros + to.macros - from.macros,
            steps: self.steps + to.steps - from.steps,
            nodes: self.nodes + to.nodes - from.nodes,
            spent: (
                self.spent.0 + to.spent.0 - from.spent.0,
                self.spent.1 + to.spent.1 - from.spent.1,
            ),
        }
    }
}

/// The last expansion, while items of its root are left out.
#[derive(Clone)]
pub(super) struct Resumption {
    /// The checkpoint that it goes on from.
    pub from: usize,
    /// The items that are other ones.
    pub changed: Range<usize>,
    /// Nothing that was read is different, so items behind may be left out too.
    pub is_current: bool,
}

/// What of the checkpoints and the macro calls was taken over from the last expansion, and has the numbers of its nodes.
#[derive(Default)]
pub(super) struct TakenOver {
    /// How many checkpoints and calls from the front.
    pub front: (usize, usize),
    /// Those behind the items that are other ones.
    pub checkpoints: Range<usize>,
    pub steps: Range<usize>,
    /// The last element or comment in front of these items: as it was numbered there, and in the tree that grows.
    pub last: Option<(Option<XId>, Option<XId>)>,
    /// The last of their elements and comments as it was numbered there, and the one that stands for them in the tree that grows.
    pub kept: Option<(XId, XId)>,
}
