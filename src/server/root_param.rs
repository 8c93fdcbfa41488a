//! The robot that a request is about.
use std::collections::BTreeMap;
use std::path::Path;

use lsp_types::{TextDocumentIdentifier, Url};
use serde::{Deserialize, Serialize};

use crate::failure::RequestFailure;
use crate::state::ServerState;
use analysis::RootConfig;

/// A root as the protocol names it.
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq, Eq)]
pub(super) struct RootParam {
    pub uri: Url,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
}

/// A root that the client names: with the arguments it gives, else with those of the preset.
pub fn chosen(state: &mut ServerState, root: RootParam) -> Result<RootConfig, RequestFailure> {
    let (file, _) = state.source(&root.uri)?;
    let root = RootConfig {
        file,
        args: root.args.into_iter().collect(),
        preset: root.preset,
    };
    if root.preset.is_none() || !root.args.is_empty() {
        return Ok(root);
    }
    let known = analysis::context(&mut state.host, &root.file)
        .candidates
        .into_iter();
    let preset = known
        .map(|(known, _)| known)
        .find(|known| known.file == root.file && known.preset == root.preset);
    Ok(preset.unwrap_or(root))
}

/// The root that a request names, or the one that its document is shown under.
pub fn chosen_or_active(
    state: &mut ServerState,
    document: &TextDocumentIdentifier,
    root: Option<RootParam>,
) -> Result<RootConfig, RequestFailure> {
    let (path, _) = state.source(&document.uri)?;
    match root {
        Some(root) => chosen(state, root),
        None => Ok(active_root(state, &path)),
    }
}

/// The root that a file is shown under; a file that no root reaches is one by itself.
pub fn active_root(state: &mut ServerState, path: &Path) -> RootConfig {
    let root = analysis::context(&mut state.host, path).root;
    root.unwrap_or_else(|| RootConfig::plain(path))
}
