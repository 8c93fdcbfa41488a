//! Findings that are kept for the next check.
use ecow::EcoString;

use super::finding::Finding;
use super::grouping::Group;
use super::rule::{Rule, Severity};
use expand::Origin;

/// A finding at a text of a step. It says the same of that text in the next expansion that takes the step over.
#[derive(Clone, Debug)]
pub(super) struct KeptFinding {
    pub rule: &'static Rule,
    pub severity: Severity,
    pub said: Wording,
    pub origin: Origin,
    pub group: Option<Group>,
    pub habit: Option<Habit>,
}

/// The message of a finding and its help.
#[derive(Clone, Debug)]
pub(super) struct Wording {
    pub message: EcoString,
    pub help: Option<EcoString>,
}

/// What makes a finding an info where enough others of its rule in the document are like it: it is meant so.
#[derive(Clone, Copy, Debug)]
pub(super) struct Habit {
    /// From how many on.
    pub least: usize,
}

impl KeptFinding {
    /// None of a finding with anything that another edit may move.
    pub(super) fn of(
        (finding, habit): (&Finding, Option<Habit>),
        said: &Wording,
        instance: Option<Origin>,
        others: &[Origin],
    ) -> Option<Self> {
        let is_simple = others.is_empty()
            && finding.related.is_empty()
            && finding.fix.is_none()
            && finding.similar.is_none()
            && !finding.probed;
        let origin = instance.filter(|_| is_simple)?;
        Some(Self {
            rule: finding.rule,
            severity: finding.severity,
            said: said.clone(),
            origin,
            group: finding.group.clone(),
            habit,
        })
    }
}
