//! A centre of mass outside of the link.

use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent_of};
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{LIGHT, MARKER, is_in_world};
use super::moments::inertials;
use crate::model::Bounds;

pub(super) const RULE: Rule = Rule {
    code: "INR009",
    name: "com-outside-geometry",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("com-outside-geometry"),
    check: Check::Document(check),
};

/// Distance that no centre of mass has from the frame of its link, metres.
const FAR: f64 = 5.0;
/// By how much of its size a box grows on each side.
const GROWN: f64 = 0.5;
/// And by how much besides, metres.
const MARGIN: f64 = 0.01;
/// Up to this part of half of its diagonal, a centre is beside a geometry.
const BESIDE: f64 = 0.25;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(text) = inertial.origin.as_ref().and_then(|origin| origin.xyz.as_ref()) else { continue };
        let Some(centre) = text.numbers::<3>() else { continue };
        let [x, y, z] = centre;
        let is_afar = x.hypot(y).hypot(z) > FAR;
        let is_light = inertial.mass().is_some_and(|mass| mass <= LIGHT);
        let parts = [extent_of(cx, &link.collisions), extent_of(cx, &link.visuals)];
        let boxes = parts.iter().filter_map(|part| part.bounds()).reduce(|a, b| a.with(b));
        let outside = match boxes {
            Some(bounds) if !is_light && !parts.contains(&Extent::Unknown) => {
                let grown = bounds.size().map(|length| length * GROWN + MARGIN);
                let around = Bounds::centred(grown.map(|length| length * 2.0));
                let large = Bounds { min: sum(bounds.min, around.min), max: sum(bounds.max, around.max) };
                large.outside(centre) > 0.0
            }
            // whatever the shape and however light: such a number has another unit
            _ => is_afar,
        };
        if outside {
            // close to the geometry, it may be that of what is not drawn
            let is_far = boxes.is_none_or(|bounds| {
                let half = bounds.diagonal() / 2.0;
                half > MARKER && bounds.outside(centre) > BESIDE * half
            });
            let is_gross = (is_far || is_afar) && !is_in_world(cx, link);
            let severity = if is_gross { Severity::Warning } else { Severity::Info };
            let message = format!("centre of mass of link `{}` lies outside of its geometry", link.shown());
            out.report(text.origin, message)
                .severity(severity)
                .help("check units (metres) and the frame of the link")
                .done();
        }
    }
}

fn sum([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [a + x, b + y, c + z]
}
