//! A value of an argument of a launch file that its choices rule out.
use super::super::finding::{Finding, Help};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use base::Span;

pub(super) static RULE: Rule = Rule {
    code: "PKG013",
    name: "value-outside-choices",
    category: Category::Package,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("value-outside-choices"),
    check: Check::Analysis,
};

/// The finding about a value that is none of the choices of an argument; `near`: the choice that was probably meant.
pub fn value_outside_choices(
    span: Span,
    name: &str,
    value: &str,
    choices: &[String],
    near: Option<&str>,
) -> Finding {
    let message = format!("value `{value}` of argument `{name}` is not one of its choices");
    let help = match near {
        Some(near) => Help::did_you_mean(near),
        None => format!("write one of {}; the launch fails", listed(choices)).into(),
    };
    Finding::new(&RULE, span, message).advised(help)
}

/// The first of some words, in backticks.
pub(super) fn listed(words: &[String]) -> String {
    const MOST: usize = 6;
    let first: Vec<String> = words
        .iter()
        .take(MOST)
        .map(|word| format!("`{word}`"))
        .collect();
    let more = words.len().saturating_sub(MOST);
    if more > 0 {
        format!("{} and {more} more", first.join(", "))
    } else {
        first.join(", ")
    }
}
