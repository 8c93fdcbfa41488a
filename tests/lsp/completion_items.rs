//! F3: what an item holds: snippets, edits, documentation, and less of it for editors that know little.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::completion::{able, both, item};
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, pan_tilt};

#[test]
fn calls_are_snippets_with_what_the_macro_requires() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<xacro:un\n</robot>");
    let unit = item(&mut client, ROBOT, "<xacro:un|\n", "xacro:unit");
    let text = unit["textEdit"]["newText"].as_str().unwrap();
    assert_eq!(unit["insertTextFormat"], 2);
    assert!(
        text.contains("name=\"$1\" parent=\"$2\"") && !text.contains("axis"),
        "{text}"
    );
    assert!(
        text.contains("<origin") && text.ends_with("</xacro:unit>$0"),
        "{text}"
    );
    assert_eq!(unit["labelDetails"]["description"], "unit.xacro");
    assert_eq!(
        client.slice(ROBOT, &unit["textEdit"]["replace"]),
        "xacro:un"
    );
}

#[test]
fn columns_are_utf16() {
    let mut client = able();
    let text = ROBOT_TEXT.replace("</robot>", "<!-- 🤖🤖 --><xacro:un</robot>");
    client.open_with(ROBOT, &text);
    let unit = item(&mut client, ROBOT, "<xacro:un|<", "xacro:unit");
    assert_eq!(client.slice(ROBOT, &unit["textEdit"]["insert"]), "xacro:un");
}

#[test]
fn clients_that_know_little_get_plain_items() {
    let mut client = Client::start();
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", "<xacro:un</robot>"));
    let unit = item(&mut client, ROBOT, "<xacro:un|<", "xacro:unit");
    assert_eq!(unit["textEdit"]["newText"], "xacro:unit");
    assert!(unit["textEdit"]["range"].is_object() && unit.get("labelDetails").is_none());
    assert!(unit.get("insertTextFormat").is_none());
}

#[test]
fn a_setting_turns_snippets_off() {
    let item = json!({ "snippetSupport": true });
    let capabilities = json!({ "textDocument": { "completion": { "completionItem": item } } });
    let settings = json!({ "completion": { "snippets": false } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            settings,
            ..Options::default()
        },
    );
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", "<xacro:un</robot>"));
    client.wait(
        |client| {
            client
                .asked
                .iter()
                .any(|m| m["method"] == "workspace/configuration")
                .then_some(())
        },
        || "settings".into(),
    );
    let unit = item_when(&mut client, |item| item.get("insertTextFormat").is_none());
    assert_eq!(unit["textEdit"]["newText"], "xacro:unit");
}

/// The item of the macro `unit`, asked for until it is as expected: settings come some time after the start.
fn item_when(client: &mut Client, is: impl Fn(&Value) -> bool) -> Value {
    for _ in 0..100 {
        let found = item(client, ROBOT, "<xacro:un|<", "xacro:unit");
        if is(&found) {
            return found;
        }
    }
    panic!("the item never is as expected");
}

#[test]
fn documentation_comes_when_an_item_is_looked_at() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<xacro:un\n</robot>");
    let unit = item(&mut client, ROBOT, "<xacro:un|\n", "xacro:unit");
    assert!(unit.get("documentation").is_none());
    let resolved = client.request("completionItem/resolve", unit.clone());
    let text = resolved["documentation"]["value"].as_str().unwrap();
    assert!(
        text.contains("A motor with its bracket.") && text.contains("axis='0 0 1'"),
        "{text}"
    );
    assert_eq!(resolved["textEdit"], unit["textEdit"]);
    let limit = item(&mut client, UNIT, "<|limit", "limit");
    let resolved = client.request("completionItem/resolve", limit);
    assert!(
        resolved["documentation"]["value"]
            .as_str()
            .unwrap()
            .contains("velocity")
    );
}

#[test]
fn forged_items_come_back_as_they_are() {
    let mut client = both();
    let good =
        json!({ "uri": client.uri(ROBOT), "topic": { "about": "macro", "name": "nothing" } });
    let foreign =
        json!({ "uri": "file:///etc/passwd", "topic": { "about": "property", "name": "root" } });
    for data in [
        json!(null),
        json!(7),
        json!({ "uri": 3 }),
        json!(["x"]),
        good,
        foreign,
    ] {
        let item = json!({ "label": "x", "data": data });
        let resolved = client.request("completionItem/resolve", item);
        assert_eq!(resolved["label"], "x");
        assert!(resolved.get("documentation").is_none());
    }
}

#[test]
fn long_lists_are_cut_and_say_so() {
    let mut client = able();
    let many: String = (0..300)
        .map(|n| format!("<xacro:property name=\"value_{n}\" value=\"{n}\"/>"))
        .collect();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace(
            "</robot>",
            &format!("{many}<link name=\"${{value_2\"/></robot>"),
        ),
    );
    let answer = client.request("textDocument/completion", client.at(ROBOT, "${value_2|"));
    assert_eq!(answer["isIncomplete"], true);
    let items = answer["items"].as_array().unwrap();
    assert!(
        items.len() <= 200 && items.iter().any(|item| item["label"] == "value_299"),
        "{}",
        items.len()
    );
}
