//! What a rule has to say.

use ecow::EcoString;

use super::grouping::Group;
use super::registry::{Rule, Safety, Severity};
use base::Span;
use expand::Outside;

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
    /// The macro calls in which it holds, when the text that is wrong stands in the body of a macro.
    pub ways: Vec<Way>,
    /// Whether it holds in some calls of that macro only, because the text reads differently in others.
    pub partial: bool,
    /// What outside of the expansion may make it go away.
    pub outside: Option<Outside>,
    /// Whether it is in a macro that nothing calls.
    pub probed: bool,
    /// What it shares with other findings that are the same defect; none: what the rule says.
    pub group: Option<Group>,
    /// The further places, once findings are grouped.
    pub places: Vec<Related>,
}

/// A macro call in which a finding holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way {
    /// The tag of the call.
    pub call: Span,
    /// The macro.
    pub name: EcoString,
    /// What the call passes, when the text that is wrong is a parameter and nothing else.
    pub argument: Option<Span>,
    /// What there is to say about this call.
    pub message: String,
    /// What to do here.
    pub help: Option<String>,
}

impl Finding {
    /// A finding without further places, help or fix, as bad as its rule says.
    pub fn new(rule: &'static Rule, span: Span, message: impl Into<String>) -> Self {
        Self {
            rule,
            severity: rule.severity,
            message: message.into(),
            span,
            related: Vec::new(),
            help: None,
            fix: None,
            ways: Vec::new(),
            partial: false,
            outside: None,
            probed: false,
            group: None,
            places: Vec::new(),
        }
    }
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
