//! A transmission for a joint that does not exist.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;
use model::AttrValue;
use packages::{RosVersion, misspelled};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL012",
    name: "transmission-unknown-joint",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("transmission-unknown-joint"),
    check: Check::Whole(check),
};

/// What the messages say.
const BLOCK: &str = "a transmission";

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let listed = cx
        .robot
        .transmissions
        .iter()
        .flat_map(|transmission| &transmission.joints);
    let names: Vec<&AttrValue> = listed.filter_map(|(_, name)| name.as_ref()).collect();
    if names.is_empty() {
        return;
    }
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let generation = root.and_then(|root| cx.world.packages.generation(root));
    // a description of no package is for the ROS of those around it
    let around = || root.and_then(|root| cx.world.packages.generation_around(root));
    let severity = match generation {
        // nothing in ROS 2 reads these elements: what resembles no joint is left over from ROS 1
        Some(RosVersion::Ros2) => {
            let is_slip = |text: &&AttrValue| {
                let joints = cx.robot.joints.iter().map(|joint| joint.shown());
                text.name()
                    .is_some_and(|name| misspelled(name, joints).is_some())
            };
            let (slips, others): (Vec<&AttrValue>, Vec<&AttrValue>) =
                names.into_iter().partition(is_slip);
            unknown_joints(cx, out, slips.into_iter(), BLOCK, Severity::Warning);
            return unknown_joints(cx, out, others.into_iter(), BLOCK, Severity::Info);
        }
        None if around() == Some(RosVersion::Ros2) => Severity::Info,
        _ if is_driven_by_plugin(cx) => Severity::Info,
        _ => RULE.severity,
    };
    unknown_joints(cx, out, names.into_iter(), BLOCK, severity);
}

/// Whether a plugin of Gazebo drives the wheels, and none reads transmissions.
fn is_driven_by_plugin(cx: &RobotCx<'_>) -> bool {
    let tree = &cx.expansion.tree;
    let plugins = cx
        .robot
        .gazebo
        .iter()
        .flat_map(|block| tree.elements(block.element));
    let names: Vec<&str> = plugins
        .filter(|&plugin| tree.get(plugin).text == "plugin")
        .filter_map(|plugin| Some(tree.attr(plugin, "filename")?.value.as_str()))
        .collect();
    names.iter().any(|name| name.contains("drive"))
        && !names.iter().any(|name| name.contains("control"))
}
