//! Going on from the last expansion of the same root: what lies in front of the first item that is another one is as it was, and
//! what lies behind the last one is too, once everything stands as it did there.
use std::ops::Range;
use std::sync::Arc;

use super::checkpoint::{Checkpoint, ResumeState, Resumption};
use super::expander::{Expander, has_elements};
use super::expansion::Expansion;
use super::node::{XId, XKind};
use super::origin::{FileIdx, Origin};
use super::part::part;
use super::problem::{Problem, Severity};
use super::record::Read;
use super::scope::Scopes;
use base::Id;
use base::limits::GLOB_ENTRIES;

/// Where the items of a root go on.
pub(super) struct Entry {
    /// The root element.
    pub root: XId,
    /// The first item to be evaluated.
    pub item: usize,
    pub eval_comments: bool,
}

impl<'w> Expander<'w> {
    /// Put everything as it was in front of the first item of the root that is another one than in the last expansion; none where
    /// all items have to be evaluated.
    pub(super) fn resume(&mut self, file: FileIdx) -> Option<Entry> {
        let before = self.steps.before?;
        let resume = before.memo.resume.as_ref()?;
        let changed = self.changed_items(before.expansion, file)?;
        let now = expr::changes_in_place();
        if resume.in_place != now
            || !self.has_same_packages(resume)
            || !self.problems.list.is_empty()
            || !has_elements(&before.expansion.tree)
        {
            return None;
        }
        let reads = self.reads_that_hold(before.expansion)?;
        let is_usable_hole = |checkpoint: &Checkpoint| {
            let reported = part(&before.expansion.problems, 0..checkpoint.lengths.problems);
            let (list, item) = (&resume.checkpoints, checkpoint.item);
            let mut all = list.iter().take_while(|one| one.item <= item);
            self.is_hole_known(checkpoint, reported) || all.all(|one| one.is_complete)
        };
        let is_usable = |checkpoint: &Checkpoint| {
            checkpoint.item <= changed.start
                && checkpoint.lengths.record <= reads
                && (checkpoint.lengths.unclear, checkpoint.in_place) == (resume.unclear, now)
                && !checkpoint.has_undefined
                && is_usable_hole(checkpoint)
        };
        let from = resume.checkpoints.iter().rposition(is_usable)?;
        let checkpoint = resume.checkpoints.get(from)?;
        let root = before.expansion.tree.root()?;
        self.restore(before.expansion, resume, checkpoint, root);
        let checkpoints = &mut self.steps.checkpoints;
        checkpoints.extend_from(&resume.checkpoints, 0..from + 1);
        self.steps.taken_over = checkpoint.lengths.steps;
        self.steps.left_out = checkpoint.item;
        self.steps.rest.front = (from + 1, checkpoint.lengths.steps);
        let steps = 0..checkpoint.lengths.steps;
        self.steps.done.extend_from(&before.memo.steps, steps);
        self.steps.resumed = Some(Resumption {
            from,
            changed,
            is_current: reads == before.expansion.record.len(),
        });
        debug_assert_eq!(self.numbers(), checkpoint.numbers);
        debug_assert_eq!(self.lengths(), checkpoint.lengths);
        Some(Entry {
            root,
            item: checkpoint.item,
            eval_comments: checkpoint.state.eval_comments,
        })
    }

    /// Whether nobody looks for what could not be computed when everything has been evaluated: there is a reason for it, or it was
    /// reported.
    pub(super) fn is_hole_known(&self, checkpoint: &Checkpoint, reported: &[Problem]) -> bool {
        checkpoint.state.gaps.guessed
            || !self.request.unknown_args.is_empty()
            || reported.iter().any(|one| one.severity == Severity::Error)
    }

    /// The items of the root that are other ones than before; none where that does not tell all.
    fn changed_items(&self, before: &Expansion, file: FileIdx) -> Option<Range<usize>> {
        let (now, then) = (self.result.files.get(file)?, before.files.get(file)?);
        let (document, old) = (&now.source.document, &then.source.document);
        let is_alike = now.source.path == then.source.path
            && (now.items, now.first_source) == (then.items, then.first_source)
            && document.errors().is_empty()
            && old.errors().is_empty();
        document.items_not_in(old).filter(|_| is_alike)
    }

    fn has_same_packages(&self, resume: &ResumeState) -> bool {
        resume.packages.iter().all(|(name, from, folder)| {
            let now = self.sources.packages.find(name, from);
            now.ok().map(|found| found.path) == *folder
        })
    }

    /// How many of the reads, from the first, say the same as before.
    fn reads_that_hold(&self, before: &Expansion) -> Option<usize> {
        let root = before.files.first()?;
        let mut left = GLOB_ENTRIES;
        let mut holds = |read: &Read| match read {
            Read::File(path, _) if **path == *root.source.path => true,
            Read::File(path, hash) => {
                let kept = before.files.iter().find(|file| *file.source.path == **path);
                match kept {
                    Some(kept) => self
                        .sources
                        .vfs
                        .document(path)
                        .is_ok_and(|now| Arc::ptr_eq(&now, &kept.source)),
                    None => self.sources.vfs.document_hash(path) == Some(*hash),
                }
            }
            Read::Missing(path) => !self.sources.vfs.is_file(path),
            Read::Glob(pattern, found) => self
                .sources
                .vfs
                .glob(pattern, &self.sources.env.cwd, &mut left)
                .is_ok_and(|now| now == *found),
            Read::Package(..) | Read::Env(..) | Read::Arg(..) => true,
        };
        Some(before.record.iter().take_while(|read| holds(read)).count())
    }

    /// Put everything as it was at a checkpoint.
    fn restore(
        &mut self,
        before: &Expansion,
        resume: &ResumeState,
        checkpoint: &Checkpoint,
        root: XId,
    ) {
        let (numbers, lengths) = (&checkpoint.numbers, &checkpoint.lengths);
        let result = &mut self.result;
        let behind = before.tree.behind_top(checkpoint.last, root);
        let attrs = checkpoint.state.attrs.clone();
        result
            .tree
            .restore(&before.tree, (checkpoint.last, behind), (root, attrs));
        if checkpoint.last.is_none() && !checkpoint.state.is_empty {
            let blank = result.tree.add(XKind::Text, "\n".into(), Origin::NOWHERE);
            result.tree.append(root, blank);
        }
        self.marker = result.tree.add_marker();
        if checkpoint.state.has_marker {
            result.tree.append(root, self.marker);
        }
        let frames = result.frames.list_mut();
        frames.clear();
        frames.extend_from(before.frames.list(), 0..numbers.frames);
        let own = result.sources.len();
        let more = before.sources.as_slice().get(own..numbers.sources);
        result.sources.extend_from_slice(more.unwrap_or_default());
        let files = before
            .files
            .as_slice()
            .get(1..numbers.files)
            .unwrap_or_default();
        for (file, used) in before.files.iter_ids().take(numbers.files).skip(1) {
            self.files.by_path.insert(used.source.path.clone(), file);
        }
        result.files.extend_from_slice(files);
        for read in before
            .record
            .iter()
            .take(lengths.record)
            .skip(result.record.len())
        {
            result.record.add(read.clone());
        }
        let index = &before.index;
        result
            .index
            .reads
            .extend_from_slice(part(&index.reads, 0..numbers.reads));
        result
            .index
            .evaluations
            .extend_from(&index.evaluations, 0..lengths.evaluations);
        let symbols = &mut result.index.symbols;
        let counts = (numbers.definitions, lengths.uses, lengths.conditional);
        symbols.restore(&index.symbols, counts);
        result.messages = part(&before.messages, 0..lengths.messages).to_vec();
        result.includes = part(&before.includes, 0..lengths.includes).to_vec();
        self.problems.restore(
            part(&before.problems, 0..lengths.problems),
            checkpoint.touched,
        );
        self.restore_names(before, resume, checkpoint);
        self.gaps = checkpoint.state.gaps;
        self.files.glob_entries = checkpoint.glob_entries;
        self.names.compared = checkpoint.compared;
        self.probing.macros = part(&resume.probed, 0..lengths.macros).to_vec();
        self.guards.budget.steps = self.guards.start.0 - lengths.spent.0;
        self.guards.budget.bytes = self.guards.start.1 - lengths.spent.1;
        self.steps.packages.clone_from(&resume.packages);
        self.steps.journal.unclear = lengths.unclear;
        let changes = &mut self.steps.journal.changes;
        changes.clear();
        changes.extend_from(&resume.changes, 0..lengths.changes);
        self.steps.nodes_left_out = lengths.nodes - self.result.tree.len();
    }

    /// The names of the document as they were at a checkpoint, and the bindings.
    fn restore_names(&mut self, before: &Expansion, resume: &ResumeState, checkpoint: &Checkpoint) {
        let names = &mut self.names;
        *names.scopes.get_mut(Scopes::TOP) = resume.top.clone();
        names.macros.put_top(resume.macros.clone());
        names.args.clone_from(&resume.args);
        let bindings = &mut self.result.index.bindings;
        let kept = checkpoint.numbers.bindings;
        bindings.list_mut().clear();
        bindings
            .list_mut()
            .extend_from(before.index.bindings.list(), 0..kept);
        let later = checkpoint.lengths.changes..resume.changes.len();
        for change in resume.changes.range(later).rev() {
            change.undo(names, bindings);
        }
        names.scopes.get_mut(Scopes::TOP).evaluated = checkpoint.state.evaluated;
        names
            .scopes
            .skip(checkpoint.numbers.scopes - names.scopes.len());
        names
            .macros
            .skip(checkpoint.numbers.tables - names.macros.len());
        for (id, scope) in &resume.scopes {
            if id.index() < checkpoint.numbers.scopes {
                *names.scopes.get_mut(*id) = scope.clone();
            }
        }
    }
}
