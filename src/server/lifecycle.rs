//! From `initialize` to the first scan: capabilities, settings, folders, progress.

use std::path::PathBuf;
use std::time::Duration;

use lsp_types::{
    DidChangeConfigurationParams, InitializeParams, InitializeResult, MessageType, PositionEncodingKind,
    Registration, ServerInfo, Url,
};
use serde_json::{Value, json};

use super::capabilities;
use super::client::{CLIENT_OPTIONS, ClientFacts, options};
use super::engine::Engine;
use super::exit::{Shutdown, watch_process};
use super::failure::Failure;
use super::outbox::Question;
use base::{CancelFlag, Encoding};
use ide::HintSettings;
use vfs::is_process_alive;
use workspace::config::unknown_settings;

impl Engine {
    pub fn initialize(
        &mut self,
        (params, shutdown): (InitializeParams, Shutdown),
        _: &CancelFlag,
    ) -> Result<InitializeResult, Failure> {
        self.client = ClientFacts::of(&params);
        // a client in another container or on another machine is not to be seen from here
        if let Some(process) = params.process_id.filter(|&process| is_process_alive(process)) {
            watch_process(process, shutdown);
        }
        self.encoding = encoding(&params);
        self.world.set_folders(folders(&params));
        self.first_settings = first_settings(&params);
        self.settings(&Value::Null);
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
        let folder = |scope: &Option<Url>| scope.as_ref().map(|uri| self.path(uri));
        let scoped = scopes.iter().zip(&values);
        let given = scoped.map(|(scope, value)| (self.effective(value), folder(scope))).collect();
        self.take_settings(given);
        self.schedule();
    }

    /// Settings of no folder in particular.
    fn settings(&mut self, value: &Value) {
        let given = vec![(self.effective(value), None)];
        self.take_settings(given);
    }

    /// What holds when a client gives this, with or without the section around it. Nothing is what it says when there
    /// are no settings, or none any more: what it began with holds then.
    fn effective(&self, value: &Value) -> Value {
        let settings = value.get("xacro").unwrap_or(value);
        if settings.is_object() { settings.clone() } else { self.first_settings.clone() }
    }

    /// Take settings over, in the place of all that held before: what is no longer said is the default again.
    fn take_settings(&mut self, given: Vec<(Value, Option<PathBuf>)>) {
        self.delay = Self::DELAY;
        self.snippets = true;
        self.hint_settings = HintSettings::default();
        self.world.set_all_contexts(false);
        for (settings, _) in &given {
            self.own_settings(settings);
        }
        let warnings = self.world.set_folder_settings(given);
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

/// What a client says of settings when it begins.
fn first_settings(params: &InitializeParams) -> Value {
    let mut settings = options(params).filter(|options| options.is_object()).cloned().unwrap_or(json!({}));
    if let Some(settings) = settings.as_object_mut() {
        settings.remove(CLIENT_OPTIONS);
    }
    settings
}

#[allow(deprecated)] // old clients send `rootUri`, and still older ones `rootPath`
fn folders(params: &InitializeParams) -> Vec<PathBuf> {
    let listed = params.workspace_folders.iter().flatten().map(|folder| &folder.uri);
    let mut uris: Vec<&Url> = listed.collect();
    if uris.is_empty() {
        uris.extend(&params.root_uri);
    }
    if uris.is_empty() {
        return params.root_path.iter().map(PathBuf::from).filter(|path| path.is_absolute()).collect();
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
