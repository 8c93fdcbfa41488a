//! Taking over the steps of the last expansion that still hold.

use super::expander::Expander;
use super::expansion::Expansion;
use super::memo::{StepMemo, StepReads, StepResult};
use super::names::EvalContext;
use super::node::{XId, XKind};
use super::origin::{Frame, FrameId, SrcId};
use super::part::part;
use super::same::{is_same_binding, is_same_source};
use super::scope::{PropertyState, Scopes};
use super::symbols::{Definition, DefinitionId, Symbols};
use super::tag::Tag;
use base::Id;

impl Expander<'_> {
    /// Take over what a call gave in the last expansion; `false`: it has to be evaluated.
    // not in the frame of a call, of which there are many in a deep document
    #[inline(never)]
    pub(super) fn replay(
        &mut self,
        tag: Tag<'_>,
        has_next: bool,
        out: XId,
        cx: EvalContext,
    ) -> bool {
        let Some(before) = self.steps.before else {
            return false;
        };
        let Some(kept) = before.step((tag.src, tag.node.id())) else {
            return false;
        };
        let step = kept.step.memo();
        let holds = self.has_room(step)
            && self.stands_alike(step)
            && self.reads_alike(before.expansion, &step.reads)
            && self.refers_alike(before.expansion, step)
            && (!step.moves_marker || self.takes_marker(has_next, out));
        if holds {
            self.steps.taken_over += 1;
            let evaluations = self.result.index.evaluations.len();
            self.add_lists(before.expansion, kept);
            self.add_effects(step);
            let at = self.tag_origin(tag, cx);
            let body = self.container(at);
            let made = self.result.tree.len();
            self.result
                .tree
                .graft(&before.expansion.tree, kept.content, body);
            let first = self.result.tree.first_child(body);
            // the container is one of the nodes that the step made
            self.steps.nodes_left_out += step.nodes - 1 - (self.result.tree.len() - made);
            if step.moves_marker {
                self.result.tree.detach(self.marker);
            }
            self.place_body(body, has_next, out, cx);
            if let Some(first) = first {
                self.steps.done.push(StepResult {
                    step: kept.step.clone(),
                    content: (first, first),
                    evaluations,
                });
            }
        }
        holds
    }

    /// Whether no limit is reached in the step.
    fn has_room(&self, step: &StepMemo) -> bool {
        let nodes = (self.nodes_made() + step.nodes) as u64;
        self.guards.budget.steps >= step.spent.0
            && self.guards.budget.bytes >= step.spent.1
            && nodes <= self.request.limits.expand_nodes
            && self.result.index.evaluations.has_room(step.evaluations)
    }

    /// Whether what the step adds gets the same numbers as before.
    fn stands_alike(&self, step: &StepMemo) -> bool {
        let result = &self.result;
        let numbers = (
            result.frames.len(),
            result.index.bindings.len(),
            result.index.reads.len(),
        );
        numbers == (step.frames.start, step.bindings.start, step.read_list.start)
    }

    /// Whether frames are the same, and all that they refer to.
    fn leads_alike(&self, before: &Expansion, frames: &[FrameId]) -> bool {
        let mut open = frames.to_vec();
        let mut next = 0;
        while let Some(&id) = open.get(next) {
            next += 1;
            let (Some(then), Some(now)) = (before.frames.get(id), self.result.frames.get(id))
            else {
                return false;
            };
            if !is_same_frame(then, now) {
                return false;
            }
            for other in frames_in(now) {
                if !open.contains(&other) {
                    open.push(other);
                }
            }
        }
        true
    }

    /// Whether what the step reads says the same as before.
    fn reads_alike(&self, before: &Expansion, reads: &StepReads) -> bool {
        let StepReads {
            names,
            macros,
            args,
            packages,
            sources,
            frames,
        } = reads;
        let same_source = |src: &SrcId| is_same_source(before, &self.result, *src);
        self.leads_alike(before, frames)
            && sources.iter().all(same_source)
            && names.iter().all(|(name, then)| {
                let now = self
                    .names
                    .scopes
                    .find(Scopes::TOP, name)
                    .map(|(_, binding)| binding);
                match (then, now) {
                    (None, None) => true,
                    (Some(then), Some(now)) => is_same_binding(before, then, &self.result, now),
                    _ => false,
                }
            })
            && macros.iter().all(|(name, then)| {
                let now = self
                    .names
                    .macros
                    .find(super::macro_table::Macros::TOP, name)
                    .map(|def| def.body);
                now == *then && then.is_none_or(|body| same_source(&body.src))
            })
            && args
                .iter()
                .all(|(name, then)| self.names.args.get(name) == then.as_ref())
            && packages.iter().all(|(name, from, folder)| {
                self.sources
                    .packages
                    .find(name, from)
                    .is_ok_and(|now| Some(&now.path) == folder.as_ref())
            })
    }

    /// Whether the definitions that the step gives and names have the same numbers.
    fn refers_alike(&self, before: &Expansion, step: &StepMemo) -> bool {
        let (now, then) = (&self.result.index.symbols, &before.index.symbols);
        let given = &step.symbols.definitions;
        let mut next = now.definitions.len();
        let mut is_given_alike =
            |(at, (definition, id)): (usize, &(Definition, DefinitionId))| match now
                .number_of(definition)
            {
                Some(known) => known == *id,
                // only one that this step gave before has a number by now
                None if id.index() < next => given.iter().take(at).any(|(other, same)| {
                    (same, other.place, &other.name) == (id, definition.place, &definition.name)
                }),
                None => {
                    next += 1;
                    id.index() + 1 == next
                }
            };
        let is_named_alike =
            |id| is_same_definition(now, then, id) || given.iter().any(|(_, given)| *given == id);
        let mut bindings = before.index.bindings.list().range(step.bindings.clone());
        given.iter().enumerate().all(&mut is_given_alike)
            && step
                .symbols
                .uses
                .iter()
                .all(|(used, _)| is_named_alike(used.definition))
            && bindings
                .by_ref()
                .filter_map(|info| info.definition)
                .all(is_named_alike)
    }

    /// Whether the marker comes to stand behind the content of a call.
    fn takes_marker(&self, has_next: bool, out: XId) -> bool {
        let first = self.result.tree.first_child(out);
        has_next && first.is_some_and(|first| self.result.tree.get(first).kind != XKind::Comment)
    }

    fn add_lists(&mut self, before: &Expansion, kept: &StepResult) {
        let step = kept.step.memo();
        let result = &mut self.result;
        let frames = result.frames.list_mut();
        frames.extend_from(before.frames.list(), step.frames.clone());
        let bindings = result.index.bindings.list_mut();
        bindings.extend_from(before.index.bindings.list(), step.bindings.clone());
        result
            .index
            .reads
            .extend_from_slice(part(&before.index.reads, step.read_list.clone()));
        result.index.evaluations.extend_from(
            &before.index.evaluations,
            kept.evaluations..kept.evaluations + step.evaluations,
        );
        for (definition, _) in &step.symbols.definitions {
            result.index.symbols.add(definition.clone());
        }
        for &(used, quiet) in &step.symbols.uses {
            result.index.symbols.add_use(used, quiet);
        }
        for read in &step.record {
            result.record.add(read.clone());
        }
    }

    fn add_effects(&mut self, step: &StepMemo) {
        self.names.scopes.skip(step.scopes);
        self.names.macros.skip(step.tables);
        if step.evaluated {
            self.names.scopes.note_evaluation(Scopes::TOP);
        }
        for forced in &step.forced {
            self.note_evaluated(&forced.name, (forced.info, forced.reads), &forced.value);
            if let Some(info) = self.result.index.bindings.get_mut(forced.info) {
                (info.reads, info.value) = (forced.reads, Some(forced.value.clone()));
            }
            if let Some(binding) = self
                .names
                .scopes
                .get_mut(Scopes::TOP)
                .vars
                .get_mut(&forced.name)
            {
                binding.state = PropertyState::Ready(forced.value.clone());
            }
        }
        self.guards.budget.steps -= step.spent.0;
        self.guards.budget.bytes -= step.spent.1;
    }
}

/// Whether a number means the same definition in both lists.
fn is_same_definition(now: &Symbols, then: &Symbols, id: DefinitionId) -> bool {
    now.get(id)
        .zip(then.get(id))
        .is_some_and(|(a, b)| a.place == b.place && a.name == b.name)
}

/// The frames that a frame refers to.
pub(super) fn frames_in(frame: &Frame) -> impl Iterator<Item = FrameId> {
    let definition = frame.definition.map(|definition| definition.frame);
    definition.into_iter().chain([frame.call.frame])
}

fn is_same_frame(a: &Frame, b: &Frame) -> bool {
    (a.kind, a.call, a.definition, a.depth) == (b.kind, b.call, b.definition, b.depth)
        && a.name == b.name
}
