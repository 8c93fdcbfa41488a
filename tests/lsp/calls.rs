//! F13, F27: the workspace as a whole, and who calls whom.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

fn both() -> Client {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

#[test]
fn a_macro_knows_its_callers() {
    let mut client = both();
    let items = client.request(
        "textDocument/prepareCallHierarchy",
        client.at(UNIT, "name=\"un|it\""),
    );
    let item = items[0].clone();
    assert_eq!(
        (&item["name"], client.slice(UNIT, &item["selectionRange"])),
        (&json!("unit"), "unit".to_owned())
    );
    let incoming = client.request("callHierarchy/incomingCalls", json!({ "item": item }));
    assert_eq!(incoming.as_array().unwrap().len(), 1, "{incoming}");
    assert_eq!(incoming[0]["from"]["name"], "pan_tilt.urdf.xacro");
    let ranges = incoming[0]["fromRanges"].as_array().unwrap();
    assert_eq!(
        ranges
            .iter()
            .map(|range| client.slice(ROBOT, range))
            .collect::<Vec<_>>(),
        ["unit", "unit"]
    );
    let from = incoming[0]["from"].clone();
    let outgoing = client.request("callHierarchy/outgoingCalls", json!({ "item": from }));
    assert_eq!(
        (
            &outgoing[0]["to"]["name"],
            outgoing.as_array().unwrap().len()
        ),
        (&json!("unit"), 1)
    );
}

#[test]
fn macros_that_call_macros_are_callers() {
    let mut client = both();
    let pair = "<!-- 🤖 --><xacro:macro name=\"pair\" params=\"x\"><xacro:unit name=\"${x}\" parent=\"desk\"><origin/>\
        </xacro:unit></xacro:macro>\n<xacro:pair x=\"q\"/><broken";
    client.edit(ROBOT, "</robot>", pair);
    let items = client.request(
        "textDocument/prepareCallHierarchy",
        client.at(ROBOT, "<xacro:pa|ir"),
    );
    let outgoing = client.request("callHierarchy/outgoingCalls", json!({ "item": items[0] }));
    assert_eq!(outgoing[0]["to"]["name"], "unit");
    assert_eq!(client.slice(ROBOT, &outgoing[0]["fromRanges"][0]), "unit");
    let incoming = client.request(
        "callHierarchy/incomingCalls",
        json!({ "item": outgoing[0]["to"] }),
    );
    let names: Vec<&str> = incoming
        .as_array()
        .unwrap()
        .iter()
        .map(|c| c["from"]["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["pan_tilt.urdf.xacro", "pair"]);
    assert!(
        client
            .request(
                "textDocument/prepareCallHierarchy",
                client.at(UNIT, "<jo|int")
            )
            .is_null()
    );
}

fn symbols(client: &mut Client, query: &str) -> Vec<String> {
    let found = client.request("workspace/symbol", json!({ "query": query }));
    let shown = |symbol: &Value| {
        format!(
            "{} {} {}",
            symbol["name"].as_str().unwrap(),
            symbol["kind"],
            symbol["containerName"].as_str().unwrap()
        )
    };
    found.as_array().unwrap().iter().map(shown).collect()
}

#[test]
fn files_that_are_not_open_are_searched_too() {
    let mut client = Client::start();
    assert_eq!(
        symbols(&mut client, "le")[..2],
        ["lens 12 lens.xacro", "lens 4 package.xml"]
    );
    assert_eq!(symbols(&mut client, "m0"), ["m0 14 pan_tilt.urdf.xacro"]);
    let all = symbols(&mut client, "");
    for expected in [
        "${name}_body 5 unit.xacro",
        "${name} 24 unit.xacro",
        "mount 13 pan_tilt.urdf.xacro",
        "pan_tilt 4 package.xml",
    ] {
        assert!(
            all.iter().any(|symbol| symbol == expected),
            "{expected} in {all:?}"
        );
    }
}

#[test]
fn what_is_typed_can_be_found_before_it_is_saved() {
    let mut client = both();
    client.edit(UNIT, "name=\"unit\"", "name=\"gimbal_unit\"");
    client.edit(UNIT, "</robot>", "<link name=\"half");
    assert_eq!(symbols(&mut client, "gimb"), ["gimbal_unit 12 unit.xacro"]);
    assert_eq!(symbols(&mut client, "zzz"), [""; 0]);
}
