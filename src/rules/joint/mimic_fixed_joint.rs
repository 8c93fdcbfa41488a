//! A joint that follows one which never moves.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::mimicking;
use model::JointType;

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT023",
    name: "mimic-fixed-joint",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mimic-fixed-joint"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for (joint, text, target) in mimicking(cx.robot) {
        // variants that fix a pair of joints fix both
        if target.is(&[JointType::Fixed]) && !joint.is(&[JointType::Fixed]) {
            let message = format!(
                "joint `{}` mimics joint `{}`, which is fixed",
                joint.shown(),
                target.shown()
            );
            out.report(text.origin, message)
                .help("mimic a joint that moves, or make this joint fixed")
                .done();
        }
    }
}
