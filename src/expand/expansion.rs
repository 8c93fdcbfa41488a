//! The result of an expansion.
use std::ops::Range;
use std::sync::Arc;

use ecow::EcoString;

use super::binding_info::{BindingId, BindingInfo};
use super::evaluations::Evaluations;
use super::memo::{Memo, StepKey};
use super::node::XId;
use super::origin::{FileIdx, Frame, FrameId, FrameKind, Origin, SourceItem, SrcId};
use super::problem::{FileRange, Problem, Severity};
use super::record::Record;
use super::symbols::{DefinitionId, Symbols};
use super::tree::XTree;
use base::{IdVec, SharedIdVec, TextRange};
use vfs::{LoadError, SourceFile};

/// A file that took part.
#[derive(Clone, Debug)]
pub struct FileUse {
    /// Its name as the reference would print it.
    pub name: String,
    /// The file.
    pub source: Arc<SourceFile>,
    /// Source of its header; its items and its footer follow in order.
    pub first_source: SrcId,
    /// How many items it has, or how many of them take part.
    pub items: u32,
}

/// What a macro gives that nothing calls.
#[derive(Clone, Copy, Debug)]
pub struct Probe {
    /// The macro.
    pub definition: DefinitionId,
    /// A node beside the document that holds the result.
    pub content: XId,
}

/// What names refer to, and the values of expressions: for rules about names, and for editors.
#[derive(Debug, Default)]
pub struct NameIndex {
    /// Properties, parameters and arguments that pieces refer to.
    pub bindings: SharedIdVec<BindingId, BindingInfo>,
    /// What was read, in the order in which it was wanted: see [`Self::read_in`].
    pub(super) reads: Vec<BindingId>,
    /// What each expression gave, each time.
    pub evaluations: Evaluations,
    /// Which definition each name of the source refers to.
    pub symbols: Symbols,
    /// What macros give that nothing calls, with parameters whose values are unknown; beside the document.
    pub probes: Vec<Probe>,
}

impl NameIndex {
    /// Properties, parameters and arguments that were read for something: numbers of [`Self::bindings`].
    pub fn read_in(&self, part: TextRange) -> &[BindingId] {
        self.reads
            .get(part.start as usize..part.end as usize)
            .unwrap_or(&[])
    }
}

/// The result: the document, and where everything in it came from.
#[derive(Debug, Default)]
pub struct Expansion {
    /// The expanded document.
    pub tree: XTree,
    /// The files in the order of first use; the root file is the first.
    pub files: IdVec<FileIdx, FileUse>,
    /// Items that origins refer to.
    pub sources: IdVec<SrcId, SourceItem>,
    /// Steps that origins refer to.
    pub frames: SharedIdVec<FrameId, Frame>,
    /// What names refer to, and the values of expressions.
    pub index: NameIndex,
    /// All problems in the order they were met.
    pub problems: Vec<Problem>,
    /// What the recovered trees of files that are not well-formed seem to say.
    pub untrusted: Vec<Problem>,
    /// Lines for the user, in order: what `xacro.message` and its kin print.
    pub messages: Vec<String>,
    /// What the result depends on.
    pub record: Record,
    /// Names of included and loaded files, as `--deps` lists them.
    pub includes: Vec<String>,
    /// False when something could not be resolved: rules about the whole robot then stay silent.
    pub complete: bool,
    /// False when parts of the document may be missing: an include, macro or condition could not be resolved.
    /// Unlike [`complete`](Self::complete), a value that could not be computed leaves this as it is.
    pub whole: bool,
    /// All arguments with their values, sorted by name; those whose values are unknown are left out.
    pub arguments: Vec<(EcoString, EcoString)>,
    /// Why the root file could not be read; there is no document then.
    pub root_error: Option<LoadError>,
    /// What the next expansion of the same root may take over.
    pub(super) memo: Option<Box<Memo>>,
}

impl Expansion {
    /// Make room for about as much as another expansion of the same root has.
    pub(super) fn reserve_like(&mut self, before: &Self) {
        // blank text is gone from the tree that was kept
        self.tree.reserve(before.tree.len() + before.tree.len() / 4);
        self.index.reads.reserve(before.index.reads.len());
    }

    /// Give back the room for more of everything: a language server keeps expansions for long.
    pub(super) fn shrink(&mut self) {
        self.frames.list_mut().finish();
        self.index.bindings.list_mut().finish();
        self.sources.shrink_to_fit();
        self.index.symbols.finish();
        self.index.evaluations.finish();
        self.index.reads.shrink_to_fit();
    }

    /// How many macro calls were taken over from the expansion before.
    pub fn taken_over(&self) -> usize {
        self.memo.as_ref().map_or(0, |memo| memo.taken_over)
    }

    /// How many items of the root were not evaluated: they lie in front of the first one that is another one than in the expansion
    /// before, or behind the last one, where everything stood as before.
    pub fn left_out(&self) -> usize {
        self.memo.as_ref().map_or(0, |memo| memo.left_out)
    }

    /// The macro calls below the root element that the next expansion may take over, each with its first element and the
    /// node behind its last one, in document order. One that was taken over gave the same elements with the same origins.
    pub fn steps(&self) -> impl Iterator<Item = (&StepKey, Range<XId>)> {
        let steps = self.memo.iter().flat_map(|memo| &memo.steps);
        steps.map(|kept| {
            let (first, behind) = kept.content;
            (&kept.step, first..behind)
        })
    }

    /// The absolute place of an origin.
    pub fn place(&self, origin: Origin) -> Option<FileRange> {
        let source = self.sources.get(origin.src)?;
        Some(FileRange {
            file: source.file,
            range: origin.range.shift(source.base),
        })
    }

    /// The frame of an origin and all frames around it, innermost first, without the root.
    pub fn frames_of(&self, origin: Origin) -> impl Iterator<Item = &Frame> {
        let not_root = |frame: &&Frame| frame.kind != FrameKind::Root;
        std::iter::successors(self.frames.get(origin.frame).filter(not_root), move |f| {
            self.frames.get(f.call.frame).filter(not_root)
        })
    }

    /// Whether the reference would have refused the file.
    pub fn has_errors(&self) -> bool {
        self.problems.iter().any(|p| p.severity == Severity::Error)
    }
}
