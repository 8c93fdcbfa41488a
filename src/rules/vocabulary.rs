//! The words of URDF and of xacro.

use crate::xml::Node;

/// Elements that URDF parsers know outside of the free zones.
const URDF: &[&str] = &[
    "axis",
    "box",
    "calibration",
    "capsule",
    "child",
    "collision",
    "color",
    "cylinder",
    "dynamics",
    "gazebo",
    "geometry",
    "inertia",
    "inertial",
    "joint",
    "limit",
    "link",
    "mass",
    "material",
    "mesh",
    "mimic",
    "origin",
    "parent",
    "robot",
    "ros2_control",
    "safety_controller",
    "sensor",
    "sphere",
    "texture",
    "transmission",
    "visual",
];

/// Elements whose content follows the rules of somebody else.
const FREE_ZONES: &[&str] = &["gazebo", "mujoco", "ros2_control", "sdf", "sensor", "transmission"];

/// Whether URDF knows an element.
pub(super) fn is_urdf_element(name: &str) -> bool {
    URDF.binary_search(&name).is_ok()
}

/// Whether the content of an element is none of URDF's business.
fn is_free_zone(name: &str) -> bool {
    FREE_ZONES.contains(&name) || name.contains(':') && !name.starts_with("xacro:")
}

/// Whether an element of an item stands in a free zone, the element itself not counted.
pub(super) fn in_free_zone(node: Node<'_>) -> bool {
    std::iter::successors(node.parent(), |node| node.parent()).any(|node| is_free_zone(node.name()))
}

#[cfg(test)]
mod tests {
    #[test]
    fn words_are_sorted() {
        assert!(super::URDF.is_sorted());
        assert!(super::is_urdf_element("link") && !super::is_urdf_element("lnik"));
    }
}
