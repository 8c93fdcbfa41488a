//! An initial position that the joint cannot have.
use super::super::context::DocumentCx;
use super::super::numbers::short;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, range, value_place};

pub(super) static RULE: Rule = Rule {
    code: "CTL009",
    name: "ros2-control-initial-value-out-of-limits",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-initial-value-out-of-limits"),
    check: Check::Document(check),
};

/// What calculation may lose.
const ROUNDING: f64 = 1e-6;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (control, joint) in controlled(cx) {
        let Some((lower, upper)) = range(joint) else {
            continue;
        };
        for interface in control
            .interfaces()
            .filter(|interface| interface.is("position"))
        {
            let Some(text) = interface.param("initial_value") else {
                continue;
            };
            if text
                .number()
                .is_some_and(|value| value < lower - ROUNDING || value > upper + ROUNDING)
            {
                let message = format!(
                    "initial value of joint `{}` is {}, outside its limits",
                    joint.shown(),
                    text.value
                );
                out.report(value_place(cx.expansion, text), message)
                    .help(format!(
                        "write a value from {} to {}",
                        short(lower),
                        short(upper)
                    ))
                    .done();
            }
        }
    }
}
