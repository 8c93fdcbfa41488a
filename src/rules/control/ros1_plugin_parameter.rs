//! Parameters of a plugin of Gazebo that only ROS 1 reads.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::gazebo_ros::{NAMESPACE, REMAPPING, plugins_for_ros2, renamed};
use expand::{XId, XTree};
use model::{AttrValue, JointType, Link, Robot, tag_start};

pub(in super::super) static RULE: Rule = Rule {
    code: "CTL031",
    name: "ros1-plugin-parameter",
    category: Category::Control,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ros1-plugin-parameter"),
    check: Check::Document(check),
};

/// Whether a plugin has what took the place of a parameter: the old one is left over.
fn is_there(tree: &XTree, plugin: XId, new: &str) -> bool {
    let has = |around: XId, name: &str| {
        let mut inside = tree.elements(around);
        inside.any(|id| tree.get(id).text == name)
    };
    let mut inside = tree.elements(plugin);
    match new {
        REMAPPING => inside.any(|id| tree.get(id).text == "ros" && has(id, "remapping")),
        NAMESPACE => inside.any(|id| tree.get(id).text == "ros" && has(id, "namespace")),
        _ => has(plugin, new),
    }
}

/// Whether a parameter has the value that holds without it, in a namespace or in none.
fn is_default((name, new): (&str, &str), value: &str, has_namespace: bool) -> bool {
    let is_topic =
        |topic: &str| value == topic || !has_namespace && value.strip_prefix('/') == Some(topic);
    match name {
        "commandTopic" => is_topic("cmd_vel"),
        "odometryTopic" => is_topic("odom"),
        "odometryFrame" => value == "odom",
        "imageTopicName" => value == "image_raw",
        "cameraInfoTopicName" => value == "camera_info",
        _ => new == NAMESPACE && ["", "/"].contains(&value),
    }
}

/// Whether a plugin is in a sensor of this name, which is that of the camera without a parameter.
///
/// Source: `gazebo_ros_camera.cpp` of ROS 2.
fn is_sensor(tree: &XTree, plugin: XId, name: &str) -> bool {
    let sensor = tree
        .parent(plugin)
        .filter(|&around| tree.get(around).text == "sensor");
    sensor
        .and_then(|sensor| tree.attr(sensor, "name"))
        .is_some_and(|own| own.value == name.trim_start_matches('/'))
}

/// Whether a plugin is in an element for this link, which stays a link of its own: it is the frame of the data without a parameter.
fn is_own_frame(cx: &DocumentCx<'_>, plugin: XId, name: &str) -> bool {
    let tree = &cx.expansion.tree;
    let mut around = std::iter::successors(tree.parent(plugin), |&id| tree.parent(id));
    let is_it = |id: XId| {
        let reference = tree.attr(id, "reference");
        tree.get(id).text == "gazebo" && reference.is_some_and(|own| own.value == name)
    };
    let moves = |robot: &Robot| {
        let kinematics = robot.kinematics();
        let link = kinematics.link(name)?;
        let joint = kinematics.parent_joints(link).first().copied()?;
        Some(!robot.joints.get(joint)?.is(&[JointType::Fixed]))
    };
    around.any(is_it) && cx.robot.and_then(moves) == Some(true)
}

/// Whether the frame that drives take without a parameter is the root of the robot: another one would get a second parent.
fn has_default_base(cx: &DocumentCx<'_>, new: &str) -> bool {
    /// Source: `gazebo_ros_diff_drive` and `gazebo_ros_planar_move` of ROS 2.
    const DEFAULT: &str = "base_footprint";
    let links = cx.robot.into_iter().flat_map(|robot| {
        let kinematics = robot.kinematics();
        let roots = kinematics.roots(robot).into_iter();
        roots.filter_map(|root| robot.links.get(root))
    });
    new == "robot_base_frame" && links.map(Link::shown).any(|root| root == DEFAULT)
}

/// Whether a plugin is put into a namespace.
fn has_namespace(tree: &XTree, plugin: XId) -> bool {
    let mut ros = tree
        .elements(plugin)
        .filter(|&id| tree.get(id).text == "ros");
    ros.any(|ros| {
        let mut named = tree
            .elements(ros)
            .filter(|&id| tree.get(id).text == "namespace");
        named.any(|id| {
            AttrValue::content(tree, id).is_some_and(|name| !["", "/"].contains(&name.value.trim()))
        })
    })
}

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let tree = &cx.expansion.tree;
    for (plugin, library) in plugins_for_ros2(cx) {
        let is_named = has_namespace(tree, plugin);
        let old = tree.elements(plugin).filter_map(|parameter| {
            let name = &tree.get(parameter).text;
            let new = renamed(&library.value, name)?;
            let value = AttrValue::content(tree, parameter);
            let value = value.as_ref().map_or("", |value| value.value.trim());
            let is_default = is_default((name, new), value, is_named)
                || name == "cameraName" && is_sensor(tree, plugin, value)
                || name == "frameName" && is_own_frame(cx, plugin, value);
            let is_needless = is_default || has_default_base(cx, new);
            (!is_needless && !is_there(tree, plugin, new)).then_some((parameter, name, new))
        });
        let mut old = old.peekable();
        let Some(&(first, name, new)) = old.peek() else {
            continue;
        };
        let message = format!("`{}` ignores `{name}` in ROS 2", library.value);
        let mut report = out
            .report(tag_start(cx.expansion, first), message)
            .help(format!("write `{new}`"));
        for (parameter, name, new) in old.skip(1) {
            let what = format!("`{name}` as well: write `{new}`");
            report = report.also(tag_start(cx.expansion, parameter), what);
        }
        report.done();
    }
}
