//! Keeping a step: what is written down while a macro call of the root is evaluated.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::checkpoint::{ResumeState, TakenOver};
use super::compact::Moved;
use super::expander::Expander;
use super::expansion::Expansion;
use super::macro_table::Macros;
use super::memo::{ForcedProperty, Memo, Recorder, StepKey, StepMemo, StepReads, StepResult};
use super::names::EvalContext;
use super::node::{XId, XKind};
use super::origin::{FrameId, SrcId};
use super::plain::is_plain;
use super::record::Read;
use super::replay::frames_in;
use super::request::Request;
use super::scope::Scopes;
use super::tag::Tag;
use base::{CancelFlag, Id, SharedVec};
use xml::NodeId;

/// How things stood when a step began.
struct Start {
    frames: usize,
    bindings: usize,
    read_list: usize,
    evaluations: usize,
    scopes: usize,
    tables: usize,
    nodes: usize,
    messages: usize,
    includes: usize,
    losses: u32,
    compared: usize,
    problems: u64,
    budget: (u64, u64),
    marker: Option<XId>,
    was_complete: bool,
}

impl Expander<'_> {
    /// Whether a call is a step: a child of the root element, outside of everything.
    pub(super) fn is_step(&self, tag: Tag<'_>, out: XId, cx: EvalContext) -> bool {
        self.steps.keeps
            && self.steps.recorder.is_none()
            && (cx.scope, cx.macros, cx.frame) == (Scopes::TOP, Macros::TOP, FrameId::ROOT)
            && self.result.tree.parent(out) == Some(XId::DOCUMENT)
            && self.guards.calls.is_empty()
            && self.names.lazy_uses.is_empty()
            && (
                self.flow.conditions,
                self.flow.unknown_conditions,
                self.guards.block_depth,
            ) == (0, 0, 0)
            && self.files.open.len() == 1
            && tag.used.is_empty()
    }

    /// Evaluate a step, and keep what it gave for the next expansion.
    // not in the frame of a call, of which there are many in a deep document
    #[inline(never)]
    pub(super) fn recorded_call(
        &mut self,
        tag: Tag<'_>,
        name: &str,
        has_next: bool,
        out: XId,
        cx: EvalContext,
    ) {
        let start = self.start_step();
        let evaluations = start.evaluations;
        self.note_source(tag.src);
        let body = self.call_body(tag, name, cx);
        let memo = self.finish_step((tag.src, tag.node.id()), body, start);
        let Some(body) = body else { return };
        let first = self.result.tree.elements(body).next();
        self.place_body(body, has_next, out, cx);
        if let (Some(memo), Some(first)) = (memo, first) {
            // a marker that stays inside is part of the content
            let marker = self.result.tree.parent(self.marker);
            if !memo.moves_marker || marker == Some(out) {
                self.steps.done.push(StepResult {
                    step: StepKey(Arc::new(memo.compact())),
                    content: (first, first),
                    evaluations,
                });
            }
        }
    }

    fn start_step(&mut self) -> Start {
        self.steps.recorder = Some(Recorder::default());
        self.names.scopes.watch();
        self.names.macros.watch();
        self.result.index.symbols.start_log();
        self.result.record.start_log();
        Start {
            frames: self.result.frames.len(),
            bindings: self.result.index.bindings.len(),
            read_list: self.result.index.reads.len(),
            evaluations: self.result.index.evaluations.len(),
            scopes: self.names.scopes.len(),
            tables: self.names.macros.len(),
            nodes: self.nodes_made(),
            messages: self.result.messages.len(),
            includes: self.result.includes.len(),
            losses: self.gaps.losses,
            compared: self.names.compared,
            problems: self.problems.touched(),
            budget: (self.guards.budget.steps, self.guards.budget.bytes),
            marker: self.result.tree.parent(self.marker),
            // whether this step makes it incomplete is seen only when nothing before did
            was_complete: std::mem::replace(&mut self.result.complete, true),
        }
    }

    /// How many nodes a run from scratch would have made.
    pub(super) fn nodes_made(&self) -> usize {
        self.result.tree.len() + self.steps.nodes_left_out
    }

    /// What there is to keep of the step that ends here.
    fn finish_step(
        &mut self,
        call: (SrcId, NodeId),
        body: Option<XId>,
        start: Start,
    ) -> Option<StepMemo> {
        let recorder = self.steps.recorder.take().unwrap_or_default();
        let lazy_left = self.names.scopes.has_lazy_from(start.scopes);
        let (names, macros) = (self.names.scopes.unwatch(), self.names.macros.unwatch());
        let (symbols, record) = (
            self.result.index.symbols.take_log(),
            self.result.record.take_log(),
        );
        let is_clear = self.result.complete;
        self.result.complete &= start.was_complete;
        let elements = body.and_then(|body| self.content_elements(body))?;
        let (names, evaluated) = names?;
        let is_kept =
            |read: &Read| matches!(read, Read::Package(..) | Read::Env(..) | Read::Arg(..));
        let result = &self.result;
        let quiet = (result.messages.len(), result.includes.len())
            == (start.messages, start.includes)
            && (
                self.gaps.losses,
                self.names.compared,
                self.problems.touched(),
            ) == (start.losses, start.compared, start.problems)
            && !(recorder.unclear || lazy_left || self.flow.stopped || self.flow.unwinding);
        let values = result
            .index
            .bindings
            .iter()
            .skip(start.bindings)
            .filter_map(|info| info.value.as_ref());
        let evaluations = start.evaluations..result.index.evaluations.len();
        let is_plain_data = values
            .chain(result.index.evaluations.values(evaluations.clone()))
            .all(is_plain)
            && recorder.forced.iter().all(|forced| is_plain(&forced.value));
        if !(is_clear && quiet && is_plain_data && record.iter().all(is_kept)) {
            return None;
        }
        let moves_marker = result.tree.parent(self.marker) != start.marker;
        Some(StepMemo {
            call,
            reads: StepReads {
                names,
                macros: macros?,
                frames: self.outer_frames(body?, &start),
                ..recorder.reads
            },
            frames: start.frames..result.frames.len(),
            bindings: start.bindings..result.index.bindings.len(),
            read_list: start.read_list..result.index.reads.len(),
            evaluations: evaluations.len(),
            symbols,
            record,
            forced: recorder.forced,
            evaluated,
            scopes: self.names.scopes.len() - start.scopes,
            tables: self.names.macros.len() - start.tables,
            nodes: self.nodes_made() - start.nodes,
            elements,
            spent: (
                start.budget.0 - self.guards.budget.steps,
                start.budget.1 - self.guards.budget.bytes,
            ),
            moves_marker,
        })
    }

    /// The frames from before a step that what it gives refers to.
    fn outer_frames(&self, body: XId, start: &Start) -> Vec<FrameId> {
        let Expansion {
            tree,
            frames,
            index,
            ..
        } = &self.result;
        let frames = frames.iter().skip(start.frames).flat_map(frames_in);
        let of_tree = tree.below(body).map(|id| tree.get(id)).flat_map(|node| {
            let attrs = node.attrs.iter().map(|attr| attr.origin);
            let pieces = node.attrs.iter().flat_map(|attr| &attr.pieces);
            let sources = pieces.map(|piece| piece.source);
            std::iter::once(node.origin).chain(attrs).chain(sources)
        });
        let bindings = index.bindings.iter().skip(start.bindings);
        let origins = of_tree
            .chain(bindings.filter_map(|info| info.origin))
            .chain(index.evaluations.places_from(start.evaluations));
        let mut outer = Vec::new();
        for frame in frames.chain(origins.map(|origin| origin.frame)) {
            if frame.index() < start.frames && !outer.contains(&frame) {
                outer.push(frame);
            }
        }
        outer
    }

    /// How many elements the content of a call has, when they are all that it has: beside them only blank text, and nothing
    /// for the tag around it.
    fn content_elements(&self, body: XId) -> Option<usize> {
        let tree = &self.result.tree;
        let mut elements = 0;
        for child in tree.children(body) {
            let node = tree.get(child);
            match node.kind {
                XKind::Element => elements += 1,
                XKind::Text if node.text.chars().all(super::params::is_space) => {}
                _ => return None,
            }
        }
        let lifts = tree
            .get(body)
            .attrs
            .iter()
            .any(|attr| attr.name.starts_with("xmlns"));
        (elements > 0 && !lifts).then_some(elements)
    }

    /// Note that text of an item is evaluated.
    pub(super) fn note_source(&mut self, src: SrcId) {
        if let Some(recorder) = &mut self.steps.recorder
            && !recorder.reads.sources.contains(&src)
        {
            recorder.reads.sources.push(src);
        }
    }

    /// Note that an argument is looked up.
    pub(super) fn note_argument(&mut self, name: &EcoString) {
        if let Some(recorder) = &mut self.steps.recorder
            && !recorder.reads.args.iter().any(|(known, _)| known == name)
        {
            recorder
                .reads
                .args
                .push((name.clone(), self.names.args.get(name).cloned()));
        }
    }

    /// Note the folder of a package, or that there is none.
    pub(super) fn note_package(&mut self, name: &EcoString, from: &Path, folder: Option<&Path>) {
        if !self.steps.keeps {
            return;
        }
        let is_same = |(known, asks, _): &(EcoString, PathBuf, Option<PathBuf>)| {
            known == name && asks == from
        };
        let read = || (name.clone(), from.to_owned(), folder.map(Path::to_owned));
        if !self.steps.packages.iter().any(is_same) {
            self.steps.packages.push(read());
        }
        if let Some(recorder) = &mut self.steps.recorder
            && !recorder.reads.packages.iter().any(is_same)
        {
            recorder.reads.packages.push(read());
        }
    }

    /// Note that a lazy property of the document got its value.
    pub(super) fn note_forced(&mut self, forced: impl FnOnce() -> ForcedProperty) {
        if let Some(recorder) = &mut self.steps.recorder {
            recorder.forced.push(forced());
        }
    }

    /// Note that the step does what cannot be taken over.
    pub(super) fn note_unclear(&mut self) {
        if let Some(recorder) = &mut self.steps.recorder {
            recorder.unclear = true;
        }
    }

    /// What the next expansion may take over, with its places in the finished document: `moved` is what stands below the
    /// root element.
    pub(super) fn memo(&mut self, moved: &[Moved], resume: Option<ResumeState>) -> Memo {
        let rest = std::mem::take(&mut self.steps.rest);
        let number = |old: XId| {
            let found = moved.iter().find(|one| one.old == old);
            found.map(|one| one.new)
        };
        let by = rest
            .kept
            .and_then(|(last, kept)| Some(number(kept)?.away_from(last)));
        let by = by.unwrap_or_default();
        let resume = resume.map(|mut resume| {
            let here = rest.last.map(|(old, here)| (old, here.and_then(number)));
            let is_same = |at: usize| {
                rest.checkpoints.contains(&at)
                    && by == 0
                    && here.is_none_or(|(old, here)| old == here)
            };
            let mut tops = moved.iter().peekable();
            for at in (rest.front.0..resume.checkpoints.len()).filter(|&at| !is_same(at)) {
                let Some(checkpoint) = resume.checkpoints.get_mut(at) else {
                    continue;
                };
                let Some(last) = checkpoint.last else {
                    continue;
                };
                checkpoint.last = if !rest.checkpoints.contains(&at) {
                    // there may be several behind the same element
                    while tops.next_if(|one| one.old != last).is_some() {}
                    tops.peek().map(|one| one.new)
                } else if let Some((_, here)) = here.filter(|(old, _)| *old == Some(last)) {
                    here
                } else {
                    Some(last.moved(by))
                };
            }
            resume.checkpoints.finish();
            resume
        });
        let steps = self.placed_steps(moved, &rest, by);
        let request = Request {
            cancel: CancelFlag::default(),
            ..self.request.clone()
        };
        Memo {
            request,
            steps,
            resume,
            taken_over: self.steps.taken_over,
            left_out: self.steps.left_out,
        }
    }

    /// The steps with their places in the finished document; `by` is how far those behind an edit moved.
    fn placed_steps(
        &mut self,
        moved: &[Moved],
        rest: &TakenOver,
        by: i64,
    ) -> SharedVec<StepResult> {
        let tree = &self.result.tree;
        let mut elements = moved.iter().filter(|one| one.is_element);
        let all = std::mem::take(&mut self.steps.done);
        let mut steps = SharedVec::new();
        steps.extend_from(&all, 0..rest.front.1);
        let mut at = rest.front.1;
        while let Some(kept) = all.get(at) {
            let (first, behind) = kept.content;
            if rest.steps.start == at && by == 0 && !rest.steps.is_empty() {
                steps.extend_from(&all, rest.steps.clone());
                at = rest.steps.end;
                continue;
            }
            let content = if rest.steps.contains(&at) {
                Some((first.moved(by), behind.moved(by)))
            } else {
                let found = elements.find(|one| one.old == first);
                found.and_then(|found| {
                    let more = kept.step.memo().elements.checked_sub(2);
                    let last = match more {
                        Some(more) => elements.clone().nth(more)?.new,
                        None => found.new,
                    };
                    Some((found.new, tree.behind(last)))
                })
            };
            if let Some(content) = content {
                steps.push(StepResult {
                    content,
                    ..kept.clone()
                });
            }
            at += 1;
        }
        steps.finish();
        steps
    }
}
