//! F5, F21: signatures, end tags and indentation while somebody types.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT};

fn help(client: &mut Client, file: &str, at: &str) -> Value {
    client.request("textDocument/signatureHelp", client.at(file, at))
}

/// The text of the active parameter.
fn active(help: &Value) -> String {
    let place = help["activeParameter"].as_u64().unwrap();
    let parameters = help["signatures"][0]["parameters"].as_array().unwrap();
    parameters[usize::try_from(place).unwrap()]["label"]
        .as_str()
        .unwrap()
        .to_owned()
}

#[test]
fn the_active_parameter_follows_the_attribute() {
    let mut client = Client::start();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", "<xacro:unit name=\"x\" parent=\""),
    );
    let found = help(&mut client, ROBOT, "<xacro:unit name=\"x\" parent=\"|");
    assert_eq!(
        found["signatures"][0]["label"],
        "unit(name, parent, axis='0 0 1', *at)"
    );
    assert_eq!(active(&found), "parent");
    assert_eq!(
        active(&help(&mut client, ROBOT, "<xacro:unit name=\"x|")),
        "name"
    );
    assert_eq!(
        active(&help(&mut client, ROBOT, "parent=\"pan_body\" |axis")),
        "axis='0 0 1'"
    );
    assert_eq!(help(&mut client, ROBOT, "<link| name"), Value::Null);
}

#[test]
fn functions_in_expressions_have_signatures() {
    let mut client = Client::start();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", "<!-- 🤖 --><link name=\"${2 * atan2(m0, "),
    );
    let found = help(&mut client, ROBOT, "${2 * atan2(m0, |");
    assert!(
        found["signatures"][0]["label"]
            .as_str()
            .unwrap()
            .starts_with("atan2("),
        "{found}"
    );
    assert_eq!(found["activeParameter"], 1);
    assert_eq!(help(&mut client, ROBOT, "<!-- |🤖"), Value::Null);
}

#[test]
fn an_unsaved_macro_has_its_new_signature() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "params=\"name parent", "params=\"name base parent");
    let found = help(&mut client, ROBOT, "<xacro:unit name=\"pa|n");
    assert_eq!(
        found["signatures"][0]["label"],
        "unit(name, base, parent, axis='0 0 1', *at)"
    );
}

/// The edits behind a character that was just typed.
fn typed(client: &mut Client, at: &str, character: &str) -> Value {
    let mut params = client.at(ROBOT, at);
    params["ch"] = json!(character);
    params["options"] = json!({ "tabSize": 2, "insertSpaces": true });
    client.request("textDocument/onTypeFormatting", params)
}

#[test]
fn a_start_tag_gets_its_end_tag() {
    let mut client = Client::start();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", "  <!-- 🤖 --><link name=\"x\">\n</robot>"),
    );
    let edits = typed(&mut client, "<link name=\"x\">|", ">");
    assert_eq!(edits.as_array().unwrap().len(), 1);
    assert_eq!(edits[0]["newText"], "</link>");
    assert_eq!(
        edits[0]["range"]["start"],
        client.at(ROBOT, "<link name=\"x\">|")["position"]
    );
    assert_eq!(edits[0]["range"]["start"], edits[0]["range"]["end"]);
    assert_eq!(
        typed(&mut client, "<link name=\"$(arg mount)\"/>|", ">"),
        Value::Null
    );
}

#[test]
fn end_tags_and_lines_are_completed_in_broken_files() {
    let mut client = Client::start();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", "  <link name=\"x\">\n\n  </"),
    );
    assert_eq!(
        typed(&mut client, "</|", "/"),
        Value::Null,
        "inside of a tag that is there"
    );
    let position = client.at(ROBOT, "\n\n  </|")["position"].clone();
    let params = json!({
        "textDocument": { "uri": client.uri(ROBOT) },
        "position": position,
        "ch": "/",
        "options": { "tabSize": 2, "insertSpaces": true },
    });
    assert_eq!(
        client.request("textDocument/onTypeFormatting", params)[0]["newText"],
        "link>"
    );
    assert_eq!(
        typed(&mut client, "<link name=\"x\">\n|\n", "\n")[0]["newText"],
        "    "
    );
}
