//! A mass below zero.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::Link;

pub(in super::super) static RULE: Rule = Rule {
    code: "INR001",
    name: "negative-mass",
    category: Category::Inertia,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("negative-mass"),
    check: Check::Link(check),
};

fn check(_: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some(text) = inertial
        .mass
        .as_ref()
        .filter(|text| text.number().is_some_and(|mass| mass < 0.0))
    else {
        return;
    };
    let message = format!("link `{}` has a negative mass", link.shown());
    out.report(text.origin, message)
        .help("write a mass greater than 0, in kilograms")
        .done();
}
