//! A value of an argument that no condition of the robot compares with.
use std::path::Path;

use super::super::finding::{Finding, Help};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::value_outside_choices::listed;
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG014",
    name: "value-never-compared",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("value-never-compared"),
    check: Check::Analysis,
};

/// The finding about a value that a call gives, while the robot only compares the argument with others.
pub fn value_never_compared(
    span: Span,
    (name, value): (&str, &str),
    file: &Path,
    compared: &[String],
    near: Option<&str>,
) -> Finding {
    let file = file.file_name().unwrap_or_default().to_string_lossy();
    let message = format!("`{file}` never compares argument `{name}` with `{value}`");
    let help = match near {
        Some(near) => Help::did_you_mean(near),
        None => format!("write one of {}", listed(compared)).into(),
    };
    Finding::new(&RULE, span, message).advised(help)
}
