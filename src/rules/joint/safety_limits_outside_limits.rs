//! Soft limits beyond the limits.
use super::super::context::DocumentCx;
use super::super::numbers::short;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::JointType::{Prismatic, Revolute};
use model::{AttrValue, Joint};

pub(in super::super) static RULE: Rule = Rule {
    code: "JNT020",
    name: "safety-limits-outside-limits",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("safety-limits-outside-limits"),
    check: Check::Joint(check),
};

/// What calculation may lose.
const ROUNDING: f64 = 1e-9;

fn check(_: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    if !joint.is(&[Revolute, Prismatic]) {
        return;
    }
    let (Some(limit), Some(safety)) = (&joint.limit, &joint.safety) else {
        return;
    };
    let Some((lower, upper)) = limit.range() else {
        return;
    };
    let number = |text: &Option<AttrValue>| text.as_ref().map_or(Some(0.0), AttrValue::number);
    let (Some(low), Some(up)) = (
        number(&safety.soft_lower_limit),
        number(&safety.soft_upper_limit),
    ) else {
        return;
    };
    if low == 0.0 && up == 0.0 {
        return;
    }
    let outside = [
        (
            "soft_lower_limit",
            &safety.soft_lower_limit,
            low < lower - ROUNDING,
            "below the lower",
            lower,
        ),
        (
            "soft_upper_limit",
            &safety.soft_upper_limit,
            up > upper + ROUNDING,
            "above the upper",
            upper,
        ),
    ];
    let is_switched_off = lower - low > ROUNDING && up - upper > ROUNDING;
    // both are out of the way: they were never meant to act
    let severity = if is_switched_off {
        Severity::Info
    } else {
        Severity::Warning
    };
    for (name, text, _, side, hard) in outside
        .into_iter()
        .filter(|(_, _, is_outside, ..)| *is_outside)
    {
        let Some(text) = text else { continue };
        let message = format!(
            "joint `{}`: {name} {} is {side} limit {}",
            joint.shown(),
            text.value,
            short(hard)
        );
        out.report(text.origin, message)
            .severity(severity)
            .help("write a soft limit inside the hard limits")
            .done();
    }
}
