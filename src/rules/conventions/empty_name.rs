//! A link or joint whose name is empty.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names;

pub(in super::super) static RULE: Rule = Rule {
    code: "CNV002",
    name: "empty-name",
    category: Category::Conventions,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("empty-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if cx.robot.is_none_or(|robot| !robot.naming().marks.empty) {
        return;
    }
    let names = cx.robot.into_iter().flat_map(names::names);
    for (named, name) in names.filter(|(_, name)| name.value.is_empty()) {
        out.report(
            name.origin,
            format!("this {} has an empty name", named.word()),
        )
        .help("write a name: name=\"...\"")
        .done();
    }
}
