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
    texts: FastSet<StepKey>,
    shapes: FastSet<StepKey>,
}

/// What rules about single elements look at: whatever of a step is settled, the other may not be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum About {
    /// What the element says.
    Texts,
    /// The shape of a link, which may be in a file.
    Shapes,
}

impl About {
    pub(super) const ALL: [Self; 2] = [Self::Texts, Self::Shapes];
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
            ..Self::default()
        }
    }

    /// Whether the other one was found in the same way.
    pub(super) fn rests_on(&self, other: &Self) -> bool {
        self.basis == other.basis
    }

    pub(super) fn holds(&self, about: About, step: &StepKey) -> bool {
        match about {
            About::Texts => self.texts.contains(step),
            About::Shapes => self.shapes.contains(step),
        }
    }

    pub(super) fn add(&mut self, about: About, step: StepKey) {
        match about {
            About::Texts => self.texts.insert(step),
            About::Shapes => self.shapes.insert(step),
        };
    }

    /// Whether nothing is settled.
    pub fn is_empty(&self) -> bool {
        self.texts.is_empty() && self.shapes.is_empty()
    }
}
