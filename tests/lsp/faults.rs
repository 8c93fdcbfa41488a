//! Faults of our own, and files that change their nature under the server.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, write};

fn notes<'a>(client: &'a Client, method: &str) -> Vec<&'a str> {
    let ours = client.notes.iter().filter(|note| note["method"] == method);
    let texts = ours.filter_map(|note| note["params"]["message"].as_str());
    texts
        .filter(|text| text.contains("internal error"))
        .collect()
}

#[cfg(debug_assertions)]
#[test]
fn a_fault_in_a_job_is_answered_logged_and_shown_once_and_the_server_lives() {
    let mut client = Client::start();
    client.open(ROBOT);
    for _ in 0..3 {
        let id = client.post("xacro/debug/fail", json!({}));
        let reply = client.reply(id);
        assert_eq!(reply["error"]["code"], -32603, "{reply}");
        assert_eq!(
            reply["error"]["message"],
            "internal error; see the log for details"
        );
    }
    client.wait(
        |client| (notes(client, "window/logMessage").len() == 3).then_some(()),
        || "three lines in the log".to_owned(),
    );
    assert!(notes(&client, "window/logMessage")[0].contains("this job was asked to fail"));
    assert_eq!(notes(&client, "window/showMessage").len(), 1);
    // it still takes edits and answers
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert_eq!(client.findings(ROBOT), ["8:76-78 undefined-property"]);
    client.request("shutdown", Value::Null);
    client.notify("exit", Value::Null);
    assert_eq!(client.exit_code(), 0);
}

/// Tell the server that a file changed on disk.
fn changed(client: &mut Client, file: &str) {
    let change = json!({ "changes": [{ "uri": client.uri(file), "type": 2 }] });
    client.notify("workspace/didChangeWatchedFiles", change);
}

fn has(client: &mut Client, rule: &str) -> bool {
    client.eventually(|client| {
        client.request("textDocument/foldingRange", client.of(ROBOT));
        client
            .findings(ROBOT)
            .iter()
            .any(|finding| finding.contains(rule))
            != rule.is_empty()
    })
}

#[test]
fn a_file_that_becomes_something_else_is_named_and_comes_back() {
    let mut client = Client::start();
    client.open(ROBOT);
    assert_eq!(client.findings(ROBOT), Vec::<String>::new());
    let path = client.folder.join(UNIT);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    changed(&mut client, UNIT);
    assert!(
        has(&mut client, "include-not-found"),
        "{:?}",
        client.findings(ROBOT)
    );
    std::fs::create_dir(&path).unwrap();
    changed(&mut client, UNIT);
    assert!(
        has(&mut client, "include-not-found"),
        "{:?}",
        client.findings(ROBOT)
    );
    std::fs::remove_dir(&path).unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("/dev/zero", &path).unwrap();
        changed(&mut client, UNIT);
        assert!(
            has(&mut client, "include-not-found"),
            "{:?}",
            client.findings(ROBOT)
        );
        std::fs::remove_file(&path).unwrap();
        std::os::unix::fs::symlink("unit.xacro", &path).unwrap();
        changed(&mut client, UNIT);
        assert!(
            has(&mut client, "include-not-found"),
            "{:?}",
            client.findings(ROBOT)
        );
        std::fs::remove_file(&path).unwrap();
    }
    write(&client.folder, UNIT, &text[..text.len() / 2]);
    changed(&mut client, UNIT);
    write(&client.folder, UNIT, text);
    changed(&mut client, UNIT);
    assert!(client.eventually(|client| {
        client.request("textDocument/foldingRange", client.of(ROBOT));
        client.findings(ROBOT).is_empty()
    }));
    assert_eq!(client.text(ROBOT), ROBOT_TEXT);
}
