//! Limits of a joint that look like degrees.
use super::super::context::DocumentCx;
use super::super::numbers::{UNLIMITED, from_degrees, is_part_of_pi, short, whole};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use model::{AttrValue, Joint, JointType, Limit};

pub(super) static RULE: Rule = Rule {
    code: "JNT006",
    name: "joint-limit-degrees",
    category: Category::Joint,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("joint-limit-degrees"),
    check: Check::Joint(check),
};

/// Four half turns each way and some: more than any wrist has, in radians.
const MOST: f64 = 4.0 * std::f64::consts::PI + 0.01;

/// Ranges that end before are a few turns, and no angles that people write in degrees.
const LEAST_DEGREES: f64 = 30.0;

/// Whether a limit is some half turns of 3.14.
fn is_in_half_turns(value: f64) -> bool {
    // as people write it, not as it is
    const HUNDREDTHS_OF_PI: f64 = 314.0;
    const MOST_TURNS: f64 = 20.0;
    let turns = (value * 100.0 / HUNDREDTHS_OF_PI).abs();
    turns <= MOST_TURNS && (turns - turns.round()).abs() < 1e-6
}

/// Whether limits stand for none: equal both ways, and a number that no joint has in degrees either, such as 999 or 10000, or one
/// that a joint along a line has as well.
fn is_for_none(cx: &DocumentCx<'_>, limit: &Limit) -> bool {
    /// From here on, a number is no angle in degrees.
    const LEAST: f64 = 999.0;
    let Some((lower, upper)) = range(limit) else {
        return false;
    };
    let is_along_a_line = || {
        let ranges = || {
            let joints = cx.joints().iter();
            let sliding = joints.filter(|joint| joint.is(&[JointType::Prismatic]));
            let ranges = sliding.filter_map(|joint| joint.limit.as_ref().and_then(range));
            ranges
                .map(|range| <[f64; 2]>::from(range).map(f64::to_bits))
                .collect()
        };
        let all = cx.all().sliding_ranges.get_or_init(ranges);
        all.contains(&[lower, upper].map(f64::to_bits))
    };
    // 999 or 1000
    let is_power = |value: f64| value.log10().fract() == 0.0;
    lower == -upper
        && (upper >= LEAST && [upper + 1.0, upper].into_iter().any(is_power) || is_along_a_line())
}

/// Whether the large ends are the number of the effort as well, which no angle is: all stand for no limit. Of two, the number is
/// none that people write for an angle.
fn is_filled_in(limit: &Limit, large: &[(&str, &AttrValue, f64)]) -> bool {
    const ANGLES: f64 = 45.0;
    let effort = limit.effort.as_ref().and_then(AttrValue::number);
    let is_effort = |(_, _, value): &(&str, &AttrValue, f64)| effort == Some(value.abs());
    let is_angle = |(_, _, value): &(&str, &AttrValue, f64)| value % ANGLES == 0.0;
    large.iter().all(is_effort) && (large.len() == 1 || !large.iter().any(is_angle))
}

/// Both ends.
fn range(limit: &Limit) -> Option<(f64, f64)> {
    let number = |text: &Option<AttrValue>| text.as_ref().and_then(AttrValue::number);
    Some((number(&limit.lower)?, number(&limit.upper)?))
}

fn check(cx: &DocumentCx<'_>, joint: &Joint, out: &mut Sink<'_>) {
    let Some(limit) = joint
        .limit
        .as_ref()
        .filter(|_| joint.is(&[JointType::Revolute]))
    else {
        return;
    };
    let ends = [("lower", &limit.lower), ("upper", &limit.upper)];
    let large: Vec<_> = ends.into_iter().filter_map(large).collect();
    let are_turns = large
        .iter()
        .all(|(_, _, value)| value.abs() < LEAST_DEGREES);
    if are_turns || is_for_none(cx, limit) || is_filled_in(limit, &large) {
        return;
    }
    for (name, text, value) in large {
        let turns = short((value / std::f64::consts::TAU).abs().round());
        let message = format!(
            "{name} limit of joint `{}` is {} rad ({turns} turns); this looks like degrees",
            joint.shown(),
            text.value
        );
        let report = out
            .report(text.origin, message)
            .help("write the angle in radians");
        from_degrees(report, cx.expansion, text, whole(text)).done();
    }
}

/// The end of a range, if it is no angle in radians.
fn large<'a>(
    (name, text): (&'static str, &'a Option<AttrValue>),
) -> Option<(&'static str, &'a AttrValue, f64)> {
    let text = text.as_ref()?;
    let value = text.number()?;
    let is_large = value.abs() > MOST
        && value.abs() < UNLIMITED
        && !is_part_of_pi(value)
        && !is_in_half_turns(value);
    is_large.then_some((name, text, value))
}
