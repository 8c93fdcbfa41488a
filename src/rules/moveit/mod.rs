//! Settings of MoveIt, compared with the robot and its SRDF.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
