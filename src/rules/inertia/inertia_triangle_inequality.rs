//! Principal moments that no body has.
use nalgebra::Vector3;

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{body_inertia, is_built_into_world, is_in_world, is_small_part};
use super::moments::{Impossible, InertiaClass, inertia_tag, judged, verdict};
use model::{Inertial, JointType, Link};

pub(in super::super) static RULE: Rule = Rule {
    code: "INR005",
    name: "inertia-triangle-inequality",
    category: Category::Inertia,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("inertia-triangle-inequality"),
    check: Check::Link(check),
};

/// From this many links on, a moment that is too large about the own joint is that of the motor, added on purpose.
const ROTORS: usize = 3;

/// Less than this part short may be rounding.
const COARSE: f64 = 2e-2;

/// What a moment is too large by is lost in this part of the least moment of the body that the link is a part of.
const NEGLIGIBLE: f64 = 0.05;

/// What the last digit of exporters that write six decimals stands for, kg m^2.
const LAST_DIGIT: f64 = 1e-6;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let judged = judged(inertial);
    let Some(impossible) = &judged.impossible else {
        return;
    };
    // what never moves here may be a part that moves elsewhere
    let severity = if is_built_into_world(cx, link) || !is_error(cx, link, inertial) {
        Severity::Info
    } else if let Some([least, ..]) = possible_with_others(cx, link) {
        let [a, b, c] = impossible.moments;
        if c - a - b <= NEGLIGIBLE * least {
            Severity::Info
        } else {
            Severity::Warning
        }
    } else if is_in_world(cx, link) {
        Severity::Warning
    } else {
        Severity::Error
    };
    // there may be one for each of thousands of links, at each edit
    let message = ["inertia of link `", link.shown(), "` ", &impossible.said].concat();
    let report = out
        .report(inertia_tag(cx.expansion, inertial), message)
        .group(Group::Value(impossible.numbers.clone()))
        .severity(severity)
        .help("compute the inertia from mass and shape");
    if has_rotor(cx, link, impossible) {
        report.unless_habit(ROTORS).done();
    } else {
        report.done();
    }
}

/// The moments of the possible body that a link makes with those that are fixed to it: simulators see that body alone.
fn possible_with_others(cx: &DocumentCx<'_>, link: &Link) -> Option<[f64; 3]> {
    let (_, entries) = body_inertia(cx, link)?;
    match verdict(entries) {
        InertiaClass::Definite([a, b, c]) if a + b >= c => Some([a, b, c]),
        _ => None,
    }
}

/// Whether the largest moment of a link is that of a motor about its own joint.
fn has_rotor(cx: &DocumentCx<'_>, link: &Link, impossible: &Impossible) -> bool {
    const TOLERANCE: f64 = 0.02;
    let Some(joint) = cx.joint_above(link.shown()) else {
        return false;
    };
    let axis = joint
        .axis()
        .map(Vector3::from)
        .and_then(|axis| axis.try_normalize(f64::EPSILON));
    let axis = axis.filter(|_| !joint.is(&[JointType::Fixed]));
    let (Some(axis), Some(tensor)) = (axis, impossible.tensor) else {
        return false;
    };
    let most = impossible.moments[2];
    (tensor * axis - most * axis).norm() <= TOLERANCE * most
}

/// Whether the inertia of a link is impossible, and not by rounding alone.
pub(super) fn is_error(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial) -> bool {
    let judged = judged(inertial);
    let Some(Impossible {
        moments: [a, b, c],
        is_rounded: false,
        ..
    }) = judged.impossible.as_ref()
    else {
        return false;
    };
    // simulators add the inertia of a part that is fixed to a heavy body to that of the body
    let is_added = inertial
        .mass()
        .is_some_and(|mass| is_small_part(cx, link, mass));
    !is_added && a + b < c * (1.0 - COARSE) && c - a - b > LAST_DIGIT
}
