//! An inertia that was copied from an example.
use super::super::context::DocumentCx;
use super::super::geometry::extent;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::moments::inertia_tag;
use model::{Inertial, Link};

pub(super) static RULE: Rule = Rule {
    code: "INR008",
    name: "placeholder-inertia",
    category: Category::Inertia,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("placeholder-inertia"),
    check: Check::Link(check),
};

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    if is_placeholder(cx, link, inertial) {
        let message = format!(
            "inertia of link `{}` looks like a placeholder value",
            link.shown()
        );
        out.report(inertia_tag(cx.expansion, inertial), message)
            .help("compute the inertia from mass and shape")
            .done();
    }
}

/// Whether the inertia of a link is a round number that does not come from its mass and shape.
pub(super) fn is_placeholder(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial) -> bool {
    let Some([xx, xy, xz, yy, yz, zz]) = inertial.entries() else {
        return false;
    };
    let is_round = xx == yy && yy == zz && [xy, xz, yz] == [0.0; 3] && is_power_of_ten(xx);
    if !is_round || inertial.mass().is_some_and(|mass| mass <= 0.0) {
        return false;
    }
    let estimate = || {
        let [x, y, z] = extent(cx, link).bounds()?.size();
        // a full box of this size: the mean of its three moments
        Some(inertial.mass()? * (x * x + y * y + z * z) / 18.0)
    };
    let is_off = |estimate: f64| estimate > 0.0 && !(0.1..=10.0).contains(&(xx / estimate));
    xx == 1.0 || estimate().is_some_and(is_off)
}

/// Whether a number is 1, 0.1, 0.01 and so on.
fn is_power_of_ten(number: f64) -> bool {
    (0..=9).any(|digits| format!("1e-{digits}").parse() == Ok(number))
}
