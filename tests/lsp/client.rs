//! A small client: one server process, requests by method and JSON, positions by their text.

use std::collections::HashMap;
use std::io::{BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{self, Receiver};
use std::time::{Duration, Instant};

use serde_json::{Map, Value, json};

use super::messages::{merge, read, remove, usual};
use super::positions::{offset, position, short};
use super::workspace;

/// No answer may take longer; a slow machine under load is no reason to fail.
const PATIENCE: Duration = Duration::from_secs(60);

/// How a client differs from the usual one.
#[derive(Clone, Default)]
pub struct Options {
    pub capabilities: Value,
    /// What is taken away from the capabilities, as JSON pointers; the empty one takes all.
    pub without: Vec<&'static str>,
    pub settings: Value,
    /// What `initialize` says, beyond that there is no delay.
    pub first: Value,
    /// Settings of single folders, by their names.
    pub folder_settings: HashMap<String, Value>,
    /// Answer no request of the server.
    pub deaf: bool,
    /// No folder is open.
    pub no_folder: bool,
    /// The value of `XACRO_LOG`; standard error is kept then.
    pub log: Option<&'static str>,
}

pub struct Client {
    pub folder: PathBuf,
    pub child: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    next_id: i64,
    replies: HashMap<i64, Value>,
    /// Diagnostics by file: the version they are for, and the list.
    published: HashMap<String, (Option<i64>, Vec<Value>)>,
    texts: HashMap<String, (i64, String)>,
    options: Options,
    /// Notifications other than diagnostics.
    pub notes: Vec<Value>,
    /// Requests of the server.
    pub asked: Vec<Value>,
}

impl Client {
    /// A server on the pan-tilt workspace, ready for requests.
    pub fn start() -> Self {
        Self::with(workspace::pan_tilt(), Options::default())
    }

    /// A server on a folder.
    pub fn with(folder: PathBuf, options: Options) -> Self {
        let mut client = Self::spawn(folder, options);
        client.initialize();
        client
    }

    /// A server that was not spoken to yet.
    pub fn spawn(folder: PathBuf, options: Options) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_xacro-lsp"))
            .current_dir(&folder)
            .env_remove("ROS_PACKAGE_PATH")
            .env("AMENT_PREFIX_PATH", folder.join("none"))
            .envs(options.log.map(|log| ("XACRO_LOG", log)))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(if options.log.is_some() {
                Stdio::piped()
            } else {
                Stdio::inherit()
            })
            .spawn()
            .unwrap();
        let (sender, messages) = mpsc::channel();
        let output = child.stdout.take().unwrap();
        std::thread::spawn(move || {
            let mut output = BufReader::new(output);
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let input = child.stdin.take();
        let (replies, published, texts) = (HashMap::new(), HashMap::new(), HashMap::new());
        let (notes, asked) = (Vec::new(), Vec::new());
        Self {
            folder,
            child,
            input,
            messages,
            next_id: 0,
            replies,
            published,
            texts,
            options,
            notes,
            asked,
        }
    }

    pub fn initialize(&mut self) -> Value {
        let mut capabilities = usual();
        capabilities["workspace"]["configuration"] = json!(!self.options.settings.is_null());
        merge(&mut capabilities, &self.options.capabilities);
        for pointer in &self.options.without {
            remove(&mut capabilities, pointer);
        }
        let folders = json!([{ "uri": uri(&self.folder), "name": "ws" }]);
        let mut first = json!({ "diagnostics": { "delay": 0 } });
        merge(&mut first, &self.options.first);
        let result = self.request(
            "initialize",
            json!({
                "processId": std::process::id(),
                "rootUri": null,
                "capabilities": capabilities,
                "workspaceFolders": if self.options.no_folder { Value::Null } else { folders },
                "initializationOptions": first,
            }),
        );
        self.notify("initialized", json!({}));
        result
    }

    pub fn uri(&self, file: &str) -> String {
        uri(&self.folder.join(file))
    }

    pub fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.send_raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    pub fn send_raw(&mut self, bytes: &[u8]) {
        let input = self.input.as_mut().expect("the input is open");
        input
            .write_all(bytes)
            .and_then(|()| input.flush())
            .expect("the server reads");
    }

    /// Close the server's input.
    pub fn hang_up(&mut self) {
        self.input = None;
    }

    pub fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// Send a request; its id.
    pub fn post(&mut self, method: &str, params: Value) -> i64 {
        self.next_id += 1;
        let id = self.next_id;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        id
    }

    /// The whole reply to a request.
    pub fn reply(&mut self, id: i64) -> Value {
        self.wait(
            |client| client.replies.remove(&id),
            || format!("reply to request {id}"),
        )
    }

    /// The result of a request that must succeed.
    #[track_caller]
    pub fn request(&mut self, method: &str, params: Value) -> Value {
        let id = self.post(method, params);
        let reply = self.reply(id);
        assert!(reply.get("error").is_none(), "{method}: {reply}");
        reply["result"].clone()
    }

    /// Take messages in until `found` finds something.
    pub fn wait<T>(
        &mut self,
        mut found: impl FnMut(&mut Self) -> Option<T>,
        what: impl Fn() -> String,
    ) -> T {
        let begin = Instant::now();
        loop {
            if let Some(value) = found(self) {
                return value;
            }
            let left = PATIENCE.saturating_sub(begin.elapsed());
            match self.messages.recv_timeout(left) {
                Ok(message) => self.take(message),
                Err(error) => panic!("waiting for the {}: {error}", what()),
            }
        }
    }

    fn take(&mut self, message: Value) {
        let method = message["method"].as_str().map(str::to_owned);
        match (method.as_deref(), message.get("id")) {
            (Some(method), Some(id)) => {
                let result = match method {
                    "workspace/configuration" => {
                        let items = message["params"]["items"]
                            .as_array()
                            .cloned()
                            .unwrap_or_default();
                        items
                            .iter()
                            .map(|item| self.settings_of(&item["scopeUri"]))
                            .collect()
                    }
                    _ => Value::Null,
                };
                let reply = json!({ "jsonrpc": "2.0", "id": id, "result": result });
                self.asked.push(message);
                if !self.options.deaf {
                    self.send(&reply);
                }
            }
            (Some("textDocument/publishDiagnostics"), None) => {
                let params = &message["params"];
                let list = params["diagnostics"]
                    .as_array()
                    .cloned()
                    .unwrap_or_default();
                let file = params["uri"].as_str().unwrap().to_owned();
                self.published
                    .insert(file, (params["version"].as_i64(), list));
            }
            (Some(_), None) => self.notes.push(message),
            (None, _) => {
                let id = message["id"].as_i64().unwrap_or(-1);
                self.replies.insert(id, message);
            }
        }
    }

    /// The settings of a folder: those of all, unless it has its own by its name.
    fn settings_of(&self, scope: &Value) -> Value {
        let name = scope
            .as_str()
            .and_then(|uri| uri.rsplit('/').next())
            .unwrap_or("");
        self.options
            .folder_settings
            .get(name)
            .unwrap_or(&self.options.settings)
            .clone()
    }

    /// Open a file of the workspace with the text it has on the disk.
    pub fn open(&mut self, file: &str) {
        let text = std::fs::read_to_string(self.folder.join(file)).unwrap();
        self.open_with(file, &text);
    }

    pub fn open_with(&mut self, file: &str, text: &str) {
        let uri = self.uri(file);
        self.texts.insert(uri.clone(), (1, text.to_owned()));
        let document = json!({ "uri": uri, "languageId": "xacro", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replace the first `old` in an open file by `new`, as one incremental change.
    #[track_caller]
    pub fn edit(&mut self, file: &str, old: &str, new: &str) {
        let uri = self.uri(file);
        let (version, text) = self.texts.get_mut(&uri).expect("open");
        let start = text
            .find(old)
            .unwrap_or_else(|| panic!("`{old}` in {file}"));
        let range =
            json!({ "start": position(text, start), "end": position(text, start + old.len()) });
        text.replace_range(start..start + old.len(), new);
        *version += 1;
        let version = *version;
        self.notify(
            "textDocument/didChange",
            json!({
                "textDocument": { "uri": uri, "version": version },
                "contentChanges": [{ "range": range, "text": new }],
            }),
        );
    }

    pub fn is_open(&self, file: &str) -> bool {
        self.texts.contains_key(&self.uri(file))
    }

    pub fn text(&self, file: &str) -> &str {
        let (_, text) = &self.texts[&self.uri(file)];
        text
    }

    /// The diagnostics for the current text of an open file, in short: `line:start-end code`, lines from 1.
    pub fn findings(&mut self, file: &str) -> Vec<String> {
        let list = self.diagnostics(file);
        list.iter().map(short).collect()
    }

    /// The diagnostics for the current text of an open file.
    pub fn diagnostics(&mut self, file: &str) -> Vec<Value> {
        let uri = self.uri(file);
        let version = self.texts[&uri].0;
        let current = |client: &mut Self| {
            let (published, list) = client.published.get(&uri)?;
            (*published == Some(version)).then(|| list.clone())
        };
        self.wait(current, || {
            format!("diagnostics of {file} at version {version}")
        })
    }

    /// The first diagnostics of a file that is not open, in short.
    pub fn findings_of_closed(&mut self, file: &str) -> Vec<String> {
        let uri = self.uri(file);
        let list = self.wait(
            |client| client.published.get(&uri).map(|(_, list)| list.clone()),
            || format!("diagnostics of {file}"),
        );
        list.iter().map(short).collect()
    }

    /// Other settings than before, for when the server asks again.
    pub fn change_settings(&mut self, settings: Value) {
        self.options.settings = settings;
    }

    /// Whether diagnostics of a file arrive that carry a version.
    pub fn have_version(&mut self, file: &str) -> bool {
        let uri = self.uri(file);
        let found = |client: &mut Self| {
            client
                .published
                .get(&uri)
                .map(|(version, _)| version.is_some())
        };
        self.wait(found, || format!("diagnostics of {file}"))
    }

    /// The place in an open file that `pattern` marks with `|`: parameters of a request about a position.
    #[track_caller]
    pub fn at(&self, file: &str, pattern: &str) -> Value {
        let text = self.text(file);
        let (before, behind) = pattern.split_once('|').expect("a `|` in the pattern");
        let whole = format!("{before}{behind}");
        let start = text
            .find(&whole)
            .unwrap_or_else(|| panic!("`{whole}` in {file}"));
        json!({ "textDocument": { "uri": self.uri(file) }, "position": position(text, start + before.len()) })
    }

    /// The changes of renaming what `at` marks; or the message of the error.
    pub fn changes_of_rename(
        &mut self,
        file: &str,
        at: &str,
        new: &str,
    ) -> Result<Map<String, Value>, String> {
        let mut params = self.at(file, at);
        params["newName"] = json!(new);
        let id = self.post("textDocument/rename", params);
        let reply = self.reply(id);
        match reply.get("error") {
            Some(error) => Err(error["message"].as_str().unwrap().to_owned()),
            None => Ok(reply["result"]["changes"].as_object().unwrap().clone()),
        }
    }

    /// Parameters of a request about a file.
    pub fn of(&self, file: &str) -> Value {
        json!({ "textDocument": { "uri": self.uri(file) } })
    }

    /// The text that a range of an open file covers.
    pub fn slice(&self, file: &str, range: &Value) -> String {
        let text = self.text(file);
        text[offset(text, &range["start"])..offset(text, &range["end"])].to_owned()
    }

    /// The text of an open file after an edit of the workspace that changes it.
    #[track_caller]
    pub fn after(&self, file: &str, edit: &Value) -> String {
        let edits = edit["changes"][self.uri(file)]
            .as_array()
            .expect("changes of the file");
        self.after_edits(file, edits)
    }

    /// The text of an open file after edits.
    pub fn after_edits(&self, file: &str, edits: &[Value]) -> String {
        let mut text = self.text(file).to_owned();
        let place = |edit: &Value| {
            let range = &edit["range"];
            (
                offset(self.text(file), &range["start"]),
                offset(self.text(file), &range["end"]),
            )
        };
        let mut places: Vec<((usize, usize), &Value)> =
            edits.iter().map(|edit| (place(edit), edit)).collect();
        places.sort_by_key(|(place, _)| *place);
        for pair in places.windows(2) {
            assert!(pair[0].0.1 <= pair[1].0.0, "edits overlap: {edits:?}");
        }
        for ((start, end), edit) in places.into_iter().rev() {
            text.replace_range(start..end, edit["newText"].as_str().unwrap());
        }
        text
    }

    /// A location in short: `file:line text`, where the file is open.
    pub fn shown(&self, uri: &str, range: &Value) -> String {
        let name = uri.rsplit('/').next().unwrap();
        let line = range["start"]["line"].as_u64().unwrap() + 1;
        let text = self.texts.get(uri).map_or(String::new(), |(_, text)| {
            text[offset(text, &range["start"])..offset(text, &range["end"])].to_owned()
        });
        format!("{name}:{line} {text}")
    }

    /// Ask until it holds: settings arrive when the server has asked for them. Whether it did in the end.
    pub fn eventually(&mut self, mut holds: impl FnMut(&mut Self) -> bool) -> bool {
        let begin = Instant::now();
        while begin.elapsed() < PATIENCE {
            while let Ok(message) = self.messages.try_recv() {
                self.take(message);
            }
            if holds(self) {
                return true;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        false
    }

    /// Wait for the end of the process; its exit code.
    /// What the server wrote to standard error, once it ended.
    pub fn errors(&mut self) -> String {
        self.request("shutdown", Value::Null);
        self.notify("exit", Value::Null);
        self.exit_code();
        let mut text = String::new();
        let _ = self
            .child
            .stderr
            .take()
            .map(|mut errors| errors.read_to_string(&mut text));
        text
    }

    pub fn exit_code(&mut self) -> i32 {
        let begin = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code().expect("no signal");
            }
            assert!(begin.elapsed() < PATIENCE, "the server does not end");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

pub fn uri(path: &Path) -> String {
    format!("file://{}", path.display())
}
