//! Text of open documents.
use std::path::Path;

use lsp_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams, MessageType,
};

use crate::convert;
use crate::framing::NO_VERSION;
use crate::installed;
use crate::outbox::ClientRequest;
use crate::publishing::withdraw;
use crate::refreshing::refresh;
use crate::scheduler::Cause;
use crate::settings::request_settings;
use crate::state::{OpenDocument, ServerState};

pub fn opened(state: &mut ServerState, params: DidOpenTextDocumentParams) {
    let document = params.text_document;
    let path = installed::opening(state, &document.uri);
    state.host.set_text(&path, document.text);
    let open = OpenDocument {
        uri: document.uri,
        version: version(document.version),
    };
    offer_source(state, &path);
    state.documents.insert(path.clone(), open);
    // what there is to say of a file should not wait for a pause in typing
    state.diagnostics.at_once(Cause::Opened(path));
}

/// Who has opened an installed copy should edit the source: the next build replaces the copy. Of two documents of one
/// file, the source has the findings.
fn offer_source(state: &ServerState, path: &Path) {
    let packages = &state.host.session().packages;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (source, message) = if let Some(source) = packages.source_of(path) {
        let shown = vfs::slashed(&source);
        let message = format!(
            "`{name}` is an installed copy, which the next build replaces; its source is `{shown}`"
        );
        (source, message)
    } else if let Some(source) = state.installed.source_of_double(path) {
        let shown = vfs::slashed(source);
        let message = format!(
            "`{name}` is a link to `{shown}`, which is open too: findings are shown in that one"
        );
        (source.to_owned(), message)
    } else {
        return;
    };
    let Some(uri) = state.uri(&source) else {
        return;
    };
    if state.client.shows_documents {
        state.outbox.request(ClientRequest::Offer {
            message,
            action: "Open Source",
            uri,
        });
    } else {
        state.outbox.show(MessageType::INFO, message);
    }
}

pub fn changed(state: &mut ServerState, params: DidChangeTextDocumentParams) {
    state.status.edit_arrived();
    let path = state.path(&params.text_document.uri);
    let Some(open) = state.documents.get_mut(&path) else {
        return state.outbox.log(format!(
            "ignored changes of `{}`, which is not open",
            params.text_document.uri
        ));
    };
    open.version = version(params.text_document.version);
    for change in params.content_changes {
        match (change.range, state.host.document(&path)) {
            (Some(range), Some(source)) => {
                let range = convert::edited_range(&source.document, range, state.encoding);
                state.host.edit(&path, range, &change.text);
            }
            _ => state.host.set_text(&path, change.text),
        }
    }
    state.schedule(Cause::Edited(path));
}

/// Who saves wants to know how things are: what other programs did to the disk meanwhile is asked for as well, since
/// not all clients tell of it.
pub fn saved(state: &mut ServerState, params: DidSaveTextDocumentParams) {
    let path = state.path(&params.text_document.uri);
    state.host.changed_on_disk(std::slice::from_ref(&path));
    state.schedule(Cause::Saved(path));
}

pub fn closed(state: &mut ServerState, params: DidCloseTextDocumentParams) {
    let path = state.path(&params.text_document.uri);
    state.sent.contexts.remove(&path);
    if let Some(open) = state.documents.remove(&path) {
        state.host.close(&path);
        withdraw(state, &path, open.uri);
    }
    installed::closed(state, &params.text_document.uri);
    state.schedule(Cause::Closed(path));
}

pub fn watched(state: &mut ServerState, params: DidChangeWatchedFilesParams) {
    let paths: Vec<_> = params
        .changes
        .iter()
        .map(|change| state.path(&change.uri))
        .collect();
    state.host.changed_on_disk(&paths);
    state.schedule(Cause::FilesChanged(paths.len()));
    refresh(state);
}

pub fn folders_changed(state: &mut ServerState, params: DidChangeWorkspaceFoldersParams) {
    let removed: Vec<_> = params
        .event
        .removed
        .iter()
        .map(|folder| state.path(&folder.uri))
        .collect();
    let mut folders: Vec<_> = state.host.folders().to_vec();
    folders.retain(|folder| !removed.contains(folder));
    for folder in params.event.added {
        let path = state.path(&folder.uri);
        if !folders.contains(&path) {
            folders.push(path);
        }
    }
    state.host.set_folders(folders);
    request_settings(state);
    state.schedule(Cause::FoldersChanged);
    refresh(state);
}

/// Something came in that is no message.
pub fn bad_message(state: &mut ServerState, params: serde_json::Value) {
    let reason = params
        .get("reason")
        .and_then(serde_json::Value::as_str)
        .unwrap_or("");
    state.outbox.log(format!("ignored a message: {reason}"));
}

/// The version that a client gives, if it gives one.
fn version(given: i32) -> Option<i32> {
    (given != NO_VERSION).then_some(given)
}
