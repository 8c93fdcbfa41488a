//! A plugin of Gazebo whose wheels are on the wrong sides.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugin_wheel_mismatch::{DRIVES, JOINTS, wheels};
use super::plugins::plugins_of;
use expand::{XId, XTree};
use model::AttrValue;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL037",
    name: "plugin-wheels-exchanged",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("plugin-wheels-exchanged"),
    check: Check::Whole(check),
};

/// The tag for the left joint of the plugin of ROS 1, which took the right one for it up to Kinetic.
const LEFT_IN_ROS1: &str = "leftJoint";
/// What says in ROS 1 which one it takes.
const LEGACY: &str = "legacyMode";

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for plugin in plugins_of(tree, cx.robot) {
        let file = AttrValue::attr(tree, plugin, "filename");
        let is_drive = |file: &AttrValue| DRIVES.iter().any(|part| file.value.contains(part));
        let pair = file
            .filter(is_drive)
            .filter(|_| is_left_the_left(tree, plugin))
            .and_then(|_| wheels(cx, tree, plugin));
        let Some((message, help)) = pair.and_then(|pair| pair.exchanged()) else {
            continue;
        };
        let left = tree.elements(plugin).find(|&child| {
            let name = tree.get(child).text.as_str();
            JOINTS.iter().any(|[left, _]| *left == name)
        });
        let Some(joint) = left.and_then(|left| AttrValue::content(tree, left)) else {
            continue;
        };
        out.report(joint.origin, message).help(help).done();
    }
}

/// Whether a plugin takes the joint that is called the left one for that, in all versions.
fn is_left_the_left(tree: &XTree, plugin: XId) -> bool {
    let value = |name: &str| {
        let mut all = tree.elements(plugin);
        let child = all.find(|&child| tree.get(child).text == name)?;
        Some(AttrValue::content(tree, child)?.value.trim().to_owned())
    };
    value(LEFT_IN_ROS1).is_none()
        || value(LEGACY).is_some_and(|text| matches!(text.as_str(), "false" | "0"))
}
