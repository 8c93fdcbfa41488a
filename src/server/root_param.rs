//! The robot that a request is about.
use std::collections::BTreeMap;

use lsp_types::Url;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::state::State;
use analysis::RootChoice;

/// A root as the protocol names it.
#[derive(Clone, Debug, Serialize, Deserialize, PartialEq, Eq)]
pub(super) struct Root {
    pub uri: Url,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
}

/// A root that the client names.
pub fn chosen(state: &State, root: Root) -> Result<RootChoice, Failure> {
    let (file, _) = state.source(&root.uri)?;
    Ok(RootChoice {
        file,
        args: root.args.into_iter().collect(),
        preset: root.preset,
    })
}
