//! The linter itself: suppressions and configuration.

mod directive;
pub(super) mod invalid_config;
pub(super) mod malformed_suppression;
mod reach;
mod suppression;
pub(super) mod unknown_rule_in_suppression;
pub(super) mod unused_suppression;

use super::rule::Rule;

pub use directive::{Directive, Selector, Suppression};
pub use invalid_config::invalid_config;
pub use suppression::{Malformed, Suppressions};
pub use unused_suppression::unused_suppression;

/// All rules of this category, by code.
pub(super) static RULES: &[&Rule] = &[
    &unused_suppression::RULE,
    &unknown_rule_in_suppression::RULE,
    &malformed_suppression::RULE,
    &invalid_config::RULE,
];
