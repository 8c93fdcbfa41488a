//! Frames and orientations.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
