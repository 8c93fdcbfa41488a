//! F33: the expanded document.

use serde_json::{Value, json};

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

#[test]
fn a_robot_is_expanded_with_the_arguments_asked_for() {
    let mut client = Client::start();
    client.open(ROBOT);
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], true, "{expanded}");
    assert_eq!(
        expanded["urdf"]
            .as_str()
            .unwrap()
            .matches("<link name=")
            .count(),
        3
    );
    assert_eq!(expanded["args"], json!({ "mount": "desk" }));
    let mut params = client.of(ROBOT);
    params["args"] = json!({ "mount": "wall" });
    let expanded = client.request("xacro/expand", params);
    assert!(
        expanded["urdf"]
            .as_str()
            .unwrap()
            .contains("<link name=\"wall\"/>"),
        "{expanded}"
    );
}

#[test]
fn a_macro_file_is_expanded_as_part_of_its_robot() {
    let mut client = Client::start();
    client.open(UNIT);
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert!(
        expanded["root"]["uri"]
            .as_str()
            .unwrap()
            .ends_with("pan_tilt.urdf.xacro"),
        "{expanded}"
    );
}

#[test]
fn a_broken_robot_says_why() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m0 / 0}");
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], false);
    assert_eq!(expanded["errors"][0]["code"], "expression-error");
    assert_eq!(
        expanded["errors"][0]["location"]["range"]["start"]["line"],
        7
    );
}

#[test]
fn the_command_answers_the_same() {
    let mut client = Client::start();
    client.open(ROBOT);
    let params = json!({ "command": "xacro.expand", "arguments": [client.of(ROBOT)] });
    assert_eq!(
        client.request("workspace/executeCommand", params)["ok"],
        true
    );
}

/// `file:line text role` of the places that a text of the expanded document came from.
#[track_caller]
fn sources(client: &mut Client, pattern: &str) -> Vec<String> {
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    let urdf = expanded["urdf"].as_str().unwrap().to_owned();
    let (before, behind) = pattern.split_once('|').unwrap();
    let start = urdf
        .find(&format!("{before}{behind}"))
        .unwrap_or_else(|| panic!("`{pattern}` in {urdf}"));
    let position = super::positions::position(&urdf, start + before.len());
    let answer = client.request(
        "xacro/toSource",
        json!({ "root": client.uri(ROBOT), "position": position }),
    );
    let shown = |place: &serde_json::Value| {
        let at = client.shown(place["uri"].as_str().unwrap(), &place["range"]);
        format!("{at} {}", place["role"].as_str().unwrap())
    };
    answer["locations"]
        .as_array()
        .unwrap()
        .iter()
        .map(shown)
        .collect()
}

#[test]
fn the_parts_of_a_name_lead_to_those_who_gave_them() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    let call = "pan_tilt.urdf.xacro:8 <xacro:unit call";
    assert_eq!(
        sources(&mut client, "<joint name=\"ti|lt\""),
        [
            "pan_tilt.urdf.xacro:8 tilt origin",
            "unit.xacro:5 ${name} argument",
            call
        ]
    );
    assert_eq!(
        sources(&mut client, "<link name=\"tilt_b|ody\""),
        ["unit.xacro:4 _body origin", call]
    );
}

#[test]
fn an_earlier_version_is_expanded_beside_the_present_one() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(
        ROBOT,
        "name=\"m0\" value=\"0.15\"",
        "name=\"m0\" value=\"0.25\"",
    );
    let urdf = |client: &mut Client, texts: Option<Value>| {
        let mut params = client.of(ROBOT);
        params["texts"] = texts.unwrap_or_default();
        let answer = client.request("xacro/expand", params);
        assert_eq!(answer["ok"], true, "{answer}");
        answer["urdf"].as_str().unwrap().to_owned()
    };
    assert!(urdf(&mut client, None).contains("<mass value=\"0.5\"/>"));
    assert!(
        urdf(&mut client, Some(json!({}))).contains("<mass value=\"0.3\"/>"),
        "that of the disk"
    );
    let unit = client.text(UNIT).replace("_body", "_case");
    let texts = json!({ (client.uri(UNIT)): unit });
    let earlier = urdf(&mut client, Some(texts));
    assert!(
        earlier.contains("tilt_case") && earlier.contains("<mass value=\"0.3\"/>"),
        "{earlier}"
    );
    // what is open stays as it is
    assert!(urdf(&mut client, None).contains("tilt_body"));
}

#[test]
fn a_macro_body_shows_all_it_made() {
    let mut client = Client::start();
    client.open(UNIT);
    let answer = client.request("xacro/toExpanded", client.at(UNIT, "<ax|is"));
    let labels: Vec<&str> = answer["instances"]
        .as_array()
        .unwrap()
        .iter()
        .map(|i| i["label"].as_str().unwrap())
        .collect();
    assert_eq!(
        labels,
        [
            "unit @ pan_tilt.urdf.xacro:7",
            "unit @ pan_tilt.urdf.xacro:8"
        ]
    );
}

#[test]
fn a_call_shows_all_that_came_through_it() {
    let mut client = Client::start();
    client.open(ROBOT);
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    let urdf = expanded["urdf"].as_str().unwrap().to_owned();
    let answer = client.request(
        "xacro/toExpanded",
        client.at(ROBOT, "<xacro:un|it name=\"tilt\""),
    );
    let range = &answer["instances"][0]["range"];
    let [start, end] = ["start", "end"].map(|side| super::positions::offset(&urdf, &range[side]));
    let made = urdf.get(start..end).unwrap();
    assert!(
        made.contains("tilt_body") && made.contains("<joint name=\"tilt\""),
        "{made}"
    );
    assert!(!made.contains("name=\"pan\""), "{made}");
    assert_eq!(
        answer["instances"][0]["label"],
        "unit @ pan_tilt.urdf.xacro:8"
    );
}

#[test]
fn the_tree_lists_links_with_their_joints_and_masses() {
    let mut client = Client::start();
    client.open(UNIT);
    let tree = client.request("xacro/tree", client.of(UNIT));
    let shown: Vec<String> = tree["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|node| format!("{} {} {}", node["link"], node["joint"], node["mass"]))
        .collect();
    assert_eq!(
        shown,
        [
            "\"desk\" null null",
            "\"pan_body\" \"pan\" 0.3",
            "\"tilt_body\" \"tilt\" 0.3"
        ]
    );
}

#[test]
fn roots_can_be_listed_and_picked() {
    let mut client = Client::start();
    client.open(UNIT);
    let params = json!({ "textDocument": { "uri": client.uri(UNIT) } });
    let roots = client.request("xacro/roots", params.clone());
    assert!(
        roots["active"]["uri"]
            .as_str()
            .unwrap()
            .ends_with("pan_tilt.urdf.xacro"),
        "{roots}"
    );
    assert_eq!(
        roots["args"],
        json!([{ "name": "mount", "value": "desk", "default": "desk" }])
    );
    let root = json!({ "uri": client.uri(ROBOT), "args": { "mount": "wall" } });
    client.request(
        "xacro/setRoot",
        json!({ "root": root, "textDocument": { "uri": client.uri(UNIT) } }),
    );
    let roots = client.request("xacro/roots", params);
    assert_eq!(
        roots["args"],
        json!([{ "name": "mount", "value": "wall", "default": "desk" }])
    );
}

#[test]
fn what_a_call_passes_shows_all_that_it_became() {
    let mut client = Client::start();
    client.open(ROBOT);
    let answer = client.request("xacro/toExpanded", client.at(ROBOT, "name=\"p|an\""));
    let labels: Vec<&str> = answer["instances"]
        .as_array()
        .unwrap()
        .iter()
        .map(|i| i["label"].as_str().unwrap())
        .collect();
    // the link, the joint, and the child of the joint
    assert_eq!(labels, ["unit @ pan_tilt.urdf.xacro:7"; 3]);
}
