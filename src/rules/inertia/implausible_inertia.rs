//! An inertia that does not fit the size of the link.
use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent, is_scaled_wrong};
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::inertia_triangle_inequality;
use super::joined::{LIGHT, is_in_world, is_joined, shape};
use super::moments::{InertiaClass, inertia_tag, is_same_about_all_axes, judged, short};
use super::placeholder_inertia::is_placeholder;
use model::Link;

pub(super) static RULE: Rule = Rule {
    code: "INR006",
    name: "implausible-inertia",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("implausible-inertia"),
    check: Check::Link(check),
};

/// Radius of gyration that no link without geometry has, meters.
const FAR: f64 = 5.0;
/// From this ratio to the greatest moment that the geometry admits on, it is no matter of rough shapes.
const GROSS: f64 = 10.0;

/// Up to this mass in kg, a link that is fixed to another one is a sensor or a cover, which changes little.
const LIGHT_PART: f64 = 0.1;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(mass) = inertial.mass().filter(|&mass| mass > 0.0) else {
        return;
    };
    let Some(entries) = inertial.entries() else {
        return;
    };
    let Some(InertiaClass::Definite([_, _, most])) = judged(inertial).class else {
        return;
    };
    let radius = (most / mass).sqrt();
    let Some(misfit) = misfit(cx, link, radius)
        .filter(|_| !is_placeholder(cx, link, inertial) && !is_scaled_wrong(cx, link))
        // one defect, one finding
        .filter(|_| !inertia_triangle_inequality::is_error(cx, link, inertial))
    else {
        return;
    };
    let made_up = is_same_about_all_axes(entries);
    let (severity, help) = if misfit.is_gross && !made_up && matters(cx, link, mass) {
        (
            Severity::Warning,
            "check the units: kg m^2, not kg mm^2 or g mm^2",
        )
    } else {
        (Severity::Info, "compute the inertia from mass and shape")
    };
    let (name, radius, beside) = (link.shown(), short(radius), misfit.beside);
    let message =
        format!("inertia of link `{name}` is implausible: radius of gyration {radius} m, {beside}");
    out.report(inertia_tag(cx.expansion, inertial), message)
        .severity(severity)
        .help(help)
        .done();
}

/// Whether a simulation depends on the inertia of a link.
fn matters(cx: &DocumentCx<'_>, link: &Link, mass: f64) -> bool {
    let least = if is_joined(cx, link) {
        LIGHT_PART
    } else {
        LIGHT
    };
    mass > least && !is_in_world(cx, link)
}

/// How a radius of gyration does not fit a link.
struct Misfit {
    /// Whether no choice of the shape explains it.
    is_gross: bool,
    /// What to compare it with.
    beside: String,
}

fn misfit(cx: &DocumentCx<'_>, link: &Link, radius: f64) -> Option<Misfit> {
    match extent(cx, link) {
        Extent::Unknown => None,
        Extent::Nothing => (radius > FAR).then(|| Misfit {
            is_gross: true,
            beside: "too large for any link".to_owned(),
        }),
        Extent::Known(bounds) => {
            let half = bounds.diagonal() / 2.0;
            let wrong = half > 0.0 && (radius > 2.0 * half || radius < half / 50.0);
            // a rough collision says less than the shape with the visuals
            let is_gross = shape(cx, link).is_some_and(|shape| {
                is_far_off(radius, half) && is_far_off(radius, shape.diagonal() / 2.0)
            });
            let beside = format!("geometry radius {} m", short(half));
            wrong.then_some(Misfit { is_gross, beside })
        }
    }
}

/// Whether a moment is far from what half the diagonal of a shape admits: moments go with the square of the radius.
fn is_far_off(radius: f64, half: f64) -> bool {
    !(1.0 / GROSS..GROSS).contains(&(radius / half).powi(2))
}
