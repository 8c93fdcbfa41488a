//! An inertia so small that solvers suffer.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::moments::{InertiaClass, inertia_tag, judged, short};
use model::Link;

pub(super) static RULE: Rule = Rule {
    code: "INR012",
    name: "tiny-inertia",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("tiny-inertia"),
    check: Check::Link(check),
};

/// Smaller moments are hard for solvers, kg m^2.
const TINY: f64 = 1e-9;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(InertiaClass::Definite([least, ..])) = judged(inertial).class else {
        return;
    };
    if least > 0.0 && least < TINY {
        let message = format!(
            "inertia of link `{}` is very small: {} kg m^2",
            link.shown(),
            short(least)
        );
        out.report(inertia_tag(cx.expansion, inertial), message)
            .help(
                "increase the inertia, or attach the link with a fixed joint; simulators become inaccurate otherwise",
            )
            .done();
    }
}
