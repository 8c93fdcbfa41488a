//! What pages say.

use std::sync::Arc;

use super::{
    Location, RequestFailure, RootParam, ServerState, ShowParams, Url, client_names, convert,
    send_selection, show_root,
};
use crate::outbox::ClientRequest;
use base::CancelFlag;
use preview::{FromViewer, Hub, Received, RootName};

/// The server for browsers, started when it is needed first.
pub(super) fn hub(state: &mut ServerState) -> Result<Arc<Hub>, RequestFailure> {
    if let Some(hub) = &state.previews.hub {
        return Ok(hub.clone());
    }
    let Some(from_pages) = state.previews.from_pages.clone() else {
        return Err(RequestFailure::Refused(
            "cannot start the preview here".to_owned(),
        ));
    };
    let files = state.previews.views.files().clone();
    let vfs = state.host.session().vfs.clone();
    let hub = Hub::start(files, vfs, move |received| from_pages(received))
        .map_err(|error| RequestFailure::Refused(format!("cannot start the preview: {error}")))?;
    state.previews.hub = Some(hub.clone());
    Ok(hub)
}

/// A page said something.
pub fn page_said(state: &mut ServerState, received: Received) {
    let id = received.id;
    match received.message {
        FromViewer::Ready => state.previews.due = true,
        FromViewer::Select {
            link,
            joint,
            location,
        } => {
            let names = client_names(state);
            let views = &state.previews.views;
            let Some(mut selection) = names.with(|names| views.place_of(id, link, joint, names))
            else {
                return;
            };
            selection.location = location.or(selection.location);
            show_location(state, selection.location.as_ref());
            send_selection(state, &selection);
        }
        FromViewer::Open { location } => show_location(state, Some(&location)),
        FromViewer::Root { root, compare } => {
            let named = |name: RootName| {
                let uri = Url::parse(&name.uri).ok()?;
                Some(RootParam {
                    uri,
                    args: name.args,
                    preset: name.preset,
                })
            };
            let Some(root) = named(root) else { return };
            let params = ShowParams {
                id,
                root,
                compare: compare.and_then(named),
            };
            if let Err(RequestFailure::Invalid(why)) =
                show_root(state, params, &CancelFlag::default())
            {
                state
                    .outbox
                    .log(format!("cannot show this in the preview: {why}"));
            }
        }
        // pages ask for files in another way
        FromViewer::Mesh { .. } => {}
    }
}

/// Have the editor show a place.
fn show_location(state: &ServerState, location: Option<&Location>) {
    let uri = location.and_then(|location| Url::parse(&location.uri).ok());
    let (Some(location), Some(uri)) = (location, uri) else {
        return;
    };
    if state.client.shows_documents && state.may_read(&convert::path(&uri)) {
        let range = lsp_types::Range::new(point(location.range.start), point(location.range.end));
        state
            .outbox
            .request(ClientRequest::ShowDocument(uri, range));
    }
}

fn point(point: preview::LinePosition) -> lsp_types::Position {
    lsp_types::Position::new(point.line, point.character)
}
