//! Settings of the client.
use std::path::PathBuf;
use std::time::Duration;

use lsp_types::{DidChangeConfigurationParams, MessageType, Url};
use serde_json::Value;

use crate::convert;
use crate::outbox::ClientRequest;
use crate::scheduler::Cause;
use crate::state::ServerState;
use ide::HintSettings;
use workspace::config::unknown_settings;

/// Ask for the settings of each folder, where the client answers that.
pub fn request_settings(state: &ServerState) {
    if state.client.configuration {
        let folders = state
            .host
            .folders()
            .iter()
            .map(|folder| convert::file_uri(folder));
        let mut scopes: Vec<_> = folders.collect();
        if scopes.is_empty() {
            scopes.push(None);
        }
        state.outbox.request(ClientRequest::Configuration(scopes));
    }
}

pub fn settings_changed(state: &mut ServerState, params: DidChangeConfigurationParams) {
    if state.client.configuration {
        // the settings sent along are those of no folder in particular
        request_settings(state);
    } else {
        settings(state, &params.settings);
    }
    state.schedule(Cause::SettingsChanged);
}

/// The client's answer about settings: those of each folder hold for what lies in it.
pub fn configured(state: &mut ServerState, scopes: &[Option<Url>], values: &[Value]) {
    let scoped = scopes.iter().zip(values);
    let given = scoped
        .map(|(scope, value)| {
            let folder = scope.as_ref().map(|uri| state.path(uri));
            (effective(state, value), folder)
        })
        .collect();
    take_settings(state, given);
    state.diagnostics.release();
    state.schedule(Cause::SettingsChanged);
}

/// Settings of no folder in particular.
pub(super) fn settings(state: &mut ServerState, value: &Value) {
    let given = vec![(effective(state, value), None)];
    take_settings(state, given);
}

/// What holds when a client gives this, with or without the section around it. Nothing is what it says when there
/// are no settings, or none any more: what it began with holds then.
fn effective(state: &ServerState, value: &Value) -> Value {
    let settings = value.get("xacro").unwrap_or(value);
    if settings.is_object() {
        settings.clone()
    } else {
        state.settings.initial.clone()
    }
}

/// Take settings over, in the place of all that held before: what is no longer said is the default again.
fn take_settings(state: &mut ServerState, given: Vec<(Value, Option<PathBuf>)>) {
    state.diagnostics.set_delay(None);
    state.settings.snippets = true;
    state.settings.hints = HintSettings::default();
    state.host.set_all_contexts(false);
    for (settings, _) in &given {
        own_settings(state, settings);
    }
    let warnings = state.host.set_folder_settings(given);
    for warning in warnings {
        warn_once(state, format!("settings: {warning}"));
    }
}

/// Take over what is the server's own: that holds for all folders.
fn own_settings(state: &mut ServerState, settings: &Value) {
    if let Some(delay) = settings.pointer("/diagnostics/delay") {
        match delay.as_u64() {
            Some(delay) => {
                let delay = Duration::from_millis(delay.min(60_000));
                state.diagnostics.set_delay(Some(delay));
            }
            None => {
                let message =
                    "`xacro.diagnostics.delay` is not a number of milliseconds; using the default";
                warn_once(state, message.to_owned());
            }
        }
    }
    let dotted = || settings.get("diagnostics.contexts");
    if let Some(contexts) = settings.pointer("/diagnostics/contexts").or_else(dotted) {
        state.host.set_all_contexts(contexts == "all");
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
fn warn_once(state: &mut ServerState, message: String) {
    if state.sent.warnings.insert(message.clone()) {
        state.outbox.show(MessageType::WARNING, message);
    }
}
