//! The linter itself: suppressions and configuration.

pub(super) mod invalid_config;
mod malformed_suppression;
mod reach;
mod suppression;
mod unknown_rule_in_suppression;
pub(super) mod unused_suppression;

use super::registry::Rule;

pub use invalid_config::invalid_config;
pub use suppression::{Directive, Malformed, Selector, Suppression, Suppressions};
pub use unused_suppression::unused_suppression;

/// The rules.
pub(super) static RULES: &[&Rule] = &[
    &unused_suppression::RULE,
    &unknown_rule_in_suppression::RULE,
    &malformed_suppression::RULE,
    &invalid_config::RULE,
];
