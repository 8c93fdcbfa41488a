//! A mass without extent.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{LIGHT, is_in_world, is_joined};
use super::moments::{InertiaClass, inertia_tag, judged};
use model::Link;

pub(super) static RULE: Rule = Rule {
    code: "INR003",
    name: "zero-inertia",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("zero-inertia"),
    check: Check::Link(check),
};

/// Up to this mass in kg, a link has one only because its exporter writes one.
const NOTHING: f64 = 1e-5;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let heavy = inertial.mass().is_some_and(|mass| mass > NOTHING);
    if heavy && judged(inertial).class == Some(InertiaClass::Zero) {
        let message = format!("link `{}` has a mass but zero inertia", link.shown());
        // what is joined to a heavier body, or never turns, needs no inertia of its own
        let is_frame = !link.has_geometry() && inertial.mass().is_some_and(|mass| mass <= LIGHT);
        // a kinematic link goes where it is put
        let is_placed = || cx.is_set_for(Some(link.shown()), "kinematic");
        let without_effect =
            is_frame || is_joined(cx, link) || is_in_world(cx, link) || is_placed();
        let severity = if without_effect {
            Severity::Info
        } else {
            Severity::Warning
        };
        out.report(inertia_tag(cx.expansion, inertial), message)
            .severity(severity)
            .help("compute the inertia from mass and shape; simulators become unstable otherwise")
            .done();
    }
}
