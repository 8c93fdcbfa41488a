//! The joints and interfaces that the hardware of a robot offers to controllers.
use super::super::beside::{BesideCx, PairedRobot};
use super::ros2_control_unknown_interface::is_misspelled;
use super::ros2_control_unknown_tag::is_misread_in_joint;
use base::{FastMap, FastSet};
use model::{AttrValue, ControlJoint, Interface, Ros2Control};

/// Interfaces that the hardware of Gazebo exports under the name of another one, and controls by itself.
/// Source: `gazebo_system.cpp` of gazebo_ros2_control 0.6.
const WITH_GAINS: [(&str, &str); 2] = [("position_pid", "position"), ("velocity_pid", "velocity")];

/// The joints of all `<ros2_control>` of the robots.
pub(super) struct HardwareJoints<'a> {
    joints: FastMap<&'a str, Vec<&'a ControlJoint>>,
    /// The joints of blocks that declare no interface for commands: some hardware offers what it does not declare.
    undeclared: FastSet<&'a str>,
    /// The joints of blocks that declare no interface at all.
    unsaid: FastSet<&'a str>,
    /// Whether all joints are here: each robot has hardware, and none is left out.
    pub is_complete: bool,
}

impl<'a> HardwareJoints<'a> {
    /// None where no robot has hardware, or not all names are known. A joint with a mistake of its own is left out: what it
    /// offers is not what was meant. A robot without hardware offers controllers nothing.
    pub fn of(cx: &BesideCx<'a>) -> Option<Self> {
        Self::of_robots(cx.robots)
    }

    /// The same for some robots.
    pub fn of_robots(robots: &'a [PairedRobot<'a>]) -> Option<Self> {
        let mut found = Self {
            joints: FastMap::default(),
            undeclared: FastSet::default(),
            unsaid: FastSet::default(),
            is_complete: true,
        };
        for paired in robots {
            found.add(paired)?;
        }
        (!found.joints.is_empty()).then_some(found)
    }

    /// Add the hardware of a robot; none when a name in it is unknown.
    fn add(&mut self, paired: &'a PairedRobot<'a>) -> Option<()> {
        let mistaken = mistaken(paired);
        let controls = &paired.robot.controls;
        self.is_complete &=
            mistaken.is_empty() && controls.iter().any(|control| !control.joints.is_empty());
        for control in controls {
            let is_silent = control.joints.iter().all(|joint| joint.commands.is_empty());
            let is_undeclared = is_silent && !offers_only_declared(paired, control);
            let is_unsaid =
                is_undeclared && control.joints.iter().all(|joint| joint.states.is_empty());
            for joint in &control.joints {
                let named = |interface: &Interface| {
                    interface.name.as_ref().is_some_and(|name| name.is_known())
                };
                let name = joint.name.as_ref()?.name()?.as_str();
                if !joint.interfaces().all(named) {
                    return None;
                }
                if is_undeclared {
                    self.undeclared.insert(name);
                }
                if is_unsaid {
                    self.unsaid.insert(name);
                }
                if !mistaken.contains(name) {
                    self.joints.entry(name).or_default().push(joint);
                }
            }
        }
        Some(())
    }

    /// Whether a joint is there.
    pub fn has(&self, joint: &str) -> bool {
        self.joints.contains_key(joint)
    }

    /// Whether a joint is there, and does not offer an interface.
    pub fn lacks(&self, joint: &str, interface: &str, is_command: bool) -> bool {
        let undeclared = if is_command {
            &self.undeclared
        } else {
            &self.unsaid
        };
        let is_declared = !undeclared.contains(joint);
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
        AttrValue::content(tree, plugin)
            .is_some_and(|class| ONLY_DECLARED.contains(&class.value.trim()))
    })
}

/// The joints of the hardware with a mistake that other rules report: the robot does not have it, it is there twice, an element or
/// an interface is misspelled.
fn mistaken<'a>(paired: &PairedRobot<'a>) -> FastSet<&'a str> {
    let mut found = FastSet::default();
    for control in &paired.robot.controls {
        let mut seen = FastSet::default();
        for joint in &control.joints {
            let Some(name) = joint.name.as_ref().and_then(|name| name.name()) else {
                continue;
            };
            let is_again = !seen.insert(name.as_str());
            if is_again || paired.robot.joint(name).is_none() || is_misread(paired, joint) {
                found.insert(name.as_str());
            }
        }
    }
    found
}

/// Whether a name in a joint of the hardware is misspelled, or an element stayed that xacro should have replaced.
fn is_misread(paired: &PairedRobot<'_>, joint: &ControlJoint) -> bool {
    let tree = &paired.expansion.tree;
    let mut names = joint
        .interfaces()
        .filter_map(|interface| interface.name.as_ref()?.name());
    names.any(|name| is_misspelled(name))
        || tree
            .elements(joint.element)
            .any(|tag| is_misread_in_joint(&tree.get(tag).text))
}
