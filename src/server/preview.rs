//! `xacro/preview/*` and the command `xacro.preview`: the robot in 3D.
//!
//! Clients with requests of their own subscribe and pass messages on to the viewer; all others open the address that
//! the command answers. Models are made when no event waits, so that a burst of edits costs one of them.

#[cfg(feature = "preview")]
pub(super) mod pages;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use lsp_types::{TextDocumentIdentifier, Url};
use serde::{Deserialize, Serialize};
use serde_json::Value;
#[cfg(feature = "preview")]
use serde_json::json;

use crate::convert;
use crate::failure::RequestFailure;
#[cfg(feature = "preview")]
use crate::outbox::ClientRequest;
#[cfg(feature = "preview")]
use crate::requests::mapping::named;
use crate::root_param::{RootParam, active_root, chosen};
use crate::state::ServerState;
use crate::views::Previews;
use analysis::RootConfig;
use base::limits::VIEWS;
use base::{CancelFlag, Encoding};
#[cfg(feature = "preview")]
use pages::hub;
use preview::{Location, LocationFormat, ModelMessage, Selection};

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SubscribeParams {
    pub root: Option<RootParam>,
    pub text_document: Option<TextDocumentIdentifier>,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct Subscribed {
    pub id: u32,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct ViewParams {
    pub id: u32,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct ShowParams {
    pub id: u32,
    pub root: RootParam,
    pub compare: Option<RootParam>,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct MeshParams {
    pub mesh: String,
}

#[derive(Clone, Debug, Serialize)]
pub(super) struct MeshData {
    pub name: String,
    /// In base64.
    pub data: String,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct SelectParams {
    /// The view; all of them when absent.
    pub id: Option<u32>,
    pub link: Option<String>,
    pub joint: Option<String>,
    pub location: Option<Location>,
}

/// How the client names files, taken out of the state.
struct ClientNames {
    uris: BTreeMap<PathBuf, String>,
    encoding: Encoding,
}

impl ClientNames {
    fn with<T>(&self, work: impl FnOnce(&LocationFormat<'_>) -> T) -> T {
        let uri = |path: &Path| {
            let open = self.uris.get(path).cloned();
            open.or_else(|| Some(convert::file_uri(path)?.to_string()))
        };
        let path = |uri: &str| Some(convert::path(&Url::parse(uri).ok()?));
        work(&LocationFormat {
            uri: &uri,
            path: &path,
            encoding: self.encoding,
        })
    }
}

pub fn subscribe(
    state: &mut ServerState,
    params: SubscribeParams,
    _: &CancelFlag,
) -> Result<Subscribed, RequestFailure> {
    let id = open_view(state, params)?;
    state.previews.subscribed.insert(id);
    Ok(Subscribed { id })
}

pub fn unsubscribe(
    state: &mut ServerState,
    params: ViewParams,
    _: &CancelFlag,
) -> Result<Value, RequestFailure> {
    state.previews.subscribed.remove(&params.id);
    if !state.previews.views.close(params.id) {
        return Err(no_view(params.id));
    }
    #[cfg(feature = "preview")]
    if let Some(hub) = &state.previews.hub {
        hub.close(params.id);
    }
    Ok(Value::Null)
}

pub fn show_root(
    state: &mut ServerState,
    params: ShowParams,
    _: &CancelFlag,
) -> Result<Value, RequestFailure> {
    let root = chosen(state, params.root)?;
    let compare = params.compare.map(|root| chosen(state, root)).transpose()?;
    let compares = compare.is_some();
    if !state.previews.views.show(params.id, root, compare) {
        return Err(no_view(params.id));
    }
    #[cfg(feature = "preview")]
    if let Some(hub) = state.previews.hub.as_ref().filter(|_| !compares) {
        hub.end_compare(params.id);
    }
    let _ = compares;
    state.previews.due = true;
    Ok(Value::Null)
}

pub fn preview_mesh(
    state: &mut ServerState,
    params: MeshParams,
    _: &CancelFlag,
) -> Result<MeshData, RequestFailure> {
    let mesh = state
        .previews
        .views
        .mesh(&state.host, &params.mesh)
        .map_err(RequestFailure::Invalid)?;
    let data = base64::engine::general_purpose::STANDARD.encode(mesh.bytes);
    Ok(MeshData {
        name: mesh.name,
        data,
    })
}

/// The robot of a view as URDF, as it is shown.
pub fn preview_urdf(
    state: &mut ServerState,
    params: ViewParams,
    _: &CancelFlag,
) -> Result<Value, RequestFailure> {
    let urdf = state.previews.views.urdf(params.id);
    let urdf = urdf.map_err(RequestFailure::Refused)?;
    Ok(serde_json::json!({ "urdf": urdf }))
}

/// The client selects: the cursor moved, or a link was clicked in its viewer.
pub fn selected(state: &mut ServerState, params: SelectParams) {
    let names = client_names(state);
    let ids = match params.id {
        Some(id) => vec![id],
        None => state.previews.views.ids(),
    };
    for id in ids {
        let views = &state.previews.views;
        let found = names.with(
            |names| match (&params.location, &params.link, &params.joint) {
                (Some(location), None, None) => views.made_by(id, location, names),
                _ => views.place_of(id, params.link.clone(), params.joint.clone(), names),
            },
        );
        if let Some(selection) = found {
            send_selection(state, &selection);
        }
    }
}

fn send_selection(state: &ServerState, selection: &Selection) {
    #[cfg(feature = "preview")]
    if let Some(hub) = &state.previews.hub {
        hub.select(selection);
    }
    if state.previews.subscribed.contains(&selection.id) {
        let params = serde_json::to_value(selection).unwrap_or_default();
        state.outbox.notify("xacro/preview/select", &params);
    }
}

/// Make the models of what changed, and send them.
pub fn make_previews(state: &mut ServerState) {
    state.previews.due = false;
    let names = client_names(state);
    let cancel = state.status.background();
    #[cfg(feature = "preview")]
    let hub = state.previews.hub.clone();
    let Previews {
        views, subscribed, ..
    } = &mut state.previews;
    #[cfg(feature = "preview")]
    let watched = |id| hub.as_ref().is_some_and(|hub| hub.is_watched(id));
    #[cfg(not(feature = "preview"))]
    let watched = |_| false;
    let wanted = |id: u32| subscribed.contains(&id) || watched(id);
    let (messages, finished) =
        names.with(|names| views.update(&mut state.host, names, &wanted, &cancel));
    // given up because an event came in: after it
    state.previews.due |= !finished;
    for message in &messages {
        send_model(state, message);
    }
}

fn send_model(state: &ServerState, message: &ModelMessage) {
    #[cfg(feature = "preview")]
    if let Some(hub) = &state.previews.hub {
        hub.tell(message);
    }
    if state.previews.subscribed.contains(&message.id) {
        let params = serde_json::to_value(message).unwrap_or_default();
        state.outbox.notify("xacro/preview/model", &params);
    }
}

fn open_view(state: &mut ServerState, params: SubscribeParams) -> Result<u32, RequestFailure> {
    let root = view_root(state, params)?;
    if state.previews.views.ids().len() >= VIEWS {
        return Err(RequestFailure::Refused(format!(
            "the limit of {VIEWS} open previews is reached: close one first"
        )));
    }
    state.previews.due = true;
    Ok(state.previews.views.open(root))
}

/// The root that is asked for: named, or that of a document.
fn view_root(
    state: &mut ServerState,
    params: SubscribeParams,
) -> Result<RootConfig, RequestFailure> {
    match (params.root, params.text_document) {
        (Some(root), _) => chosen(state, root),
        (None, Some(document)) => {
            let (path, _) = state.source(&document.uri)?;
            Ok(active_root(state, &path))
        }
        (None, None) => Err(RequestFailure::Invalid(
            "missing parameter: pass `root` or `textDocument`".to_owned(),
        )),
    }
}

fn client_names(state: &ServerState) -> ClientNames {
    let open = state.documents.iter();
    let uris = open
        .map(|(path, document)| (path.clone(), document.uri.to_string()))
        .collect();
    ClientNames {
        uris,
        encoding: state.encoding,
    }
}

/// The command `xacro.preview`: the address of a page that shows a robot.
#[cfg(feature = "preview")]
pub fn preview_page(state: &mut ServerState, argument: Value) -> Result<Value, RequestFailure> {
    let params = match argument {
        Value::String(uri) => json!({ "textDocument": { "uri": uri } }),
        other => other,
    };
    let shown = params.get("show") == Some(&Value::Bool(true));
    let params: SubscribeParams = serde_json::from_value(params)
        .map_err(|error| RequestFailure::Invalid(error.to_string()))?;
    let hub = hub(state)?;
    let root = view_root(state, params)?;
    let views = &state.previews.views;
    let same = |id: &u32| views.root(*id) == Some(&root) && hub.has(*id);
    let known = views.ids().into_iter().find(same);
    let id = match known {
        Some(id) => id,
        None => {
            let root = named(state, &root)?;
            open_view(
                state,
                SubscribeParams {
                    root: Some(root),
                    text_document: None,
                },
            )?
        }
    };
    hub.open(id);
    let url = hub.url(id);
    if shown && state.client.shows_documents {
        let page = Url::parse(&url).map_err(|error| RequestFailure::Invalid(error.to_string()))?;
        state.outbox.request(ClientRequest::ShowPage(page));
    }
    Ok(json!({ "url": url, "id": id }))
}

/// There is no server for browsers in this build.
#[cfg(not(feature = "preview"))]
pub fn preview_page(_: &mut ServerState, _: Value) -> Result<Value, RequestFailure> {
    Err(RequestFailure::Refused(
        "this build does not include the preview: build it with the feature `preview`".to_owned(),
    ))
}

fn no_view(id: u32) -> RequestFailure {
    RequestFailure::Invalid(format!("unknown preview {id}"))
}
