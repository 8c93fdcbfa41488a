//! Command limits beyond the limits of the joint.
use std::cell::LazyCell;
use std::f64::consts::TAU;

use super::super::context::DocumentCx;
use super::super::numbers::{UNLIMITED, rewrite, short};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::{controlled, is_since_jazzy, range, value_place};
use model::{AttrValue, Interface, Joint};

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
/// A command range that reaches this far both ways stands for none: a turn, as people round it, or as many meters.
const ALL_AROUND: f64 = TAU * 0.999;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    // before Jazzy, ros2_control does not read them, and without a word of it most workspaces are older
    let usual = LazyCell::new(|| match is_since_jazzy(cx) {
        true => RULE.severity,
        false => Severity::Info,
    });
    for (control, joint) in controlled(cx) {
        let Some(limits) = range(joint) else {
            continue;
        };
        for command in control
            .commands
            .iter()
            .filter(|command| command.is("position"))
        {
            // most bounds fit, and nothing is asked about them
            let severity = || match stands_for_none(command) {
                true => Severity::Info,
                false => *usual,
            };
            check_command(cx, joint, command, (limits, &severity), out);
        }
    }
}

/// Report the bounds of a command interface that are outside the limits of its joint.
fn check_command(
    cx: &DocumentCx<'_>,
    joint: &Joint,
    command: &Interface,
    ((lower, upper), severity): ((f64, f64), &dyn Fn() -> Severity),
    out: &mut Sink<'_>,
) {
    for (name, limit) in [("min", lower), ("max", upper)] {
        let Some((text, value)) = bound(command, name) else {
            continue;
        };
        let beyond = if name == "min" {
            value < lower - ROUNDING
        } else {
            value > upper + ROUNDING
        };
        if !beyond || value.abs() >= UNLIMITED {
            continue;
        }
        let message = format!(
            "{name} {} of joint `{}` is outside its limits",
            text.value,
            joint.shown()
        );
        let (lower, upper) = (short(lower), short(upper));
        let report = out
            .report(value_place(cx.expansion, text), message)
            .severity(severity())
            .help(format!("write a value from {lower} to {upper}"));
        rewrite(report, Safety::Unsafe, text, short(limit)).done();
    }
}

/// A bound of a command interface that is a number.
fn bound<'c>(command: &'c Interface, name: &str) -> Option<(&'c AttrValue, f64)> {
    let text = command.param(name)?;
    Some((text, text.number()?))
}

/// Whether both bounds of a command interface are so far that they stand for none.
fn stands_for_none(command: &Interface) -> bool {
    let mut bounds = ["min", "max"].map(|name| bound(command, name)).into_iter();
    bounds.all(|bound| bound.is_some_and(|(_, value)| value.abs() >= ALL_AROUND))
}
