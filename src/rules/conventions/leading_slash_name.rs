//! A name that begins with a slash.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::names;

pub(super) const RULE: Rule = Rule {
    code: "CNV003",
    name: "leading-slash-name",
    category: Category::Conventions,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page!("leading-slash-name"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (named, name) in cx.robot.into_iter().flat_map(names::names) {
        let Some(rest) = name.value.strip_prefix('/') else { continue };
        let new = rest.trim_start_matches('/');
        let report = out
            .report(name.origin, format!("the name of {} `{}` begins with a slash", named.word(), name.value))
            .help("tf2 refuses frames whose name begins with a slash");
        match names::rename(cx, named, &name.value, new).filter(|_| !new.is_empty()) {
            Some(edits) => {
                report.edits(Safety::Safe, format!("rename it to `{new}` everywhere"), edits).done();
            }
            None => report.done(),
        }
    }
}
