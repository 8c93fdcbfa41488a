//! What rules about single elements need not be asked again after an edit.
use super::context::{DocumentCx, RootKind};
use super::rule::Rule;
use base::FastMap;
use expand::StepKey;
use model::Version;

/// The steps of an expansion with the rules that have to be asked about them again: those that found something, or looked at
/// something else to know. An expansion that takes a step over gives the same elements, of which all other rules find nothing.
/// Files around the description, packages and configuration have to be the same; whoever keeps this sees to it.
#[derive(Clone, Debug, Default)]
pub struct Settled {
    basis: Option<Basis>,
    steps: FastMap<StepKey, OpenRules>,
}

/// The rules that have to be asked again: their places among those that run, in order.
pub(super) type OpenRules = Vec<u16>;

/// What rules about single elements may ask of the whole document without being asked again.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Basis {
    rules: Vec<&'static Rule>,
    kind: RootKind,
    complete: bool,
    version: Option<Version>,
}

impl Basis {
    pub(super) fn of(cx: &DocumentCx<'_>, rules: &[&'static Rule]) -> Self {
        Self {
            rules: rules.to_vec(),
            kind: cx.kind,
            complete: cx.complete,
            version: Version::of(&cx.expansion.tree),
        }
    }
}

impl Settled {
    pub(super) fn on(basis: Basis) -> Self {
        Self {
            basis: Some(basis),
            steps: FastMap::default(),
        }
    }

    /// Whether the other one was found in the same way.
    pub(super) fn rests_on(&self, other: &Self) -> bool {
        self.basis == other.basis
    }

    /// The rules that have to be asked about a step again; none when all have to.
    pub(super) fn open_rules(&self, step: &StepKey) -> Option<&OpenRules> {
        self.steps.get(step)
    }

    pub(super) fn add(&mut self, step: StepKey, open: OpenRules) {
        self.steps.insert(step, open);
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }
}
