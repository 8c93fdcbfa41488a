//! The linter itself: suppressions and configuration.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
