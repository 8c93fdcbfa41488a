//! The files beside a robot that name its links and joints: its semantic description (SRDF), and YAML files for
//! controllers and MoveIt. Each reader gives the names with the text that says them; what names mean is for rules.

mod controllers;
mod cursor;
mod members;
mod moveit;
mod settings;
mod srdf;
mod steps;
#[cfg(test)]
mod tests;
mod value;

pub use controllers::{Controller, Listed, joint_keys};
pub use cursor::{ExpectedName, TypedWord, word_at};
pub use members::joints_of_group;
pub use moveit::{Assistant, JointLimit, MoveitController, planner_names};
pub use settings::{YamlSettings, may_be_settings};
pub use srdf::{Chain, CollisionPair, EndEffector, GroupState, PlanningGroup, Srdf, VirtualJoint};
pub use value::SpannedName;

use ecow::EcoString;

/// What a name in a file beside the robot is the name of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ProjectNameKind {
    /// A link of the robot.
    Link,
    /// A joint of the robot.
    Joint,
    /// A planning group of its SRDF.
    Group,
}

/// Whether a name is put together when the file is read by something else, as `$(var prefix)joint_1` is: nothing is
/// known of it.
pub fn is_computed(name: &str) -> bool {
    name.contains(['$', '{', '<']) || name.is_empty()
}

/// The joint part of a name of an interface, `joint_1/position`, or of a plain joint.
pub fn joint_of(name: &EcoString) -> &str {
    name.split('/').next().unwrap_or(name)
}
