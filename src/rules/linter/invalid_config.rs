//! Something in the configuration that has no effect.

use super::super::finding::Finding;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use base::{FileId, Span};
use workspace::config::ConfigWarning;

pub(super) const RULE: Rule = Rule {
    code: "LNT004",
    name: "invalid-config",
    category: Category::Linter,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("invalid-config"),
    check: Check::Analysis,
};

/// The finding about a warning of the configuration in `file`.
pub fn invalid_config(file: FileId, warning: &ConfigWarning) -> Finding {
    let span = Span { file, range: warning.place.range };
    let help = warning.nearest.as_ref().map(|near| format!("did you mean `{near}`?"));
    Finding { help, ..Finding::new(&RULE, span, warning.message.clone()) }
}
