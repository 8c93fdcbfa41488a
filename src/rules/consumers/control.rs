//! The XML, and elements outside of links and joints.
use super::facts::{Facts, Found};
use expand::XId;
use model::{Text, decimal};
use xml::NodeKind;

/// Elements of `<gazebo>` that hold a number.
const NUMBERS: [&str; 8] = [
    "mu1",
    "mu2",
    "kp",
    "kd",
    "maxVel",
    "max_vel",
    "minDepth",
    "min_depth",
];
/// The types of sensors of SDFormat.
const SENSORS: [&str; 35] = [
    "air_pressure",
    "air_speed",
    "airpressure",
    "airspeed",
    "altimeter",
    "boundingbox",
    "boundingbox_camera",
    "camera",
    "contact",
    "custom",
    "depth",
    "depth_camera",
    "force_torque",
    "gps",
    "gpu_lidar",
    "gpu_ray",
    "imu",
    "lidar",
    "logical_camera",
    "magnetometer",
    "multicamera",
    "navsat",
    "none",
    "ray",
    "rfid",
    "rfidtag",
    "rgbd",
    "rgbd_camera",
    "segmentation",
    "segmentation_camera",
    "sonar",
    "thermal",
    "thermal_camera",
    "wireless_receiver",
    "wireless_transmitter",
];

pub(super) fn find(facts: &Facts<'_, '_>, out: &mut Found) {
    document(facts, out);
    transmissions(facts, out);
    for gazebo in &facts.robot.gazebo {
        extension(facts, gazebo.element, out);
    }
    let tree = &facts.cx.expansion.tree;
    for mujoco in facts.children(facts.robot.element, "mujoco") {
        out.add("mujoco-element", facts.at(mujoco), "the robot");
    }
    let drake = tree.below(facts.robot.element).find(|&id| {
        tree.get(id).text.starts_with("drake:")
            || tree
                .get(id)
                .attrs
                .iter()
                .any(|attr| attr.name.starts_with("drake:"))
    });
    if let Some(drake) = drake {
        out.add("drake-element", facts.at(drake), "the robot");
    }
}

/// What the root file says above its elements. What xacro reads is written again for consumers.
fn document(facts: &Facts<'_, '_>, out: &mut Found) {
    let Some(file) = facts.cx.expansion.files.first() else {
        return;
    };
    let at = facts.at(facts.robot.element);
    let document = &file.source.document;
    let root = document.root();
    if root.is_some_and(|root| root.attrs().any(|attr| attr.name() == "xmlns")) {
        out.add("default-namespace", at, "the robot");
    }
    if root.is_some_and(|root| root.attr("xmlns:xacro").is_some()) {
        return;
    }
    let header = document.header();
    let nodes = || header.all_nodes().chain(document.epilog());
    if nodes().any(|node| node.kind() == NodeKind::Doctype) {
        out.add("doctype", at, "the robot");
    }
    // what is no entity has a row of its own
    let is_sound = document.errors().is_empty();
    if is_sound
        && document.parts().any(|(_, item)| {
            item.all_nodes()
                .any(|node| node.attrs().any(|attr| is_entity(attr.raw())))
        })
    {
        out.add("entity", at, "the robot");
    }
    let declaration = nodes().find(|node| node.kind() == NodeKind::Declaration);
    let declaration = declaration
        .map(|node| document.slice(node.range()).to_ascii_lowercase())
        .unwrap_or_default();
    let encoding = declaration
        .split_once("encoding=")
        .map_or("", |(_, rest)| rest.trim_start_matches(['"', '\'']));
    if !encoding.is_empty() && !encoding.starts_with("utf-8") && !encoding.starts_with("us-ascii") {
        out.add("encoding-latin-1", at, "the robot");
    }
}

/// Whether a value holds an entity that XML itself does not know.
fn is_entity(value: &str) -> bool {
    let mut parts = value.split('&').skip(1);
    parts.any(|part| {
        let name = part.split(';').next().unwrap_or_default();
        !name.starts_with('#') && !["amp", "lt", "gt", "quot", "apos"].contains(&name)
    })
}

fn transmissions(facts: &Facts<'_, '_>, out: &mut Found) {
    let tree = &facts.cx.expansion.tree;
    for transmission in &facts.robot.transmissions {
        let element = transmission.element;
        let owner = transmission
            .name
            .as_ref()
            .map_or("a transmission".to_owned(), |name| {
                format!("transmission `{}`", name.value)
            });
        let mut add = |row: &str| out.add(row, facts.at(element), owner.as_str());
        let has = |name: &'static str| facts.children(element, name).next().is_some();
        add("transmission");
        if transmission.name.is_none() {
            add("transmission-without-name");
        }
        match (has("type"), tree.attr(element, "type").is_some()) {
            (false, true) => add("transmission-of-pr2"),
            (false, false) => add("transmission-without-type"),
            (true, _) => {}
        }
        if !has("actuator") {
            add("transmission-without-actuator");
        }
        if !has("joint") {
            add("transmission-without-joint");
        }
        let unknown = |name: &Text| {
            name.name()
                .is_some_and(|name| facts.robot.joint(name).is_none())
        };
        if transmission
            .joints
            .iter()
            .filter_map(|(_, name)| name.as_ref())
            .any(unknown)
        {
            add("transmission-joint-unknown");
        }
    }
}

fn extension(facts: &Facts<'_, '_>, gazebo: XId, out: &mut Found) {
    let tree = &facts.cx.expansion.tree;
    let owner = "a `<gazebo>` element";
    for child in tree.elements(gazebo) {
        let name = tree.get(child).text.as_str();
        let is_number = |text: &Text| !text.is_known() || decimal(text.value.trim()).is_some();
        let written = || Text::attr(tree, child, "value").or_else(|| Text::content(tree, child));
        if NUMBERS.contains(&name) && !written().as_ref().is_some_and(is_number) {
            out.add("gazebo-number", facts.at(child), owner);
        }
    }
    let mut names = Vec::new();
    for sensor in facts.children(gazebo, "sensor") {
        match tree.attr(sensor, "name") {
            None => out.add("gazebo-sensor-without-name", facts.at(sensor), owner),
            Some(name) if names.contains(&name.value) => {
                out.add("gazebo-sensors-of-one-name", facts.at(sensor), owner);
            }
            Some(name) => names.push(name.value.clone()),
        }
        let kind = Text::attr(tree, sensor, "type").filter(Text::is_known);
        if let Some(kind) = kind.filter(|kind| !SENSORS.contains(&kind.value.as_str())) {
            out.add("gazebo-sensor-type", kind.origin, owner);
        }
    }
    for pose in tree.below(gazebo).filter(|&id| tree.get(id).text == "pose") {
        let text = Text::content(tree, pose).filter(Text::is_known);
        if text.is_some_and(|text| text.words().count() != 6) {
            out.add("gazebo-pose", facts.at(pose), owner);
        }
    }
}
