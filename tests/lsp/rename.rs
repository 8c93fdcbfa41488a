//! F11: renaming in all files that use a name.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::client::{Client, Options, offset};
use super::workspace::{ROBOT, UNIT, pan_tilt};

/// The files after renaming what `at` marks; or the message of the error.
fn renamed(client: &mut Client, file: &str, at: &str, new: &str) -> Result<BTreeMap<String, String>, String> {
    let mut params = client.at(file, at);
    params["newName"] = json!(new);
    let id = client.post("textDocument/rename", params);
    let reply = client.reply(id);
    if let Some(error) = reply.get("error") {
        return Err(error["message"].as_str().unwrap().to_owned());
    }
    let mut files = BTreeMap::new();
    for (uri, edits) in reply["result"]["changes"].as_object().unwrap() {
        let name = [ROBOT, UNIT].into_iter().find(|name| client.uri(name) == *uri).unwrap();
        let mut text = client.text(name).to_owned();
        let mut edits: Vec<(usize, usize)> = edits
            .as_array()
            .unwrap()
            .iter()
            .map(|edit| (offset(&text, &edit["range"]["start"]), offset(&text, &edit["range"]["end"])))
            .collect();
        edits.sort_unstable();
        for (start, end) in edits.into_iter().rev() {
            text.replace_range(start..end, new);
        }
        files.insert(name.to_owned(), text);
    }
    Ok(files)
}

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[test]
fn a_parameter_is_renamed_in_its_macro_and_in_all_calls() {
    let mut client = both();
    let files = renamed(&mut client, UNIT, "${ax|is}", "direction").unwrap();
    assert!(files[UNIT].contains("name parent direction:='0 0 1' *at"), "{}", files[UNIT]);
    assert!(files[UNIT].contains("<axis xyz=\"${direction}\"/>"), "{}", files[UNIT]);
    assert!(files[ROBOT].contains("direction=\"0 1 0\""), "{}", files[ROBOT]);
}

#[test]
fn a_macro_is_renamed_with_its_end_tags() {
    let mut client = both();
    let files = renamed(&mut client, ROBOT, "<xacro:un|it name=\"pan\"", "motor").unwrap();
    assert!(files[UNIT].contains("<xacro:macro name=\"motor\""), "{}", files[UNIT]);
    assert_eq!(files[ROBOT].matches("xacro:motor").count(), 4, "{}", files[ROBOT]);
}

#[test]
fn a_property_is_renamed_in_branches_that_are_not_taken_too() {
    let mut client = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<!-- 🤖 --><xacro:if value=\"false\"><link name=\"${m0}\"/></xacro:if></robot>",
    );
    let files = renamed(&mut client, ROBOT, "name=\"m|0\"", "mass").unwrap();
    assert_eq!(files[ROBOT].matches("${mass").count(), 2, "{}", files[ROBOT]);
    assert_eq!(files[UNIT].matches("${mass * 2}").count(), 1, "{}", files[UNIT]);
}

#[test]
fn names_that_do_not_fit_are_refused() {
    let mut client = both();
    assert!(renamed(&mut client, ROBOT, "name=\"m|0\"", "m 0").unwrap_err().contains("no good name"));
    assert!(renamed(&mut client, ROBOT, "name=\"m|0\"", "cam").unwrap_err().contains("defined already"));
    let made = renamed(&mut client, ROBOT, "parent=\"pan_b|ody\"", "x");
    assert!(made.is_err(), "{made:?}");
}

#[test]
fn what_is_no_name_is_not_renamed() {
    let mut client = both();
    assert_eq!(client.request("textDocument/prepareRename", client.at(UNIT, "<lim|it")), Value::Null);
    let found = client.request("textDocument/prepareRename", client.at(ROBOT, "${m|0 / 3}"));
    assert_eq!(found["placeholder"], "m0");
}

#[test]
fn edits_carry_versions_for_clients_that_take_them() {
    let capabilities = json!({ "workspace": { "workspaceEdit": { "documentChanges": true } } });
    let mut client = Client::with(pan_tilt(), Options { capabilities, ..Options::default() });
    client.open(ROBOT);
    let mut params = client.at(ROBOT, "name=\"m|0\"");
    params["newName"] = json!("mass");
    let edit = client.request("textDocument/rename", params);
    let versions: Vec<&Value> =
        edit["documentChanges"].as_array().unwrap().iter().map(|c| &c["textDocument"]["version"]).collect();
    assert!(versions.contains(&&json!(1)), "{edit}");
}
