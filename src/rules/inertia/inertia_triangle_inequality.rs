//! Principal moments that no body has.

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::is_small_part;
use super::moments::{Verdict, inertia_tag, inertials, short, verdict};
use model::{Inertial, Link};

pub(super) const RULE: Rule = Rule {
    code: "INR005",
    name: "inertia-triangle-inequality",
    category: Category::Inertia,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("inertia-triangle-inequality"),
    check: Check::Document(check),
};

/// Less than this part short is rounding.
const ROUNDING: f64 = 1e-6;
/// Less than this part short may be rounding.
const COARSE: f64 = 2e-2;

/// What the last digit of exporters that write six decimals stands for, kg m^2.
const LAST_DIGIT: f64 = 1e-6;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some([a, b, c]) = impossible(inertial) else { continue };
        let severity = if is_error(cx, link, inertial) { Severity::Error } else { Severity::Info };
        let message = format!(
            "inertia of link `{}` is impossible: moment {} exceeds the sum of {} and {}",
            link.shown(),
            short(c),
            short(a),
            short(b)
        );
        out.report(inertia_tag(cx.expansion, inertial), message)
            .group(Group::Value(format!("{:?}", inertial.entries()).into()))
            .severity(severity)
            .help("compute the inertia from mass and shape")
            .done();
    }
}

/// The moments, if no body has them.
fn impossible(inertial: &Inertial) -> Option<[f64; 3]> {
    let Verdict::Definite(moments @ [a, b, c]) = verdict(inertial.entries()?) else { return None };
    (a + b < c * (1.0 - ROUNDING)).then_some(moments)
}

/// Whether the inertia of a link is impossible, and not by rounding alone.
pub(super) fn is_error(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial) -> bool {
    let Some([a, b, c]) = impossible(inertial) else { return false };
    // simulators add the inertia of a part that is fixed to a heavy body to that of the body
    let is_added = inertial.mass().is_some_and(|mass| is_small_part(cx, link, mass));
    !is_added && a + b < c * (1.0 - COARSE) && c - a - b > LAST_DIGIT
}
