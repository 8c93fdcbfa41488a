//! Semantic descriptions (SRDF): groups, states and collision pairs, compared with the robot.

mod adjacent;
mod joints;
mod srdf_adjacent_pair_missing;
mod srdf_duplicate_name;
mod srdf_duplicate_pair;
mod srdf_incomplete_group_state;
mod srdf_invalid_chain;
mod srdf_not_adjacent;
pub(super) mod srdf_robot_name;
mod srdf_state_joint_not_in_group;
mod srdf_state_out_of_limits;
mod srdf_unknown_element;
pub(super) mod srdf_unknown_group;
mod srdf_unknown_joint;
pub(super) mod srdf_unknown_link;

use super::rule::Rule;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &srdf_robot_name::RULE,
    &srdf_unknown_link::RULE,
    &srdf_unknown_joint::RULE,
    &srdf_unknown_group::RULE,
    &srdf_invalid_chain::RULE,
    &srdf_state_out_of_limits::RULE,
    &srdf_state_joint_not_in_group::RULE,
    &srdf_incomplete_group_state::RULE,
    &srdf_duplicate_name::RULE,
    &srdf_duplicate_pair::RULE,
    &srdf_not_adjacent::RULE,
    &srdf_adjacent_pair_missing::RULE,
    &srdf_unknown_element::RULE,
];
