//! What several rules have in common, for those who treat their findings alike.

use super::registry::Rule;
use super::{control, geometry, inertia, joint, linter, package, xacro, xml};

/// Something that a rule is or is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trait {
    /// Something is written that nothing needs: editors show it faded.
    Unnecessary,
    /// An old way to write it: editors strike it through.
    Deprecated,
    /// About collisions, which a robot that is only shown does not need.
    Contact,
    /// urdfdom rejects it, and Bullet accepts it. Source: `UrdfParser.cpp` of Bullet 3.25, and loading with PyBullet.
    AcceptedByBullet,
    /// A mass or an inertia is below zero, which nobody means.
    WrongSign,
    /// About what a controller of the parameters moves.
    Controller,
    /// More of a robot is there after its fix, which may have errors of its own: texts that could not be parsed, tags and files
    /// that were missing or meant nothing.
    Reveals,
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

static CONTACT: [&Rule; 2] = [
    &geometry::collision_mesh_too_detailed::RULE,
    &geometry::mesh_inconsistent_normals::RULE,
];

static CONTROLLER: [&Rule; 2] = [
    &control::controller_unknown_interface::RULE,
    &control::controller_unknown_joint::RULE,
];

static WRONG_SIGN: [&Rule; 2] = [
    &inertia::inertia_not_positive_definite::RULE,
    &inertia::negative_mass::RULE,
];

static ACCEPTED_BY_BULLET: [&Rule; 10] = [
    &geometry::duplicate_material::RULE,
    &xml::invalid_number::RULE,
    &xml::missing_attribute::RULE,
    &joint::missing_limit_attribute::RULE,
    &xml::missing_robot_name::RULE,
    &geometry::undefined_material::RULE,
    &geometry::unknown_geometry_type::RULE,
    &joint::unknown_joint_type::RULE,
    &xml::wrong_vector_length::RULE,
    &inertia::zero_mass::RULE,
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

impl Trait {
    /// The rules that have it.
    pub fn rules(self) -> &'static [&'static Rule] {
        match self {
            Trait::Unnecessary => &UNNECESSARY,
            Trait::Deprecated => &DEPRECATED,
            Trait::Contact => &CONTACT,
            Trait::AcceptedByBullet => &ACCEPTED_BY_BULLET,
            Trait::WrongSign => &WRONG_SIGN,
            Trait::Controller => &CONTROLLER,
            Trait::Reveals => &REVEALS,
        }
    }
}

impl Rule {
    /// Whether it has a trait.
    pub fn has(&self, wanted: Trait) -> bool {
        wanted.rules().contains(&self)
    }
}
