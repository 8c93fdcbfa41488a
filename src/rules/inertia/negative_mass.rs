//! A mass below zero.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::moments::inertials;

pub(in super::super) static RULE: Rule = Rule {
    code: "INR001",
    name: "negative-mass",
    category: Category::Inertia,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("negative-mass"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for (link, inertial) in inertials(cx) {
        let Some(text) = inertial
            .mass
            .as_ref()
            .filter(|text| text.number().is_some_and(|mass| mass < 0.0))
        else {
            continue;
        };
        let message = format!("link `{}` has a negative mass", link.shown());
        out.report(text.origin, message)
            .help("write a mass greater than 0, in kilograms")
            .done();
    }
}
