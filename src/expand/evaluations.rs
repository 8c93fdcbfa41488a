//! What each `${...}` and `$(...)` gave, each time it was evaluated: what editors show beside it.

use std::sync::OnceLock;

use super::machine::Expander;
use super::origin::{FrameId, Origin};
use super::symbols::SourceRange;
use crate::base::limits::EVALUATIONS;
use crate::base::{FastMap, TextRange};
use crate::expr::Value;

/// A value that an expression gave.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The `${...}` or `$(...)`.
    pub at: Origin,
    /// What it gave.
    pub value: Value,
    /// Its part of [`Evaluations::reads`].
    reads: TextRange,
}

/// All values that expressions gave, in order.
#[derive(Clone, Debug, Default)]
pub struct Evaluations {
    list: Vec<Evaluation>,
    reads: Vec<u32>,
    /// By place, made on first use.
    places: OnceLock<FastMap<SourceRange, Vec<u32>>>,
    /// The first of each place and frame, made on first use.
    frames: OnceLock<FastMap<(SourceRange, FrameId), u32>>,
}

impl Evaluations {
    /// Those of one `${...}` or `$(...)`, in order.
    pub fn at(&self, place: SourceRange) -> impl Iterator<Item = &Evaluation> {
        let places = self.places.get_or_init(|| {
            let mut places: FastMap<SourceRange, Vec<u32>> = FastMap::default();
            for (index, evaluation) in (0..).zip(&self.list) {
                places.entry(evaluation.at.into()).or_default().push(index);
            }
            places
        });
        let found = places.get(&place).into_iter().flatten();
        found.filter_map(|&index| self.list.get(index as usize))
    }

    /// Give back the room for more.
    pub(super) fn shrink(&mut self) {
        self.list.shrink_to_fit();
        self.reads.shrink_to_fit();
    }

    /// The first of one `${...}` or `$(...)` in one frame.
    pub fn in_frame(&self, place: SourceRange, frame: FrameId) -> Option<&Evaluation> {
        let frames = self.frames.get_or_init(|| {
            let mut frames: FastMap<(SourceRange, FrameId), u32> = FastMap::default();
            for (index, evaluation) in (0..).zip(&self.list) {
                frames.entry((evaluation.at.into(), evaluation.at.frame)).or_insert(index);
            }
            frames
        });
        self.list.get(*frames.get(&(place, frame))? as usize)
    }

    /// Whether there were more than are kept.
    pub fn is_full(&self) -> bool {
        self.list.len() >= EVALUATIONS
    }

    /// The bindings that were read for a value: indices of [`Expansion::bindings`](super::Expansion::bindings).
    pub fn reads(&self, evaluation: &Evaluation) -> &[u32] {
        let TextRange { start, end } = evaluation.reads;
        self.reads.get(start as usize..end as usize).unwrap_or(&[])
    }
}

impl Expander<'_> {
    /// Note what the expression at `at` gave; `mark` is how many reads there were before.
    pub fn note_value(&mut self, at: Origin, value: &Value, mark: usize) {
        let kept = &mut self.result.evaluations;
        if kept.is_full() || !self.request.probe {
            return;
        }
        let start = kept.reads.len() as u32;
        kept.reads.extend(self.reads.get(mark..).unwrap_or(&[]));
        let reads = TextRange::new(start, kept.reads.len() as u32);
        kept.list.push(Evaluation { at, value: value.clone(), reads });
    }
}
