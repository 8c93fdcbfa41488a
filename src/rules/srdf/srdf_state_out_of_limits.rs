//! A group state that puts a joint outside of its limits.
use super::super::beside::BesideCx;
use super::super::control::limits_of;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule::beside(
    "SRD006",
    "srdf-state-out-of-limits",
    Category::Srdf,
    Severity::Error,
    page("srdf-state-out-of-limits"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    const SLACK: f64 = 1e-4;
    let states = cx.srdf().into_iter().flat_map(|srdf| &srdf.states);
    for (joint, value) in states.flat_map(|state| &state.joints) {
        let (Some(name), Some(text)) = (joint.name(), value) else {
            continue;
        };
        let Some(value) = text.number() else { continue };
        let mut limits = Vec::new();
        for (paired, joint) in cx.joints(name) {
            limits.push((limits_of(joint), paired, joint));
        }
        let is_outside = limits.iter().all(|(range, ..)| {
            range.is_some_and(|(lower, upper)| value < lower - SLACK || value > upper + SLACK)
        });
        if limits.is_empty() || !is_outside {
            continue;
        }
        let Some((Some((lower, upper)), paired, joint)) = limits.into_iter().next() else {
            continue;
        };
        let message =
            format!("joint `{name}` is at {value}, outside of its limits {lower} to {upper}");
        let help = format!("write a value from {lower} to {upper}");
        let origin = joint
            .name
            .as_ref()
            .and_then(|name| paired.span(name.origin));
        out.report(text.origin, message)
            .help(help)
            .also_span(origin, "joint defined here")
            .done();
    }
}
