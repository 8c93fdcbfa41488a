//! What a rule has to say.

use super::registry::{Rule, Safety, Severity};
use crate::base::Span;

/// A defect at its place.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The rule that found it.
    pub rule: &'static Rule,
    /// How bad it is.
    pub severity: Severity,
    /// One line that names the thing, without a full stop.
    pub message: String,
    /// The text that is wrong.
    pub span: Span,
    /// Further places: the first of two duplicates, definitions; then the calls that led here, innermost first.
    pub related: Vec<Related>,
    /// What to do, where there is something to say.
    pub help: Option<String>,
    /// Edits that mend it.
    pub fix: Option<Fix>,
}

/// A further place of a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// The place.
    pub span: Span,
    /// What is there.
    pub message: String,
    /// Whether expansion came through here: a call, an include, a use. Else something to compare with.
    pub is_call: bool,
}

/// A way to mend a finding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// Whether the meaning can change.
    pub safety: Safety,
    /// What the edits do.
    pub message: String,
    /// Replacements that do not overlap.
    pub edits: Vec<Edit>,
}

/// New text in place of old.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The old text.
    pub span: Span,
    /// The new text.
    pub content: String,
}
