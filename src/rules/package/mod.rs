//! Packages and files of the workspace.

mod argument_never_set;
mod dependencies;
mod deprecated_xacro_cli;
mod description_package_name;
pub(super) mod description_read_as_yaml;
mod duplicate_transform;
pub(super) mod generated_urdf_out_of_date;
mod installed_file_not_found;
mod invalid_package_name;
mod launch;
mod launched_file_not_found;
mod launched_file_not_installed;
mod launched_without_xacro;
mod malformed_package_xml;
mod manifest;
mod mention;
mod mentions;
mod missing_controller_manager;
mod missing_launch_argument;
pub(super) mod missing_package_dependency;
mod missing_sensors_system;
pub(super) mod package_not_found;
mod resource_not_installed;
mod spawned_controller_not_found;
pub(super) mod unknown_launch_argument;
mod unloadable_hardware;
mod value_never_compared;
mod value_outside_choices;
mod xacro_not_in_package;

use super::rule::Rule;

pub use argument_never_set::argument_never_set;
pub use description_read_as_yaml::{YamlReader, description_read_as_yaml};
pub use duplicate_transform::{looping_transform, repeated_transform};
pub use generated_urdf_out_of_date::generated_urdf_out_of_date;
pub(super) use launch::reads_as_it_stands;
pub use launched_file_not_found::launched_file_not_found;
pub use launched_file_not_installed::launched_file_not_installed;
pub use launched_without_xacro::launched_without_xacro;
pub use manifest::Manifests;
pub(super) use mention::PackageMention;
pub use missing_controller_manager::{Lacking, missing_controller_manager};
pub use missing_launch_argument::missing_launch_argument;
pub use missing_sensors_system::missing_sensors_system;
pub(super) use package_not_found::{RULE as PACKAGE_NOT_FOUND, excuse_find, warn_once};
pub use package_not_found::{missing_packages, own_instead};
pub use spawned_controller_not_found::spawned_controller_not_found;
pub use unknown_launch_argument::unknown_launch_argument;
pub use unloadable_hardware::unloadable_hardware;
pub use value_never_compared::value_never_compared;
pub use value_outside_choices::value_outside_choices;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &package_not_found::RULE,
    &missing_package_dependency::RULE,
    &resource_not_installed::RULE,
    &invalid_package_name::RULE,
    &xacro_not_in_package::RULE,
    &description_package_name::RULE,
    &deprecated_xacro_cli::RULE,
    &malformed_package_xml::RULE,
    &unknown_launch_argument::RULE,
    &launched_file_not_found::RULE,
    &launched_without_xacro::RULE,
    &generated_urdf_out_of_date::RULE,
    &missing_launch_argument::RULE,
    &value_outside_choices::RULE,
    &value_never_compared::RULE,
    &argument_never_set::RULE,
    &description_read_as_yaml::RULE,
    &duplicate_transform::RULE,
    &installed_file_not_found::RULE,
    &spawned_controller_not_found::RULE,
    &unloadable_hardware::RULE,
    &launched_file_not_installed::RULE,
    &missing_controller_manager::RULE,
    &missing_sensors_system::RULE,
];
