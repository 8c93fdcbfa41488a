//! Principal moments that no body has.
use ecow::EcoString;
use nalgebra::{Matrix3, Vector3};

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{is_built_into_world, is_in_world, is_small_part};
use super::moments::{InertiaClass, inertia_tag, short, verdict};
use model::{Inertial, JointType, Link, transform};

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

/// Less than this part short is rounding.
const ROUNDING: f64 = 1e-6;
/// Less than this part short may be rounding.
const COARSE: f64 = 2e-2;

/// What the last digit of exporters that write six decimals stands for, kg m^2.
const LAST_DIGIT: f64 = 1e-6;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some((inertial, [a, b, c])) = impossible_of(link) else {
        return;
    };
    let has_rotors = || {
        let rotors = cx.links().iter().filter(|link| has_rotor(cx, link));
        rotors.take(ROTORS).count() == ROTORS
    };
    let is_rotor = has_rotor(cx, link) && *cx.all().has_rotors.get_or_init(has_rotors);
    // what never moves here may be a part that moves elsewhere
    let is_idle = is_rotor || is_built_into_world(cx, link);
    let severity = if is_idle || !is_error(cx, link, inertial) {
        Severity::Info
    } else if is_in_world(cx, link) {
        Severity::Warning
    } else {
        Severity::Error
    };
    let message = format!(
        "inertia of link `{}` is impossible: moment {} exceeds the sum of {} and {}",
        link.shown(),
        short(c),
        short(a),
        short(b)
    );
    out.report(inertia_tag(cx.expansion, inertial), message)
        .group(Group::Value(same_numbers(inertial)))
        .severity(severity)
        .help("compute the inertia from mass and shape")
        .done();
}

/// What is the same of inertias with the same numbers.
fn same_numbers(inertial: &Inertial) -> EcoString {
    let entries = inertial.entries().unwrap_or_default();
    // in hexadecimal: writing them as people read them takes longer than all else that is done here
    let bits = entries.map(|entry| format!("{:x}", entry.to_bits()));
    bits.join(" ").into()
}

/// The inertial of a link with its moments, if no body has them.
fn impossible_of(link: &Link) -> Option<(&Inertial, [f64; 3])> {
    let inertial = link.inertial.as_ref()?;
    Some((inertial, impossible(inertial)?))
}

/// Whether the largest moment of a link is that of a motor about its own joint.
fn has_rotor(cx: &DocumentCx<'_>, link: &Link) -> bool {
    impossible_of(link)
        .is_some_and(|(inertial, [.., most])| is_about_joint(cx, link, inertial, most))
}

/// The moments, if no body has them.
fn impossible(inertial: &Inertial) -> Option<[f64; 3]> {
    let InertiaClass::Definite(moments @ [a, b, c]) = verdict(inertial.entries()?) else {
        return None;
    };
    (a + b < c * (1.0 - ROUNDING)).then_some(moments)
}

/// Whether the largest moment of a link is that about the axis of its own joint.
fn is_about_joint(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial, most: f64) -> bool {
    const TOLERANCE: f64 = 0.02;
    let &[joint] = cx.joints_above(link.shown()) else {
        return false;
    };
    let axis = joint
        .axis()
        .map(Vector3::from)
        .and_then(|axis| axis.try_normalize(f64::EPSILON));
    let Some(axis) = axis.filter(|_| !joint.is(&[JointType::Fixed])) else {
        return false;
    };
    let (Some([xx, xy, xz, yy, yz, zz]), Some(frame)) =
        (inertial.entries(), transform(inertial.origin.as_ref()))
    else {
        return false;
    };
    let axis = frame.rotation.inverse() * axis;
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    (tensor * axis - most * axis).norm() <= TOLERANCE * most
}

/// Whether the inertia of a link is impossible, and not by rounding alone.
pub(super) fn is_error(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial) -> bool {
    let Some([a, b, c]) = impossible(inertial) else {
        return false;
    };
    // simulators add the inertia of a part that is fixed to a heavy body to that of the body
    let is_added = inertial
        .mass()
        .is_some_and(|mass| is_small_part(cx, link, mass));
    !is_added && a + b < c * (1.0 - COARSE) && c - a - b > LAST_DIGIT
}
