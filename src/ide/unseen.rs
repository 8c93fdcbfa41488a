//! Names that no evaluated robot has: why they cannot be renamed.

use super::context::Cx;
use super::locate::{NodePart, locate};
use rules::schema::{AttributeKind, every_element};
use xml::{Attr, Node};

/// Why the name of a link, joint or material at an offset cannot be renamed, when no robot that was evaluated has it;
/// `None` where no such name is written.
pub fn unseen_name(cx: &Cx<'_>, offset: u32) -> Option<String> {
    let at = locate(&cx.source.document, offset);
    let (NodePart::AttrValue(attr), Some(node)) = (at.part, at.node) else {
        return None;
    };
    if !names_part_of_robot(node, attr) {
        return None;
    }
    let name = attr.raw();
    let macro_name = std::iter::successors(Some(node), |node| node.parent())
        .find(|node| node.name() == "xacro:macro")
        .and_then(|node| node.attr("name"));
    Some(match macro_name {
        Some(macro_name) => format!(
            "cannot rename `{name}`: no robot in the workspace calls macro `{}`, so its uses are not known",
            macro_name.raw()
        ),
        None => format!(
            "cannot rename `{name}`: no robot in the workspace contains it, so its uses are not known"
        ),
    })
}

/// Whether an attribute names a link, a joint or a material.
fn names_part_of_robot(node: Node<'_>, attr: Attr<'_>) -> bool {
    let mut kinds = every_element()
        .filter(|spec| spec.name == node.name())
        .filter_map(|spec| spec.attribute(attr.name()))
        .map(|attribute| attribute.kind);
    kinds.any(|kind| match kind {
        AttributeKind::Name => matches!(node.name(), "link" | "joint" | "material"),
        AttributeKind::Link | AttributeKind::Joint | AttributeKind::LinkOrJoint => true,
        _ => false,
    })
}
