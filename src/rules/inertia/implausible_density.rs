//! A mass that does not fit the volume of the link.
use super::super::context::DocumentCx;
use super::super::geometry::{is_scaled_wrong, volume};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{is_in_world, shape};
use super::moments::{inertials, short};
use super::placeholder_inertia::is_placeholder;
use model::{Link, Robot};

pub(super) static RULE: Rule = Rule {
    code: "INR007",
    name: "implausible-density",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("implausible-density"),
    check: Check::Link(check),
};

/// Smaller volumes say nothing, cubic meters.
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

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(text) = &inertial.mass else { return };
    let Some(mass) = text.number().filter(|&mass| mass > 0.0) else {
        return;
    };
    let Some(volume) = volume(cx, link).filter(|&volume| volume >= LEAST_VOLUME) else {
        return;
    };
    let density = mass / volume;
    if (LIGHT..=HEAVY).contains(&density) || is_scaled_wrong(cx, link) {
        return;
    }
    let message = format!(
        "link `{}` has an implausible density of {} kg/m^3",
        link.shown(),
        short(density)
    );
    let is_gross = !(FAR_TOO_LIGHT..FAR_TOO_HEAVY).contains(&density)
        && mass >= LEAST_MASS
        // a shape that touches nothing is a marker
        && !link.collisions.is_empty()
        && !fits_in_shape(cx, link, mass)
        && !is_in_world(cx, link)
        && !is_placeholder(cx, link, inertial)
        && !is_mass_of_all(cx, mass)
        && !is_immovable(cx, mass);
    out.report(text.origin, message)
        .severity(if is_gross {
            Severity::Warning
        } else {
            Severity::Info
        })
        .help("check the units: kilograms for the mass, meters for the geometry")
        .done();
}

/// Whether an object without joints has a large round mass: it is an obstacle that nothing is to move.
fn is_immovable(cx: &DocumentCx<'_>, mass: f64) -> bool {
    const LEAST_MASS: f64 = 1e4;
    mass >= LEAST_MASS && mass.log10().fract() == 0.0 && cx.robot.is_some_and(Robot::is_rigid)
}

/// Whether most links have this mass, large ones and small ones: a number to begin with.
fn is_mass_of_all(cx: &DocumentCx<'_>, mass: f64) -> bool {
    /// Links that share a mass.
    const LEAST_LINKS: usize = 4;
    /// How much larger than the smallest the largest of them is.
    const SPREAD: f64 = 10.0;
    let all: Vec<(&Link, f64)> = inertials(cx)
        .filter_map(|(link, own)| Some((link, own.mass()?)))
        .collect();
    let same: Vec<&Link> = all
        .iter()
        .filter(|(_, own)| *own == mass)
        .map(|(link, _)| *link)
        .collect();
    if same.len() < LEAST_LINKS || same.len() * 2 < all.len() {
        return false;
    }
    let volumes = same
        .iter()
        .filter_map(|link| volume(cx, link))
        .filter(|&volume| volume > 0.0);
    let (least, most) = volumes.fold((f64::INFINITY, 0.0), |(least, most), volume| {
        (volume.min(least), volume.max(most))
    });
    most > SPREAD * least
}

/// Whether a mass is possible in the box around visuals and collisions, or that box is not known: the collision alone may
/// be a marker.
fn fits_in_shape(cx: &DocumentCx<'_>, link: &Link, mass: f64) -> bool {
    /// Sides that are shorter are those of a sheet, whose thickness nobody measured, meters.
    const SHEET: f64 = 0.01;
    shape(cx, link).is_none_or(|shape| {
        let density = mass
            / shape
                .size()
                .into_iter()
                .map(|side| side.max(SHEET))
                .product::<f64>();
        (FAR_TOO_LIGHT..=HEAVY).contains(&density)
    })
}
