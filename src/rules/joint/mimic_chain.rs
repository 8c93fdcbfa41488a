//! A joint that follows one which follows another.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mimics::mimicking;

pub(super) static RULE: Rule = Rule {
    code: "JNT026",
    name: "mimic-chain",
    category: Category::Joint,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("mimic-chain"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for (joint, text, target) in mimicking(cx.robot) {
        let Some(last) = target.mimic.as_ref().and_then(|mimic| mimic.joint.as_ref()) else {
            continue;
        };
        let message = format!(
            "joint `{}` mimics `{}`, which mimics `{}`",
            joint.shown(),
            target.shown(),
            last.value
        );
        out.report(text.origin, message)
            .help("mimic the last joint directly, with the product of the multipliers")
            .done();
    }
}
