//! Plugins of Gazebo.
use super::super::context::DocumentCx;
use expand::{XId, XTree};
use model::Robot;

/// The `plugin` elements inside of `gazebo` elements, without those inside of other plugins: what stands there
/// is the plugin's own business.
pub(super) fn plugins(cx: &DocumentCx<'_>) -> Vec<XId> {
    cx.robot
        .map_or_else(Vec::new, |robot| plugins_of(&cx.expansion.tree, robot))
}

/// The same of a robot.
pub(super) fn plugins_of(tree: &XTree, robot: &Robot) -> Vec<XId> {
    let blocks = robot.gazebo.iter();
    let mut open: Vec<XId> = blocks.map(|block| block.element).collect();
    open.reverse();
    let mut found = Vec::new();
    while let Some(element) = open.pop() {
        if tree.get(element).text == "plugin" {
            found.push(element);
            continue;
        }
        let inside = open.len();
        open.extend(tree.elements(element));
        if let Some(new) = open.get_mut(inside..) {
            new.reverse();
        }
    }
    found
}
