//! Names.

pub(super) mod empty_name;
pub(super) mod invalid_name;
pub(super) mod leading_slash_name;
mod link_naming;
mod macro_file_emits;
mod named_by;
mod names;
mod non_snake_case_name;
mod sdf_reserved_name;
mod unprefixed_name_in_macro;

use super::rule::Rule;

pub(super) use named_by::NamedBy;
pub(super) use names::{NamedElement, names, rename};

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &invalid_name::RULE,
    &empty_name::RULE,
    &leading_slash_name::RULE,
    &unprefixed_name_in_macro::RULE,
    &sdf_reserved_name::RULE,
    &non_snake_case_name::RULE,
    &link_naming::RULE,
    &macro_file_emits::RULE,
];
