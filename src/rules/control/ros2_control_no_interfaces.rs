//! A joint of ros2_control without interfaces.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{ControlJoint, tag_start};

pub(super) const RULE: Rule = Rule {
    code: "CTL011",
    name: "ros2-control-no-interfaces",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros2-control-no-interfaces"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.whole()) else { return };
    for joint in robot.controls.iter().flat_map(|control| &control.joints) {
        if joint.interfaces().next().is_none() && !mimics(cx, joint) {
            out.report(
                tag_start(cx.expansion, joint.element),
                format!("joint `{}` has no interface", joint.shown()),
            )
            .help("add <command_interface> and <state_interface> elements, or take the joint out")
            .done();
        }
    }
}

/// Joints that follow another one need no interface: by attribute, or by a parameter as it used to be written.
fn mimics(cx: &DocumentCx<'_>, joint: &ControlJoint) -> bool {
    let tree = &cx.expansion.tree;
    let is_mimic =
        |id| tree.get(id).text == "param" && tree.attr(id, "name").is_some_and(|a| a.value == "mimic");
    joint.mimic.is_some() || tree.elements(joint.element).any(is_mimic)
}
