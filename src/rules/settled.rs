//! What rules about single elements need not be asked again after an edit.
use std::cell::OnceCell;
use std::sync::Arc;

use super::context::{DocumentCx, RootKind};
use super::kept_finding::KeptFinding;
use super::rule::Rule;
use super::watch::Beyond;
use base::{FastMap, FastSet};
use expand::{StepKey, XId};
use model::{SharedNames, Version};

/// The steps of an expansion with the rules that have to be asked about them again: those that found something, or looked at
/// something else to know. An expansion that takes a step over gives the same elements, of which all other rules find nothing.
/// Those that looked only at links and joints say the same while these are the same.
/// Files around the description, packages and configuration have to be the same; whoever keeps this sees to it.
#[derive(Clone, Debug, Default)]
pub struct Settled {
    basis: Option<Basis>,
    names: Option<SharedNames>,
    /// In document order.
    steps: Vec<(StepKey, SettledStep)>,
}

/// The rules that have to be asked again: their places among those that run, in order.
pub(super) type OpenRules = Arc<[u16]>;

/// What is known of a step.
#[derive(Clone, Debug)]
pub(super) struct SettledStep {
    pub open: OpenRules,
    /// What these say; none when they have to be asked in any case.
    pub said: Option<Arc<Said>>,
}

/// What rules say of a step, and what that rests on.
#[derive(Debug, Default)]
pub(super) struct Said {
    pub findings: Vec<KeptFinding>,
    /// The names of links and joints.
    names: bool,
    /// Other steps whose links and joints were looked at.
    steps: Vec<StepKey>,
}

/// What rules about single elements may ask of the whole document without being asked again.
#[derive(Clone, Debug, PartialEq)]
struct Basis {
    rules: Vec<&'static Rule>,
    kind: RootKind,
    complete: bool,
    version: Option<Version>,
}

impl Settled {
    /// Nothing yet of a document that these rules run on.
    pub(super) fn on(cx: &DocumentCx<'_>, rules: &[&'static Rule]) -> Self {
        Self {
            basis: Some(Basis {
                rules: rules.to_vec(),
                kind: cx.kind,
                complete: cx.complete,
                version: Version::of(&cx.expansion.tree),
            }),
            names: cx.robot.map(|robot| robot.shared_names()),
            steps: Vec::new(),
        }
    }

    pub(super) fn add(&mut self, step: &StepKey, known: SettledStep) {
        self.steps.push((step.clone(), known));
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }
}

/// Looks up in document order what is known from before.
pub(super) struct Known<'b> {
    before: &'b Settled,
    /// What was known of this is of no use now.
    is_other: bool,
    has_same_names: bool,
    /// The step that probably comes next, and all steps once one stands elsewhere.
    next: usize,
    places: OnceCell<FastMap<&'b StepKey, usize>>,
}

impl<'b> Known<'b> {
    /// Steps in front of which another one may have been added or removed.
    const NEAR: usize = 4;

    pub(super) fn of(before: &'b Settled, now: &Settled) -> Self {
        Self {
            before,
            is_other: before.basis != now.basis,
            has_same_names: before.names.is_some() && before.names == now.names,
            next: 0,
            places: OnceCell::new(),
        }
    }

    /// What is known of a step.
    pub(super) fn step(&mut self, step: &StepKey) -> Option<&'b SettledStep> {
        let steps = self.before.steps.as_slice();
        if self.is_other || steps.is_empty() {
            return None;
        }
        let near = steps.iter().enumerate().skip(self.next).take(Self::NEAR);
        let mut near = near.filter(|(_, (known, _))| known == step);
        let found = near.next().map(|(place, _)| place);
        let place = match found {
            Some(place) => place,
            None => self.place(step)?,
        };
        self.next = place + 1;
        steps.get(place).map(|(_, known)| known)
    }

    /// The place of a step wherever it is.
    #[expect(
        clippy::mutable_key_type,
        reason = "a step is told from others by its address"
    )]
    fn place(&self, step: &StepKey) -> Option<usize> {
        let places = self.places.get_or_init(|| {
            let steps = self.before.steps.iter().enumerate();
            steps.map(|(place, (step, _))| (step, place)).collect()
        });
        places.get(step).copied()
    }

    /// Whether what rules said still holds; `steps` are those that the document has now.
    pub(super) fn holds(&self, said: &Said, steps: &Steps<'_, '_>) -> bool {
        (!said.names || self.has_same_names) && said.steps.iter().all(|step| steps.has(step))
    }
}

/// The steps of a document by their elements.
pub(super) struct Steps<'s, 'a> {
    cx: &'s DocumentCx<'a>,
    list: OnceCell<Vec<(XId, XId, StepKey)>>,
    all: OnceCell<FastSet<StepKey>>,
    /// What is said of steps of which nothing was found, by what that rests on: nearly all.
    quiet: FastMap<bool, Arc<Said>>,
}

impl<'s, 'a> Steps<'s, 'a> {
    pub(super) fn of(cx: &'s DocumentCx<'a>) -> Self {
        Self {
            cx,
            list: OnceCell::new(),
            all: OnceCell::new(),
            quiet: FastMap::default(),
        }
    }

    fn has(&self, step: &StepKey) -> bool {
        let all = || self.cx.steps().map(|(step, _)| step.clone()).collect();
        self.all.get_or_init(all).contains(step)
    }

    /// The step that an element belongs to.
    fn around(&self, element: XId) -> Option<&StepKey> {
        let list = self.list.get_or_init(|| {
            let steps = self.cx.steps();
            steps
                .map(|(step, elements)| (elements.start, elements.end, step.clone()))
                .collect()
        });
        let behind = list.partition_point(|(start, ..)| *start <= element);
        let (_, end, step) = list.get(behind.checked_sub(1)?)?;
        (element < *end).then_some(step)
    }

    /// What rules say of a step that looked at something beyond; none when that may change without a trace.
    pub(super) fn said(
        &mut self,
        own: &StepKey,
        beyond: &Beyond,
        findings: Option<Vec<KeptFinding>>,
    ) -> Option<Arc<Said>> {
        let findings = findings.filter(|_| !beyond.anything)?;
        let mut steps: Vec<StepKey> = Vec::new();
        for &element in &beyond.elements {
            let step = self.around(element)?;
            if step != own && !steps.contains(step) {
                steps.push(step.clone());
            }
        }
        let names = beyond.names;
        let is_quiet = findings.is_empty() && steps.is_empty();
        let said = Said {
            findings,
            names,
            steps,
        };
        if is_quiet {
            let known = self.quiet.entry(names);
            return Some(Arc::clone(known.or_insert_with(|| Arc::new(said))));
        }
        Some(Arc::new(said))
    }
}
