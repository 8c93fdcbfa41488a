//! F28: semantic tokens.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

/// The pieces of an open file that `data` stands for: `line text kind modifiers`, lines from 1.
fn decoded(client: &Client, file: &str, data: &Value, legend: &Value) -> Vec<String> {
    let numbers: Vec<u64> = data
        .as_array()
        .unwrap()
        .iter()
        .map(|n| n.as_u64().unwrap())
        .collect();
    let (mut line, mut col) = (0, 0);
    let mut found = Vec::new();
    for token in numbers.chunks(5) {
        let &[lines, cols, length, kind, modifiers] = token else {
            panic!("{token:?}")
        };
        (line, col) = if lines == 0 {
            (line, col + cols)
        } else {
            (line + lines, cols)
        };
        let (start, end) = (
            json!({ "line": line, "character": col }),
            json!({ "line": line, "character": col + length }),
        );
        let text = client.slice(file, &json!({ "start": start, "end": end }));
        let names = legend["tokenModifiers"]
            .as_array()
            .unwrap()
            .iter()
            .enumerate();
        let names = names
            .filter(|(bit, _)| modifiers & (1 << bit) != 0)
            .map(|(_, name)| name.as_str().unwrap());
        let kind = legend["tokenTypes"][kind as usize].as_str().unwrap();
        let words: Vec<&str> = [text.as_str(), kind].into_iter().chain(names).collect();
        found.push(format!("{} {}", line + 1, words.join(" ")));
    }
    found
}

fn both() -> (Client, Value) {
    let folder = super::workspace::pan_tilt();
    let mut client = Client::spawn(folder, super::client::Options::default());
    let offered = client.initialize();
    client.open(ROBOT);
    client.open(UNIT);
    let legend = offered["capabilities"]["semanticTokensProvider"]["legend"].clone();
    (client, legend)
}

fn all(client: &mut Client, file: &str, legend: &Value) -> Vec<String> {
    let result = client.request("textDocument/semanticTokens/full", client.of(file));
    decoded(client, file, &result["data"], legend)
}

#[track_caller]
fn check_line(found: &[String], line: usize, expected: &[&str]) {
    let lead = format!("{line} ");
    let on_line: Vec<&str> = found
        .iter()
        .filter_map(|token| token.strip_prefix(&lead))
        .collect();
    assert_eq!(on_line, expected);
}

#[test]
fn names_are_told_apart() {
    let (mut client, legend) = both();
    let found = all(&mut client, ROBOT, &legend);
    let expected = ["xacro:property keyword", "m0 variable declaration readonly"];
    check_line(&found, 3, &expected);
    let yaml = [
        "xacro:property keyword",
        "cam variable declaration",
        "${ operator",
        "xacro namespace defaultLibrary",
        ". operator",
        "load_yaml function defaultLibrary",
        "( operator",
        "' string",
        "$( operator",
        "find keyword",
        "pan_tilt namespace",
        ") operator",
        "/config/cam.yaml' string",
        ") operator",
        "} operator",
    ];
    check_line(&found, 4, &yaml);
    check_line(
        &found,
        6,
        &[
            "$( operator",
            "arg keyword",
            "mount parameter",
            ") operator",
        ],
    );
    let call = [
        "unit macro",
        "name parameter",
        "parent parameter",
        "axis parameter",
        "${ operator",
        "m0 variable",
        "/ operator",
        "3 number",
        "} operator",
        "unit macro",
    ];
    check_line(&found, 8, &call);
    let found = all(&mut client, UNIT, &legend);
    let definition = [
        "xacro:macro keyword",
        "unit macro declaration",
        "name parameter declaration",
        "parent parameter declaration",
        "axis parameter declaration",
        "at parameter declaration",
    ];
    check_line(&found, 3, &definition);
    let joint = [
        "${ operator",
        "name parameter",
        "} operator",
        "revolute enumMember",
    ];
    check_line(&found, 5, &joint);
    let ends = [
        "xacro:insert_block keyword",
        "at parameter",
        "${ operator",
        "parent parameter",
        "} operator",
        "${ operator",
        "name parameter",
        "} operator",
        "_body class",
    ];
    check_line(&found, 6, &ends);
}

#[test]
fn what_a_condition_leaves_out_is_a_comment() {
    let (mut client, legend) = both();
    client.edit(
        ROBOT,
        "</robot>",
        "<xacro:if value=\"${m0 > 1}\">\n  <link name=\"🤖\"/>\n\n  </xacro:if>\n</robot>",
    );
    let found = all(&mut client, ROBOT, &legend);
    check_line(&found, 10, &["<link name=\"🤖\"/> comment unused"]);
    check_line(&found, 12, &["xacro:if keyword"]);
    client.edit(ROBOT, "${m0 > 1}", "${m0 > 0}");
    check_line(
        &all(&mut client, ROBOT, &legend),
        10,
        &["🤖 class declaration"],
    );
}

#[test]
fn changes_and_ranges_agree_with_the_whole() {
    let (mut client, legend) = both();
    let before = client.request("textDocument/semanticTokens/full", client.of(ROBOT));
    client.edit(ROBOT, "value=\"0.15\"", "value=\"${len('🤖') * 1.5}\"");
    let mut params = client.of(ROBOT);
    params["previousResultId"] = before["resultId"].clone();
    let delta = client.request("textDocument/semanticTokens/full/delta", params);
    let mut data: Vec<Value> = before["data"].as_array().unwrap().clone();
    for edit in delta["edits"].as_array().unwrap() {
        let start = edit["start"].as_u64().unwrap() as usize;
        let end = start + edit["deleteCount"].as_u64().unwrap() as usize;
        data.splice(
            start..end,
            edit["data"].as_array().cloned().unwrap_or_default(),
        );
    }
    let full = client.request("textDocument/semanticTokens/full", client.of(ROBOT));
    assert_eq!(Value::Array(data), full["data"]);
    assert!(
        delta["edits"][0]["data"].as_array().unwrap().len() < 80,
        "{delta}"
    );
    let mut params = client.of(ROBOT);
    params["range"] =
        json!({ "start": { "line": 2, "character": 0 }, "end": { "line": 3, "character": 0 } });
    let part = client.request("textDocument/semanticTokens/range", params);
    let expected = [
        "xacro:property keyword",
        "m0 variable declaration",
        "${ operator",
        "len function defaultLibrary",
        "( operator",
        "'🤖' string",
        ") operator",
        "* operator",
        "1.5 number",
        "} operator",
    ];
    check_line(
        &decoded(&client, ROBOT, &part["data"], &legend),
        3,
        &expected,
    );
}

#[test]
fn half_typed_text_has_colors() {
    let (mut client, legend) = both();
    client.edit(ROBOT, "</robot>", "<link name=\"${m0 +");
    let found = all(&mut client, ROBOT, &legend);
    check_line(&found, 9, &["m0 variable", "+ operator"]);
    client.edit(UNIT, "params=\"name parent", "params=\"name other parent");
    let found = all(&mut client, UNIT, &legend);
    assert!(
        found
            .iter()
            .any(|token| token == "3 other parameter declaration"),
        "{found:?}"
    );
}
