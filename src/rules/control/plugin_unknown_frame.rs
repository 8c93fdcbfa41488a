//! A frame of the data of a simulated sensor that is not a link of the robot.
use std::cell::OnceCell;

use super::super::context::{RobotCx, elements};
use super::super::finding::Help;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::super::vocabulary::is_surroundings;
use base::FastSet;
use expand::{XId, XKind, XTree};
use model::AttrValue;
use packages::{RosVersion, Suggestions};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL036",
    name: "plugin-unknown-frame",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("plugin-unknown-frame"),
    check: Check::Whole(check),
};

/// What sensors of Gazebo call the frame of their data.
pub(super) const OF_SENSORS: [&str; 2] = ["gz_frame_id", "ignition_frame_id"];

/// What the plugins of sensors call it, in ROS 2 and in ROS 1.
///
/// Source: `gazebo_plugins` on the branches `ros2` and `noetic-devel`.
const IN_ROS2: &str = "frame_name";
const IN_ROS1: &str = "frameName";

/// Types of sensors whose data are points: programs need their frame. What reads images or the values of an IMU often does not.
const OF_POINTS: [&str; 8] = [
    "depth",
    "depth_camera",
    "gpu_lidar",
    "gpu_ray",
    "lidar",
    "ray",
    "rgbd",
    "rgbd_camera",
];

/// Plugins that give data in a frame of the world, by a part of their names.
const IN_THE_WORLD: [&str; 2] = ["p3d", "ft_sensor"];

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let sensors = sensors(cx);
    if sensors.is_empty() {
        return;
    }
    let names = cx.robot.links.iter().filter_map(|link| link.name.as_ref());
    let links: Vec<&str> = names.filter_map(|name| Some(name.name()?.trim())).collect();
    // a node may put the name of the robot in front
    let last = |name: &'_ str| {
        name.rsplit('/')
            .next()
            .unwrap_or_default()
            .trim()
            .to_owned()
    };
    let known: FastSet<String> = links.iter().map(|link| last(link)).collect();
    // of a link that is not there, Gazebo ignores the sensor too, and that is said of the link
    let is_there = |link: &Option<&str>| link.is_none_or(|link| known.contains(&last(link)));
    let sensors = sensors.iter().filter(|(link, _)| is_there(link));
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let version = root.and_then(|root| cx.world.packages.generation(root));
    let frames: Vec<(AttrValue, bool)> = sensors
        .flat_map(|(_, sensor)| frames(&cx.expansion.tree, *sensor, version))
        .collect();
    let elsewhere = OnceCell::new();
    let mut suggestions = Suggestions::default();
    for (text, is_of_points) in frames.iter().filter(|(text, _)| text.is_known()) {
        let name = last(&text.value);
        if name.is_empty() || is_surroundings(&name) || known.contains(&name) {
            continue;
        }
        let elsewhere = elsewhere.get_or_init(|| links_elsewhere(cx));
        let is_elsewhere = elsewhere.iter().any(|end| name.ends_with(end));
        let message = format!("frame `{name}` of a sensor is not a link of the robot");
        let is_needed = *is_of_points && !is_elsewhere;
        let report = out.report(text.origin, message).severity(if is_needed {
            RULE.severity
        } else {
            Severity::Info
        });
        match suggestions.nearest(&name, links.iter().copied()) {
            Some(near) if text.is_literal() && text.value == name => report
                .help(Help::did_you_mean(near))
                .replace_with(Safety::Unsafe, format!("rename to `{near}`"), near)
                .done(),
            Some(near) => report.help(Help::did_you_mean(near)).done(),
            None => report
                .help("write the name of a link; no program can place the data of the sensor otherwise")
                .done(),
        }
    }
}

/// The sensors, each with the link that it is meant for, in document order.
pub(super) fn sensors<'a>(cx: &RobotCx<'a>) -> Vec<(Option<&'a str>, XId)> {
    let tree = &cx.expansion.tree;
    let blocks = cx.robot.gazebo.iter();
    let sensors = blocks.flat_map(|block| {
        let link = block.reference.as_ref().map(|text| text.value.as_str());
        tree.below(block.element).map(move |id| (link, id))
    });
    sensors
        .filter(|&(_, id)| is_element(tree, id, "sensor"))
        .collect()
}

/// The frames that a sensor and its plugins name, in document order, each with whether the data are points.
fn frames(tree: &XTree, sensor: XId, version: Option<RosVersion>) -> Vec<(AttrValue, bool)> {
    let is_read = |name: &str| match name {
        IN_ROS2 => version != Some(RosVersion::Ros1),
        IN_ROS1 => version != Some(RosVersion::Ros2),
        _ => false,
    };
    let kind = tree.attr(sensor, "type");
    let is_of_points = kind.is_some_and(|kind| OF_POINTS.contains(&kind.value.as_str()));
    let mut found = Vec::new();
    for part in tree.elements(sensor) {
        let name = tree.get(part).text.as_str();
        if OF_SENSORS.contains(&name) {
            found.extend(AttrValue::content(tree, part));
        } else if name == "plugin" && !is_in_the_world(tree, part) {
            let own = tree
                .elements(part)
                .filter(|&id| is_read(&tree.get(id).text));
            found.extend(own.filter_map(|id| AttrValue::content(tree, id)));
        }
    }
    found.into_iter().map(|text| (text, is_of_points)).collect()
}

/// What the names of links end with that the files write, also where other arguments are needed for them.
fn links_elsewhere<'a>(cx: &RobotCx<'a>) -> FastSet<&'a str> {
    let files = cx.expansion.files.iter();
    let nodes = files.flat_map(|file| elements(&file.source.document));
    let names = nodes
        .filter(|(_, node)| node.name() == "link")
        .filter_map(|(_, node)| node.attr("name"));
    let ends = names.filter_map(|name| name.raw().rsplit(['}', ')']).next());
    // a word that follows any name says nothing
    ends.filter(|end| end.contains('_') && !["_link", "_frame"].contains(end))
        .collect()
}

fn is_element(tree: &XTree, id: XId, name: &str) -> bool {
    let node = tree.get(id);
    node.kind == XKind::Element && node.text == name
}

/// Whether a plugin gives its data in a frame of the world.
fn is_in_the_world(tree: &XTree, plugin: XId) -> bool {
    let file = tree.attr(plugin, "filename");
    file.is_some_and(|file| IN_THE_WORLD.iter().any(|part| file.value.contains(part)))
}
