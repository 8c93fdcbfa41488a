//! What the client was told last.
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use lsp_types::SemanticToken;

use crate::encoded_tokens::EncodedPart;
use ide::KeptTokens;

/// What the client was told last.
#[derive(Default)]
pub(super) struct Published {
    /// By path, a hash of the message.
    pub messages: BTreeMap<PathBuf, u64>,
}

/// What was sent last for a file.
#[derive(Default)]
pub(super) struct SentTokens {
    pub number: u64,
    pub data: Vec<SemanticToken>,
    /// Those of the parts of the file.
    pub kept: KeptTokens<EncodedPart>,
}

/// What the client was told last.
#[derive(Default)]
pub(super) struct Sent {
    /// What was published last.
    pub diagnostics: Published,
    /// The files that the client was told findings of when it asked for those of the workspace.
    pub workspace_files: BTreeSet<PathBuf>,
    /// Semantic tokens by path.
    pub tokens: BTreeMap<PathBuf, SentTokens>,
    /// Under which root each open file is shown.
    pub contexts: BTreeMap<PathBuf, serde_json::Value>,
    /// Messages about settings.
    pub warnings: BTreeSet<String>,
    /// Whether the user was told of an internal fault.
    pub fault: bool,
}
