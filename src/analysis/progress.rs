//! How far a check is.
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Counts expansions; may be read while a check runs.
#[derive(Clone, Debug, Default)]
pub struct Progress {
    counts: Arc<(AtomicUsize, AtomicUsize)>,
}

impl Progress {
    /// How many expansions are done, and of how many.
    pub fn get(&self) -> (usize, usize) {
        let (done, all) = &*self.counts;
        (done.load(Ordering::Relaxed), all.load(Ordering::Relaxed))
    }

    pub(super) fn begin(&self, all: usize) {
        self.counts.0.store(0, Ordering::Relaxed);
        self.counts.1.store(all, Ordering::Relaxed);
    }

    /// More expansions are to be made.
    pub(super) fn add(&self, expansions: usize) {
        self.counts.1.fetch_add(expansions, Ordering::Relaxed);
    }

    pub(super) fn step(&self) {
        self.skip(1);
    }

    pub(super) fn skip(&self, expansions: usize) {
        self.counts.0.fetch_add(expansions, Ordering::Relaxed);
    }
}
