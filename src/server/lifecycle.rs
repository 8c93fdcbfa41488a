//! From `initialize` to the first scan: capabilities, settings, folders, progress.

use std::path::PathBuf;
use std::time::Duration;

use lsp_types::{
    DidChangeConfigurationParams, InitializeParams, InitializeResult, MessageType, PositionEncodingKind,
    Registration, ServerInfo, Url,
};
use serde_json::{Value, json};

use super::capabilities;
use super::client::ClientFacts;
use super::engine::Engine;
use super::exit::{Shutdown, watch_process};
use super::failure::Failure;
use super::outbox::Question;
use crate::base::{CancelFlag, Encoding};
use crate::workspace::config::unknown_settings;

impl Engine {
    pub fn initialize(
        &mut self,
        (params, shutdown): (InitializeParams, Shutdown),
        _: &CancelFlag,
    ) -> Result<InitializeResult, Failure> {
        self.client = ClientFacts::of(&params);
        if let Some(process) = params.process_id {
            watch_process(process, shutdown);
        }
        self.encoding = encoding(&params);
        self.world.set_folders(folders(&params));
        if let Some(options) = &params.initialization_options {
            self.settings(options);
        }
        let encoding = match self.encoding {
            Encoding::Utf8 => PositionEncodingKind::UTF8,
            _ => PositionEncodingKind::UTF16,
        };
        Ok(InitializeResult {
            capabilities: capabilities::offered(encoding, &self.client),
            server_info: Some(ServerInfo {
                name: "xacro-lsp".to_owned(),
                version: Some(env!("CARGO_PKG_VERSION").to_owned()),
            }),
        })
    }

    pub fn client_ready(&mut self, (): ()) {
        self.initialized = true;
        let mut registrations = Vec::new();
        if self.client.watches_files {
            registrations
                .push(registration("workspace/didChangeWatchedFiles", json!({ "watchers": watchers() })));
        }
        if self.client.registers_settings {
            registrations
                .push(registration("workspace/didChangeConfiguration", json!({ "section": "xacro" })));
        }
        if !registrations.is_empty() {
            self.outbox.ask(Question::Register(registrations));
        }
        self.ask_for_settings();
        if self.client.progress && !self.world.folders().is_empty() {
            self.outbox.ask(Question::CreateProgress("xacro/scan".to_owned()));
        }
    }

    /// Ask for the settings of each folder, where the client answers that.
    pub fn ask_for_settings(&self) {
        if self.client.configuration {
            let folders = self.world.folders().iter().map(|folder| Url::from_file_path(folder).ok());
            let mut scopes: Vec<_> = folders.collect();
            if scopes.is_empty() {
                scopes.push(None);
            }
            self.outbox.ask(Question::Configuration(scopes));
        }
    }

    pub fn settings_changed(&mut self, params: DidChangeConfigurationParams) {
        match self.client.configuration {
            // the settings sent along are those of no folder in particular
            true => self.ask_for_settings(),
            false => self.settings(&params.settings),
        }
        self.schedule();
    }

    /// The client's answer about settings: those of each folder hold for what lies in it.
    pub fn configured(&mut self, (scopes, values): (Vec<Option<Url>>, Vec<Value>)) {
        let first = self.world.folders().first().cloned();
        let mut of_folders = Vec::new();
        for (scope, value) in scopes.iter().zip(&values) {
            let settings = value.get("xacro").unwrap_or(value);
            let folder = scope.as_ref().map(|uri| self.path(uri)).or_else(|| first.clone());
            match folder.filter(|_| settings.is_object()) {
                Some(folder) => {
                    self.own_settings(settings);
                    of_folders.push((settings.clone(), folder));
                }
                None => self.settings(value),
            }
        }
        if !of_folders.is_empty() {
            let warnings = self.world.set_folder_settings(of_folders);
            self.warn_of_settings(warnings);
        }
        self.schedule();
    }

    /// Take settings over, with or without the section around them.
    fn settings(&mut self, settings: &Value) {
        let settings = settings.get("xacro").unwrap_or(settings);
        if !settings.is_object() {
            return;
        }
        self.own_settings(settings);
        let warnings = self.world.set_editor_settings(settings.clone());
        self.warn_of_settings(warnings);
    }

    fn warn_of_settings(&mut self, warnings: Vec<String>) {
        for warning in warnings {
            self.warn_once(format!("settings: {warning}"));
        }
    }

    /// Take over what is the server's own: that holds for all folders.
    fn own_settings(&mut self, settings: &Value) {
        if let Some(delay) = settings.pointer("/diagnostics/delay") {
            match delay.as_u64() {
                Some(delay) => self.delay = Duration::from_millis(delay.min(60_000)),
                None => {
                    let message = "`xacro.diagnostics.delay` is no number of milliseconds; the default holds";
                    self.warn_once(message.to_owned());
                }
            }
        }
        let dotted = || settings.get("diagnostics.contexts");
        if let Some(contexts) = settings.pointer("/diagnostics/contexts").or_else(dotted) {
            self.world.set_all_contexts(contexts == "all");
            if contexts != "all" && contexts != "active" {
                let message = "`xacro.diagnostics.contexts` is neither `active` nor `all`; the default holds";
                self.warn_once(message.to_owned());
            }
        }
        super::hints::settings(settings, &mut self.hint_settings);
        if let Some(snippets) = settings.pointer("/completion/snippets") {
            self.snippets = snippets.as_bool().unwrap_or(true);
        }
        for unknown in unknown_settings(settings) {
            self.outbox.log(format!("settings: {unknown}"));
        }
    }

    /// Tell the user something about settings, once as long as the server lives.
    fn warn_once(&mut self, message: String) {
        if self.warned.insert(message.clone()) {
            self.outbox.show(MessageType::WARNING, message);
        }
    }

    /// The client made the token for the scan, or will not show it.
    pub fn progress_created(&mut self, made: bool) {
        if made {
            self.progress = Some("xacro/scan".to_owned());
            self.report_progress(json!({ "kind": "begin", "title": "Indexing robot descriptions" }));
        }
        // some clients turn their sign from here on, whether it began or not
        if made && self.world.is_scanned() {
            self.end_progress();
        }
    }

    /// Look at more files of the workspace, until a job comes in.
    pub fn scan(&mut self) {
        let pressure = self.pressure.clone();
        match self.world.scan(|| pressure.is_high()) {
            // still searching for them
            Some((_, 0)) => {}
            Some((done, total)) => {
                let message = format!("{done} of {total} files");
                self.report_progress(json!({ "kind": "report", "message": message }));
            }
            None => self.scanned(),
        }
    }

    /// Look at the workspace before an answer that depends on it, when that takes a moment only: who asks for
    /// diagnostics of a part as soon as it is open gets those of the robot around it.
    pub fn scan_first(&mut self) {
        if self.initialized && !self.world.is_scanned() && self.world.scan_within(Self::SCAN_FIRST) {
            self.scanned();
        }
    }

    /// Other roots may be known now.
    fn scanned(&mut self) {
        self.end_progress();
        if !self.documents.is_empty() {
            self.schedule();
            self.refresh();
        }
    }

    fn end_progress(&mut self) {
        self.report_progress(json!({ "kind": "end" }));
        self.progress = None;
    }

    fn report_progress(&self, value: Value) {
        if let Some(token) = &self.progress {
            self.outbox.tell("$/progress", &json!({ "token": token, "value": value }));
        }
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

#[allow(deprecated)] // old clients send `rootUri`
fn folders(params: &InitializeParams) -> Vec<PathBuf> {
    let listed = params.workspace_folders.iter().flatten().map(|folder| &folder.uri);
    let mut uris: Vec<&Url> = listed.collect();
    if uris.is_empty() {
        uris.extend(&params.root_uri);
    }
    uris.into_iter().filter(|uri| uri.scheme() == "file").filter_map(|uri| uri.to_file_path().ok()).collect()
}

fn registration(method: &str, options: Value) -> Registration {
    Registration { id: method.to_owned(), method: method.to_owned(), register_options: Some(options) }
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
    patterns.iter().map(|pattern| json!({ "globPattern": pattern })).collect()
}
