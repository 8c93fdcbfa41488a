//! Parameters of controllers, of ros2_control and of the older ros_control.

use ecow::EcoString;

use super::value::{SpannedName, entries, get, number, text};
use base::TextRange;
use yaml::{YamlKind, YamlNode};

/// The parameters of one controller.
#[derive(Clone, Debug)]
pub struct Controller {
    /// The last part of the name of its node.
    pub name: SpannedName,
    /// Its class, when these parameters say it.
    pub class: Option<SpannedName>,
    /// The joints it names, with the keys that hold them.
    pub joints: Vec<(EcoString, SpannedName)>,
    /// `command_interfaces` of each joint, or `interface_names` of other controllers.
    pub commands: Vec<SpannedName>,
    /// `state_interfaces` of each joint.
    pub states: Vec<SpannedName>,
    /// Whether it has a list of `interfaces`.
    pub has_interfaces: bool,
    /// `interface_name`: the one interface that it commands.
    pub interface: Option<SpannedName>,
    /// Numbers that it names: the key, the value and its place.
    pub numbers: Vec<(EcoString, f64, TextRange)>,
    /// Whether these are parameters of a node of ROS 2.
    pub is_ros2: bool,
}

/// A controller that a controller manager may load.
#[derive(Clone, Debug)]
pub struct Listed {
    /// Its name.
    pub name: SpannedName,
    /// Its class.
    pub class: SpannedName,
    /// Whether its parameters are in a file that the controller manager is given.
    pub has_file: bool,
}

/// The parameters of controllers that hold names of joints.
/// Source: the parameter files of ros2_controllers and the parameters of ros_controllers.
const JOINT_KEYS: [&str; 19] = [
    "joint",
    "joints",
    "extra_joints",
    "command_joints",
    "dof_names",
    "left_wheel",
    "left_wheel_names",
    "right_wheel",
    "right_wheel_names",
    "front_wheels_names",
    "rear_wheels_names",
    "traction_joint_name",
    "steering_joint_name",
    "traction_joints_names",
    "steering_joints_names",
    "front_left_wheel_command_joint_name",
    "front_right_wheel_command_joint_name",
    "rear_left_wheel_command_joint_name",
    "rear_right_wheel_command_joint_name",
];

/// The parameters of controllers that hold names of joints.
pub fn joint_keys() -> &'static [&'static str] {
    &JOINT_KEYS
}

/// The ends of parameters that hold names of joints in controllers of any class.
const JOINT_ENDS: [&str; 4] = ["joints", "joint_name", "joint_names", "joints_names"];

pub(super) fn may_hold_joints(key: &str) -> bool {
    JOINT_KEYS.contains(&key) || JOINT_ENDS.iter().any(|end| key.ends_with(end))
}

impl Controller {
    /// Leave out what only looks like names of joints: the node is no controller that a controller manager lists.
    pub(super) fn keep_known_parameters(&mut self) {
        self.joints
            .retain(|(key, _)| JOINT_KEYS.contains(&key.as_str()));
    }
}

/// Deepest nesting of namespaces above the parameters of a node.
const DEPTH: u32 = 4;

/// Add the controllers below a node, and those that controller managers list.
pub(super) fn read(node: &YamlNode, listed: &mut Vec<Listed>, found: &mut Vec<Controller>) {
    below(node, DEPTH, listed, found);
}

fn below(node: &YamlNode, depth: u32, listed: &mut Vec<Listed>, found: &mut Vec<Controller>) {
    for (key, value) in entries(node) {
        let name = SpannedName {
            name: key.name.rsplit('/').next().unwrap_or_default().into(),
            range: key.range,
        };
        match get(value, "ros__parameters") {
            Some(parameters) if name.name == "controller_manager" => manager(parameters, listed),
            Some(parameters) => found.extend(controller(name, parameters, true)),
            None if is_ros1(value) => found.extend(controller(name, value, false)),
            None if depth > 0 => below(value, depth - 1, listed, found),
            None => {}
        }
    }
}

/// `type: position_controllers/JointTrajectoryController`
fn is_ros1(node: &YamlNode) -> bool {
    text(node, "type").is_some_and(|class| {
        let mut parts = class.name.split('/');
        parts
            .next()
            .is_some_and(|package| package.contains("controller"))
            && parts.count() == 1
    })
}

fn manager(parameters: &YamlNode, listed: &mut Vec<Listed>) {
    let with_class = entries(parameters).filter_map(|(name, value)| {
        let has_file = ["params_file", "params_files"]
            .iter()
            .any(|key| get(value, key).is_some());
        Some(Listed {
            name,
            class: text(value, "type")?,
            has_file,
        })
    });
    listed.extend(with_class);
}

fn controller(name: SpannedName, parameters: &YamlNode, is_ros2: bool) -> Option<Controller> {
    let list = |key: &str| {
        get(parameters, key)
            .map(SpannedName::list)
            .unwrap_or_default()
    };
    let named = entries(parameters).filter(|(key, _)| may_hold_joints(&key.name));
    let joints = named.flat_map(|(key, value)| {
        SpannedName::list(value)
            .into_iter()
            .map(move |name| (key.name.clone(), name))
    });
    let numbers = entries(parameters)
        .filter_map(|(key, value)| Some((key.name, number(value)?.0, value.range)));
    let is_map = matches!(parameters.kind, YamlKind::Map(_));
    is_map.then(|| Controller {
        class: text(parameters, "type"),
        joints: joints.collect(),
        commands: [list("command_interfaces"), list("interface_names")].concat(),
        states: list("state_interfaces"),
        has_interfaces: get(parameters, "interfaces").is_some(),
        interface: text(parameters, "interface_name"),
        numbers: numbers.collect(),
        name,
        is_ros2,
    })
}
