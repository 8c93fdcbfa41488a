//! Principal moments that no body has.

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::moments::{Verdict, inertia_tag, inertials, short, verdict};

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
const COARSE: f64 = 1e-2;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(Verdict::Definite([a, b, c])) = inertial.entries().map(verdict) else { continue };
        if a + b >= c * (1.0 - ROUNDING) {
            continue;
        }
        let severity = if a + b >= c * (1.0 - COARSE) { Severity::Info } else { Severity::Error };
        let message = format!(
            "inertia of link `{}`: principal moment {} is greater than {} and {} together",
            link.shown(),
            short(c),
            short(a),
            short(b)
        );
        out.report(inertia_tag(cx.expansion, inertial), message)
            .group(Group::Value(format!("{:?}", inertial.entries()).into()))
            .severity(severity)
            .help("no body has such moments: compute them again from mass and shape")
            .done();
    }
}
