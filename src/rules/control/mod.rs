//! ros2_control, transmissions and Gazebo.

mod controller_joint_without_hardware;
pub(super) mod controller_unknown_interface;
pub(super) mod controller_unknown_joint;
mod controller_wheel_mismatch;
mod controller_wheels_exchanged;
pub(super) mod controller_without_parameters;
mod gazebo_classic_plugin;
pub(super) mod gazebo_link_settings_on_joint;
mod gazebo_lumped_reference;
pub(super) mod gazebo_missing_reference;
mod gazebo_plugin_missing_filename;
mod gazebo_ros;
pub(super) mod gazebo_unknown_element;
pub(super) mod gazebo_unknown_material;
pub(super) mod gazebo_unknown_reference;
mod hardware;
mod joints;
mod misspelled_plugin;
pub(super) mod plugin_file_not_found;
mod plugin_parameters;
pub(super) mod plugin_unknown_frame;
pub(super) mod plugin_unknown_joint;
pub(super) mod plugin_wheel_mismatch;
pub(super) mod plugin_wheels_exchanged;
mod plugins;
pub(super) mod ros1_gazebo_plugin;
pub(super) mod ros1_plugin_parameter;
pub(super) mod ros2_control_duplicate_joint;
pub(super) mod ros2_control_duplicate_name;
mod ros2_control_fixed_joint;
mod ros2_control_initial_value_out_of_limits;
mod ros2_control_invalid_type;
mod ros2_control_limits_mismatch;
mod ros2_control_mimic_command;
mod ros2_control_missing_plugin;
mod ros2_control_no_interfaces;
mod ros2_control_param_nonpositive_size;
mod ros2_control_plugin_mismatch;
mod ros2_control_unknown_interface;
mod ros2_control_unknown_joint;
mod ros2_control_unknown_tag;
mod sdf;
pub(super) mod sdf_surface;
pub(super) mod sensor_outside_gazebo;
pub(super) mod sensor_without_frame;
pub(super) mod transmission_missing_actuator;
pub(super) mod transmission_missing_hardware_interface;
pub(super) mod transmission_unknown_joint;
pub(super) mod transmission_unknown_type;
mod transmissions;
pub(super) mod unknown_plugin_parameter;
mod wheel_sizes;

use super::rule::Rule;
pub(crate) use joints::range as limits_of;
pub(crate) use plugin_unknown_joint::driven;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &ros2_control_unknown_joint::RULE,
    &ros2_control_missing_plugin::RULE,
    &ros2_control_unknown_interface::RULE,
    &ros2_control_fixed_joint::RULE,
    &ros2_control_invalid_type::RULE,
    &ros2_control_duplicate_name::RULE,
    &ros2_control_duplicate_joint::RULE,
    &ros2_control_mimic_command::RULE,
    &ros2_control_initial_value_out_of_limits::RULE,
    &ros2_control_limits_mismatch::RULE,
    &ros2_control_no_interfaces::RULE,
    &transmission_unknown_joint::RULE,
    &transmission_missing_hardware_interface::RULE,
    &gazebo_unknown_reference::RULE,
    &gazebo_lumped_reference::RULE,
    &gazebo_plugin_missing_filename::RULE,
    &ros2_control_param_nonpositive_size::RULE,
    &gazebo_classic_plugin::RULE,
    &ros2_control_unknown_tag::RULE,
    &gazebo_missing_reference::RULE,
    &plugin_file_not_found::RULE,
    &transmission_missing_actuator::RULE,
    &transmission_unknown_type::RULE,
    &misspelled_plugin::RULE,
    &controller_unknown_joint::RULE,
    &controller_joint_without_hardware::RULE,
    &controller_unknown_interface::RULE,
    &controller_without_parameters::RULE,
    &plugin_unknown_joint::RULE,
    &ros1_gazebo_plugin::RULE,
    &ros1_plugin_parameter::RULE,
    &plugin_wheel_mismatch::RULE,
    &controller_wheel_mismatch::RULE,
    &gazebo_link_settings_on_joint::RULE,
    &sdf_surface::RULE,
    &plugin_unknown_frame::RULE,
    &plugin_wheels_exchanged::RULE,
    &controller_wheels_exchanged::RULE,
    &ros2_control_plugin_mismatch::RULE,
    &unknown_plugin_parameter::RULE,
    &sensor_outside_gazebo::RULE,
    &gazebo_unknown_element::RULE,
    &gazebo_unknown_material::RULE,
    &sensor_without_frame::RULE,
];
