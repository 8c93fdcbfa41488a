//! Putting checkpoints between the items of a root: see [`Checkpoint`].
use super::checkpoint::{Around, Checkpoint, Lengths, Numbers, ResumeState};
use super::comments::is_thin_blank;
use super::expander::Expander;
use super::node::{XId, XKind};
use super::params::is_space;
use super::scope::Scopes;
use super::tag::SiblingState;
use expr::ScopeId;

impl Expander<'_> {
    /// Items and nodes between checkpoints: what a checkpoint takes is more than most items cost, and less than so many.
    const ITEMS: usize = if cfg!(test) { 1 } else { 8 };
    const NODES: usize = 100;

    /// Whether these are the items of the root.
    pub(super) fn has_checkpoints(&self, siblings: &SiblingState) -> bool {
        self.steps.keeps
            && self.files.open.len() == 1
            && self.result.tree.parent(siblings.out) == Some(XId::DOCUMENT)
            && !self.steps.journal.is_lost
    }

    /// Put a checkpoint in front of an item, where the last one is far away and one is possible.
    pub(super) fn add_checkpoint(&mut self, item: usize, siblings: &SiblingState) {
        let last = self.steps.checkpoints.last();
        let is_far = last.is_none_or(|last| {
            let nodes = last.lengths.nodes + Self::NODES;
            item >= last.item + Self::ITEMS || item > last.item && self.nodes_made() >= nodes
        });
        if !is_far || self.flow.stopped {
            return;
        }
        if let Some(checkpoint) = self.checkpoint(item, siblings) {
            self.result.complete = true;
            self.steps.checkpoints.push(checkpoint);
        }
    }

    /// How everything stands in front of an item; none where what follows may still change what is there.
    pub(super) fn checkpoint(&self, item: usize, siblings: &SiblingState) -> Option<Checkpoint> {
        let (last, has_marker) = self.last_fixed(siblings.out)?;
        let tree = &self.result.tree;
        if !has_marker
            && tree.parent(self.marker).is_some()
            && tree.parent(self.marker) != Some(siblings.out)
        {
            return None;
        }
        if tree.has_set_prefixes() {
            return None;
        }
        let state = Around {
            gaps: self.gaps,
            eval_comments: siblings.eval_comments,
            is_empty: tree.first_child(siblings.out).is_none(),
            has_marker,
            evaluated: self.names.scopes.get(Scopes::TOP).evaluated,
            attrs: tree.get(siblings.out).attrs.clone(),
        };
        Some(Checkpoint {
            item,
            last,
            numbers: self.numbers(),
            lengths: self.lengths(),
            state,
            is_complete: self.result.complete,
            has_undefined: !self.names.undefined.is_empty(),
            touched: self.problems.touched(),
            in_place: expr::changes_in_place(),
            compared: self.names.compared,
            glob_entries: self.files.glob_entries,
        })
    }

    /// The last element or comment, and whether the marker stands behind it; none when what comes later may remove it, or when there is
    /// text behind it.
    fn last_fixed(&self, out: XId) -> Option<(Option<XId>, bool)> {
        let tree = &self.result.tree;
        let (mut has_marker, mut is_fixed) = (false, false);
        let mut last = tree.last_child(out);
        while let Some(id) = last {
            let node = tree.get(id);
            match node.kind {
                XKind::Element => return Some((Some(id), has_marker)),
                // an empty line stays, and with it the comments in front of it
                XKind::Comment if is_fixed => return Some((Some(id), has_marker)),
                XKind::Text if id == self.marker => has_marker = true,
                XKind::Text if node.text.chars().all(is_space) => {
                    is_fixed |= !is_thin_blank(&node.text);
                }
                _ => return None,
            }
            last = tree.prev_sibling(id);
        }
        Some((None, has_marker))
    }

    pub(super) fn numbers(&self) -> Numbers {
        let result = &self.result;
        Numbers {
            frames: result.frames.len(),
            bindings: result.index.bindings.len(),
            reads: result.index.reads.len(),
            definitions: result.index.symbols.definitions.len(),
            scopes: self.names.scopes.len(),
            tables: self.names.macros.len(),
            files: result.files.len(),
            sources: result.sources.len(),
        }
    }

    pub(super) fn lengths(&self) -> Lengths {
        let (result, journal) = (&self.result, &self.steps.journal);
        let symbols = &result.index.symbols;
        Lengths {
            evaluations: result.index.evaluations.len(),
            uses: symbols.uses.len(),
            conditional: symbols.made_conditional.len(),
            record: result.record.len(),
            messages: result.messages.len(),
            includes: result.includes.len(),
            problems: self.problems.list.len(),
            changes: journal.changes.len(),
            unclear: journal.unclear + self.problems.changed,
            macros: self.probing.macros.len(),
            steps: self.steps.done.len(),
            nodes: self.nodes_made(),
            spent: (
                self.guards.start.0 - self.guards.budget.steps,
                self.guards.start.1 - self.guards.budget.bytes,
            ),
        }
    }

    /// What the next expansion may need of what was made here, at the end of the items: before anything is evaluated that the
    /// document does not need.
    pub(super) fn keep_open_scopes(&mut self) {
        if !self.steps.keeps {
            return;
        }
        let scopes = &self.names.scopes;
        let mut kept: Vec<ScopeId> = Vec::new();
        for id in scopes.with_lazy() {
            let around = std::iter::successors(Some(id), |&id| scopes.get(id).parent);
            kept.extend(around.take_while(|&id| id != Scopes::TOP));
        }
        kept.sort_unstable();
        kept.dedup();
        self.steps.open_scopes = kept
            .into_iter()
            .map(|id| (id, scopes.get(id).clone()))
            .collect();
        self.steps.probed.clone_from(&self.probing.macros);
    }

    /// What the next expansion may go on from; none when the root says things that cannot be put back.
    pub(super) fn resume_state(&mut self) -> Option<ResumeState> {
        if self.steps.journal.is_lost || self.flow.stopped || !self.files.broken.is_empty() {
            return None;
        }
        let lengths = self.lengths();
        let steps = &mut self.steps;
        steps.journal.changes.finish();
        Some(ResumeState {
            checkpoints: std::mem::take(&mut steps.checkpoints),
            changes: std::mem::take(&mut steps.journal.changes),
            unclear: lengths.unclear,
            in_place: expr::changes_in_place(),
            top: std::mem::take(self.names.scopes.get_mut(Scopes::TOP)),
            macros: self.names.macros.take_top(),
            args: std::mem::take(&mut self.names.args),
            scopes: std::mem::take(&mut steps.open_scopes),
            probed: std::mem::take(&mut steps.probed),
            packages: std::mem::take(&mut steps.packages),
        })
    }
}
