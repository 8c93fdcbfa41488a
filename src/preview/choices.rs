//! What could be shown instead: the presets of the root, and the other robots of the workspace.

use super::messages::RootName;
use super::places::LocationFormat;
use analysis::{RootChoice, World};

/// Choices that are offered at most.
const MOST: usize = 200;

/// The roots that a viewer may choose from, the one shown first.
pub(super) fn choices(
    world: &mut World,
    shown: &RootChoice,
    names: &LocationFormat<'_>,
) -> Vec<RootName> {
    let mut found = vec![shown.clone()];
    let own = world
        .context(&shown.file)
        .candidates
        .into_iter()
        .map(|(root, _)| root);
    let others = world.robots();
    for root in own.chain([RootChoice::plain(&shown.file)]).chain(others) {
        if found.len() < MOST && !found.contains(&root) {
            found.push(root);
        }
    }
    let named = found
        .iter()
        .filter_map(|root| Some(RootName::of(root, (names.uri)(&root.file)?)));
    named.collect()
}
