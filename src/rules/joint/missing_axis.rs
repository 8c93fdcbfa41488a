//! A moving joint without an axis.
use super::super::context::DocumentCx;
use super::super::edits::{indent, source_text};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::{Reported, Sink};
use super::axis::moves;
use base::TextRange;
use model::{Joint, element_range, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "JNT013",
    name: "missing-axis",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Safe),
    docs: page("missing-axis"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if joint.axis.is_some() || !moves(joint) || !cx.whole() {
        return;
    }
    let message = format!(
        "joint `{}` has no `axis`; the default is `1 0 0`",
        joint.shown()
    );
    let report = out.report(tag_start(cx.expansion, joint.element), message);
    written(report.help("add <axis xyz=\"...\"/>"), cx, joint).done();
}

/// With the fix to write the axis behind the last of the elements that usually stand in front of it.
fn written<'s, 'a>(
    report: Reported<'s, 'a>,
    cx: &DocumentCx<'_>,
    joint: &Joint,
) -> Reported<'s, 'a> {
    let tree = &cx.expansion.tree;
    let usual = |&id: &_| ["origin", "parent", "child"].contains(&tree.get(id).text.as_str());
    let own = |&id: &_| tree.get(id).origin.frame == tree.get(joint.element).origin.frame;
    let Some(last) = tree
        .elements(joint.element)
        .filter(usual)
        .filter(own)
        .last()
    else {
        return report;
    };
    let Some((file, range, _)) = source_text(cx.expansion, element_range(cx.expansion, last))
    else {
        return report;
    };
    let edit = (
        TextRange::empty(range.end),
        format!("{}<axis xyz=\"1 0 0\"/>", indent(cx.expansion, file, range)),
    );
    report.fix(Safety::Safe, "add `<axis xyz=\"1 0 0\"/>`", file, [edit])
}
