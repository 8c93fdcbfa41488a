//! Texts with expressions, split into their parts, and where they are in the source.
use std::sync::Arc;

use ecow::EcoString;

use super::scope::TextOrigin;
use base::TextRange;
use expr::Template;

/// A text, split and parsed.
#[derive(Debug)]
pub(super) struct SplitText {
    pub text: EcoString,
    pub template: Template,
}

impl SplitText {
    pub fn of(text: &str) -> Arc<Self> {
        Arc::new(Self {
            text: text.into(),
            template: expr::split(text),
        })
    }
}

/// The text being evaluated: its decoded form, and where it stands.
#[derive(Clone, Copy)]
pub(super) struct TextSite<'t> {
    pub text: &'t str,
    pub place: TextOrigin,
    /// Whether the source spells the text as it is, without references.
    pub is_raw: bool,
}

/// An expression being evaluated.
#[derive(Clone, Copy)]
pub(super) struct CodeSite<'t> {
    /// The `${...}` in the decoded text.
    pub whole: TextRange,
    /// Where its code starts there; none when the code was put together at run time.
    pub start: Option<u32>,
    /// The code as it is written.
    pub code: &'t str,
    pub site: TextSite<'t>,
}
