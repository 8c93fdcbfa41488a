//! A center of mass outside of the link.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{LIGHT, MARKER, body_boxes, is_in_world, is_small_part, known_box};
use super::moments::is_same_about_all_axes;
use model::{Bounds, Inertial, Link};

pub(super) static RULE: Rule = Rule {
    code: "INR009",
    name: "com-outside-geometry",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("com-outside-geometry"),
    check: Check::Link(check),
};

/// Distance that no center of mass has from the frame of its link, meters.
const FAR: f64 = 5.0;
/// By how much of its size a box grows on each side.
const GROWN: f64 = 0.5;
/// And by how much besides, meters.
const MARGIN: f64 = 0.01;
/// Up to this part of half of its diagonal, a center is beside a geometry.
const BESIDE: f64 = 0.25;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(text) = inertial
        .origin
        .as_ref()
        .and_then(|origin| origin.xyz.as_ref())
    else {
        return;
    };
    let Some(center) = text.numbers::<3>() else {
        return;
    };
    let is_light = inertial.mass().is_some_and(|mass| mass <= LIGHT);
    let [x, y, z] = center;
    // whatever the shape and however light: such a number has another unit
    let is_far = x.hypot(y).hypot(z) > FAR;
    let severity = match known_box(cx, link).filter(|_| !is_light) {
        Some(bounds) if !is_outside(bounds, center) => return,
        Some(_)
            if body_boxes(cx, link)
                .into_iter()
                .any(|bounds| !is_outside(bounds, center)) =>
        {
            return;
        }
        None if !is_far => return,
        // what never moves has no use for it
        Some(_) if is_in_world(cx, link) => Severity::Info,
        Some(bounds)
            if !is_far
                && (is_beside(bounds, center)
                    || inertial
                        .mass()
                        .is_some_and(|mass| is_small_part(cx, link, mass))
                    || is_made_up(inertial, center)) =>
        {
            Severity::Info
        }
        _ => Severity::Warning,
    };
    let message = format!(
        "center of mass of link `{}` is outside its geometry",
        link.shown()
    );
    out.report(text.origin, message)
        .severity(severity)
        .help("check the units (meters) and the frame of the inertial origin")
        .done();
}

/// Whether numbers were made up so that a simulation runs: the center at the frame, and the same moment about all axes.
fn is_made_up(inertial: &Inertial, center: [f64; 3]) -> bool {
    center == [0.0; 3] && inertial.entries().is_some_and(is_same_about_all_axes)
}

/// Whether a point outside of a box is close to it, where it may be the center of what is not drawn; a marker is close to
/// all.
fn is_beside(bounds: Bounds, point: [f64; 3]) -> bool {
    let half = bounds.diagonal() / 2.0;
    half <= MARKER || bounds.outside(point) <= BESIDE * half
}

/// Whether a point is outside of a box with some room around it.
fn is_outside(bounds: Bounds, point: [f64; 3]) -> bool {
    let grown = bounds.size().map(|length| length * GROWN + MARGIN);
    let around = Bounds::centered(grown.map(|length| length * 2.0));
    let large = Bounds {
        min: sum(bounds.min, around.min),
        max: sum(bounds.max, around.max),
    };
    large.outside(point) > 0.0
}

fn sum([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a + x, b + y, c + z]
}
