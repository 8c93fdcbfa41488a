//! Settings of MoveIt, compared with the robot and its SRDF.

mod groups;
mod joint_limits_above_urdf;
mod joint_limits_not_double;
mod joint_limits_unknown_joint;
pub(super) mod kinematics_unknown_group;
mod moveit_controller_action;
mod moveit_controller_unknown_joint;
pub(super) mod moveit_unknown_controller;
mod namespace;
mod planning_unknown_group;
mod servo_unknown_group;
mod setup_assistant_file_not_found;
mod setup_assistant_robot_fails;
mod setup_assistant_unknown_argument;

use super::rule::Rule;

pub use setup_assistant_file_not_found::setup_assistant_file_not_found;
pub use setup_assistant_robot_fails::setup_assistant_robot_fails;
pub use setup_assistant_unknown_argument::setup_assistant_unknown_argument;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &joint_limits_unknown_joint::RULE,
    &joint_limits_above_urdf::RULE,
    &joint_limits_not_double::RULE,
    &kinematics_unknown_group::RULE,
    &planning_unknown_group::RULE,
    &moveit_controller_unknown_joint::RULE,
    &moveit_unknown_controller::RULE,
    &servo_unknown_group::RULE,
    &setup_assistant_file_not_found::RULE,
    &setup_assistant_robot_fails::RULE,
    &setup_assistant_unknown_argument::RULE,
    &moveit_controller_action::RULE,
];
