//! Settings of MoveIt, compared with the robot and its SRDF.

mod groups;
mod joint_limits_above_urdf;
mod joint_limits_not_double;
mod joint_limits_unknown_joint;
mod kinematics_unknown_group;
mod moveit_controller_unknown_joint;
mod moveit_unknown_controller;
mod planning_unknown_group;

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[
    joint_limits_unknown_joint::RULE,
    joint_limits_above_urdf::RULE,
    joint_limits_not_double::RULE,
    kinematics_unknown_group::RULE,
    planning_unknown_group::RULE,
    moveit_controller_unknown_joint::RULE,
    moveit_unknown_controller::RULE,
];
