//! What could be shown instead: the presets of the root, and the other robots of the workspace.

use super::locations::LocationFormat;
use super::messages::RootName;
use analysis::{AnalysisHost, RootConfig};

/// Choices that are offered at most.
const MOST: usize = 200;

/// The roots that a viewer may choose from, the one shown first.
pub(super) fn choices(
    host: &mut AnalysisHost,
    shown: &RootConfig,
    names: &LocationFormat<'_>,
) -> Vec<RootName> {
    let mut found = vec![shown.clone()];
    let own = analysis::context(host, &shown.file)
        .candidates
        .into_iter()
        .map(|(root, _)| root);
    let others = analysis::known_robots(host);
    for root in own.chain([RootConfig::plain(&shown.file)]).chain(others) {
        if found.len() < MOST && !found.contains(&root) {
            found.push(root);
        }
    }
    let named = found
        .iter()
        .filter_map(|root| Some(RootName::of(root, (names.uri)(&root.file)?)));
    named.collect()
}
