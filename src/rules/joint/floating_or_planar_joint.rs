//! A joint of a type that many programs take for fixed.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Joint;
use model::JointType::{Floating, Planar};

pub(super) static RULE: Rule = Rule {
    code: "JNT025",
    name: "floating-or-planar-joint",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("floating-or-planar-joint"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.is(&[Floating, Planar]) {
        return;
    }
    let Some(kind) = &joint.kind else { return };
    out.report(kind.origin, format!("joint `{}` is {}, which kdl_parser treats as fixed", joint.shown(), kind.value))
        .help("use a chain of prismatic and revolute joints; robot_state_publisher publishes this joint as fixed")
        .done();
}
