//! Style; off unless asked for.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
