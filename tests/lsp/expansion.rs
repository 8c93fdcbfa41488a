//! F33: the expanded document.

use serde_json::json;

use super::client::Client;
use super::workspace::{ROBOT, UNIT};

#[test]
fn a_robot_is_expanded_with_the_arguments_asked_for() {
    let mut client = Client::start();
    client.open(ROBOT);
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], true, "{expanded}");
    assert_eq!(expanded["urdf"].as_str().unwrap().matches("<link name=").count(), 3);
    assert_eq!(expanded["args"], json!({ "mount": "desk" }));
    let mut params = client.of(ROBOT);
    params["args"] = json!({ "mount": "wall" });
    let expanded = client.request("xacro/expand", params);
    assert!(expanded["urdf"].as_str().unwrap().contains("<link name=\"wall\"/>"), "{expanded}");
}

#[test]
fn a_macro_file_is_expanded_as_part_of_its_robot() {
    let mut client = Client::start();
    client.open(UNIT);
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert!(expanded["root"]["uri"].as_str().unwrap().ends_with("pan_tilt.urdf.xacro"), "{expanded}");
}

#[test]
fn a_broken_robot_says_why() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "${m0 / 3}", "${m0 / 0}");
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], false);
    assert_eq!(expanded["errors"][0]["code"], "expression-error");
    assert_eq!(expanded["errors"][0]["location"]["range"]["start"]["line"], 7);
}

#[test]
fn the_command_answers_the_same() {
    let mut client = Client::start();
    client.open(ROBOT);
    let params = json!({ "command": "xacro.expand", "arguments": [client.of(ROBOT)] });
    assert_eq!(client.request("workspace/executeCommand", params)["ok"], true);
}
