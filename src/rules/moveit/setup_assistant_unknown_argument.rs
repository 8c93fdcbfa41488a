//! An argument of `.setup_assistant` that the robot does not know.
use super::super::finding::{Finding, Help};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "MOV011",
    name: "setup-assistant-unknown-argument",
    category: Category::Moveit,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("setup-assistant-unknown-argument"),
    check: Check::Analysis,
};

/// The finding about an argument that no file of the robot declares or reads.
pub fn setup_assistant_unknown_argument(
    span: Span,
    name: &str,
    file: &str,
    near: Option<&str>,
) -> Finding {
    let help = match near {
        Some(near) => Help::did_you_mean(near),
        None => format!("remove it, or declare it in `{file}`; xacro ignores an unknown argument")
            .into(),
    };
    Finding::new(
        &RULE,
        span,
        format!("unknown argument `{name}` of `{file}`"),
    )
    .advised(help)
}
