//! The last expansion of the same root, of which steps may be taken over.
use super::expansion::Expansion;
use super::memo::{Memo, StepResult};
use super::origin::SrcId;
use super::request::Request;

/// The last expansion of the same root.
#[derive(Clone, Copy)]
pub(super) struct Before<'w> {
    pub expansion: &'w Expansion,
    pub memo: &'w Memo,
}

impl<'w> Before<'w> {
    /// An earlier expansion, when it was asked for in the same way.
    pub fn of(expansion: Option<&'w Expansion>, request: &Request) -> Option<Self> {
        let expansion = expansion?;
        let memo = expansion
            .memo
            .as_deref()
            .filter(|memo| memo.request.is_same(request))?;
        Some(Self { expansion, memo })
    }

    pub fn step(&self, call: (SrcId, xml::NodeId)) -> Option<&'w StepResult> {
        let steps = &self.memo.steps;
        let place = steps.partition_point(|kept| kept.step.memo().call < call);
        steps
            .get(place)
            .filter(|kept| kept.step.memo().call == call)
    }
}
