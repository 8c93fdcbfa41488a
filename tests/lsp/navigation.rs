//! F7, F9, F10: definitions, references, highlights.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

/// `file:line name` of each target.
#[track_caller]
fn check_definition(client: &mut Client, file: &str, at: &str, expected: &[&str]) {
    let targets = client.request("textDocument/definition", client.at(file, at));
    let shown: Vec<String> = targets
        .as_array()
        .into_iter()
        .flatten()
        .map(|link| client.shown(link["targetUri"].as_str().unwrap(), &link["targetSelectionRange"]))
        .collect();
    assert_eq!(shown, expected, "{at}");
}

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[test]
fn names_lead_to_where_they_are_given() {
    let mut client = both();
    check_definition(&mut client, ROBOT, "${m|0 / 3}", &["pan_tilt.urdf.xacro:3 m0"]);
    check_definition(&mut client, UNIT, "${m|0 * 2}", &["pan_tilt.urdf.xacro:3 m0"]);
    check_definition(&mut client, UNIT, "xyz=\"${ax|is}\"", &["unit.xacro:3 axis"]);
    check_definition(&mut client, ROBOT, "<xacro:un|it name=\"pan\"", &["unit.xacro:3 unit"]);
    check_definition(&mut client, ROBOT, "ax|is=\"0 1 0\"", &["unit.xacro:3 axis"]);
    check_definition(&mut client, ROBOT, "name=\"$(arg mo|unt)\"", &["pan_tilt.urdf.xacro:2 mount"]);
    check_definition(&mut client, UNIT, "insert_block name=\"a|t\"", &["unit.xacro:3 at"]);
}

#[test]
fn an_unsaved_include_leads_to_its_new_place() {
    let mut client = both();
    client.edit(UNIT, "  <!-- A motor with its bracket. -->\n", "  <!-- 🤖 -->\n\n\n");
    check_definition(&mut client, ROBOT, "<xacro:un|it name=\"pan\"", &["unit.xacro:5 unit"]);
}

#[test]
fn names_in_a_broken_file_still_lead_somewhere() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<link name=\"");
    check_definition(&mut client, ROBOT, "${m|0 / 3}", &["pan_tilt.urdf.xacro:3 m0"]);
}

fn references(client: &mut Client, file: &str, at: &str) -> Vec<String> {
    let mut params = client.at(file, at);
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", params);
    let shown = |place: &Value| client.shown(place["uri"].as_str().unwrap(), &place["range"]);
    found.as_array().unwrap().iter().map(shown).collect()
}

#[test]
fn references_are_found_in_all_files() {
    let mut client = both();
    let expected = ["pan_tilt.urdf.xacro:3 m0", "unit.xacro:4 m0", "pan_tilt.urdf.xacro:8 m0"];
    let mut found = references(&mut client, ROBOT, "name=\"m|0\"");
    found.sort();
    let mut sorted = expected;
    sorted.sort();
    assert_eq!(found, sorted);
    assert_eq!(references(&mut client, UNIT, "${m|0 * 2}").len(), 3);
}

#[test]
fn highlights_tell_giving_from_reading() {
    let mut client = both();
    let found = client.request("textDocument/documentHighlight", client.at(ROBOT, "name=\"m|0\""));
    let kinds: Vec<i64> = found.as_array().unwrap().iter().map(|h| h["kind"].as_i64().unwrap()).collect();
    assert_eq!(kinds, [3, 2]);
    let tags = client.request("textDocument/documentHighlight", client.at(UNIT, "<jo|int"));
    assert_eq!(tags.as_array().unwrap().len(), 2);
}
