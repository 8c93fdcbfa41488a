//! F1, F31, F32: from `initialize` to the end of the process.

use std::time::Duration;

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, fresh_folder, pan_tilt, write};

#[test]
fn initialize_says_who_and_what() {
    let mut client = Client::spawn(pan_tilt(), Options::default());
    let result = client.initialize();
    assert_eq!(result["serverInfo"]["name"], "xacro-lsp");
    assert_eq!(result["capabilities"]["textDocumentSync"]["change"], 2);
    assert_eq!(result["capabilities"]["positionEncoding"], "utf-16");
}

#[test]
fn utf_8_is_taken_when_the_client_prefers_it() {
    let capabilities = json!({ "general": { "positionEncodings": ["utf-8", "utf-16"] } });
    let mut client = Client::spawn(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    assert_eq!(
        client.initialize()["capabilities"]["positionEncoding"],
        "utf-8"
    );
}

#[test]
fn the_exit_code_hangs_on_shutdown() {
    let mut client = Client::start();
    client.request("shutdown", Value::Null);
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 0);

    let mut client = Client::start();
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn the_end_of_the_input_is_the_end_of_the_server() {
    let mut client = Client::start();
    client.hang_up();
    assert_eq!(client.exit_code(), 1);
}

#[test]
fn three_hundred_edits_are_applied_in_order() {
    let mut client = Client::start();
    client.open(ROBOT);
    for step in 0..300 {
        client.edit(ROBOT, "name=\"m0\"", "name=\"m0x\"");
        client.edit(ROBOT, "name=\"m0x\"", "name=\"m0\"");
        if step == 299 {
            client.edit(ROBOT, "value=\"0.15\"", "value=\"0.75\"");
        }
    }
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert!(
        expanded["urdf"].as_str().unwrap().contains("0 0 0.25"),
        "{expanded}"
    );
    assert_eq!(client.findings(ROBOT), Vec::<String>::new());
}

#[test]
fn a_client_that_answers_nothing_is_served() {
    let capabilities = json!({
        "workspace": { "configuration": true, "didChangeWatchedFiles": { "dynamicRegistration": true } },
        "window": { "workDoneProgress": true },
    });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            deaf: true,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    for _ in 0..120 {
        client.notify(
            "workspace/didChangeConfiguration",
            json!({ "settings": null }),
        );
    }
    let symbols = client.request("textDocument/documentSymbol", client.of(ROBOT));
    assert_eq!(symbols.as_array().unwrap().len(), 7);
}

#[test]
fn a_cancelled_request_gets_one_reply_that_says_so() {
    let mut client = Client::start();
    client.open(ROBOT);
    let id = client.post("xacro/expand", client.of(ROBOT));
    client.notify("$/cancelRequest", json!({ "id": id }));
    let reply = client.reply(id);
    // the answer may have been faster
    let code = &reply["error"]["code"];
    assert!(reply.get("result").is_some() || *code == -32800, "{reply}");
}

#[test]
fn what_is_no_message_does_no_harm() {
    let mut client = Client::start();
    for body in [
        "{not json",
        "42",
        "[]",
        "{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"x\"}",
    ] {
        client.send_raw(format!("content-length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }
    let id = client.post("no/such", Value::Null);
    assert_eq!(client.reply(id)["error"]["code"], -32601);
}

#[test]
fn settings_are_asked_for_and_hold() {
    let capabilities = json!({ "workspace": { "configuration": true } });
    let settings = json!({ "diagnostics": { "rules": { "undefined-property": "off" } } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            settings,
            ..Options::default()
        },
    );
    client.wait(
        |client| {
            client
                .asked
                .iter()
                .any(|asked| asked["method"] == "workspace/configuration")
                .then_some(())
        },
        || "configuration request".to_owned(),
    );
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert!(client.eventually(|client| {
        client.request("textDocument/foldingRange", client.of(ROBOT));
        client.findings(ROBOT).is_empty()
    }));
}

#[test]
fn a_single_file_without_folder_is_served() {
    let mut client = Client::with(
        pan_tilt(),
        Options {
            no_folder: true,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert_eq!(client.findings(ROBOT), ["8:76-78 undefined-property"]);
}

#[test]
fn progress_that_was_made_begins_and_ends() {
    let capabilities = json!({ "window": { "workDoneProgress": true } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    let kinds = |client: &Client| -> Vec<String> {
        let told = client
            .notes
            .iter()
            .filter(|note| note["method"] == "$/progress");
        told.map(|note| {
            note["params"]["value"]["kind"]
                .as_str()
                .unwrap_or_default()
                .to_owned()
        })
        .collect()
    };
    let ended = |client: &mut Client| {
        kinds(client)
            .last()
            .is_some_and(|last| last == "end")
            .then_some(())
    };
    client.wait(ended, || "no end of the progress".to_owned());
    assert_eq!(kinds(&client).first().map(String::as_str), Some("begin"));
}

#[test]
fn the_progress_ends_when_an_answer_waits_for_the_whole_workspace() {
    let capabilities = json!({ "window": { "workDoneProgress": true } });
    let folder = pan_tilt();
    for number in 0..3000 {
        write(
            &folder,
            &format!("src/many/{}/{number}.xacro", number % 50),
            "<robot><link name=\"🤖\"/></robot>",
        );
    }
    let mut client = Client::with(
        folder,
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    let kinds = |client: &Client| -> Vec<String> {
        let told = client
            .notes
            .iter()
            .filter(|note| note["method"] == "$/progress");
        told.map(|note| {
            note["params"]["value"]["kind"]
                .as_str()
                .unwrap_or_default()
                .to_owned()
        })
        .collect()
    };
    client.wait(
        |client| (!kinds(client).is_empty()).then_some(()),
        || "no progress".to_owned(),
    );
    let found = client.request("workspace/symbol", json!({ "query": "🤖" }));
    assert!(!found.as_array().unwrap().is_empty());
    let mut params = client.at(ROBOT, "name=\"m|0\"");
    params["newName"] = json!("mass");
    assert!(client.request("textDocument/rename", params)["changes"].is_object());
    let ended = |client: &mut Client| {
        kinds(client)
            .last()
            .is_some_and(|last| last == "end")
            .then_some(())
    };
    client.wait(ended, || "no end of the progress".to_owned());
    let told = kinds(&client);
    assert_eq!(told.first().map(String::as_str), Some("begin"), "{told:?}");
    assert_eq!(
        told.iter().filter(|kind| *kind == "end").count(),
        1,
        "{told:?}"
    );
}

#[test]
fn each_folder_has_its_own_settings() {
    let folder = fresh_folder();
    let robot = "<robot name=\"🤖\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<link name=\"a\"/><link name=\"${m}\"/></robot>\n";
    for name in ["one/r.urdf.xacro", "two/r.urdf.xacro"] {
        write(&folder, name, robot);
    }
    let off = json!({ "diagnostics": { "delay": 0, "rules": { "undefined-property": "off" } } });
    let on = json!({ "diagnostics": { "delay": 0 } });
    let folder_settings =
        [("one", off), ("two", on.clone())].map(|(name, value)| (name.to_owned(), value));
    let mut client = Client::with(
        folder,
        Options {
            settings: on,
            folder_settings: folder_settings.into(),
            ..Options::default()
        },
    );
    let folders = ["one", "two"].map(|name| json!({ "uri": client.uri(name), "name": name }));
    let whole = json!({ "uri": client.uri("").trim_end_matches('/'), "name": "ws" });
    client.notify(
        "workspace/didChangeWorkspaceFolders",
        json!({ "event": { "added": folders, "removed": [whole] } }),
    );
    client.open("one/r.urdf.xacro");
    client.open("two/r.urdf.xacro");
    let has = |client: &mut Client, file: &str| {
        client
            .findings(file)
            .iter()
            .any(|found| found.ends_with("undefined-property"))
    };
    assert!(client.eventually(|client| !has(client, "one/r.urdf.xacro")));
    assert!(client.eventually(|client| has(client, "two/r.urdf.xacro")));
    let scopes: Vec<String> = client
        .asked
        .iter()
        .filter(|asked| asked["method"] == "workspace/configuration")
        .flat_map(|asked| asked["params"]["items"].as_array().unwrap().clone())
        .map(|item| item["scopeUri"].as_str().unwrap().to_owned())
        .collect();
    assert!(
        scopes.contains(&client.uri("one")) && scopes.contains(&client.uri("two")),
        "{scopes:?}"
    );
}

#[test]
fn the_first_diagnostics_know_the_settings() {
    let options = Options {
        settings: json!({ "severity": { "undefined-property": "info" } }),
        ..Options::default()
    };
    let mut client = Client::with(pan_tilt(), options);
    let text = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"${nothing}\"/></robot>";
    client.open_with(ROBOT, text);
    // the server has asked, and gets no answer yet
    std::thread::sleep(Duration::from_millis(200));
    let list = client.diagnostics(ROBOT);
    let found = list.iter().find(|one| one["code"] == "undefined-property");
    assert_eq!(found.unwrap()["severity"], 3, "{list:?}");
}
