//! Geometry, meshes and materials.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
