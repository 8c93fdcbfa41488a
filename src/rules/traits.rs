//! What several rules have in common, for those who treat their findings alike.
use super::grouping::Group;
use super::rule::{Rule, Severity};
use super::{
    control, conventions, geometry, inertia, joint, linter, package, structure, xacro, xml,
};

/// Something that a rule is or is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trait {
    /// Something is written that nothing needs: editors show it faded.
    Unnecessary,
    /// An old way to write it: editors strike it through.
    Deprecated,
    /// About collisions, which a robot that is only shown does not need.
    Contact,
    /// About what simulators and planners do, which a robot that is only shown does not need.
    Simulation,
    /// About what only Gazebo reads.
    Gazebo,
    /// About plugins for Gazebo Classic, which nothing loads where it does not run.
    GazeboClassic,
    /// About transmissions, which only controllers read, and simulators that run some.
    Transmission,
    /// urdfdom rejects it, and Bullet accepts or ignores it. Source: `UrdfParser.cpp` of Bullet 3.25, and loading with PyBullet.
    AcceptedByBullet,
    /// urdfdom rejects it, and RaiSim accepts it: vectors with commas, joints without limits, spherical joints, a material twice.
    /// Source: `RaiSimTinyXmlWrapper.hpp` and `loaders.hpp` of RaiSim, and its documentation of joints.
    AcceptedByRaiSim,
    /// A mass or an inertia is below zero, which nobody means.
    WrongSign,
    /// About what a controller of the parameters moves.
    Controller,
    /// More of a robot is there after its fix, which may have errors of its own: texts that could not be parsed, tags and files
    /// that were missing or meant nothing.
    Reveals,
    /// About structure and syntax: two findings are two defects, even where the text is the same.
    EachPlace,
    /// Below errors, and about names or texts: what is written alike is repaired alike.
    ByText,
    /// Its errors are about values: the program that wrote one of them wrote all of them.
    ByFile,
}

static UNNECESSARY: [&Rule; 7] = [
    &xacro::unused_arg::RULE,
    &xacro::unused_include::RULE,
    &xacro::unused_macro::RULE,
    &xacro::unused_macro_param::RULE,
    &geometry::unused_material::RULE,
    &xacro::unused_property::RULE,
    &linter::unused_suppression::RULE,
];

static DEPRECATED: [&Rule; 4] = [
    &xacro::unprefixed_xacro_tag::RULE,
    &xacro::unprefixed_macro_call::RULE,
    &xacro::found::DEPRECATED_BUILTIN_CALL,
    &xml::nonstandard_xacro_namespace::RULE,
];

static CONTACT: [&Rule; 3] = [
    &geometry::collision_mesh_too_detailed::RULE,
    &geometry::collision_origin_mismatch::RULE,
    &geometry::mesh_inconsistent_normals::RULE,
];

static SIMULATION: [&Rule; 10] = [
    &control::gazebo_link_settings_on_joint::RULE,
    &control::gazebo_unknown_element::RULE,
    &control::gazebo_unknown_material::RULE,
    &control::gazebo_unknown_reference::RULE,
    &control::plugin_unknown_frame::RULE,
    &control::sdf_surface::RULE,
    &control::sensor_outside_gazebo::RULE,
    &control::sensor_without_frame::RULE,
    &control::unknown_plugin_parameter::RULE,
    &joint::mimic_range_exceeds_limits::RULE,
];

static GAZEBO: [&Rule; 14] = [
    &control::gazebo_link_settings_on_joint::RULE,
    &control::gazebo_missing_reference::RULE,
    &control::gazebo_unknown_element::RULE,
    &control::gazebo_unknown_material::RULE,
    &control::sdf_surface::RULE,
    &control::sensor_outside_gazebo::RULE,
    &control::sensor_without_frame::RULE,
    &control::gazebo_unknown_reference::RULE,
    &control::plugin_file_not_found::RULE,
    &control::plugin_unknown_frame::RULE,
    &control::plugin_unknown_joint::RULE,
    &control::plugin_wheel_mismatch::RULE,
    &control::plugin_wheels_exchanged::RULE,
    &control::unknown_plugin_parameter::RULE,
];

static GAZEBO_CLASSIC: [&Rule; 2] = [
    &control::ros1_gazebo_plugin::RULE,
    &control::ros1_plugin_parameter::RULE,
];

static TRANSMISSION: [&Rule; 4] = [
    &control::transmission_missing_actuator::RULE,
    &control::transmission_missing_hardware_interface::RULE,
    &control::transmission_unknown_joint::RULE,
    &control::transmission_unknown_type::RULE,
];

static CONTROLLER: [&Rule; 2] = [
    &control::controller_unknown_interface::RULE,
    &control::controller_unknown_joint::RULE,
];

static WRONG_SIGN: [&Rule; 2] = [
    &inertia::inertia_not_positive_definite::RULE,
    &inertia::negative_mass::RULE,
];

static ACCEPTED_BY_BULLET: [&Rule; 12] = [
    &geometry::duplicate_material::RULE,
    &xml::invalid_number::RULE,
    &xml::missing_attribute::RULE,
    &joint::mimic_fixed_joint::RULE,
    &joint::mimic_range_exceeds_limits::RULE,
    &joint::missing_limit_attribute::RULE,
    &xml::missing_robot_name::RULE,
    &geometry::undefined_material::RULE,
    &geometry::unknown_geometry_type::RULE,
    &joint::unknown_joint_type::RULE,
    &xml::wrong_vector_length::RULE,
    &inertia::zero_mass::RULE,
];

static ACCEPTED_BY_RAISIM: [&Rule; 6] = [
    &geometry::duplicate_material::RULE,
    &xml::invalid_number::RULE,
    &joint::missing_joint_limit::RULE,
    &joint::missing_limit_attribute::RULE,
    &geometry::undefined_material::RULE,
    &joint::unknown_joint_type::RULE,
];

static REVEALS: [&Rule; 12] = [
    &xml::xml_syntax_error::RULE,
    &xml::missing_xacro_namespace::RULE,
    &xml::inconsistent_xacro_prefix::RULE,
    &xml::unknown_element::RULE,
    &xacro::found::UNDEFINED_MACRO,
    &xacro::include_not_found::RULE,
    &xacro::found::INCLUDE_CYCLE,
    &xacro::redefined_macro::RULE,
    &xacro::unprefixed_xacro_tag::RULE,
    &xacro::unprefixed_macro_call::RULE,
    &xacro::found::MISSING_XACRO_ATTRIBUTE,
    &package::package_not_found::RULE,
];

static EACH_PLACE: [&Rule; 27] = [
    &structure::duplicate_geometry_name::RULE,
    &structure::duplicate_joint_name::RULE,
    &structure::duplicate_link_name::RULE,
    &geometry::duplicate_material::RULE,
    &conventions::empty_name::RULE,
    &xacro::found::INCLUDE_CYCLE,
    &xacro::found::INFINITE_MACRO_RECURSION,
    &linter::invalid_config::RULE,
    &xacro::found::INVALID_EXPRESSION,
    &structure::joint_self_loop::RULE,
    &structure::link_cycle::RULE,
    &xacro::found::MACRO_BLOCK_MISMATCH,
    &linter::malformed_suppression::RULE,
    &joint::mimic_cycle::RULE,
    &xacro::missing_macro_param::RULE,
    &xacro::found::MISSING_XACRO_ATTRIBUTE,
    &structure::multiple_parents::RULE,
    &structure::multiple_roots::RULE,
    &structure::names_differ_by_case::RULE,
    &structure::no_links::RULE,
    &structure::orphan_link::RULE,
    &xacro::found::PROPERTY_CYCLE,
    &control::ros2_control_duplicate_name::RULE,
    &xacro::found::UNCLOSED_EXPRESSION,
    &structure::undefined_link::RULE,
    &linter::unused_suppression::RULE,
    &xml::xml_syntax_error::RULE,
];

static BY_TEXT: [&Rule; 16] = [
    &xml::duplicate_element::RULE,
    &xacro::duplicate_include::RULE,
    &xacro::found::GLOB_INCLUDE_NO_MATCH,
    &conventions::invalid_name::RULE,
    &xacro::found::MACRO_NAME_WITH_PREFIX,
    &xacro::redefined_macro::RULE,
    &xacro::redefined_property::RULE,
    &xacro::shadowed_builtin::RULE,
    &xml::unexpected_text::RULE,
    &linter::unknown_rule_in_suppression::RULE,
    &xacro::unknown_xacro_attribute::RULE,
    &xacro::unused_arg::RULE,
    &xacro::unused_include::RULE,
    &xacro::unused_macro::RULE,
    &xacro::unused_macro_param::RULE,
    &xacro::unused_property::RULE,
];

static BY_FILE: [&Rule; 3] = [
    &inertia::inertia_not_positive_definite::RULE,
    &joint::joint_limit_negative::RULE,
    &geometry::non_positive_dimension::RULE,
];

impl Trait {
    /// The rules that have it.
    pub fn rules(self) -> &'static [&'static Rule] {
        match self {
            Trait::Unnecessary => &UNNECESSARY,
            Trait::Deprecated => &DEPRECATED,
            Trait::Contact => &CONTACT,
            Trait::Simulation => &SIMULATION,
            Trait::Gazebo => &GAZEBO,
            Trait::GazeboClassic => &GAZEBO_CLASSIC,
            Trait::Transmission => &TRANSMISSION,
            Trait::AcceptedByBullet => &ACCEPTED_BY_BULLET,
            Trait::AcceptedByRaiSim => &ACCEPTED_BY_RAISIM,
            Trait::WrongSign => &WRONG_SIGN,
            Trait::Controller => &CONTROLLER,
            Trait::Reveals => &REVEALS,
            Trait::EachPlace => &EACH_PLACE,
            Trait::ByText => &BY_TEXT,
            Trait::ByFile => &BY_FILE,
        }
    }
}

impl Rule {
    /// Whether it has a trait.
    pub fn has(&self, wanted: Trait) -> bool {
        wanted.rules().contains(&self)
    }

    /// What findings share that do not say it themselves. Errors are one defect only where the same text is
    /// wrong; conventions and doubtful values are one for each file.
    pub fn group(&self) -> Group {
        if self.has(Trait::EachPlace) {
            Group::Place
        } else if self.has(Trait::ByFile) {
            Group::File
        } else if self.has(Trait::ByText) || self.severity == Severity::Error {
            Group::Text
        } else {
            Group::File
        }
    }
}
