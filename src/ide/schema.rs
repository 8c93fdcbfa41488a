//! Which entry of the table of URDF an element of the source has.

use rules::schema::{AttributeSpec, ElementSpec, elements, robot};
use xml::Node;

/// The entries of an element: several when the source does not say what stands around it.
pub fn element(node: Node<'_>) -> Vec<&'static ElementSpec> {
    element_below(robot(), node)
}

/// The same in a file with another root element.
pub fn element_below(root: &'static ElementSpec, node: Node<'_>) -> Vec<&'static ElementSpec> {
    let name = node.name();
    if name == root.name {
        return vec![root];
    }
    let parents = match around(root, node) {
        ParentElement::Element(parent) => element_below(root, parent),
        ParentElement::Robot => vec![root],
        ParentElement::Unknown if root.key != robot().key => return Vec::new(),
        ParentElement::Unknown => return elements().filter(|spec| spec.name == name).collect(),
    };
    let mut found: Vec<&ElementSpec> = parents
        .iter()
        .filter_map(|parent| parent.child(name))
        .collect();
    found.dedup_by_key(|spec| spec.key);
    found
}

/// The entry of an attribute.
pub fn attribute(node: Node<'_>, name: &str) -> Option<&'static AttributeSpec> {
    element(node)
        .into_iter()
        .find_map(|spec| spec.attribute(name))
}

/// Whether an attribute holds angles in radians.
pub fn is_angle(node: Node<'_>, name: &str) -> bool {
    if matches!(node.name(), "limit" | "safety_controller" | "calibration") && !may_turn(node) {
        return false;
    }
    let specs = element(node);
    let own = specs
        .iter()
        .flat_map(|spec| spec.attributes)
        .filter(|attribute| attribute.name == name);
    own.into_iter()
        .any(|attribute| matches!(attribute.unit, Some("rad" | "rad or m")))
}

/// Whether the joint around an element may turn.
fn may_turn(node: Node<'_>) -> bool {
    let kind = node.parent().and_then(|joint| joint.attr("type"));
    !matches!(
        kind.map(|kind| kind.raw()),
        Some("prismatic" | "fixed" | "floating")
    )
}

enum ParentElement<'a> {
    Element(Node<'a>),
    Robot,
    Unknown,
}

/// What an element stands in once conditions and macros are gone.
fn around<'a>(root: &ElementSpec, node: Node<'a>) -> ParentElement<'a> {
    let mut next = node.parent();
    while let Some(parent) = next {
        match parent.name() {
            "xacro:if" | "xacro:unless" => next = parent.parent(),
            // a body may be called anywhere; what is no part of a robot by itself is a piece of something
            "xacro:macro" => return top(root, node),
            name if name.starts_with("xacro:") => return ParentElement::Unknown,
            _ => return ParentElement::Element(parent),
        }
    }
    top(root, node)
}

fn top<'a>(root: &ElementSpec, node: Node<'a>) -> ParentElement<'a> {
    if root.child(node.name()).is_some() {
        ParentElement::Robot
    } else {
        ParentElement::Unknown
    }
}
