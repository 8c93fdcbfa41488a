//! A joint of ros2_control without interfaces.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::misspelled_plugin::HARDWARE;
use model::{AttrValue, ControlJoint, Robot, Ros2Control, tag_start};

pub(super) static RULE: Rule = Rule {
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
    let Some(robot) = cx.robot.filter(|_| cx.whole()) else {
        return;
    };
    for (control, joint) in robot
        .controls
        .iter()
        .flat_map(|control| control.joints.iter().map(move |joint| (control, joint)))
    {
        if joint.interfaces().next().is_none()
            && !is_unknown(robot, joint)
            && !mimics(cx, joint)
            && !exports_its_own(cx, control)
        {
            out.report(
                tag_start(cx.expansion, joint.element),
                format!("joint `{}` has no interfaces", joint.shown()),
            )
            .severity(if may_know_better(cx, control) { Severity::Info } else { Severity::Warning })
            .help("add <command_interface name=\"position\"/> or <state_interface name=\"position\"/>, or remove the joint")
            .done();
        }
    }
}

/// Whether the sources of the plugin are at hand, and it exports interfaces without looking at the description.
fn exports_its_own(cx: &DocumentCx<'_>, control: &Ros2Control) -> bool {
    let tree = &cx.expansion.tree;
    let plugin = control
        .plugin(tree)
        .and_then(|element| AttrValue::content(tree, element));
    let from = cx.expansion.files.first().map(|file| &*file.source.path);
    plugin.zip(from).is_some_and(|(plugin, from)| {
        cx.world
            .packages
            .exports_interfaces(plugin.value.trim(), from)
    })
}

/// Whether the hardware is none of ROS's own, and no joint of it has interfaces: it seems to know them without being told.
fn may_know_better(cx: &DocumentCx<'_>, control: &Ros2Control) -> bool {
    let tree = &cx.expansion.tree;
    let plugin = control
        .plugin(tree)
        .and_then(|element| AttrValue::content(tree, element));
    let is_other = plugin.is_some_and(|plugin| !HARDWARE.contains(&plugin.value.trim()));
    is_other
        && control
            .joints
            .iter()
            .all(|joint| joint.interfaces().next().is_none())
}

/// Whether the robot does not have the joint, which is what has to be put right.
fn is_unknown(robot: &Robot, joint: &ControlJoint) -> bool {
    let name = joint.name.as_ref().and_then(AttrValue::name);
    name.is_some_and(|name| robot.joint(name).is_none())
}

/// Joints that follow another one need no interface: by attribute, or by a parameter as it used to be written.
fn mimics(cx: &DocumentCx<'_>, joint: &ControlJoint) -> bool {
    let tree = &cx.expansion.tree;
    let is_mimic = |id| {
        tree.get(id).text == "param" && tree.attr(id, "name").is_some_and(|a| a.value == "mimic")
    };
    joint.mimic.is_some() || tree.elements(joint.element).any(is_mimic)
}
