//! A mass of zero.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::moments::inertials;
use crate::model::element_range;

pub(super) const RULE: Rule = Rule {
    code: "INR002",
    name: "zero-mass",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page!("zero-mass"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(text) = inertial.mass.as_ref().filter(|text| text.number() == Some(0.0)) else { continue };
        // a frame that says that it weighs nothing is harmless
        let is_frame = !link.has_geometry() && inertial.entries().is_none_or(|entries| entries == [0.0; 6]);
        let severity = if is_frame { Severity::Info } else { Severity::Warning };
        let message = format!("mass of link `{}` is zero", link.shown());
        let report = out
            .report(text.origin, message)
            .severity(severity)
            .help("simulators drop a link without mass: give it one, or remove `inertial`");
        match cx.expansion.place(element_range(cx.expansion, inertial.element)) {
            Some(place) => {
                let edit = [(place.range, String::new())];
                report.fix(Safety::Unsafe, "remove `inertial`", place.file, edit).done();
            }
            None => report.done(),
        }
    }
}
