//! A file of `.setup_assistant` that is not there.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "MOV009",
    name: "setup-assistant-file-not-found",
    category: Category::Moveit,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("setup-assistant-file-not-found"),
    check: Check::Analysis,
};

/// The finding about a file of a package that is named and does not exist.
pub fn setup_assistant_file_not_found(span: Span, file: &str, package: &str) -> Finding {
    let mut finding = Finding::new(
        &RULE,
        span,
        format!("file `{file}` does not exist in package `{package}`"),
    );
    finding.help = Some(
        "correct the path; launch files that use `MoveItConfigsBuilder` fail without the file"
            .to_owned(),
    );
    finding
}
