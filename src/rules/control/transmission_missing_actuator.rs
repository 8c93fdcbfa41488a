//! A transmission without an actuator.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::transmissions::{severity, type_of};
use model::{source_mentions, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL022",
    name: "transmission-missing-actuator",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("transmission-missing-actuator"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.whole()) else {
        return;
    };
    let tree = &cx.expansion.tree;
    for transmission in &robot.transmissions {
        let is_standard = type_of(tree, transmission.element)
            .is_some_and(|kind| kind.value.starts_with("transmission_interface/"));
        let has_actuator = tree
            .elements(transmission.element)
            .any(|id| tree.get(id).text == "actuator");
        // other arguments may bring one
        if !is_standard
            || has_actuator
            || source_mentions(cx.expansion, transmission.element, "actuator")
        {
            continue;
        }
        let name = transmission
            .name
            .as_ref()
            .map_or("", |name| name.value.as_str());
        out.report(tag_start(cx.expansion, transmission.element), format!("transmission `{name}` has no actuator"))
            .severity(severity(cx))
            .help("add <actuator name=\"...\"/> with the name of the motor; the transmission is not loaded without one")
            .done();
    }
}
