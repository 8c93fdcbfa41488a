//! Leaving out the items behind an edit, once everything stands as it did there in the last expansion of the same root.
use std::ops::Range;
use std::sync::Arc;

use super::checkpoint::{Checkpoint, ResumeState};
use super::expander::Expander;
use super::expansion::{Expansion, FileUse};
use super::flow::Gaps;
use super::journal::Change;
use super::memo::StepResult;
use super::origin::SrcId;
use super::part::part;
use super::record::Read;
use super::same::is_same_change;
use super::scope::Scopes;
use super::symbols::{Definition, Use};
use super::tag::SiblingState;
use base::{Id, SharedVec, SharedVecIter};

impl Expander<'_> {
    /// Leave out the items behind a checkpoint of the last expansion when everything stands as it did there; the item to go on with.
    pub(super) fn leave_out(&mut self, item: usize, siblings: &mut SiblingState) -> Option<usize> {
        let resumed = self.steps.resumed.as_ref()?;
        if item < resumed.changed.end || !resumed.is_current {
            return None;
        }
        let before = self.steps.before?;
        let resume = before.memo.resume.as_ref()?;
        let at = resume
            .checkpoints
            .partition_point(|checkpoint| checkpoint.item < item);
        let (from, then, end) = (
            resume.checkpoints.get(resumed.from)?,
            resume.checkpoints.get(at)?,
            resume.checkpoints.last()?,
        );
        let now = self.checkpoint(item, siblings)?;
        let is_alike = then.item == item
            && then.item < end.item
            && now.numbers == then.numbers
            && (end.state.attrs.is_same(&then.state.attrs)
                || now.state.attrs.is_same(&then.state.attrs))
            && self.stands_as(before.expansion, &now, then)
            && self.did_the_same(before.expansion, resume, (from, then), &now)
            && self.leads_on(resume, then, end)
            && self.has_room_for(&now, then, end);
        if !is_alike {
            return None;
        }
        let steps = then.lengths.steps..end.lengths.steps;
        self.add_between(before.expansion, resume, &now, (then, end), siblings);
        self.add_calls((&before.memo.steps, steps), &now, then);
        self.add_checkpoints(&now, (then, at), &resume.checkpoints);
        siblings.eval_comments = end.state.eval_comments;
        self.steps.resumed = None;
        self.steps.left_out += end.item - item;
        Some(end.item)
    }

    /// Whether nothing that is seen from the items behind is different.
    fn stands_as(&self, before: &Expansion, now: &Checkpoint, then: &Checkpoint) -> bool {
        let (state, old) = (&now.state, &then.state);
        let files = |expansion: &Expansion| -> Vec<FileUse> {
            expansion
                .files
                .iter()
                .take(then.numbers.files)
                .skip(1)
                .cloned()
                .collect()
        };
        let is_same_file =
            |(a, b): (&FileUse, &FileUse)| Arc::ptr_eq(&a.source, &b.source) && a.name == b.name;
        state.gaps.is_same(old.gaps)
            && (
                state.eval_comments,
                state.has_marker,
                state.is_empty,
                state.evaluated,
            ) == (
                old.eval_comments,
                old.has_marker,
                old.is_empty,
                old.evaluated,
            )
            && now.in_place == then.in_place
            && now.glob_entries == then.glob_entries
            && self.flow.is_calm()
            && files(&self.result)
                .iter()
                .zip(&files(before))
                .all(is_same_file)
    }

    /// Whether the items in between changed the same names in the same way, and were the first to read and to name the same
    /// things.
    fn did_the_same(
        &self,
        before: &Expansion,
        resume: &ResumeState,
        (from, then): (&Checkpoint, &Checkpoint),
        now: &Checkpoint,
    ) -> bool {
        let changes = resume
            .changes
            .range(from.lengths.changes..then.lengths.changes);
        let own = &self.steps.journal.changes;
        let own = own.range(from.lengths.changes..now.lengths.changes);
        let is_same = |(a, b): (&Change, &Change)| is_same_change((a, &self.result), (b, before));
        let record = |expansion: &'_ Expansion, range: Range<usize>| -> Vec<Read> {
            let reads = expansion.record.iter().skip(range.start);
            reads.take(range.len()).cloned().collect()
        };
        changes.len() == own.len()
            && own.zip(changes).all(is_same)
            && record(&self.result, from.lengths.record..now.lengths.record)
                == record(before, from.lengths.record..then.lengths.record)
            && self.named_the_same(before, (from, then), now)
    }

    /// Whether the items in between were the first to give and to use the same names outside of the texts that are other ones.
    fn named_the_same(
        &self,
        before: &Expansion,
        (from, then): (&Checkpoint, &Checkpoint),
        now: &Checkpoint,
    ) -> bool {
        let Some(resumed) = &self.steps.resumed else {
            return false;
        };
        let first = self
            .result
            .files
            .first()
            .map_or(0, |file| file.first_source.index())
            + 1;
        let changed = first + resumed.changed.start..first + resumed.changed.end;
        let is_own = |src: SrcId| changed.contains(&src.index());
        let (symbols, old) = (&self.result.index.symbols, &before.index.symbols);
        let definitions = from.numbers.definitions..then.numbers.definitions;
        let is_same = |(a, b): (&Definition, &Definition)| {
            (a.kind, &a.name, a.of) == (b.kind, &b.name, b.of)
                && (a.place == b.place || is_own(a.place.src) && is_own(b.place.src))
        };
        let given = symbols.definitions.list().range(definitions.clone());
        let foreign = |uses: SharedVecIter<'_, Use>| -> Vec<Use> {
            uses.copied()
                .filter(|used| !is_own(used.place.src))
                .collect()
        };
        let conditional = part(
            &old.made_conditional,
            from.lengths.conditional..then.lengths.conditional,
        );
        let made = from.lengths.conditional..now.lengths.conditional;
        conditional == part(&symbols.made_conditional, made)
            && given
                .zip(old.definitions.list().range(definitions))
                .all(is_same)
            && foreign(symbols.uses.range(from.lengths.uses..now.lengths.uses))
                == foreign(old.uses.range(from.lengths.uses..then.lengths.uses))
    }

    /// Whether the items behind reported nothing, and define no name that was asked for too early.
    fn leads_on(&self, resume: &ResumeState, then: &Checkpoint, end: &Checkpoint) -> bool {
        let mut changes = resume
            .changes
            .range(then.lengths.changes..end.lengths.changes);
        let is_early = |name| self.names.undefined.keys().any(|(_, early)| early == name);
        let behind = resume.checkpoints.iter().rev();
        let mut behind = behind.take_while(|checkpoint| checkpoint.item > then.item);
        then.touched == end.touched
            && (self.is_hole_known(end, &self.problems.list)
                || behind.all(|checkpoint| checkpoint.is_complete))
            && (then.lengths.unclear, then.in_place) == (end.lengths.unclear, end.in_place)
            && (self.names.undefined.is_empty()
                || !changes.by_ref().filter_map(Change::defines).any(is_early))
    }

    /// Whether no limit is reached in the items behind.
    fn has_room_for(&self, now: &Checkpoint, then: &Checkpoint, end: &Checkpoint) -> bool {
        let all = now.lengths.and_between(&then.lengths, &end.lengths);
        let more = end.lengths.evaluations - then.lengths.evaluations;
        all.nodes as u64 <= self.request.limits.expand_nodes
            && all.spent.0 <= self.guards.start.0
            && all.spent.1 <= self.guards.start.1
            && self.result.index.evaluations.has_room(more)
    }

    /// Add what the items between two checkpoints gave.
    fn add_between(
        &mut self,
        before: &Expansion,
        resume: &ResumeState,
        now: &Checkpoint,
        (then, end): (&Checkpoint, &Checkpoint),
        siblings: &SiblingState,
    ) {
        let (from, to) = (&then.lengths, &end.lengths);
        let result = &mut self.result;
        let index = &before.index;
        result.frames.list_mut().extend_from(
            before.frames.list(),
            then.numbers.frames..end.numbers.frames,
        );
        result.sources.extend_from_slice(part(
            before.sources.as_slice(),
            then.numbers.sources..end.numbers.sources,
        ));
        for (file, used) in before
            .files
            .iter_ids()
            .take(end.numbers.files)
            .skip(then.numbers.files)
        {
            self.files.by_path.insert(used.source.path.clone(), file);
            result.files.push(used.clone());
        }
        for read in before.record.iter().take(to.record).skip(from.record) {
            result.record.add(read.clone());
        }
        result
            .index
            .reads
            .extend_from_slice(part(&index.reads, then.numbers.reads..end.numbers.reads));
        result
            .index
            .evaluations
            .extend_from(&index.evaluations, from.evaluations..to.evaluations);
        result.index.symbols.add_between(
            &index.symbols,
            (then.numbers.definitions, from.uses, from.conditional),
            (end.numbers.definitions, to.uses, to.conditional),
        );
        result
            .messages
            .extend_from_slice(part(&before.messages, from.messages..to.messages));
        result
            .includes
            .extend_from_slice(part(&before.includes, from.includes..to.includes));
        self.probing
            .macros
            .extend_from_slice(part(&resume.probed, from.macros..to.macros));
        self.guards.budget.steps -= to.spent.0 - from.spent.0;
        self.guards.budget.bytes -= to.spent.1 - from.spent.1;
        // what was missing here is the same as then
        self.gaps = Gaps {
            losses: self.gaps.losses + end.state.gaps.losses - then.state.gaps.losses,
            ..end.state.gaps
        };
        self.add_names(before, resume, (then, end));
        self.add_elements(before, now, (then, end), siblings);
    }

    /// The names of the document that the items between two checkpoints change, and their bindings.
    fn add_names(
        &mut self,
        before: &Expansion,
        resume: &ResumeState,
        (then, end): (&Checkpoint, &Checkpoint),
    ) {
        let names = &mut self.names;
        let given = then.numbers.bindings..end.numbers.bindings;
        let own = &mut self.result.index.bindings;
        own.list_mut()
            .extend_from(before.index.bindings.list(), given);
        // what the end of the expansion did is done again there
        let later = end.lengths.changes..resume.changes.len();
        for change in resume.changes.range(later).rev() {
            change.undo_binding(own);
        }
        let between = then.lengths.changes..end.lengths.changes;
        for change in resume.changes.range(between.clone()) {
            change.redo(names);
            // those of these items are as they were in the end
            if change
                .binding()
                .is_some_and(|info| info.index() < then.numbers.bindings)
            {
                change.redo_binding(own);
            }
        }
        let changes = &mut self.steps.journal.changes;
        changes.extend_from(&resume.changes, between);
        names.scopes.get_mut(Scopes::TOP).evaluated = end.state.evaluated;
        names.scopes.skip(end.numbers.scopes - then.numbers.scopes);
        names.macros.skip(end.numbers.tables - then.numbers.tables);
        for (id, scope) in &resume.scopes {
            if (then.numbers.scopes..end.numbers.scopes).contains(&id.index()) {
                *names.scopes.get_mut(*id) = scope.clone();
            }
        }
    }

    /// The nodes between two checkpoints.
    fn add_elements(
        &mut self,
        before: &Expansion,
        now: &Checkpoint,
        (then, end): (&Checkpoint, &Checkpoint),
        siblings: &SiblingState,
    ) {
        let (tree, old) = (&mut self.result.tree, &before.tree);
        tree.detach(self.marker);
        let root = siblings.out;
        let range = old.behind_top(then.last, root)..old.behind_top(end.last, root);
        let kept = end
            .last
            .and_then(|last| Some((last, tree.keep(old, (range, last), root)?)));
        let rest = &mut self.steps.rest;
        (rest.last, rest.kept) = (Some((then.last, now.last)), kept);
        if end.state.has_marker {
            tree.append(siblings.out, self.marker);
        }
        // only what these items set
        if !end.state.attrs.is_same(&then.state.attrs) {
            tree.get_mut(siblings.out).attrs = end.state.attrs.clone();
        }
        let all = now.lengths.and_between(&then.lengths, &end.lengths).nodes;
        self.steps.nodes_left_out = all - self.result.tree.len();
    }

    /// The macro calls between two checkpoints.
    fn add_calls(
        &mut self,
        (all, steps): (&SharedVec<StepResult>, Range<usize>),
        now: &Checkpoint,
        then: &Checkpoint,
    ) {
        let (own, old) = (now.lengths.evaluations, then.lengths.evaluations);
        let first = self.steps.done.len();
        self.steps.taken_over += steps.len();
        if own == old {
            self.steps.done.extend_from(all, steps);
        } else {
            for kept in all.range(steps) {
                self.steps.done.push(StepResult {
                    evaluations: kept.evaluations + own - old,
                    ..kept.clone()
                });
            }
        }
        self.steps.rest.steps = first..self.steps.done.len();
    }

    /// The checkpoints behind the one where everything stood alike, which has this place among all.
    fn add_checkpoints(
        &mut self,
        now: &Checkpoint,
        (then, at): (&Checkpoint, usize),
        all: &SharedVec<Checkpoint>,
    ) {
        let has_undefined = !self.names.undefined.is_empty();
        let own = &mut self.steps.checkpoints;
        if own.last().is_none_or(|last| last.item < now.item) {
            self.result.complete = true;
            own.push(now.clone());
        }
        let first = own.len();
        let is_unmoved = now.lengths == then.lengths
            && now.state.gaps.losses == then.state.gaps.losses
            && now.touched == then.touched
            && now.state.attrs.is_same(&then.state.attrs)
            && !has_undefined;
        if is_unmoved {
            own.extend_from(all, at + 1..all.len());
        } else {
            for checkpoint in all.range(at + 1..all.len()) {
                let mut moved = checkpoint.clone();
                moved.lengths = now.lengths.and_between(&then.lengths, &checkpoint.lengths);
                moved.state.gaps.losses =
                    now.state.gaps.losses + checkpoint.state.gaps.losses - then.state.gaps.losses;
                moved.touched = now.touched + checkpoint.touched - then.touched;
                moved.has_undefined |= has_undefined;
                if checkpoint.state.attrs.is_same(&then.state.attrs) {
                    moved.state.attrs = now.state.attrs.clone();
                }
                own.push(moved);
            }
        }
        self.steps.rest.checkpoints = first..own.len();
    }
}
