//! Mass and inertia.

mod com_outside_geometry;
mod implausible_density;
mod implausible_inertia;
mod inertia_axes_swapped;
pub(super) mod inertia_not_positive_definite;
pub(super) mod inertia_triangle_inequality;
mod joined;
mod missing_inertial;
mod moments;
pub(super) mod negative_mass;
mod placeholder_inertia;
mod root_link_inertia;
mod tiny_inertia;
mod zero_inertia;
pub(super) mod zero_mass;

use super::rule::Rule;

pub(super) use moments::principal;
pub(super) use root_link_inertia::{ADD_ROOT, massless_root};

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &negative_mass::RULE,
    &zero_mass::RULE,
    &zero_inertia::RULE,
    &inertia_not_positive_definite::RULE,
    &inertia_triangle_inequality::RULE,
    &implausible_inertia::RULE,
    &implausible_density::RULE,
    &placeholder_inertia::RULE,
    &com_outside_geometry::RULE,
    &root_link_inertia::RULE,
    &missing_inertial::RULE,
    &tiny_inertia::RULE,
    &inertia_axes_swapped::RULE,
];
