//! What to write instead of a construct.
use super::super::finding::Edit;
use super::super::rule::Safety;

/// A fix.
pub(super) struct Remedy {
    pub(super) safety: Safety,
    pub(super) message: String,
    pub(super) edits: Vec<Edit>,
}
