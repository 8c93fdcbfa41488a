//! A macro called without the prefix `xacro:`.
use super::super::context::FileCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::{is_urdf_element, outside_free_zones};
use base::TextRange;

pub(in super::super) static RULE: Rule = Rule {
    code: "XAC021",
    name: "unprefixed-macro-call",
    category: Category::Xacro,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("unprefixed-macro-call"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    for (base, node) in outside_free_zones(cx.elements()) {
        let name = node.name();
        if !cx.macros.contains(name) || is_urdf_element(name) {
            continue;
        }
        let start = node.name_range().shift(base);
        let end = node.end_name_range().map(|range| range.shift(base));
        let edits = [Some(start), end]
            .into_iter()
            .flatten()
            .map(|range| (TextRange::empty(range.start), "xacro:".to_owned()));
        let message =
            format!("call of macro `{name}` is missing the `xacro:` prefix, so xacro ignores it");
        out.report_in(cx.file, TextRange::new(start.start - 1, start.end), message)
            .help(format!("write `xacro:{name}`"))
            .fix(Safety::Safe, "add the prefix `xacro:`", cx.file, edits)
            .done();
    }
}
