//! A transmission whose type looks misspelled.
use super::super::context::DocumentCx;
use super::super::finding::Help;
use super::super::numbers::rewrite;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::transmissions::{severity, type_of};
use packages::nearest;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL023",
    name: "transmission-unknown-type",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("transmission-unknown-type"),
    check: Check::Document(check),
};

/// The types of transmission_interface.
const KNOWN: [&str; 3] = [
    "transmission_interface/SimpleTransmission",
    "transmission_interface/DifferentialTransmission",
    "transmission_interface/FourBarLinkageTransmission",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for transmission in cx.robot.into_iter().flat_map(|robot| &robot.transmissions) {
        let Some(text) = type_of(&cx.expansion.tree, transmission.element) else {
            continue;
        };
        let Some(kind) = text.name().filter(|kind| !KNOWN.contains(&kind.as_str())) else {
            continue;
        };
        // types of other packages are as good
        let Some(near) = nearest(kind, KNOWN) else {
            continue;
        };
        let report = out
            .report(text.origin, format!("unknown transmission type `{kind}`"))
            .severity(severity(cx))
            .help(Help::did_you_mean(near));
        rewrite(report, Safety::Unsafe, &text, near.to_owned()).done();
    }
}
