//! An inertia that no body has.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{body_inertia, is_joined};
use super::moments::{InertiaClass, NEGLIGIBLE_MASS, inertia_tag, judged, verdict};
use model::Link;

pub(in super::super) static RULE: Rule = Rule {
    code: "INR004",
    name: "inertia-not-positive-definite",
    category: Category::Inertia,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("inertia-not-positive-definite"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    if inertial.mass().is_some_and(|mass| mass <= NEGLIGIBLE_MASS) {
        return;
    }
    let (severity, message) = match judged(inertial).class {
        Some(InertiaClass::Negative) => {
            let severity = if is_definite_with_others(cx, link) {
                Severity::Warning
            } else {
                Severity::Error
            };
            (severity, "has a negative principal moment")
        }
        Some(InertiaClass::Singular) => {
            // simulators add the inertia of a link that is fixed to that of its parent
            let severity = if is_joined(cx, link) || is_definite_with_others(cx, link) {
                Severity::Info
            } else {
                Severity::Warning
            };
            (severity, "has a principal moment of zero")
        }
        _ => return,
    };
    let message = format!("inertia of link `{}` {message}", link.shown());
    out.report(inertia_tag(cx.expansion, inertial), message)
        .severity(severity)
        .help("check the signs of ixy, ixz and iyz and the frame of the inertia")
        .done();
}

/// Whether a link makes a body with moments above zero with what is fixed to it.
fn is_definite_with_others(cx: &DocumentCx<'_>, link: &Link) -> bool {
    body_inertia(cx, link)
        .is_some_and(|(_, entries)| matches!(verdict(entries), InertiaClass::Definite(_)))
}
