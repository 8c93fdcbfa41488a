//! Limits that leave no room to move.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType::{Prismatic, Revolute};
use model::{Joint, tag_start};

pub(super) static RULE: Rule = Rule {
    code: "JNT005",
    name: "joint-limit-zero-range",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("joint-limit-zero-range"),
    check: Check::Joint(check),
};

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.is(&[Revolute, Prismatic]) {
        return;
    }
    let Some(limit) = &joint.limit else { return };
    let Some((at, _)) = limit.range().filter(|(lower, upper)| lower == upper) else {
        return;
    };
    let message = format!(
        "joint `{}` cannot move: lower and upper limit are both {at}",
        joint.shown()
    );
    out.report(tag_start(cx.expansion, limit.element), message)
        .help("write lower=\"...\" upper=\"...\" in radians or meters (the default is 0), or make the joint fixed")
        .done();
}
