//! Publishing: diagnostics are sent when they say something new.
use std::collections::BTreeMap;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

use lsp_types::notification::{Notification, PublishDiagnostics};
use lsp_types::{Diagnostic, PublishDiagnosticsParams, Url};

use crate::outbox::notification;
use crate::state::ServerState;

/// Send what differs from what was sent before.
pub fn publish(state: &mut ServerState, mut found: BTreeMap<PathBuf, Vec<Diagnostic>>) {
    for path in state.sent.diagnostics.messages.keys() {
        found.entry(path.clone()).or_default();
    }
    for (path, diagnostics) in found {
        publish_file(state, path, diagnostics);
    }
}

fn publish_file(state: &mut ServerState, path: PathBuf, diagnostics: Vec<Diagnostic>) {
    let version = state.documents.get(&path).and_then(|open| open.version);
    let Some(uri) = state.uri(&path) else { return };
    let is_cleared = diagnostics.is_empty() && !state.documents.contains_key(&path);
    let params = PublishDiagnosticsParams {
        uri,
        diagnostics,
        version,
    };
    let message = notification(PublishDiagnostics::METHOD, &params);
    let hash = fingerprint(&message);
    if state.sent.diagnostics.messages.get(&path) == Some(&hash) {
        return;
    }
    if is_cleared {
        state.sent.diagnostics.messages.remove(&path)
    } else {
        state.sent.diagnostics.messages.insert(path, hash)
    };
    state.outbox.notify_encoded(message);
}

/// A closed file has no diagnostics of its own any more.
pub fn withdraw(state: &mut ServerState, path: &Path, uri: Url) {
    if state.sent.diagnostics.messages.remove(path).is_some() {
        let none = PublishDiagnosticsParams {
            uri,
            diagnostics: Vec::new(),
            version: None,
        };
        state.outbox.notify(PublishDiagnostics::METHOD, &none);
    }
}

pub(super) fn fingerprint(json: &[u8]) -> u64 {
    let mut state = rustc_hash::FxHasher::default();
    json.hash(&mut state);
    state.finish()
}
