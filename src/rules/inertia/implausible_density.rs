//! A mass that does not fit the volume of the link.

use super::super::context::DocumentCx;
use super::super::geometry::volume;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{is_in_world, shape};
use super::moments::{inertials, short};
use super::placeholder_inertia::is_placeholder;
use model::Link;

pub(super) const RULE: Rule = Rule {
    code: "INR007",
    name: "implausible-density",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("implausible-density"),
    check: Check::Document(check),
};

/// Smaller volumes say nothing, cubic metres.
const LEAST_VOLUME: f64 = 1e-7;
/// Foam is heavier, kg/m^3.
const LIGHT: f64 = 5.0;
/// Every metal is lighter, kg/m^3.
const HEAVY: f64 = 25_000.0;

/// No material comes near, kg/m^3.
const FAR_TOO_LIGHT: f64 = 0.01;
const FAR_TOO_HEAVY: f64 = 1e5;
/// Links that weigh less have rough geometry or a mass that was made up, kg.
const LEAST_MASS: f64 = 0.05;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(text) = &inertial.mass else { continue };
        let Some(mass) = text.number().filter(|&mass| mass > 0.0) else { continue };
        let Some(volume) = volume(cx, link).filter(|&volume| volume >= LEAST_VOLUME) else { continue };
        let density = mass / volume;
        if (LIGHT..=HEAVY).contains(&density) {
            continue;
        }
        let message = format!("link `{}` has a density of {} kg/m^3", link.shown(), short(density));
        let is_gross = !(FAR_TOO_LIGHT..FAR_TOO_HEAVY).contains(&density)
            && mass >= LEAST_MASS
            && !fits_in_shape(cx, link, mass)
            && !is_in_world(cx, link)
            && !is_placeholder(cx, link, inertial);
        out.report(text.origin, message)
            .severity(if is_gross { Severity::Warning } else { Severity::Info })
            .help("check units: kilograms, and metres for the geometry")
            .done();
    }
}

/// Whether a mass is possible in the box around visuals and collisions, or that box is not known: the collision alone may
/// be a marker.
fn fits_in_shape(cx: &DocumentCx<'_>, link: &Link, mass: f64) -> bool {
    shape(cx, link).is_none_or(|shape| {
        let density = mass / shape.size().into_iter().product::<f64>();
        (FAR_TOO_LIGHT..=HEAVY).contains(&density)
    })
}
