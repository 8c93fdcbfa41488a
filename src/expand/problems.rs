//! The problems of an expansion while they are collected.
use std::cell::Cell;

use super::kind::ProblemKind;
use super::problem::{FileRange, Problem, TraceStep};
use super::{FileIdx, advice};
use base::{FastMap, TextRange};

/// Collects problems; the same problem at the same place is kept once.
#[derive(Debug, Default)]
pub(super) struct Problems {
    pub list: Vec<Problem>,
    /// By kind and place: the problems that were reported there.
    seen: FastMap<(ProblemKind, FileIdx, TextRange), Vec<usize>>,
    /// How often somebody reported something or asked what is reported.
    touched: Cell<u64>,
    /// How often one that was reported before was changed.
    pub changed: usize,
}

impl Problems {
    /// Calls kept for one problem.
    const MOST_CALLS: usize = 100;

    /// How often somebody reported something or asked what is reported.
    pub fn touched(&self) -> u64 {
        self.touched.get()
    }

    /// The number of a problem that was reported.
    pub fn find(&self, kind: ProblemKind, place: FileRange, message: &str) -> Option<usize> {
        self.touched.set(self.touched.get() + 1);
        let here = self.seen.get(&(kind, place.file, place.range))?;
        let is_same = |i: &&usize| self.list.get(**i).is_some_and(|old| old.message == message);
        here.iter().find(is_same).copied()
    }

    /// Whether further calls that lead to a problem are of interest.
    pub fn wants_calls(&self, known: usize) -> bool {
        self.list
            .get(known)
            .is_some_and(|old| old.more_calls.len() < Self::MOST_CALLS)
    }

    /// Note a further call that leads to a problem.
    pub fn add_call(&mut self, known: usize, call: Option<TraceStep>) {
        if let (Some(old), Some(call)) = (self.list.get_mut(known), call)
            && old.more_calls.len() < Self::MOST_CALLS
            && !old.trace.contains(&call)
            && !old.more_calls.contains(&call)
        {
            old.more_calls.push(call);
            self.changed += 1;
        }
    }

    /// Put those back that another expansion had reported up to some place.
    pub fn restore(&mut self, reported: &[Problem], touched: u64) {
        for (number, problem) in reported.iter().enumerate() {
            let key = (problem.kind, problem.place.file, problem.place.range);
            self.seen.entry(key).or_default().push(number);
        }
        self.list = reported.to_vec();
        self.touched.set(touched);
    }

    pub fn push(&mut self, mut problem: Problem) {
        if problem.help.is_none() {
            problem.help = Some(advice::of(&problem));
        }
        if let Some(known) = self.find(problem.kind, problem.place, &problem.message) {
            return self.add_call(known, problem.trace.into_iter().next());
        }
        let here = self
            .seen
            .entry((problem.kind, problem.place.file, problem.place.range))
            .or_default();
        here.push(self.list.len());
        self.list.push(problem);
    }
}
