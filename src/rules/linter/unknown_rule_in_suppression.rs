//! A suppression that names no rule there is.
use super::super::context::FileCx;
use super::super::finding::Help;
use super::super::registry::{find, nearest_selector};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::suppression::Suppressions;
use packages::edit_distance;

pub(in super::super) static RULE: Rule = Rule {
    code: "LNT002",
    name: "unknown-rule-in-suppression",
    category: Category::Linter,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unknown-rule-in-suppression"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let found = Suppressions::of(&cx.source.document);
    for selector in found.list.iter().flat_map(|suppression| &suppression.rules) {
        let name = selector.text.as_str();
        if name == "ALL" || find(name).next().is_some() {
            continue;
        }
        let near = nearest_selector(name);
        let help = match near {
            Some(near) => Help::did_you_mean(near),
            None => "run `xacro-lint rules` to list all rules".into(),
        };
        let finding = out
            .report_in(cx.file, selector.range, format!("unknown rule `{name}`"))
            .help(help);
        match near.filter(|near| edit_distance(&name.to_lowercase(), &near.to_lowercase()) <= 1) {
            Some(near) => finding
                .replace_with(Safety::Safe, format!("replace with `{near}`"), near)
                .done(),
            None => finding.done(),
        }
    }
}
