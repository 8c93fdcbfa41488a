//! Publishing: diagnostics are sent when they say something new.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::notification::{Notification, PublishDiagnostics};
use lsp_types::{Diagnostic, PublishDiagnosticsParams, Url};

use super::diagnostics::fingerprint;
use super::engine::Engine;
use super::outbox::notification;

/// What the client was told last.
#[derive(Default)]
pub(super) struct Published {
    /// By path, a hash of the message.
    messages: BTreeMap<PathBuf, u64>,
}

impl Engine {
    /// Send what differs from what was sent before.
    pub fn publish(&mut self, mut found: BTreeMap<PathBuf, Vec<Diagnostic>>) {
        for path in self.published.messages.keys() {
            found.entry(path.clone()).or_default();
        }
        for (path, diagnostics) in found {
            self.publish_file(path, diagnostics);
        }
    }

    fn publish_file(&mut self, path: PathBuf, diagnostics: Vec<Diagnostic>) {
        let version = self.documents.get(&path).and_then(|open| open.version);
        let Some(uri) = self.uri(&path) else { return };
        let is_cleared = diagnostics.is_empty() && !self.documents.contains_key(&path);
        let params = PublishDiagnosticsParams { uri, diagnostics, version };
        let message = notification(PublishDiagnostics::METHOD, &params);
        let hash = fingerprint(&message);
        if self.published.messages.get(&path) == Some(&hash) {
            return;
        }
        match is_cleared {
            true => self.published.messages.remove(&path),
            false => self.published.messages.insert(path, hash),
        };
        self.outbox.tell_encoded(&message);
    }

    /// A closed file has no diagnostics of its own any more.
    pub fn withdraw(&mut self, path: &Path, uri: Url) {
        if self.published.messages.remove(path).is_some() {
            let none = PublishDiagnosticsParams { uri, diagnostics: Vec::new(), version: None };
            self.outbox.tell(PublishDiagnostics::METHOD, &none);
        }
    }
}
