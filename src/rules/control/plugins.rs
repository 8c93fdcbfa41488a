//! Plugins of Gazebo.

use super::super::context::DocumentCx;
use expand::XId;

/// The `plugin` elements inside of `gazebo` elements, without those inside of other plugins: what stands there
/// is the plugin's own business.
pub(super) fn plugins(cx: &DocumentCx<'_>) -> Vec<XId> {
    let tree = &cx.expansion.tree;
    let blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
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
