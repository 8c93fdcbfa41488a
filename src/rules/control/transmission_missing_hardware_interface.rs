//! A simple transmission that does not say what it commands.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use expand::XTree;
use model::{AttrValue, Robot, Transmission, tag_start};
use packages::RosVersion;

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL013",
    name: "transmission-missing-hardware-interface",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("transmission-missing-hardware-interface"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let Some(robot) = cx.robot.filter(|_| cx.whole()) else {
        return;
    };
    let tree = &cx.expansion.tree;
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    // in ROS 2, nothing reads transmissions outside of <ros2_control>
    let severity = match root.and_then(|root| cx.world.packages.generation(root)) {
        Some(RosVersion::Ros2) => Severity::Info,
        _ if is_driven_otherwise(tree, robot) => Severity::Info,
        _ => Severity::Warning,
    };
    for transmission in robot
        .transmissions
        .iter()
        .filter(|transmission| is_simple(tree, transmission))
    {
        for (joint, name) in &transmission.joints {
            if !tree
                .elements(*joint)
                .any(|id| tree.get(id).text == "hardwareInterface")
            {
                let name = name.as_ref().map_or("", |name| name.value.as_str());
                out.report(tag_start(cx.expansion, *joint), format!("joint `{name}` in a transmission has no hardware interface"))
                    .severity(severity)
                    .help("add <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>, or the velocity or effort interface")
                    .done();
            }
        }
    }
}

/// Whether a plugin of Gazebo drives a robot, and none of its plugins runs controllers, which read transmissions.
fn is_driven_otherwise(tree: &XTree, robot: &Robot) -> bool {
    let plugins = || {
        let blocks = robot.gazebo.iter();
        let inside = blocks.flat_map(|block| tree.elements(block.element));
        inside.filter(|&child| tree.get(child).text == "plugin")
    };
    let has = |words: &[&str]| {
        plugins().any(|plugin| {
            let file = tree.attr(plugin, "filename");
            file.is_some_and(|file| words.iter().any(|word| file.value.contains(word)))
        })
    };
    has(&["_drive", "_move"]) && !has(&["control"])
}

/// Whether a transmission is ROS 1's simple one.
fn is_simple(tree: &XTree, transmission: &Transmission) -> bool {
    let mut types = tree
        .elements(transmission.element)
        .filter(|&id| tree.get(id).text == "type");
    types.any(|id| {
        AttrValue::content(tree, id).is_some_and(|text| text.value.ends_with("SimpleTransmission"))
    })
}
