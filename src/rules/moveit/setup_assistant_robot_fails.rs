//! A robot that xacro rejects with the arguments of `.setup_assistant`.
use super::super::finding::{Finding, Related};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "MOV010",
    name: "setup-assistant-robot-fails",
    category: Category::Moveit,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("setup-assistant-robot-fails"),
    check: Check::Analysis,
};

/// The finding about arguments with which a file cannot be expanded, and what is wrong there.
pub fn setup_assistant_robot_fails(
    span: Span,
    file: &str,
    (place, problem): (Span, &str),
) -> Finding {
    let mut finding = Finding::new(
        &RULE,
        span,
        format!("`{file}` has an error with these arguments: {problem}"),
    );
    finding.help = Some("correct the arguments; without them, the error does not occur".to_owned());
    finding.related.push(Related {
        span: place,
        message: problem.to_owned(),
        is_call: false,
    });
    finding
}
