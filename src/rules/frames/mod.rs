//! Frames and orientations.

mod approximate_pi;
mod base_footprint_tilted;
mod base_link_tilted;
mod base_not_fixed;
mod flange_tool0_offset;
mod frame_has_geometry;
mod imu_frame_name;
mod missing_base_frame;
mod missing_base_link;
mod missing_tool0;
mod multi_axis_rpy;
mod names;
mod optical_frame_orientation;
mod origin_units_mm;
mod poses;
pub(super) mod reserved_frame_name;
mod root_not_conventional;
mod rpy_degrees;
mod tool0_not_fixed;
mod tool_frame_name;
mod two_rotations;

use super::rule::Rule;
pub(super) use origin_units_mm::Distances;
pub use poses::ElementPose;
pub(super) use poses::{pose_of_joint, poses_of_link};

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &rpy_degrees::RULE,
    &approximate_pi::RULE,
    &origin_units_mm::RULE,
    &optical_frame_orientation::RULE,
    &reserved_frame_name::RULE,
    &tool0_not_fixed::RULE,
    &base_not_fixed::RULE,
    &frame_has_geometry::RULE,
    &tool_frame_name::RULE,
    &base_footprint_tilted::RULE,
    &missing_tool0::RULE,
    &missing_base_frame::RULE,
    &missing_base_link::RULE,
    &multi_axis_rpy::RULE,
    &flange_tool0_offset::RULE,
    &imu_frame_name::RULE,
    &root_not_conventional::RULE,
    &two_rotations::RULE,
    &base_link_tilted::RULE,
];
