//! What each `${...}` and `$(...)` gave, each time it was evaluated: what editors show beside it.
use std::ops::Range;
use std::sync::OnceLock;

use super::origin::{FrameId, Origin};
use super::symbols::SourceRange;
#[cfg(debug_assertions)]
use base::SharedVec;
use base::limits::EVALUATIONS;
use base::{FastMap, SharedIdVec, TextRange};
use expr::Value;

/// A value that an expression gave.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The `${...}` or `$(...)`.
    pub at: Origin,
    /// What it gave.
    pub value: Value,
    /// The bindings that were read for it: see [`Expansion::read_in`](super::Expansion::read_in).
    pub reads: TextRange,
}

/// A value in [`Evaluations::list`].
#[derive(Clone, Copy, Debug)]
struct EvaluationId(u32);

base::ids!(EvaluationId);

/// All values that expressions gave, in order.
#[derive(Clone, Debug, Default)]
pub struct Evaluations {
    list: SharedIdVec<EvaluationId, Evaluation>,
    /// By place, made on first use.
    places: OnceLock<FastMap<SourceRange, Vec<EvaluationId>>>,
    /// The first of each place and frame, made on first use.
    frames: OnceLock<FastMap<(SourceRange, FrameId), EvaluationId>>,
}

impl Evaluations {
    /// Those of one `${...}` or `$(...)`, in order.
    pub fn at(&self, place: SourceRange) -> impl Iterator<Item = &Evaluation> {
        let places = self.places.get_or_init(|| {
            let mut places: FastMap<SourceRange, Vec<EvaluationId>> = FastMap::default();
            for (id, evaluation) in self.list.iter_ids() {
                places.entry(evaluation.at.into()).or_default().push(id);
            }
            places
        });
        let found = places.get(&place).into_iter().flatten();
        found.filter_map(|&id| self.list.get(id))
    }

    /// They are complete: the next expansion may share them.
    pub(super) fn finish(&mut self) {
        self.list.list_mut().finish();
    }

    /// The first of one `${...}` or `$(...)` in one frame.
    pub fn in_frame(&self, place: SourceRange, frame: FrameId) -> Option<&Evaluation> {
        let frames = self.frames.get_or_init(|| {
            let mut frames: FastMap<(SourceRange, FrameId), EvaluationId> = FastMap::default();
            for (id, evaluation) in self.list.iter_ids() {
                frames
                    .entry((evaluation.at.into(), evaluation.at.frame))
                    .or_insert(id);
            }
            frames
        });
        self.list.get(*frames.get(&(place, frame))?)
    }

    #[cfg(debug_assertions)]
    pub(super) fn all(&self) -> &SharedVec<Evaluation> {
        self.list.list()
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether so many more are kept.
    pub(super) fn has_room(&self, more: usize) -> bool {
        self.list.len() + more < EVALUATIONS
    }

    /// The values of a part of them.
    pub(super) fn values(&self, part: Range<usize>) -> impl Iterator<Item = &Value> {
        let part = self.list.list().range(part);
        part.map(|evaluation| &evaluation.value)
    }

    /// The places of all from one on.
    pub(super) fn places_from(&self, first: usize) -> impl Iterator<Item = Origin> {
        self.list.iter().skip(first).map(|one| one.at)
    }

    /// Add a part of others.
    pub(super) fn extend_from(&mut self, others: &Self, part: Range<usize>) {
        self.list.list_mut().extend_from(others.list.list(), part);
    }

    /// Note what an expression gave.
    pub(super) fn add(&mut self, evaluation: Evaluation) {
        self.list.push(evaluation);
    }

    /// Whether there were more than are kept.
    pub fn is_full(&self) -> bool {
        self.list.len() >= EVALUATIONS
    }
}
