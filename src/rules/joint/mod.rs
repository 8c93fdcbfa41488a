//! Joints: types, axes, limits, dynamics, mimic.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
