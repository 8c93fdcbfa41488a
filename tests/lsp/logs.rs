//! What the server logs: at the client, on standard error, and in reports.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, pan_tilt};

/// The messages of `$/logTrace` that contain a text.
fn traced(client: &Client, text: &str) -> Vec<Value> {
    let traced = client
        .notes
        .iter()
        .filter(|note| note["method"] == "$/logTrace")
        .map(|note| note["params"].clone());
    traced
        .filter(|params| {
            params["message"]
                .as_str()
                .is_some_and(|message| message.contains(text))
        })
        .collect()
}

fn edit(client: &mut Client) {
    client.edit(ROBOT, "${m0 / 3}", "${m1 / 3}");
    assert_eq!(client.findings(ROBOT), ["8:76-78 undefined-property"]);
}

#[test]
fn the_client_is_told_as_much_as_it_asks_for() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.findings(ROBOT);
    assert!(traced(&client, "").is_empty());
    client.notify("$/setTrace", json!({ "value": "messages" }));
    edit(&mut client);
    let why = "checked: `pan_tilt.urdf.xacro` edited";
    let [params] = &traced(&client, why)[..] else {
        panic!("{:?}", client.notes)
    };
    assert_eq!(params.get("verbose"), None);
    client.notify("$/setTrace", json!({ "value": "verbose" }));
    client.edit(ROBOT, "${m1 / 3}", "${m0 / 3}");
    client.findings(ROBOT);
    let verbose = traced(&client, why).last().unwrap()["verbose"]
        .as_str()
        .unwrap()
        .to_owned();
    assert!(
        verbose.starts_with("files=1 robots=1 expanded=1 items_left_out=0 findings=0 ms="),
        "{verbose}"
    );
    client.notify("$/setTrace", json!({ "value": "off" }));
    client.request("xacro/log", Value::Null);
    let before = traced(&client, "").len();
    edit(&mut client);
    assert_eq!(traced(&client, "").len(), before);
}

#[test]
fn a_report_has_the_last_lines() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.findings(ROBOT);
    edit(&mut client);
    let lines = client.request("xacro/log", Value::Null);
    let lines: Vec<&str> = lines
        .as_array()
        .unwrap()
        .iter()
        .filter_map(Value::as_str)
        .collect();
    assert!(lines[0].contains("server started"), "{lines:?}");
    assert!(
        lines.iter().any(|line| line.contains("connected to")),
        "{lines:?}"
    );
    let edited = "checked: `pan_tilt.urdf.xacro` edited (files=1";
    assert!(lines.iter().any(|line| line.contains(edited)), "{lines:?}");
    let folder = client.folder.to_string_lossy().into_owned();
    assert!(
        !lines.iter().any(|line| line.contains(&folder)),
        "{lines:?}"
    );
}

/// What stands on standard error after an edit, with this value of `XACRO_LOG`.
fn check_stderr(value: &'static str, expected: &[&str], others: &[&str]) {
    let mut client = Client::with(
        pan_tilt(),
        Options {
            log: Some(value),
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.findings(ROBOT);
    edit(&mut client);
    let errors = client.errors();
    for text in expected {
        assert!(errors.contains(text), "{value}: no {text:?} in {errors}");
    }
    for text in others {
        assert!(!errors.contains(text), "{value}: {text:?} in {errors}");
    }
}

#[test]
fn the_environment_says_what_is_written_to_standard_error() {
    check_stderr("info", &["server started", "edited"], &["using"]);
    check_stderr("server=info", &["server started", "edited"], &["using"]);
    check_stderr("error", &[], &["server started", "edited"]);
    check_stderr(
        "what=ever=else",
        &["`XACRO_LOG` is not", "server started"],
        &[],
    );
}
