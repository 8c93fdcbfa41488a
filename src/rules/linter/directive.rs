//! What a suppression comment says.
use super::super::rule::Rule;
use base::TextRange;

/// A suppression comment.
#[derive(Clone, Debug)]
pub struct Suppression {
    /// What it does.
    pub directive: Directive,
    /// The comment, absolute.
    pub comment: TextRange,
    /// The rules it names.
    pub rules: Vec<Selector>,
    /// Where it holds, absolute.
    pub scope: TextRange,
}

/// What a suppression comment does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Directive {
    /// Hides findings of the next element's start tag.
    DisableNextLine,
    /// Hides findings from here on.
    Disable,
    /// Ends what `disable` began.
    Enable,
    /// Hides findings of the whole file.
    DisableFile,
}

/// The name, code or beginning of a code of rules, as it stands in a comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selector {
    /// The word.
    pub text: String,
    /// Where it stands, absolute.
    pub range: TextRange,
}

impl Selector {
    /// Whether it means a rule.
    pub fn names(&self, rule: &Rule) -> bool {
        self.text == "ALL" || rule.is_named(&self.text)
    }
}
