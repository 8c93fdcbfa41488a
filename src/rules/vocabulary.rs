//! The words of URDF and of xacro.

use super::schema;
use crate::xml::Node;

/// Elements whose content follows the rules of somebody else.
const FREE_ZONES: &[&str] = &["gazebo", "mujoco", "ros2_control", "sdf", "sensor", "transmission"];

/// Whether URDF knows an element.
pub(super) fn is_urdf_element(name: &str) -> bool {
    schema::is_urdf(name)
}

/// Whether the content of an element is none of URDF's business.
pub(super) fn is_free_zone(name: &str) -> bool {
    FREE_ZONES.contains(&name) || name.contains(':') && !name.starts_with("xacro:")
}

/// Whether an element of an item stands in a free zone, the element itself not counted.
pub(super) fn in_free_zone(node: Node<'_>) -> bool {
    std::iter::successors(node.parent(), |node| node.parent()).any(|node| is_free_zone(node.name()))
}

#[cfg(test)]
mod tests {
    #[test]
    fn words() {
        assert!(
            ["robot", "link", "capsule", "gazebo", "ros2_control"].map(super::is_urdf_element) == [true; 5]
        );
        assert!(["lnik", "hardware", "param"].map(super::is_urdf_element) == [false; 3]);
    }
}
