//! Command limits beyond the limits of the joint.
use std::cell::LazyCell;

use super::super::context::DocumentCx;
use super::super::numbers::{UNLIMITED, rewrite, short};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, is_before_jazzy, range, value_place};

pub(super) static RULE: Rule = Rule {
    code: "CTL010",
    name: "ros2-control-limits-mismatch",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("ros2-control-limits-mismatch"),
    check: Check::Document(check),
};

/// Digits that people leave out when they copy a limit.
const ROUNDING: f64 = 1e-3;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    // before Jazzy, ros2_control does not read them
    let severity = LazyCell::new(|| match is_before_jazzy(cx) {
        true => Severity::Info,
        false => RULE.severity,
    });
    for (control, joint) in controlled(cx) {
        let Some((lower, upper)) = range(joint) else {
            continue;
        };
        for command in control
            .commands
            .iter()
            .filter(|command| command.is("position"))
        {
            for name in ["min", "max"] {
                let Some((text, value)) = command
                    .param(name)
                    .and_then(|text| Some((text, text.number()?)))
                else {
                    continue;
                };
                let beyond = if name == "min" {
                    value < lower - ROUNDING
                } else {
                    value > upper + ROUNDING
                };
                if beyond && value.abs() < UNLIMITED {
                    let message = format!(
                        "{name} {} of joint `{}` is outside its limits",
                        text.value,
                        joint.shown()
                    );
                    let report = out
                        .report(value_place(cx.expansion, text), message)
                        .severity(*severity)
                        .help(format!(
                            "write a value from {} to {}",
                            short(lower),
                            short(upper)
                        ));
                    let limit = if name == "min" { lower } else { upper };
                    rewrite(report, Safety::Unsafe, text, short(limit)).done();
                }
            }
        }
    }
}
