//! ros2_control, transmissions and Gazebo.

use super::registry::Rule;

/// The rules.
pub(super) static RULES: &[Rule] = &[];
