//! The kinematic tree, judged on the expansion and reported at the source.

pub(super) mod duplicate_geometry_name;
pub(super) mod duplicate_joint_name;
pub(super) mod duplicate_link_name;
pub(super) mod joint_self_loop;
pub(super) mod link_cycle;
mod link_joint_same_name;
mod missing_links;
pub(super) mod multiple_parents;
pub(super) mod multiple_roots;
pub(super) mod names_differ_by_case;
pub(super) mod no_links;
pub(super) mod orphan_link;
mod repeated_calls;
mod rust_consumer_cannot_load;
pub(super) mod undefined_link;

use super::rule::Rule;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &duplicate_link_name::RULE,
    &duplicate_joint_name::RULE,
    &undefined_link::RULE,
    &multiple_parents::RULE,
    &link_cycle::RULE,
    &joint_self_loop::RULE,
    &multiple_roots::RULE,
    &orphan_link::RULE,
    &no_links::RULE,
    &duplicate_geometry_name::RULE,
    &link_joint_same_name::RULE,
    &names_differ_by_case::RULE,
    &rust_consumer_cannot_load::RULE,
];
