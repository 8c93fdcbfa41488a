//! From `initialize` to the first scan: capabilities, settings, folders, progress.

use crate::documents::refresh;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use lsp_types::{
    DidChangeConfigurationParams, InitializeParams, InitializeResult, MessageType,
    PositionEncodingKind, Registration, ServerInfo, SetTraceParams, TraceValue, Url,
};
use serde_json::{Value, json};

use crate::capabilities;
use crate::client::{CLIENT_OPTIONS, ResolvedCapabilities, options};
use crate::exit::{Shutdown, watch_process};
use crate::failure::Failure;
use crate::outbox::Question;
use crate::state::{Cause, State};
use base::{CancelFlag, Encoding};
use ide::HintSettings;
use vfs::is_process_alive;
use workspace::config::unknown_settings;

pub fn initialize(
    state: &mut State,
    (params, shutdown): (InitializeParams, Shutdown),
    _: &CancelFlag,
) -> Result<InitializeResult, Failure> {
    state.client = ResolvedCapabilities::of(&params);
    // a client in another container or on another machine is not to be seen from here
    if let Some(process) = params
        .process_id
        .filter(|&process| is_process_alive(process))
    {
        watch_process(process, shutdown);
    }
    state.encoding = encoding(&params);
    state.world.set_folders(folders(&params));
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

fn log_client(state: &State, params: &InitializeParams) {
    let client = params.client_info.as_ref();
    let version = client
        .and_then(|client| client.version.as_deref())
        .unwrap_or("");
    let name = client.map_or("unknown", |client| client.name.as_str());
    tracing::info!(
        folders = state.world.folders().len(),
        pulls_diagnostics = state.client.pulls_diagnostics,
        "connected to {}",
        format!("{name} {version}").trim_end()
    );
}

/// How much the client is told of what is logged.
pub fn set_trace(state: &mut State, params: SetTraceParams) {
    state.log.set_trace(params.value);
}

/// The last lines of the log, for a report of a defect.
pub fn last_lines(state: &mut State, (): (), _: &CancelFlag) -> Result<Vec<String>, Failure> {
    Ok(state.log.last())
}

pub fn client_ready(state: &mut State, (): ()) {
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
        state.outbox.ask(Question::Register(registrations));
    }
    ask_for_settings(state);
    if state.client.progress && !state.world.folders().is_empty() {
        state
            .outbox
            .ask(Question::CreateProgress("xacro/scan".to_owned()));
    }
}

/// Ask for the settings of each folder, where the client answers that.
pub fn ask_for_settings(state: &State) {
    if state.client.configuration {
        let folders = state
            .world
            .folders()
            .iter()
            .map(|folder| Url::from_file_path(folder).ok());
        let mut scopes: Vec<_> = folders.collect();
        if scopes.is_empty() {
            scopes.push(None);
        }
        state.outbox.ask(Question::Configuration(scopes));
    }
}

pub fn settings_changed(state: &mut State, params: DidChangeConfigurationParams) {
    match state.client.configuration {
        // the settings sent along are those of no folder in particular
        true => ask_for_settings(state),
        false => settings(state, &params.settings),
    }
    state.schedule(Cause::SettingsChanged);
}

/// The client's answer about settings: those of each folder hold for what lies in it.
pub fn configured(state: &mut State, (scopes, values): (Vec<Option<Url>>, Vec<Value>)) {
    let folder = |scope: &Option<Url>| scope.as_ref().map(|uri| state.path(uri));
    let scoped = scopes.iter().zip(&values);
    let given = scoped
        .map(|(scope, value)| (effective(state, value), folder(scope)))
        .collect();
    take_settings(state, given);
    state.schedule(Cause::SettingsChanged);
}

/// Settings of no folder in particular.
fn settings(state: &mut State, value: &Value) {
    let given = vec![(effective(state, value), None)];
    take_settings(state, given);
}

/// What holds when a client gives this, with or without the section around it. Nothing is what it says when there
/// are no settings, or none any more: what it began with holds then.
fn effective(state: &State, value: &Value) -> Value {
    let settings = value.get("xacro").unwrap_or(value);
    if settings.is_object() {
        settings.clone()
    } else {
        state.settings.initial.clone()
    }
}

/// Take settings over, in the place of all that held before: what is no longer said is the default again.
fn take_settings(state: &mut State, given: Vec<(Value, Option<PathBuf>)>) {
    state.schedule.delay = State::DELAY;
    state.settings.snippets = true;
    state.settings.hints = HintSettings::default();
    state.world.set_all_contexts(false);
    for (settings, _) in &given {
        own_settings(state, settings);
    }
    let warnings = state.world.set_folder_settings(given);
    for warning in warnings {
        warn_once(state, format!("settings: {warning}"));
    }
}

/// Take over what is the server's own: that holds for all folders.
fn own_settings(state: &mut State, settings: &Value) {
    if let Some(delay) = settings.pointer("/diagnostics/delay") {
        match delay.as_u64() {
            Some(delay) => state.schedule.delay = Duration::from_millis(delay.min(60_000)),
            None => {
                let message =
                    "`xacro.diagnostics.delay` is not a number of milliseconds; using the default";
                warn_once(state, message.to_owned());
            }
        }
    }
    let dotted = || settings.get("diagnostics.contexts");
    if let Some(contexts) = settings.pointer("/diagnostics/contexts").or_else(dotted) {
        state.world.set_all_contexts(contexts == "all");
        if contexts != "all" && contexts != "active" {
            let message =
                "`xacro.diagnostics.contexts` is not `active` or `all`; using the default";
            warn_once(state, message.to_owned());
        }
    }
    crate::requests::hints::settings(settings, &mut state.settings.hints);
    if let Some(snippets) = settings.pointer("/completion/snippets") {
        state.settings.snippets = snippets.as_bool().unwrap_or(true);
    }
    for unknown in unknown_settings(settings) {
        state.outbox.log(format!("settings: {unknown}"));
    }
}

/// Tell the user something about settings, once as long as the server lives.
fn warn_once(state: &mut State, message: String) {
    if state.sent.warnings.insert(message.clone()) {
        state.outbox.show(MessageType::WARNING, message);
    }
}

/// The client made the token for the scan, or will not show it.
pub fn progress_created(state: &mut State, made: bool) {
    if made {
        state.progress = Some("xacro/scan".to_owned());
        report_progress(
            state,
            json!({ "kind": "begin", "title": "Indexing robot descriptions" }),
        );
    }
    // some clients turn their sign from here on, whether it began or not
    if made && state.world.is_scanned() {
        end_progress(state);
    }
}

/// Look at more files of the workspace, until a job comes in.
pub fn scan(state: &mut State) {
    let status = state.status.clone();
    scan_until(state, &|| status.has_waiting());
}

/// Look at more files of the workspace, with progress, until `stop` says so; whether all were looked at.
fn scan_until(state: &mut State, stop: &dyn Fn() -> bool) -> bool {
    match state.world.scan(stop) {
        // still searching for them
        Some((_, 0)) => false,
        Some((done, total)) => {
            let message = format!("{done} of {total} files");
            report_progress(state, json!({ "kind": "report", "message": message }));
            false
        }
        None => {
            scanned(state);
            true
        }
    }
}

/// Look at all files of the workspace before an answer that would be wrong without one of them.
///
/// # Errors
/// The request was cancelled.
pub fn scan_all(state: &mut State, cancel: &CancelFlag) -> Result<(), Failure> {
    while !state.world.is_scanned() {
        let end = Instant::now() + State::SCAN_REPORT;
        if !scan_until(state, &|| cancel.is_cancelled() || Instant::now() >= end)
            && cancel.is_cancelled()
        {
            return Err(Failure::Cancelled);
        }
    }
    Ok(())
}

/// Look at the workspace before an answer that depends on it, when that takes a moment only: who asks for
/// diagnostics of a part as soon as it is open gets those of the robot around it.
pub fn scan_first(state: &mut State) {
    if state.initialized && !state.world.is_scanned() && state.world.scan_within(State::SCAN_FIRST)
    {
        scanned(state);
    }
}

/// Other roots may be known now.
fn scanned(state: &mut State) {
    tracing::info!(
        descriptions = state.world.known_files().len(),
        "workspace indexed"
    );
    end_progress(state);
    if !state.documents.is_empty() {
        state.schedule(Cause::Indexed);
        refresh(state);
    }
}

fn end_progress(state: &mut State) {
    report_progress(state, json!({ "kind": "end" }));
    state.progress = None;
}

fn report_progress(state: &State, value: Value) {
    if let Some(token) = &state.progress {
        state
            .outbox
            .tell("$/progress", &json!({ "token": token, "value": value }));
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
    uris.into_iter()
        .filter(|uri| uri.scheme() == "file")
        .filter_map(|uri| uri.to_file_path().ok())
        .collect()
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
