//! Angles that are almost a multiple of a quarter of pi.
use std::f64::consts::FRAC_PI_4;

use super::super::context::DocumentCx;
use super::super::edits::{source_text, speaks_xacro};
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::{Reported, Sink};
use super::poses::{ANGLES, ElementPose};
use expand::Origin;
use model::decimal;

pub(super) static RULE: Rule = Rule {
    code: "FRM002",
    name: "approximate-pi",
    category: Category::Frames,
    severity: Severity::Hint,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("approximate-pi"),
    check: Check::Pose(check),
};

/// How xacro writes multiples of a quarter of pi, from 1 on.
const MULTIPLES: [&str; 8] = [
    "pi/4", "pi/2", "3*pi/4", "pi", "5*pi/4", "3*pi/2", "7*pi/4", "2*pi",
];

fn check(cx: &DocumentCx<'_>, placed: &ElementPose<'_>, out: &mut Sink<'_>) {
    let Some(text) = &placed.pose.rpy else {
        return;
    };
    let Some(angles) = placed.pose.angles() else {
        return;
    };
    for ((angle, name), range) in angles.into_iter().zip(ANGLES).zip(text.words()) {
        let Some(meant) = meant(angle) else { continue };
        let at = text.part(range.clone());
        let shown = text.value.get(range).unwrap_or_default();
        let message = format!(
            "{name} {shown} of {} is a rounded value of {}",
            placed.owner(),
            meant.0
        );
        let help = format!(
            "write the exact expression; the value is off by {:.4} rad",
            (angle - meant.1).abs()
        );
        exact(out.report(at, message).help(help), cx, at, meant).done();
    }
}

/// The multiple of a quarter of pi that an angle almost is.
fn meant(angle: f64) -> Option<(String, f64)> {
    let count = (angle.abs() / FRAC_PI_4).round();
    let off = (angle.abs() - count * FRAC_PI_4).abs();
    let name = MULTIPLES.get((count as usize).checked_sub(1)?)?;
    let sign = if angle < 0.0 { "-" } else { "" };
    (off > 1e-5 && off < 2e-3)
        .then(|| (format!("{sign}{name}"), (count * FRAC_PI_4).copysign(angle)))
}

/// With the fix to write the exact angle, where the source holds the number itself.
fn exact<'s, 'a>(
    report: Reported<'s, 'a>,
    cx: &DocumentCx<'_>,
    at: Origin,
    meant: (String, f64),
) -> Reported<'s, 'a> {
    let Some((_, _, source)) = source_text(cx.expansion, at) else {
        return report;
    };
    let inner = source
        .strip_prefix("${")
        .and_then(|rest| rest.strip_suffix('}'))
        .unwrap_or(&source);
    if decimal(inner.trim()).is_none() {
        return report;
    }
    if speaks_xacro(cx.expansion, at) {
        let new = format!("${{{}}}", meant.0);
        report.replace_with(Safety::Unsafe, format!("replace with `{new}`"), new)
    } else {
        report.replace_with(
            Safety::Unsafe,
            format!("write {} with full precision", meant.0),
            meant.1.to_string(),
        )
    }
}
