//! A fixed joint in ros2_control.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, is_before_jazzy};
use model::JointType;

pub(super) static RULE: Rule = Rule {
    code: "CTL004",
    name: "ros2-control-fixed-joint",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-fixed-joint"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut is_old = None;
    for (control, joint) in controlled(cx) {
        let (Some(text), Some(kind)) = (&control.name, &joint.kind) else {
            continue;
        };
        if joint.is(&[JointType::Fixed]) {
            let is_old = *is_old.get_or_insert_with(|| is_before_jazzy(cx));
            out.report(
                text.origin,
                format!("joint `{}` is fixed, so ros2_control cannot control it", joint.shown()),
            )
            .severity(if is_old { Severity::Info } else { RULE.severity })
            .also(kind.origin, format!("type of joint `{}`", joint.shown()))
            .help("remove the joint from ros2_control, or change its type; ros2_control rejects the robot otherwise")
            .done();
        }
    }
}
