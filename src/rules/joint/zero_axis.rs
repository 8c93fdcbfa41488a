//! An axis without direction.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::axis::{NO_LENGTH, length, moving_axes};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT010",
    name: "zero-axis",
    category: Category::Joint,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("zero-axis"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (joint, text, axis) in moving_axes(cx.joints()) {
        if length(axis) < NO_LENGTH {
            out.report(
                text.origin,
                format!("axis of joint `{}` is the zero vector", joint.shown()),
            )
            .help("write a direction, for example xyz=\"0 0 1\"")
            .done();
        }
    }
}
