//! An axis without direction.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::axis::{NO_LENGTH, length, moving_axis};
use model::Joint;

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT010",
    name: "zero-axis",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("zero-axis"),
    check: Check::Joint(check),
};

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some((text, _)) = moving_axis(joint).filter(|(_, axis)| length(*axis) < NO_LENGTH) else {
        return;
    };
    out.report(
        text.origin,
        format!("axis of joint `{}` is the zero vector", joint.shown()),
    )
    .help("write a direction, for example xyz=\"0 0 1\"")
    .done();
}
