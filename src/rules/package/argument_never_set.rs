//! An argument of a robot that no launch file passes.
use super::super::finding::Finding;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG015",
    name: "argument-never-set",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("argument-never-set"),
    check: Check::Analysis,
};

/// The finding about an argument that none of `calls` calls of the robot passes.
pub fn argument_never_set(span: Span, name: &str, calls: usize) -> Finding {
    let calls = if calls == 1 {
        "the only call".to_owned()
    } else {
        format!("any of {calls} calls")
    };
    let mut finding = Finding::new(
        &RULE,
        span,
        format!("argument `{name}` is not passed in {calls}"),
    );
    finding.help = Some("replace it with its default, or pass it in a launch file".to_owned());
    finding
}
