//! What the rules about transmissions share.
use super::super::context::DocumentCx;
use super::super::rule::Severity;
use expand::{XId, XTree};
use model::AttrValue;
use packages::RosVersion;

/// The text of the `type` of a transmission.
pub(super) fn type_of(tree: &XTree, transmission: XId) -> Option<AttrValue> {
    let kind = tree
        .elements(transmission)
        .find(|&id| tree.get(id).text == "type")?;
    AttrValue::content(tree, kind)
}

/// Nothing in ROS 2 reads the transmissions of a robot.
pub(super) fn severity(cx: &DocumentCx<'_>) -> Severity {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    match root.and_then(|root| cx.world.packages.generation(root)) {
        Some(RosVersion::Ros2) => Severity::Info,
        _ => Severity::Warning,
    }
}
