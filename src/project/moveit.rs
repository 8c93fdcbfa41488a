//! Settings of MoveIt: controllers, limits of joints, kinematics, planners, and what the setup assistant wrote down.

use super::cursor::GROUP_KEYS;
use super::value::{SpannedName, entries, get, number, text};
use base::TextRange;
use yaml::YamlNode;

/// A controller as MoveIt knows it.
#[derive(Clone, Debug)]
pub struct MoveitController {
    /// Its name.
    pub name: SpannedName,
    /// Its joints.
    pub joints: Vec<SpannedName>,
    /// The action that it takes: `FollowJointTrajectory`, or one for grippers.
    pub action: Option<SpannedName>,
}

impl MoveitController {
    /// Whether it takes commands for a gripper, not trajectories.
    pub fn is_gripper(&self) -> bool {
        let action = self.action.as_ref();
        action.is_some_and(|action| action.name == "GripperCommand")
    }
}

/// The limits of a joint.
#[derive(Clone, Debug)]
pub struct JointLimit {
    /// The joint.
    pub joint: SpannedName,
    /// Numbers: the key, the value, whether it is written as an integer, and its place.
    pub values: Vec<(SpannedName, f64, bool, TextRange)>,
    /// Keys that say whether a limit holds, and whether it does.
    pub switches: Vec<(SpannedName, bool)>,
}

impl JointLimit {
    /// Whether a limit holds: `has_velocity_limits` is true.
    pub fn has(&self, switch: &str) -> bool {
        self.switches
            .iter()
            .any(|(name, on)| name.name == switch && *on)
    }

    /// A number: its value and its place.
    pub fn value(&self, key: &str) -> Option<(f64, TextRange)> {
        self.values
            .iter()
            .find(|(name, ..)| name.name == key)
            .map(|(_, value, _, place)| (*value, *place))
    }
}

/// What `.setup_assistant` says: the files of a robot.
#[derive(Clone, Debug)]
pub struct Assistant {
    /// The package of the description.
    pub package: Option<SpannedName>,
    /// The path of the description in this package.
    pub urdf: Option<SpannedName>,
    /// The arguments of the description, as on the command line of xacro.
    pub arguments: Option<SpannedName>,
    /// The path of the SRDF in the package of this file.
    pub srdf: Option<SpannedName>,
}

impl Assistant {
    pub(super) fn of(root: &YamlNode) -> Option<Self> {
        let config = get(root, "moveit_setup_assistant_config")?;
        let urdf = get(config, "URDF").or_else(|| get(config, "urdf"));
        let srdf = get(config, "SRDF").or_else(|| get(config, "srdf"));
        Some(Self {
            package: filled(urdf, "package"),
            urdf: filled(urdf, "relative_path"),
            arguments: filled(urdf, "xacro_args"),
            srdf: filled(srdf, "relative_path"),
        })
    }

    /// The arguments by name.
    pub fn given(&self) -> Vec<(String, String)> {
        let words = self
            .arguments
            .iter()
            .flat_map(|text| text.name.split_whitespace());
        words
            .filter_map(|word| word.split_once(":="))
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .collect()
    }
}

/// A text that is not empty.
fn filled(node: Option<&YamlNode>, key: &str) -> Option<SpannedName> {
    text(node?, key).filter(|text| !text.name.is_empty())
}

/// The node that holds settings which launch files put below one of these keys: the file itself, or what is below the key.
fn inside<'n>(root: &'n YamlNode, keys: &[&str]) -> &'n YamlNode {
    let mut node = root;
    for key in keys {
        node = get(node, key).unwrap_or(node);
    }
    node
}

const NODE: [&str; 2] = ["/**", "ros__parameters"];

/// The controllers of `moveit_simple_controller_manager` and of `controller_list`.
pub(super) fn controllers(root: &YamlNode) -> Vec<MoveitController> {
    let top = inside(root, &NODE);
    let mut found = Vec::new();
    let own = get(top, "moveit_simple_controller_manager");
    // a list beside the manager's own is not read
    for manager in [own.is_none().then_some(top), own].into_iter().flatten() {
        let names = get(manager, "controller_names")
            .map(SpannedName::list)
            .unwrap_or_default();
        for name in names {
            let own = get(manager, &name.name);
            found.push(controller(name, own));
        }
        if let Some(YamlNode {
            kind: yaml::YamlKind::List(items),
            ..
        }) = get(manager, "controller_list")
        {
            found.extend(
                items
                    .iter()
                    .filter_map(|item| Some(controller(text(item, "name")?, Some(item)))),
            );
        }
    }
    found
}

fn controller(name: SpannedName, parameters: Option<&YamlNode>) -> MoveitController {
    let joints = parameters
        .and_then(|own| get(own, "joints"))
        .map(SpannedName::list)
        .unwrap_or_default();
    MoveitController {
        name,
        joints,
        action: parameters.and_then(|own| text(own, "type")),
    }
}

/// The limits of joints.
pub(super) fn limits(root: &YamlNode) -> Vec<JointLimit> {
    const WORDS: [&str; 6] = [
        "has_velocity_limits",
        "has_acceleration_limits",
        "has_position_limits",
        "has_jerk_limits",
        "max_velocity",
        "max_acceleration",
    ];
    let top = inside(root, &[NODE[0], NODE[1], "robot_description_planning"]);
    let Some(limits) = get(top, "joint_limits") else {
        return Vec::new();
    };
    let own =
        entries(limits).filter(|(_, value)| WORDS.iter().any(|word| get(value, word).is_some()));
    own.map(|(joint, value)| JointLimit {
        joint,
        values: entries(value)
            .filter_map(|(key, value)| {
                number(value).map(|(number, int)| (key, number, int, value.range))
            })
            .collect(),
        switches: entries(value)
            .filter_map(|(key, value)| match value.kind {
                yaml::YamlKind::Bool(on) => Some((key, on)),
                _ => None,
            })
            .collect(),
    })
    .collect()
}

/// The groups that have a solver for inverse kinematics.
pub(super) fn kinematics(root: &YamlNode) -> Vec<SpannedName> {
    let top = inside(root, &[NODE[0], NODE[1], "robot_description_kinematics"]);
    entries(top)
        .filter(|(_, value)| get(value, "kinematics_solver").is_some())
        .map(|(name, _)| name)
        .collect()
}

/// The names of the configurations of planners.
pub fn planner_names(root: &YamlNode) -> Vec<SpannedName> {
    let top = inside(root, &[NODE[0], NODE[1], "ompl"]);
    get(top, "planner_configs")
        .into_iter()
        .flat_map(entries)
        .map(|(name, _)| name)
        .collect()
}

/// The groups that parameters of MoveIt Servo name.
pub(super) fn servo(root: &YamlNode) -> Vec<SpannedName> {
    let mut open = vec![(root, 4u32)];
    let mut found = Vec::new();
    while let Some((node, depth)) = open.pop() {
        // other nodes have a parameter of this name, too; only Servo has frames for the commands
        if ["robot_link_command_frame", "command_in_type"]
            .iter()
            .any(|key| get(node, key).is_some())
        {
            found.extend(GROUP_KEYS.iter().filter_map(|key| text(node, key)));
        }
        open.extend(
            entries(node)
                .filter(|_| depth > 0)
                .map(|(_, value)| (value, depth - 1)),
        );
    }
    found.retain(|name| !name.name.is_empty());
    found
}

/// The groups that have planners.
pub(super) fn planners(root: &YamlNode) -> Vec<SpannedName> {
    let top = inside(root, &[NODE[0], NODE[1], "ompl"]);
    if get(top, "planner_configs").is_none() {
        return Vec::new();
    }
    let keys = [
        "planner_configs",
        "default_planner_config",
        "projection_evaluator",
    ];
    entries(top)
        .filter(|(name, _)| name.name != "planner_configs")
        .filter(|(_, value)| keys.iter().any(|key| get(value, key).is_some()))
        .map(|(name, _)| name)
        .collect()
}
