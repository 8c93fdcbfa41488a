//! What the client was told last.
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use lsp_types::SemanticToken;

use crate::encoded_tokens::EncodedPart;
use base::FastMap;
use ide::{HighlightToken, KeptTokens};
use xml::Item;

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
    /// What was found in the parts of the file.
    pub kept: KeptTokens,
    /// Its encoded form, by the addresses of a part and of its tokens, which are held so that no others get them.
    pub encoded: FastMap<(usize, usize), EncodedTokens>,
}

/// A part of a file, its tokens, and these as the protocol has them.
type EncodedTokens = (Arc<Item>, Arc<[HighlightToken]>, Arc<EncodedPart>);

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
