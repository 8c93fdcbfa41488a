//! Text of open documents.

use lsp_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams,
};

use super::convert;
use super::engine::{Engine, OpenDocument};
use super::framing::NO_VERSION;
use super::outbox::{Question, Refresh};

impl Engine {
    pub fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let document = params.text_document;
        let path = self.path(&document.uri);
        self.world.set_text(&path, document.text);
        let open = OpenDocument { uri: document.uri, version: version(document.version) };
        self.documents.insert(path, open);
        // what there is to say of a file should not wait for a pause in typing
        self.due = Some(std::time::Instant::now());
    }

    pub fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let path = self.path(&params.text_document.uri);
        let Some(open) = self.documents.get_mut(&path) else {
            return self
                .outbox
                .log(format!("changes of `{}`, which is not open, are ignored", params.text_document.uri));
        };
        open.version = version(params.text_document.version);
        for change in params.content_changes {
            match (change.range, self.world.document(&path)) {
                (Some(range), Some(source)) => {
                    let range = convert::edited_range(&source.document, range, self.encoding);
                    self.world.edit(&path, range, &change.text);
                }
                _ => self.world.set_text(&path, change.text),
            }
        }
        self.schedule();
    }

    pub fn saved(&mut self, _: DidSaveTextDocumentParams) {
        self.schedule();
    }

    pub fn closed(&mut self, params: DidCloseTextDocumentParams) {
        let path = self.path(&params.text_document.uri);
        self.told.remove(&path);
        if let Some(open) = self.documents.remove(&path) {
            self.world.close(&path);
            self.withdraw(&path, open.uri);
        }
        self.schedule();
    }

    pub fn watched(&mut self, params: DidChangeWatchedFilesParams) {
        let paths: Vec<_> = params.changes.iter().map(|change| self.path(&change.uri)).collect();
        self.world.changed_on_disk(&paths);
        self.schedule();
        self.refresh();
    }

    pub fn folders_changed(&mut self, params: DidChangeWorkspaceFoldersParams) {
        let removed: Vec<_> = params.event.removed.iter().map(|folder| self.path(&folder.uri)).collect();
        let mut folders: Vec<_> = self.world.folders().to_vec();
        folders.retain(|folder| !removed.contains(folder));
        for folder in params.event.added {
            let path = self.path(&folder.uri);
            if !folders.contains(&path) {
                folders.push(path);
            }
        }
        self.world.set_folders(folders);
        self.ask_for_settings();
        self.schedule();
        self.refresh();
    }

    /// Something came in that is no message.
    pub fn bad_message(&mut self, params: serde_json::Value) {
        let reason = params.get("reason").and_then(serde_json::Value::as_str).unwrap_or("");
        self.outbox.log(format!("a message was passed over: {reason}"));
    }

    /// Have the client ask again for what it has asked for before.
    pub fn refresh(&self) {
        self.refresh_others();
        self.refresh_when(self.client.refreshes_tokens, &[Refresh::SemanticTokens]);
        self.refresh_when(self.client.refreshes_lenses, &[Refresh::CodeLens]);
    }

    /// After an edit: clients ask again for the file they changed, but findings and values in the other
    /// open files may be different now too.
    pub fn refresh_others(&self) {
        let pulls = self.client.pulls_diagnostics && self.client.refreshes_diagnostics;
        self.refresh_when(pulls, &[Refresh::Diagnostics]);
        self.refresh_when(self.client.refreshes_hints, &[Refresh::InlayHints]);
    }

    fn refresh_when(&self, supported: bool, what: &'static [Refresh]) {
        if supported && self.initialized {
            self.outbox.ask(Question::Refresh(what));
        }
    }
}

/// The version that a client gives, if it gives one.
fn version(given: i32) -> Option<i32> {
    (given != NO_VERSION).then_some(given)
}
