//! An inertia that does not fit the size of the link.

use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent};
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::moments::{Verdict, inertia_tag, inertials, short, verdict};

pub(super) const RULE: Rule = Rule {
    code: "INR006",
    name: "implausible-inertia",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("implausible-inertia"),
    check: Check::Document(check),
};

/// Radius of gyration that no link without geometry has, metres.
const FAR: f64 = 5.0;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(mass) = inertial.mass().filter(|&mass| mass > 0.0) else { continue };
        let Some(Verdict::Definite([_, _, most])) = inertial.entries().map(verdict) else { continue };
        let radius = (most / mass).sqrt();
        let (wrong, beside) = match extent(cx, link) {
            Extent::Unknown => continue,
            Extent::Nothing => (radius > FAR, "no link is so large".to_owned()),
            Extent::Known(bounds) => {
                let half = bounds.diagonal() / 2.0;
                let wrong = half > 0.0 && (radius > 2.0 * half || radius < half / 50.0);
                (wrong, format!("its geometry has a radius of {} m", short(half)))
            }
        };
        if wrong {
            let (name, radius) = (link.shown(), short(radius));
            let message =
                format!("inertia of link `{name}` means a radius of gyration of {radius} m; {beside}");
            out.report(inertia_tag(cx.expansion, inertial), message)
                .help("check units: kg m^2, not kg mm^2 or g mm^2")
                .done();
        }
    }
}
