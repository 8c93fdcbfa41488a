//! A condition that is always the same.
use super::super::context::{FileCx, elements_where};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule {
    code: "XAC038",
    name: "constant-condition",
    category: Category::Xacro,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("constant-condition"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for (base, node) in elements_where(&cx.source.document, |marks| marks.condition) {
        let wanted = match node.name() {
            "xacro:if" => true,
            "xacro:unless" => false,
            _ => continue,
        };
        let Some(value) = node.attr("value") else {
            continue;
        };
        let Some(truth) = truth(value.raw()) else {
            continue;
        };
        let (verb, help) = if truth == wanted {
            ("always", "remove the condition and keep its content")
        } else {
            (
                "never",
                "remove the element, or make the condition depend on an argument",
            )
        };
        let message = format!(
            "condition of this `{}` is constant: its content is {verb} part of the robot",
            node.name()
        );
        out.report_in(cx.file, value.value_range().shift(base), message)
            .help(help)
            .done();
    }
}

/// The truth of a value without expressions; none when it has some, or is none at all.
fn truth(value: &str) -> Option<bool> {
    let value = value.trim();
    let constant = value
        .strip_prefix("${")
        .and_then(|rest| rest.strip_suffix('}'))
        .map_or(value, str::trim);
    match constant {
        "true" | "True" => Some(true),
        "false" | "False" => Some(false),
        number => number.parse::<i64>().ok().map(|number| number != 0),
    }
}
