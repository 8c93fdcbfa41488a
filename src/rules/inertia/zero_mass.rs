//! A mass of zero.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::moments::{Verdict, inertials, verdict};
use crate::model::{JointType, Link, element_range};

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
        let is_frame = !link.has_geometry()
            && inertial.entries().map(verdict).is_none_or(|verdict| verdict == Verdict::Zero);
        let severity = if is_frame || is_fixed_end(cx, link) { Severity::Info } else { Severity::Warning };
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

/// Whether a link is fixed to another one and carries none: simulators join it to the one above.
fn is_fixed_end(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let Some(name) = link.name.as_ref().and_then(|name| name.name()) else { return false };
    let ends = |joint: &'_ crate::model::Joint, child: bool| {
        joint.ends().is_some_and(|(above, below)| if child { below == name } else { above == name })
    };
    let carries = cx.joints().iter().any(|joint| ends(joint, false));
    let mut above = cx.joints().iter().filter(|joint| ends(joint, true)).peekable();
    !carries && above.peek().is_some() && above.all(|joint| joint.is(&[JointType::Fixed]))
}
