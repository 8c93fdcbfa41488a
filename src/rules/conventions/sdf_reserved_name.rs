//! A name that SDFormat keeps for itself.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names;

pub(super) static RULE: Rule = Rule {
    code: "CNV005",
    name: "sdf-reserved-name",
    category: Category::Conventions,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("sdf-reserved-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if cx
        .robot
        .is_none_or(|robot| !robot.naming().marks.underscores)
    {
        return;
    }
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let inner = name
            .value
            .strip_prefix("__")
            .and_then(|rest| rest.strip_suffix("__"));
        if inner.is_some() {
            let what = named.word();
            out.report(
                name.origin,
                format!("name of {what} `{}` is reserved by SDFormat", name.value),
            )
            .help("rename it; Gazebo rejects names that start and end with two underscores")
            .done();
        }
    }
}
