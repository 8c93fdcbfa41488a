//! The joints and interfaces that the hardware of a robot offers to controllers.
use super::super::beside::{BesideCx, PairedRobot};
use super::ros2_control_unknown_interface::is_misspelled;
use super::ros2_control_unknown_tag::is_known_in_joint;
use base::{FastMap, FastSet};
use model::{ControlJoint, Interface, Ros2Control, Text};

/// Interfaces that the hardware of Gazebo exports under the name of another one, and controls by itself.
/// Source: `gazebo_system.cpp` of gazebo_ros2_control 0.6.
const WITH_GAINS: [(&str, &str); 2] = [("position_pid", "position"), ("velocity_pid", "velocity")];

/// The joints of all `<ros2_control>` of the robots.
pub(super) struct Hardware<'a> {
    joints: FastMap<&'a str, Vec<&'a ControlJoint>>,
    /// The joints of blocks that declare no interface for commands: some hardware offers what it does not declare.
    undeclared: FastSet<&'a str>,
}

impl<'a> Hardware<'a> {
    /// None where a robot has no hardware, not all names are known, or the hardware has a mistake of its own: what it offers
    /// is not what was meant then.
    pub fn of(cx: &BesideCx<'a>) -> Option<Self> {
        let mut joints: FastMap<&str, Vec<&ControlJoint>> = FastMap::default();
        let mut undeclared = FastSet::default();
        for paired in cx.robots {
            for control in &paired.robot.controls {
                let is_silent = control.joints.iter().all(|joint| joint.commands.is_empty());
                if is_silent && !offers_only_declared(paired, control) {
                    undeclared.extend(
                        control
                            .joints
                            .iter()
                            .filter_map(|joint| Some(joint.name.as_ref()?.name()?.as_str())),
                    );
                }
            }
            let listed: Vec<&ControlJoint> = paired
                .robot
                .controls
                .iter()
                .flat_map(|control| &control.joints)
                .collect();
            if listed.is_empty() || has_mistake(paired) {
                return None;
            }
            for joint in listed {
                let named = |interface: &Interface| {
                    interface.name.as_ref().is_some_and(|name| name.is_known())
                };
                if !joint.interfaces().all(named) {
                    return None;
                }
                joints
                    .entry(joint.name.as_ref()?.name()?.as_str())
                    .or_default()
                    .push(joint);
            }
        }
        Some(Self { joints, undeclared })
    }

    /// Whether a joint is there.
    pub fn has(&self, joint: &str) -> bool {
        self.joints.contains_key(joint)
    }

    /// Whether a joint is there, and does not offer an interface.
    pub fn lacks(&self, joint: &str, interface: &str, is_command: bool) -> bool {
        let is_declared = !is_command || !self.undeclared.contains(joint);
        is_declared && self.has(joint) && !self.offered(joint, is_command).contains(&interface)
    }

    /// The interfaces that a joint offers.
    pub fn offered(&self, joint: &str, is_command: bool) -> Vec<&'a str> {
        let listed = self.joints.get(joint).into_iter().flatten();
        let interfaces = listed.flat_map(|joint| {
            if is_command {
                &joint.commands
            } else {
                &joint.states
            }
        });
        let names =
            interfaces.filter_map(|interface| Some(interface.name.as_ref()?.value.as_str()));
        names
            .map(|name| {
                WITH_GAINS
                    .iter()
                    .find(|(own, _)| *own == name)
                    .map_or(name, |(_, as_)| as_)
            })
            .collect()
    }
}

/// Hardware that offers the declared interfaces and no others: the mocks of ros2_control, and simulators.
/// Source: the classes themselves; they go through the interfaces of the description.
const ONLY_DECLARED: [&str; 5] = [
    "mock_components/GenericSystem",
    "fake_components/GenericSystem",
    "gz_ros2_control/GazeboSimSystem",
    "ign_ros2_control/IgnitionSystem",
    "gazebo_ros2_control/GazeboSystem",
];

fn offers_only_declared(paired: &PairedRobot<'_>, control: &Ros2Control) -> bool {
    let tree = &paired.expansion.tree;
    let plugins = control
        .hardware
        .iter()
        .flat_map(|&hardware| tree.elements(hardware));
    let mut plugins = plugins.filter(|&child| tree.get(child).text == "plugin");
    plugins.any(|plugin| {
        Text::content(tree, plugin).is_some_and(|class| ONLY_DECLARED.contains(&class.value.trim()))
    })
}

/// Whether the hardware has a mistake that other rules report: a joint that the robot lacks, a joint twice, a misspelled
/// element or interface.
fn has_mistake(paired: &PairedRobot<'_>) -> bool {
    let is_unknown = |joint: &&ControlJoint| {
        joint
            .name
            .as_ref()
            .and_then(|name| name.name())
            .is_some_and(|name| paired.robot.joint(name).is_none())
    };
    let tree = &paired.expansion.tree;
    let is_misread = |joint: &&ControlJoint| {
        let names = joint
            .interfaces()
            .filter_map(|interface| interface.name.as_ref()?.name());
        names.into_iter().any(|name| is_misspelled(name))
            || tree
                .elements(joint.element)
                .any(|tag| !is_known_in_joint(&tree.get(tag).text))
    };
    let is_wrong = |control: &Ros2Control| {
        let mut seen = FastSet::default();
        let names = control
            .joints
            .iter()
            .filter_map(|joint| joint.name.as_ref()?.name());
        names.into_iter().any(|name| !seen.insert(name))
            || control
                .joints
                .iter()
                .any(|joint| is_unknown(&joint) || is_misread(&joint))
    };
    paired.robot.controls.iter().any(is_wrong)
}
