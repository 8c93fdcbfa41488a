//! The last expansion of the same root, of which steps may be taken over.
use super::expansion::Expansion;
use super::memo::{Memo, StepResult};
use super::origin::SrcId;
use super::request::Request;

/// The last expansion of the same root, and how far it is known to agree with this one.
#[derive(Clone, Copy)]
pub(super) struct Before<'w> {
    pub expansion: &'w Expansion,
    pub memo: &'w Memo,
    /// So many frames at the front are the same.
    pub same_frames: usize,
}

impl<'w> Before<'w> {
    /// An earlier expansion, when it was asked for in the same way.
    pub fn of(expansion: Option<&'w Expansion>, request: &Request) -> Option<Self> {
        let expansion = expansion?;
        let memo = expansion
            .memo
            .as_deref()
            .filter(|memo| memo.request.is_same(request))?;
        Some(Self {
            expansion,
            memo,
            same_frames: 0,
        })
    }

    pub fn step(&self, call: (SrcId, xml::NodeId)) -> Option<&'w StepResult> {
        let steps = &self.memo.steps;
        steps.get(
            steps
                .binary_search_by_key(&call, |kept| kept.step.call)
                .ok()?,
        )
    }
}
