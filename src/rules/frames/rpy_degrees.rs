//! Angles of an orientation that look like degrees.
use std::ops::Range;

use super::super::context::DocumentCx;
use super::super::numbers::{from_degrees, is_made_with, is_part_of_pi};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::poses::{ANGLES, ElementPose};
use model::AttrValue;

pub(super) static RULE: Rule = Rule {
    code: "FRM001",
    name: "rpy-degrees",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("rpy-degrees"),
    check: Check::Pose(check),
};

/// A full turn and some.
const MOST: f64 = std::f64::consts::TAU + 0.01;

/// Two full turns and some: up to here, a sum of angles is more than a turn.
const MOST_COMPUTED: f64 = 2.0 * MOST;

/// What an expression holds that gives radians.
const IN_RADIANS: [&str; 9] = [
    "pi", "tau", "M_PI", "PI", "radians", "asin", "acos", "atan", "atan2",
];

/// Angles that people write in degrees.
const ROUND: [f64; 10] = [
    30.0, 45.0, 60.0, 90.0, 120.0, 135.0, 150.0, 180.0, 270.0, 360.0,
];

/// Whether a number has so many digits that it was computed, such as 6.4577: angles in degrees are written short.
fn is_computed(written: Option<&str>) -> bool {
    const DIGITS: usize = 4;
    let digits = written.and_then(|written| written.split_once('.'));
    digits.is_some_and(|(_, digits)| digits.trim_end_matches('0').len() >= DIGITS)
}

/// Whether the part `range` of a value is an angle in radians, by its value or by what it was made with.
fn is_in_radians(cx: &DocumentCx<'_>, text: &AttrValue, range: Range<usize>, angle: f64) -> bool {
    is_part_of_pi(angle)
        || angle.abs() < MOST_COMPUTED
            && (is_computed(text.value.get(range.clone()))
                || is_made_with(cx.expansion, text, range, &IN_RADIANS))
}

fn check(cx: &DocumentCx<'_>, placed: &ElementPose<'_>, out: &mut Sink<'_>) {
    let Some(text) = &placed.pose.rpy else {
        return;
    };
    let Some(angles) = placed.pose.angles() else {
        return;
    };
    for ((angle, name), range) in angles.into_iter().zip(ANGLES).zip(text.words()) {
        if angle.abs() > MOST && !is_in_radians(cx, text, range.clone(), angle)
            || ROUND.contains(&angle.abs())
        {
            let shown = text.value.get(range.clone()).unwrap_or_default();
            let message = format!("{name} {shown} of {} looks like degrees", placed.owner());
            let report = out
                .report(text.part(range.clone()), message)
                .help("write the angle in radians");
            from_degrees(report, cx.expansion, text, range).done();
        }
    }
}
