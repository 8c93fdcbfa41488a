//! Joints: types, axes, limits, dynamics, mimic.

mod axis;
mod axis_not_normalized;
mod axis_on_fixed_joint;
mod empty_dynamics;
mod floating_or_planar_joint;
mod joint_limit_degrees;
mod joint_limit_inverted;
pub(super) mod joint_limit_negative;
mod joint_limit_zero_range;
mod joint_naming;
mod joint_velocity_degrees;
mod limit_on_continuous;
mod mimic_chain;
pub(super) mod mimic_cycle;
pub(super) mod mimic_fixed_joint;
pub(super) mod mimic_range_exceeds_limits;
mod mimic_unknown_joint;
mod mimics;
mod missing_axis;
pub(super) mod missing_joint_limit;
pub(super) mod missing_limit_attribute;
mod negative_dynamics;
mod negative_joint_axis;
pub(super) mod safety_limits_outside_limits;
pub(super) mod unknown_joint_type;
mod wheel_axis_direction;
mod wheel_axis_opposed;
mod wheels;
pub(super) mod zero_axis;
mod zero_effort_or_velocity;

use super::rule::Rule;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &unknown_joint_type::RULE,
    &missing_joint_limit::RULE,
    &missing_limit_attribute::RULE,
    &joint_limit_inverted::RULE,
    &joint_limit_zero_range::RULE,
    &joint_limit_degrees::RULE,
    &joint_velocity_degrees::RULE,
    &joint_limit_negative::RULE,
    &zero_effort_or_velocity::RULE,
    &zero_axis::RULE,
    &axis_not_normalized::RULE,
    &axis_on_fixed_joint::RULE,
    &missing_axis::RULE,
    &wheel_axis_opposed::RULE,
    &wheel_axis_direction::RULE,
    &negative_joint_axis::RULE,
    &limit_on_continuous::RULE,
    &empty_dynamics::RULE,
    &negative_dynamics::RULE,
    &safety_limits_outside_limits::RULE,
    &mimic_unknown_joint::RULE,
    &mimic_cycle::RULE,
    &mimic_fixed_joint::RULE,
    &mimic_range_exceeds_limits::RULE,
    &floating_or_planar_joint::RULE,
    &mimic_chain::RULE,
    &joint_naming::RULE,
];
