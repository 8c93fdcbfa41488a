//! A whole session, as a page in a browser has it.

#![allow(clippy::unwrap_used, clippy::indexing_slicing)] // a test may fail loudly

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde_json::{Value, json};

use super::Embedded;
use analysis::{CheckOptions, Session, Setup};
use vfs::{Environment, Vfs};

const ROBOT: &str = "\
<robot name=\"crane\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:include filename=\"parts.xacro\"/>
  <xacro:property name=\"reach\" value=\"${2 * 0.75}\"/>
  <xacro:boom length=\"${reach}\"/>
  <xacro:boon length=\"1\"/>
</robot>
";
const PARTS: &str = "\
<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:macro name=\"boom\" params=\"length\">
    <link name=\"boom\">
      <visual><geometry><mesh filename=\"package://crane/meshes/boom.stl\"/></geometry></visual>
    </link>
  </xacro:macro>
</robot>
";

/// A client of a server over files in memory.
struct Client {
    server: Embedded,
    vfs: Arc<Vfs>,
    env: Environment,
    came: Vec<Value>,
    asked: i64,
}

impl Client {
    fn new() -> Self {
        let cwd = PathBuf::from("/workspace");
        let env = Environment {
            cwd: cwd.clone(),
            ..Environment::default()
        };
        let vfs = Arc::new(Vfs::in_memory(1_000_000, cwd));
        let manifest = "<package format=\"3\"><name>crane</name></package>";
        for (path, text) in [
            ("crane/package.xml", manifest),
            ("crane/urdf/crane.urdf.xacro", ROBOT),
            ("crane/urdf/parts.xacro", PARTS),
        ] {
            vfs.put(Path::new(path), Some(text.as_bytes().to_vec()));
        }
        vfs.put_name(Path::new("crane/meshes/boom.stl"));
        Self {
            server: Embedded::new(vfs.clone(), env.clone()),
            vfs,
            env,
            came: Vec::new(),
            asked: 0,
        }
    }

    fn tell(&mut self, method: &str, params: Value) {
        let message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        self.server.receive(message.to_string().as_bytes());
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.asked += 1;
        let message =
            json!({ "jsonrpc": "2.0", "id": self.asked, "method": method, "params": params });
        self.server.receive(message.to_string().as_bytes());
        self.work();
        let own = json!(self.asked);
        let answer = self
            .came
            .iter()
            .find(|message| message["id"] == own && message["method"].is_null());
        answer.unwrap()["result"].clone()
    }

    /// Let the server work until it has nothing to do; what it asks is answered.
    fn work(&mut self) {
        loop {
            let wait = self.server.poll();
            let mut replied = false;
            while let Some(message) = self.server.outgoing() {
                let message: Value = serde_json::from_slice(&message).unwrap();
                if message["method"].is_string() && !message["id"].is_null() {
                    let result = match message["method"].as_str() {
                        Some("workspace/configuration") => json!([null]),
                        _ => Value::Null,
                    };
                    let reply = json!({ "jsonrpc": "2.0", "id": message["id"], "result": result });
                    self.server.receive(reply.to_string().as_bytes());
                    replied = true;
                }
                self.came.push(message);
            }
            match wait {
                Some(wait) => std::thread::sleep(wait),
                None if !replied => return,
                None => {}
            }
        }
    }

    /// What was said last about a file, with the place of each message.
    fn findings(&self, uri: &str) -> Vec<(u64, String)> {
        let published = self.came.iter().rfind(|message| {
            message["method"] == "textDocument/publishDiagnostics"
                && message["params"]["uri"] == *uri
        });
        let list = published.unwrap()["params"]["diagnostics"]
            .as_array()
            .unwrap()
            .clone();
        let line = |each: &Value| each["range"]["start"]["line"].as_u64().unwrap() + 1;
        let mut found: Vec<_> = list
            .iter()
            .map(|each| (line(each), each["message"].as_str().unwrap().to_owned()))
            .collect();
        found.sort();
        found
    }

    /// What `check` says of the same files.
    fn checked(&self) -> Vec<Value> {
        let options = CheckOptions {
            paths: vec![PathBuf::from(".")],
            ..CheckOptions::default()
        };
        let setup = Setup {
            folders: vec![self.env.cwd.clone()],
            ..Setup::default()
        };
        let session = Session::over(self.vfs.clone(), &self.env, setup);
        let report = analysis::to_json(&analysis::check(&session, &options), &self.env.cwd);
        serde_json::from_str(&report).unwrap()
    }
}

#[test]
fn a_session() {
    let mut client = Client::new();
    let uri = "file:///workspace/crane/urdf/crane.urdf.xacro";
    let document = json!({ "uri": uri });
    let folders = json!([{ "uri": "file:///workspace/crane", "name": "crane" }]);
    let capabilities = json!({ "workspace": { "configuration": true } });
    let begun = client.ask(
        "initialize",
        json!({ "processId": 1, "workspaceFolders": folders, "capabilities": capabilities }),
    );
    assert_eq!(begun["serverInfo"]["name"], "xacro-lsp");
    client.tell("initialized", json!({}));
    let opened = json!({ "uri": uri, "languageId": "xacro", "version": 1, "text": ROBOT });
    client.tell("textDocument/didOpen", json!({ "textDocument": opened }));
    client.work();

    let found = client.findings(uri);
    let checked = client.checked();
    let here = checked.iter().filter(|finding| {
        finding["filename"]
            .as_str()
            .unwrap()
            .ends_with("crane.urdf.xacro")
    });
    let mut expected: Vec<_> = here
        .map(|finding| {
            (
                finding["location"]["row"].as_u64().unwrap(),
                finding["message"].as_str().unwrap().to_owned(),
            )
        })
        .collect();
    expected.sort();
    let lines = |found: &[(u64, String)]| found.iter().map(|(line, _)| *line).collect::<Vec<_>>();
    assert!(lines(&found).contains(&5), "{found:?}");
    assert_eq!(lines(&found), lines(&expected), "{found:?} {expected:?}");
    for ((_, shown), (_, message)) in found.iter().zip(&expected) {
        assert!(
            shown.to_lowercase().starts_with(&message.to_lowercase()),
            "{shown}: {message}"
        );
    }

    // the mesh is asked for, and nothing was said of its content
    assert_eq!(
        client.server.wanted(),
        [PathBuf::from("/workspace/crane/meshes/boom.stl")]
    );
    let said = client.came.iter().map(Value::to_string);
    assert!(!said.into_iter().any(|message| message.contains("boom.stl")));

    let at = json!({ "textDocument": document, "position": { "line": 3, "character": 28 } });
    let shown = client.ask("textDocument/hover", at);
    assert!(shown.to_string().contains("1.5"), "{shown}");

    // a name that is being typed
    let typed = ROBOT.replace("  <xacro:boon length=\"1\"/>\n", "  <xacro:bo\n");
    let change = json!({ "textDocument": { "uri": uri, "version": 2 }, "contentChanges": [{ "text": typed }] });
    client.tell("textDocument/didChange", change);
    let at = json!({ "textDocument": document, "position": { "line": 4, "character": 11 } });
    let offered = client.ask("textDocument/completion", at);
    assert!(offered.to_string().contains("boom"), "{offered}");

    let fixed = ROBOT.replace("  <xacro:boon length=\"1\"/>\n", "");
    let change = json!({ "textDocument": { "uri": uri, "version": 3 }, "contentChanges": [{ "text": fixed }] });
    client.tell("textDocument/didChange", change);
    client.work();
    assert!(!lines(&client.findings(uri)).contains(&5));

    assert_eq!(client.ask("shutdown", Value::Null), Value::Null);
    client.tell("exit", Value::Null);
    client.work();
}

#[test]
fn a_cancelled_request_is_answered() {
    let mut client = Client::new();
    client.ask("initialize", json!({ "capabilities": {} }));
    let request = json!({ "jsonrpc": "2.0", "id": 7, "method": "workspace/symbol", "params": { "query": "boom" } });
    client.server.receive(request.to_string().as_bytes());
    client.tell("$/cancelRequest", json!({ "id": 7 }));
    client.work();
    let answer = client.came.iter().find(|message| message["id"] == 7);
    assert_eq!(answer.unwrap()["error"]["code"], -32800);
}

#[test]
fn what_is_no_message_is_logged() {
    let mut client = Client::new();
    client.server.receive(b"{");
    client.ask("initialize", json!({ "capabilities": {} }));
    client.server.receive(b"[]");
    client.work();
    assert!(
        client
            .came
            .iter()
            .any(|message| message["method"] == "window/logMessage")
    );
}
