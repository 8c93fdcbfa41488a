//! Documents that are open through a link in an install space, as `colcon build --symlink-install` makes them: they are
//! their sources, under another name.
use std::path::{Path, PathBuf};

use crate::convert;
use crate::publishing::withdraw;
use crate::state::{OpenDocument, ServerState};
use lsp_types::Url;

/// The path that a document which is opened now is kept under. Two documents of one file keep apart what is typed in
/// them; the one that was opened by the name of the source is the one that counts.
pub fn opening(state: &mut ServerState, uri: &Url) -> PathBuf {
    let path = convert::path(uri);
    let Some(source) = state.host.session().packages.linked_source(&path) else {
        make_double(state, &path);
        return path;
    };
    if state.documents.contains_key(&source) {
        state.installed.doubles.insert(path.clone(), source);
        return path;
    }
    state.installed.links.insert(path, source.clone());
    source
}

/// The source itself is opened while it is open through a link.
fn make_double(state: &mut ServerState, source: &Path) {
    let mut links = state.installed.links.iter();
    let Some((link, _)) = links.find(|(_, of)| *of == source) else {
        return;
    };
    let link = link.clone();
    state.installed.links.remove(&link);
    if let Some(open) = move_text(state, source, &link) {
        withdraw(state, source, open.uri);
        state.installed.doubles.insert(link, source.to_owned());
    }
}

/// A document was closed: a second document of its file is the only one now.
pub fn closed(state: &mut ServerState, uri: &Url) {
    let path = convert::path(uri);
    state.installed.links.remove(&path);
    state.installed.doubles.remove(&path);
    let mut doubles = state.installed.doubles.iter();
    let Some((link, _)) = doubles.find(|(_, of)| **of == path) else {
        return;
    };
    let link = link.clone();
    state.installed.doubles.remove(&link);
    state.installed.links.insert(link.clone(), path.clone());
    if let Some(open) = move_text(state, &link, &path) {
        withdraw(state, &link, open.uri);
        state.host.close(&link);
    }
}

/// Keep an open document under another path.
fn move_text(state: &mut ServerState, from: &Path, to: &Path) -> Option<OpenDocument> {
    let text = state.host.document(from)?.document.text();
    let open = state.documents.remove(from)?;
    state.host.set_text(to, text.to_string());
    state.documents.insert(to.to_owned(), open.clone());
    Some(open)
}
