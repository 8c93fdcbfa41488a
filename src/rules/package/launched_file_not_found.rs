//! A launch file that calls xacro for a description that is not there.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG010",
    name: "launched-file-not-found",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("launched-file-not-found"),
    check: Check::Analysis,
};

/// The finding about a description that a call names and that is not there.
pub fn launched_file_not_found(span: Span, shown: &str) -> Finding {
    let mut finding = Finding::new(&RULE, span, format!("file `{shown}` does not exist"));
    finding.help = Some("correct the path; the call of xacro fails".to_owned());
    finding
}
