//! A joint that needs limits and has none.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType::{Prismatic, Revolute};
use model::{AttrValue, Joint, tag_start};
use packages::nearest;

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT002",
    name: "missing-joint-limit",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-joint-limit"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !cx.whole() {
        return;
    }
    if !(joint.limit.is_none() && joint.is(&[Revolute, Prismatic])) {
        return;
    }
    // an expression that was meant to insert a block has its own finding, and so has a misspelled element
    if has_unknown_text(cx, joint) || has_misspelled_limit(cx, joint) {
        return;
    }
    let kind = joint.kind.as_ref().map_or("", |kind| kind.value.as_str());
    let name = joint.shown();
    out.report(
        tag_start(cx.expansion, joint.element),
        format!("{kind} joint `{name}` has no `limit`"),
    )
    .help("add <limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>")
    .done();
}

/// Whether a joint holds text that could not be computed.
fn has_unknown_text(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    AttrValue::content(&cx.expansion.tree, joint.element).is_some_and(|text| !text.is_known())
}

/// Whether a joint holds an element whose name is nearly `limit`.
fn has_misspelled_limit(cx: &DocumentCx<'_>, joint: &Joint) -> bool {
    let tree = &cx.expansion.tree;
    tree.elements(joint.element)
        .any(|id| nearest(&tree.get(id).text, ["limit"]).is_some())
}
