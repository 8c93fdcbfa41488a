//! From `initialize` to the first scan: capabilities, settings, folders, progress.
use std::path::PathBuf;

use lsp_types::{
    InitializeParams, InitializeResult, InitializedParams, PositionEncodingKind, Registration,
    ServerInfo, SetTraceParams, TraceValue, Url,
};
use serde_json::{Value, json};

use crate::capabilities;
use crate::client::{CLIENT_OPTIONS, ResolvedCapabilities, options};
use crate::convert;
use crate::exit::watch_process;
use crate::failure::RequestFailure;
use crate::outbox::ClientRequest;
use crate::settings::{request_settings, settings};
use crate::state::ServerState;
use base::{CancelFlag, Encoding};
use vfs::is_process_alive;

pub fn initialize(
    state: &mut ServerState,
    params: InitializeParams,
    _: &CancelFlag,
) -> Result<InitializeResult, RequestFailure> {
    state.client = ResolvedCapabilities::of(&params);
    // a client in another container or on another machine is not to be seen from here
    let process = params.process_id.zip(state.shutdown.clone());
    if let Some((process, shutdown)) = process.filter(|(process, _)| is_process_alive(*process)) {
        watch_process(process, shutdown);
    }
    state.encoding = encoding(&params);
    state.host.set_folders(folders(&params));
    state.log.set_trace(params.trace.unwrap_or(TraceValue::Off));
    log_client(state, &params);
    state.settings.initial = first_settings(&params);
    settings(state, &Value::Null);
    let encoding = match state.encoding {
        Encoding::Utf8 => PositionEncodingKind::UTF8,
        _ => PositionEncodingKind::UTF16,
    };
    Ok(InitializeResult {
        capabilities: capabilities::offered(encoding, &state.client),
        server_info: Some(ServerInfo {
            name: "xacro-lsp".to_owned(),
            version: Some(env!("CARGO_PKG_VERSION").to_owned()),
        }),
    })
}

fn log_client(state: &ServerState, params: &InitializeParams) {
    let client = params.client_info.as_ref();
    let version = client
        .and_then(|client| client.version.as_deref())
        .unwrap_or("");
    let name = client.map_or("unknown", |client| client.name.as_str());
    tracing::info!(
        folders = state.host.folders().len(),
        pulls_diagnostics = state.client.pulls_diagnostics,
        "connected to {}",
        format!("{name} {version}").trim_end()
    );
}

/// How much the client is told of what is logged.
pub fn set_trace(state: &mut ServerState, params: SetTraceParams) {
    state.log.set_trace(params.value);
}

/// The last lines of the log, for a report of a defect.
pub fn last_lines(
    state: &mut ServerState,
    _: Value,
    _: &CancelFlag,
) -> Result<Vec<String>, RequestFailure> {
    Ok(state.log.last())
}

/// Fail as a fault of ours would.
#[cfg(debug_assertions)]
#[allow(clippy::panic, reason = "that is what it is for")]
pub fn fail(_: &mut ServerState, _: Value, _: &CancelFlag) -> Result<Value, RequestFailure> {
    panic!("this job was asked to fail")
}

pub fn client_ready(state: &mut ServerState, _: InitializedParams) {
    state.initialized = true;
    let mut registrations = Vec::new();
    if state.client.watches_files {
        registrations.push(registration(
            "workspace/didChangeWatchedFiles",
            json!({ "watchers": watchers() }),
        ));
    }
    if state.client.registers_settings {
        registrations.push(registration(
            "workspace/didChangeConfiguration",
            json!({ "section": "xacro" }),
        ));
    }
    if !registrations.is_empty() {
        state.outbox.request(ClientRequest::Register(registrations));
    }
    request_settings(state);
    if state.client.configuration {
        state.diagnostics.hold_for_settings();
    }
    if state.client.progress && !state.host.folders().is_empty() {
        state
            .outbox
            .request(ClientRequest::CreateProgress("xacro/scan".to_owned()));
    }
}

/// UTF-8 when the client prefers it, else UTF-16.
fn encoding(params: &InitializeParams) -> Encoding {
    let general = params.capabilities.general.as_ref();
    let offered = general.and_then(|general| general.position_encodings.as_ref());
    match offered.and_then(|offered| offered.first()) {
        Some(first) if *first == PositionEncodingKind::UTF8 => Encoding::Utf8,
        _ => Encoding::Utf16,
    }
}

/// What a client says of settings when it begins.
fn first_settings(params: &InitializeParams) -> Value {
    let mut settings = options(params)
        .filter(|options| options.is_object())
        .cloned()
        .unwrap_or(json!({}));
    if let Some(settings) = settings.as_object_mut() {
        settings.remove(CLIENT_OPTIONS);
    }
    settings
}

#[allow(deprecated)] // old clients send `rootUri`, and still older ones `rootPath`
fn folders(params: &InitializeParams) -> Vec<PathBuf> {
    let listed = params
        .workspace_folders
        .iter()
        .flatten()
        .map(|folder| &folder.uri);
    let mut uris: Vec<&Url> = listed.collect();
    if uris.is_empty() {
        uris.extend(&params.root_uri);
    }
    if uris.is_empty() {
        return params
            .root_path
            .iter()
            .map(PathBuf::from)
            .filter(|path| path.is_absolute())
            .collect();
    }
    uris.into_iter().filter_map(convert::file_path).collect()
}

fn registration(method: &str, options: Value) -> Registration {
    Registration {
        id: method.to_owned(),
        method: method.to_owned(),
        register_options: Some(options),
    }
}

fn watchers() -> Value {
    let patterns = [
        "**/*.{xacro,urdf,srdf,sdf,yaml,yml,XACRO,URDF,Xacro,Urdf}",
        "**/{package.xml,CMakeLists.txt,setup.py}",
        "**/*.in",
        "**/*.{stl,STL,dae,DAE,obj,OBJ,glb,GLB,ply}",
        "**/{xacro-lint.toml,.xacro-lint.toml}",
        "**/COLCON_IGNORE",
    ];
    patterns
        .iter()
        .map(|pattern| json!({ "globPattern": pattern }))
        .collect()
}
