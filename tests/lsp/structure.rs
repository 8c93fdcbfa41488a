//! F12, F14, F15, F16: answers from the text of one file.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

/// Names and details of symbols, indented.
fn outline(symbols: &Value, indent: usize, lines: &mut Vec<String>) {
    for symbol in symbols.as_array().into_iter().flatten() {
        let detail = symbol["detail"]
            .as_str()
            .map_or(String::new(), |detail| format!(" ({detail})"));
        lines.push(format!(
            "{}{}{detail}",
            "  ".repeat(indent),
            symbol["name"].as_str().unwrap()
        ));
        outline(&symbol["children"], indent + 1, lines);
    }
}

#[track_caller]
fn check_outline(client: &mut Client, file: &str, expected: &[&str]) {
    let mut lines = Vec::new();
    let symbols = client.request("textDocument/documentSymbol", client.of(file));
    outline(&symbols, 0, &mut lines);
    assert_eq!(lines, expected);
}

#[test]
fn symbols_of_a_robot() {
    let mut client = Client::start();
    client.open(ROBOT);
    let expected = [
        "mount (desk)",
        "m0 (0.15)",
        "cam (${xacro.load_yaml('$(find pan_tilt)/config/cam.yaml')})",
        "unit.xacro",
        "$(arg mount)",
        "unit name=pan",
        "unit name=tilt",
    ];
    check_outline(&mut client, ROBOT, &expected);
}

#[test]
fn symbols_of_a_broken_file() {
    let mut client = Client::start();
    client.open(UNIT);
    client.edit(UNIT, "</joint>", "</jo");
    client.edit(UNIT, "  </xacro:macro>\n</robot>", "");
    let expected = [
        "unit (name parent axis:='0 0 1' *at)",
        "  ${name}_body",
        "  ${name} (revolute)",
    ];
    check_outline(&mut client, UNIT, &expected);
}

#[test]
fn symbols_have_names_while_a_tag_is_typed() {
    fn named(symbols: &Value) -> bool {
        let mut symbols = symbols.as_array().into_iter().flatten();
        symbols.all(|it| !it["name"].as_str().unwrap().trim().is_empty() && named(&it["children"]))
    }
    let mut client = Client::start();
    client.open(ROBOT);
    let (mut typed, tag) = (String::new(), "<xacro:unit name=\"\"/>");
    for letter in tag.chars() {
        let before = format!("{typed}</robot>");
        typed.push(letter);
        client.edit(ROBOT, &before, &format!("{typed}</robot>"));
        let symbols = client.request("textDocument/documentSymbol", client.of(ROBOT));
        assert!(
            !symbols.as_array().unwrap().is_empty() && named(&symbols),
            "{typed}: {symbols}"
        );
    }
}

#[test]
fn symbols_behind_an_emoji() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<link name=\"$(arg mount)\"/>",
        "<!-- 🤖 --> <link name=\"🤖\"/>",
    );
    let symbols = client.request("textDocument/documentSymbol", client.of(ROBOT));
    let link = symbols
        .as_array()
        .unwrap()
        .iter()
        .find(|symbol| symbol["name"] == "🤖")
        .unwrap();
    assert_eq!(client.slice(ROBOT, &link["selectionRange"]), "🤖");
    assert_eq!(client.slice(ROBOT, &link["range"]), "<link name=\"🤖\"/>");
}

#[test]
fn elements_comments_and_runs_fold() {
    let mut client = Client::start();
    client.open_with(
        "folds.xacro",
        "<robot>\n<!-- two\nlines -->\n<xacro:property name=\"a\"/>\n<xacro:property name=\"b\"/>\n\
         <link name=\"l\">\n  <visual/>\n</link>\n<!-- region x -->\n<link/>\n<!-- endregion -->\n</robot>\n",
    );
    let folds = client.request("textDocument/foldingRange", client.of("folds.xacro"));
    let shown: Vec<String> = folds
        .as_array()
        .unwrap()
        .iter()
        .map(|fold| {
            format!(
                "{}-{} {}",
                fold["startLine"],
                fold["endLine"],
                fold["kind"].as_str().unwrap_or("-")
            )
        })
        .collect();
    assert_eq!(
        shown,
        ["0-10 -", "1-2 comment", "3-4 -", "5-6 -", "8-10 region"]
    );
}

#[test]
fn folding_a_file_that_is_cut_off_ends() {
    let mut client = Client::start();
    client.open_with(
        "cut.xacro",
        "<robot>\n<link name=\"l\">\n<visual>\n<xacro:property name=\"a\"\n",
    );
    let folds = client.request("textDocument/foldingRange", client.of("cut.xacro"));
    assert!(folds.is_array());
}

#[test]
fn a_selection_grows_from_the_name_to_the_file() {
    let mut client = Client::start();
    client.open(ROBOT);
    let at = client.at(ROBOT, "${m|0 / 3}");
    let params = json!({ "textDocument": at["textDocument"], "positions": [at["position"]] });
    let mut selection = client.request("textDocument/selectionRange", params)[0].clone();
    let mut shown = Vec::new();
    while selection.is_object() {
        shown.push(client.slice(ROBOT, &selection["range"]));
        selection = selection["parent"].clone();
    }
    let origin = "<origin xyz=\"0 0 ${m0 / 3}\"/>";
    let call = format!(
        "<xacro:unit name=\"tilt\" parent=\"pan_body\" axis=\"0 1 0\">{origin}</xacro:unit>"
    );
    let expected = [
        "m0",
        "m0 / 3",
        "${m0 / 3}",
        "0 0 ${m0 / 3}",
        "xyz=\"0 0 ${m0 / 3}\"",
        origin,
        call.as_str(),
    ];
    assert_eq!(shown[..7], expected);
    assert_eq!(shown.last().unwrap(), client.text(ROBOT));
}

#[test]
fn both_tags_are_edited_together() {
    let mut client = Client::start();
    client.open(UNIT);
    let tags = client.request(
        "textDocument/linkedEditingRange",
        client.at(UNIT, "<jo|int"),
    );
    let names: Vec<String> = tags["ranges"]
        .as_array()
        .unwrap()
        .iter()
        .map(|range| client.slice(UNIT, range))
        .collect();
    assert_eq!(names, ["joint", "joint"]);
    client.edit(UNIT, "</joint>", "</join>");
    let tags = client.request(
        "textDocument/linkedEditingRange",
        client.at(UNIT, "<jo|int"),
    );
    assert_eq!(tags, Value::Null);
}
