//! Principal moments that no body has.
use nalgebra::{Matrix3, Vector3};

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{is_built_into_world, is_in_world, is_small_part};
use super::moments::{Impossible, inertia_tag, judged};
use base::FastSet;
use expand::XId;
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

/// Less than this part short may be rounding.
const COARSE: f64 = 2e-2;

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
    let is_rotor = cx
        .all()
        .rotors
        .get_or_init(|| rotors(cx))
        .contains(&link.element);
    // what never moves here may be a part that moves elsewhere
    let is_idle = is_rotor || is_built_into_world(cx, link);
    let severity = if is_idle || !is_error(cx, link, inertial) {
        Severity::Info
    } else if is_in_world(cx, link) {
        Severity::Warning
    } else {
        Severity::Error
    };
    // there may be one for each of thousands of links, at each edit
    let message = ["inertia of link `", link.shown(), "` ", &impossible.said].concat();
    out.report(inertia_tag(cx.expansion, inertial), message)
        .group(Group::Value(impossible.numbers.clone()))
        .severity(severity)
        .help("compute the inertia from mass and shape")
        .done();
}

/// The links with the inertia of a motor; none where they are too few to be meant so.
fn rotors(cx: &DocumentCx<'_>) -> FastSet<XId> {
    let links = cx.links().iter().filter(|link| has_rotor(cx, link));
    let rotors: FastSet<XId> = links.map(|link| link.element).collect();
    if rotors.len() < ROTORS {
        FastSet::default()
    } else {
        rotors
    }
}

/// Whether the largest moment of a link is that of a motor about its own joint.
fn has_rotor(cx: &DocumentCx<'_>, link: &Link) -> bool {
    link.inertial.as_ref().is_some_and(|inertial| {
        let judged = judged(inertial);
        let impossible = judged.impossible.as_ref();
        impossible.is_some_and(|Impossible { moments, .. }| {
            is_about_joint(cx, link, inertial, moments[2])
        })
    })
}

/// Whether the largest moment of a link is that about the axis of its own joint.
fn is_about_joint(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial, most: f64) -> bool {
    const TOLERANCE: f64 = 0.02;
    let Some(joint) = cx.joint_above(link.shown()) else {
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
