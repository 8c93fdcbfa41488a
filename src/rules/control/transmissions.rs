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

/// Nothing in ROS 2 reads the transmissions of a robot, nor does Gazebo where other plugins move it.
pub(super) fn severity(cx: &DocumentCx<'_>) -> Severity {
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let generation = root.and_then(|root| cx.world.packages.generation(root));
    if generation == Some(RosVersion::Ros2) || is_moved_by_others(cx) {
        Severity::Info
    } else {
        Severity::Warning
    }
}

/// Whether plugins of Gazebo move the robot, and none of them reads transmissions.
fn is_moved_by_others(cx: &DocumentCx<'_>) -> bool {
    const MOVES: [&str; 4] = ["_drive", "planar_move", "skid_steer", "ackermann"];
    let tree = &cx.expansion.tree;
    let blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
    let plugins = blocks
        .flat_map(|block| tree.elements(block.element))
        .filter(|&id| tree.get(id).text == "plugin");
    let files: Vec<&str> = plugins
        .filter_map(|id| Some(tree.attr(id, "filename")?.value.as_str()))
        .collect();
    let moves = |file: &&str| MOVES.iter().any(|part| file.contains(part));
    files.iter().any(moves) && !files.iter().any(|file| file.contains("control"))
}
