//! The XML, and elements outside of links and joints.
use super::facts::{ConstructCollector, ConstructOwner, RobotFacts};
use expand::{XId, XTree};
use model::{AttrValue, decimal};
use xml::{Document, Node, NodeKind};

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

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
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
fn document(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
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
    if outer_nodes(document).any(|node| node.kind() == NodeKind::Doctype) {
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
    let declaration = outer_nodes(document).find(|node| node.kind() == NodeKind::Declaration);
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

/// What stands in front of the elements and behind them.
fn outer_nodes(document: &Document) -> impl Iterator<Item = Node<'_>> {
    document.header().all_nodes().chain(document.epilog())
}

/// Whether a value holds an entity that XML itself does not know.
fn is_entity(value: &str) -> bool {
    let mut parts = value.split('&').skip(1);
    parts.any(|part| {
        let name = part.split(';').next().unwrap_or_default();
        !name.starts_with('#') && !["amp", "lt", "gt", "quot", "apos"].contains(&name)
    })
}

fn transmissions(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let tree = &facts.cx.expansion.tree;
    for transmission in &facts.robot.transmissions {
        let element = transmission.element;
        let at = facts.at(element);
        let owner = ConstructOwner {
            kind: "transmission",
            name: transmission.name.as_ref().map(|name| name.value.as_str()),
        };
        out.add("transmission", at, owner);
        if transmission.name.is_none() {
            out.add("transmission-without-name", at, owner);
        }
        if !facts.has_child(element, "type") {
            let row = match tree.attr(element, "type") {
                Some(_) => "transmission-of-pr2",
                None => "transmission-without-type",
            };
            out.add(row, at, owner);
        }
        if !facts.has_child(element, "actuator") {
            out.add("transmission-without-actuator", at, owner);
        }
        if !facts.has_child(element, "joint") {
            out.add("transmission-without-joint", at, owner);
        }
        let unknown = |name: &AttrValue| {
            name.name()
                .is_some_and(|name| facts.robot.joint(name).is_none())
        };
        if transmission
            .joints
            .iter()
            .filter_map(|(_, name)| name.as_ref())
            .any(unknown)
        {
            out.add("transmission-joint-unknown", at, owner);
        }
    }
}

fn extension(facts: &RobotFacts<'_, '_>, gazebo: XId, out: &mut ConstructCollector) {
    let tree = &facts.cx.expansion.tree;
    let owner = "a `<gazebo>` element";
    for child in tree.elements(gazebo) {
        if NUMBERS.contains(&tree.get(child).text.as_str()) && !has_number(tree, child) {
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
        let kind = AttrValue::attr(tree, sensor, "type").filter(AttrValue::is_known);
        if let Some(kind) = kind.filter(|kind| !SENSORS.contains(&kind.value.as_str())) {
            out.add("gazebo-sensor-type", kind.origin, owner);
        }
    }
    for pose in tree.below(gazebo).filter(|&id| tree.get(id).text == "pose") {
        let text = AttrValue::content(tree, pose).filter(AttrValue::is_known);
        if text.is_some_and(|text| text.words().count() != 6) {
            out.add("gazebo-pose", facts.at(pose), owner);
        }
    }
}

/// Whether an element of `<gazebo>` holds a number, or may hold one.
fn has_number(tree: &XTree, element: XId) -> bool {
    AttrValue::attr(tree, element, "value")
        .or_else(|| AttrValue::content(tree, element))
        .is_some_and(|text| !text.is_known() || decimal(text.value.trim()).is_some())
}
