//! What rules about single elements need not be asked again after an edit.
use super::context::{DocumentCx, RootKind};
use super::rule::Rule;
use base::FastSet;
use expand::StepKey;
use model::Version;

/// The steps of an expansion of whose elements rules found nothing, and looked at nothing else to know. An expansion that takes
/// such a step over gives the same elements, of which the same rules find nothing. Files around the description, packages and
/// configuration have to be the same; whoever keeps this sees to it.
#[derive(Clone, Debug, Default)]
pub struct Settled {
    basis: Option<Basis>,
    steps: FastSet<StepKey>,
}

/// What rules about single elements may ask of the whole document without being asked again.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Basis {
    rules: Vec<&'static Rule>,
    kind: RootKind,
    explicit: bool,
    complete: bool,
    version: Option<Version>,
}

impl Basis {
    pub(super) fn of(cx: &DocumentCx<'_>, rules: &[&'static Rule]) -> Self {
        Self {
            rules: rules.to_vec(),
            kind: cx.kind,
            explicit: cx.explicit,
            complete: cx.complete,
            version: Version::of(&cx.expansion.tree),
        }
    }
}

impl Settled {
    pub(super) fn on(basis: Basis) -> Self {
        Self {
            basis: Some(basis),
            steps: FastSet::default(),
        }
    }

    /// Whether the other one was found in the same way.
    pub(super) fn rests_on(&self, other: &Self) -> bool {
        self.basis == other.basis
    }

    pub(super) fn holds(&self, step: &StepKey) -> bool {
        self.steps.contains(step)
    }

    pub(super) fn add(&mut self, step: StepKey) {
        self.steps.insert(step);
    }

    /// How many steps there are.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether there is no step.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }
}
