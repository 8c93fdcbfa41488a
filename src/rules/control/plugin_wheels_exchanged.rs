//! A plugin of Gazebo whose wheels are on the wrong sides.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::plugin_wheel_mismatch::{DRIVES, JOINTS, wheels};
use super::plugins::plugins_of;
use super::wheel_sizes::WheelPair;
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
        let pair = || wheels(cx, tree, plugin);
        let found = match file.filter(is_drive).and_then(|_| sides(tree, plugin)) {
            Some(Sides::AsNamed) => pair().and_then(|pair| {
                let (message, help) = pair.exchanged()?;
                Some((left_joint(tree, plugin)?, message, help))
            }),
            Some(Sides::Exchanged(mode)) => pair().filter(WheelPair::is_in_order).map(|pair| {
                let [left, _] = pair.names();
                let message = format!(
                    "the robot turns the wrong way: legacy mode takes the left wheel `{left}` for the right one"
                );
                (mode, message, "write <legacyMode>false</legacyMode>")
            }),
            None => None,
        };
        if let Some((text, message, help)) = found {
            out.report(text.origin, message).help(help).done();
        }
    }
}

/// Which wheels a plugin takes for the left and the right one.
enum Sides {
    /// Those of the joints that are called so, in all versions.
    AsNamed,
    /// The others, because the text says so.
    Exchanged(AttrValue),
}

/// Which wheels a plugin takes for the left and the right one; none where that depends on its version.
fn sides(tree: &XTree, plugin: XId) -> Option<Sides> {
    let value = |name: &str| {
        let mut all = tree.elements(plugin);
        let child = all.find(|&child| tree.get(child).text == name)?;
        AttrValue::content(tree, child)
    };
    if value(LEFT_IN_ROS1).is_none() {
        return Some(Sides::AsNamed);
    }
    let mode = value(LEGACY)?;
    match mode.value.trim() {
        "false" | "0" => Some(Sides::AsNamed),
        "true" | "1" => Some(Sides::Exchanged(mode)),
        _ => None,
    }
}

/// What names the left joint.
fn left_joint(tree: &XTree, plugin: XId) -> Option<AttrValue> {
    let left = tree.elements(plugin).find(|&child| {
        let name = tree.get(child).text.as_str();
        JOINTS.iter().any(|[left, _]| *left == name)
    });
    AttrValue::content(tree, left?)
}
