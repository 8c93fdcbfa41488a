//! A joint that needs limits and has none.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType::{Prismatic, Revolute};
use model::tag_start;

pub(super) const RULE: Rule = Rule {
    code: "JNT002",
    name: "missing-joint-limit",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("missing-joint-limit"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    if !cx.whole() {
        return;
    }
    for joint in cx.joints().iter().filter(|joint| joint.limit.is_none() && joint.is(&[Revolute, Prismatic]))
    {
        let kind = joint.kind.as_ref().map_or("", |kind| kind.value.as_str());
        let name = joint.shown();
        out.report(tag_start(cx.expansion, joint.element), format!("{kind} joint `{name}` has no limit"))
            .help("add <limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>")
            .done();
    }
}
