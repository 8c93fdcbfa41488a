//! F2: findings of the active context, and of all.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT, pan_tilt};

/// The workspace with three runs of the robot: on a desk, on the wall and on a mast.
fn with_presets() -> std::path::PathBuf {
    let folder = pan_tilt();
    let config = "[[roots]]\nfile = \"src/pan_tilt/urdf/pan_tilt.urdf.xacro\"\nargs = { mount = \"desk\" }\n\
                  presets.wall = { mount = \"wall\" }\npresets.mast = { mount = \"mast\" }\n";
    super::workspace::write(&folder, "xacro-lint.toml", config);
    folder
}

fn showing(contexts: &str) -> Client {
    let settings = json!({ "diagnostics": { "contexts": contexts, "delay": 0 } });
    Client::with(
        with_presets(),
        Options {
            settings,
            ..Options::default()
        },
    )
}

/// A link whose name is wrong where a condition holds, behind a sign that takes two places.
fn wrong_if(condition: &str) -> String {
    format!(
        "<!-- 🤖 --><xacro:if value=\"${{{condition}}}\"><link name=\"${{m1}}\"/></xacro:if></robot>"
    )
}

fn undefined(client: &mut Client, file: &str) -> Vec<Value> {
    let found = client.diagnostics(file).into_iter();
    found
        .filter(|found| found["code"] == "undefined-property")
        .collect()
}

#[test]
fn all_contexts_are_checked_when_asked_for() {
    let mut client = showing("all");
    client.open(ROBOT);
    client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'wall'"));
    assert!(client.eventually(|client| undefined(client, ROBOT).len() == 1));
    let found = undefined(&mut client, ROBOT);
    let message = |found: &Value| {
        found["message"]
            .as_str()
            .unwrap()
            .lines()
            .next()
            .unwrap()
            .to_owned()
    };
    assert!(
        message(&found[0]).ends_with(" [root pan_tilt.urdf.xacro mount:=wall]"),
        "{found:?}"
    );
    assert_eq!(client.slice(ROBOT, &found[0]["range"]), "m1");
    // two of three are told by the message, and listed
    client.edit(ROBOT, "== 'wall'", "!= 'desk'");
    let found = undefined(&mut client, ROBOT);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        message(&found[0]).ends_with(" [root pan_tilt.urdf.xacro mount:=wall and 1 more]"),
        "{found:?}"
    );
    let related = found[0]["relatedInformation"].as_array().unwrap();
    let related: Vec<&str> = related
        .iter()
        .map(|place| place["message"].as_str().unwrap())
        .collect();
    assert!(related.ends_with(&[
        "with root pan_tilt.urdf.xacro mount:=wall",
        "with root pan_tilt.urdf.xacro mount:=mast"
    ]));
    // all of them need no word about it
    client.edit(ROBOT, "!= 'desk'", "!= 'moon'");
    let found = undefined(&mut client, ROBOT);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(!message(&found[0]).contains("[root"), "{found:?}");
    // what is used in one context is not unused
    client.edit(
        ROBOT,
        "<link name=\"${m1}\"/></xacro:if>",
        "<link name=\"l${spare}\"/></xacro:if>",
    );
    client.edit(ROBOT, "!= 'moon'", "== 'wall'");
    client.edit(
        ROBOT,
        "  <link",
        "  <xacro:property name=\"spare\" value=\"1\"/>\n  <link",
    );
    let found = client.findings(ROBOT);
    assert!(
        !found.iter().any(|found| found.ends_with("unused-property")),
        "{found:?}"
    );
}

#[test]
fn the_active_context_alone_is_checked_by_default() {
    for contexts in ["active", "some"] {
        let mut client = showing(contexts);
        client.open(ROBOT);
        client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'wall'"));
        assert_eq!(undefined(&mut client, ROBOT), Vec::<Value>::new());
        client.edit(ROBOT, "== 'wall'", "== 'desk'");
        let found = undefined(&mut client, ROBOT);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            !found[0]["message"].as_str().unwrap().contains("[root"),
            "{found:?}"
        );
        let told = |client: &mut Client| {
            client.diagnostics(ROBOT);
            let mut notes = client.notes.iter();
            notes.any(|note| {
                note["params"]["message"]
                    .as_str()
                    .is_some_and(|m| m.contains("diagnostics.contexts"))
            })
        };
        assert!(
            client.eventually(|client| told(client) == (contexts == "some")),
            "{contexts}"
        );
    }
}

#[test]
fn contexts_of_broken_and_unsaved_files_are_told_apart() {
    let mut client = showing("all");
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(
        UNIT,
        "value=\"${m0 * 2}\"",
        "value=\"${m0 * (m2 if parent == 'wall' else 2)}\"",
    );
    let message = "mount:=wall]";
    let has = |client: &mut Client| {
        // the argument of this call is to blame, or the macro
        let both = [undefined(client, UNIT), undefined(client, ROBOT)].concat();
        both.iter()
            .any(|found| found["message"].as_str().unwrap().contains(message))
    };
    assert!(client.eventually(has));
    // a file that is cut off says so in every context, once
    let text = client.text(ROBOT).to_owned();
    client.edit(
        ROBOT,
        &text,
        text.trim_end().strip_suffix("</robot>").unwrap(),
    );
    let found = client.diagnostics(ROBOT);
    let syntax: Vec<&Value> = found
        .iter()
        .filter(|found| found["code"] == "xml-syntax-error")
        .collect();
    assert_eq!(syntax.len(), 1, "{found:?}");
    assert!(
        !syntax[0]["message"].as_str().unwrap().contains("[root"),
        "{found:?}"
    );
}

#[test]
fn all_contexts_are_pulled_too() {
    let settings = json!({ "diagnostics.contexts": "all" });
    let capabilities = json!({ "textDocument": { "diagnostic": {} } });
    let mut client = Client::with(
        with_presets(),
        Options {
            settings,
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.edit(ROBOT, "</robot>", &wrong_if("'$(arg mount)' == 'mast'"));
    let told = |client: &mut Client| {
        let report = client.request("textDocument/diagnostic", client.of(ROBOT));
        let items = report["items"].as_array().unwrap().clone();
        items.iter().any(|found| {
            found["message"]
                .as_str()
                .unwrap()
                .contains("[root pan_tilt.urdf.xacro mount:=mast]")
        })
    };
    assert!(client.eventually(told));
}
