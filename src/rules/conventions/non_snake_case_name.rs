//! A name that is not in lower case with underscores.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names;

pub(super) static RULE: Rule = Rule {
    code: "CNV006",
    name: "non-snake-case-name",
    category: Category::Conventions,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("non-snake-case-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let ends = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit();
        let snake = name.value.chars().all(|c| ends(c) || c == '_') && name.value.starts_with(ends);
        if !snake && !name.value.is_empty() {
            let message = format!(
                "name of {} `{}` is not in snake case",
                named.word(),
                name.value
            );
            out.report(name.origin, message)
                .help("use lower case and underscores, for example `upper_arm_link`")
                .done();
        }
    }
}
