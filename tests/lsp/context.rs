//! Under which root a file is shown.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT, pan_tilt, write};

#[track_caller]
fn check_root(client: &mut Client, file: &str, expected: &str) {
    let expanded = client.request("xacro/expand", client.of(file));
    let root = expanded["root"]["uri"].as_str().unwrap();
    assert!(root.ends_with(expected), "{root}");
}

#[test]
fn the_nearest_robot_wins_and_the_edited_one_before_it() {
    let folder = pan_tilt();
    let far = r#"<robot name="far" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="unit.xacro"/><link name="a"/></robot>"#;
    write(&folder, "src/pan_tilt/urdf/zz.urdf.xacro", far);
    let mut client = Client::with(folder, Options::default());
    client.open(UNIT);
    check_root(&mut client, UNIT, "pan_tilt.urdf.xacro");
    client.open("src/pan_tilt/urdf/zz.urdf.xacro");
    check_root(&mut client, UNIT, "zz.urdf.xacro");
    client.open(ROBOT);
    check_root(&mut client, UNIT, "pan_tilt.urdf.xacro");
}

#[test]
fn a_comment_names_root_and_arguments() {
    let mut client = Client::start();
    client.open(UNIT);
    client.edit(
        UNIT,
        "<!-- A motor",
        "<!-- xacro-root: pan_tilt.urdf.xacro mount:=wall -->\n  <!-- A motor",
    );
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert_eq!(expanded["args"], json!({ "mount": "wall" }));
}

#[test]
fn configured_roots_come_with_their_arguments() {
    let folder = pan_tilt();
    let config =
        "[[roots]]\nfile = \"pan_tilt/urdf/pan_tilt.urdf.xacro\"\nargs = { mount = \"mast\" }\n";
    write(&folder, "src/xacro-lint.toml", config);
    let mut client = Client::with(folder, Options::default());
    client.open(UNIT);
    let expanded = client.request("xacro/expand", client.of(UNIT));
    assert_eq!(expanded["args"], json!({ "mount": "mast" }), "{expanded}");
}

#[test]
fn the_default_comes_first_and_presets_in_the_order_of_the_file() {
    let folder = pan_tilt();
    let config = "[[roots]]\nfile = \"pan_tilt/urdf/pan_tilt.urdf.xacro\"\nargs = { mount = \"shelf\" }\n\
                  presets.tall = { mount = \"mast\" }\npresets.bench = { mount = \"bench\" }\n";
    write(&folder, "src/xacro-lint.toml", config);
    let mut client = Client::with(folder, Options::default());
    client.open(UNIT);
    let found = client.request("xacro/roots", client.of(UNIT));
    assert_eq!(
        found["active"]["args"],
        json!({ "mount": "shelf" }),
        "{found}"
    );
    let candidates = found["candidates"].as_array().unwrap().iter();
    let presets: Vec<&str> = candidates
        .map(|candidate| candidate["preset"].as_str().unwrap_or("-"))
        .collect();
    assert_eq!(presets, ["-", "tall", "bench"]);
    // a preset is chosen by its name, too
    let root = json!({ "uri": found["active"]["uri"], "preset": "bench" });
    client.request("xacro/setRoot", json!({ "root": root }));
    let roots = client.request("xacro/roots", client.of(UNIT));
    assert_eq!(roots["active"]["preset"], "bench");
    assert_eq!(roots["args"][0]["value"], "bench", "{roots}");
}

#[test]
fn arguments_are_listed_as_they_are_declared() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(
        ROBOT,
        "<xacro:arg name=\"mount\" default=\"desk\"/>",
        "<xacro:arg name=\"zoom\" default=\"1\"/><xacro:arg name=\"mount\" default=\"desk\"/><xacro:arg name=\"axis\" default=\"x\"/>",
    );
    let found = client.request("xacro/roots", client.of(ROBOT));
    let names = found["args"].as_array().unwrap().iter();
    let names: Vec<&str> = names.map(|arg| arg["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["zoom", "mount", "axis"]);
}

#[test]
fn what_appears_on_the_disk_is_noticed() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "filename=\"unit.xacro\"", "filename=\"unit2.xacro\"");
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], Value::Bool(false));
    write(
        &client.folder,
        "src/pan_tilt/urdf/unit2.xacro",
        super::workspace::UNIT_TEXT,
    );
    let expanded = client.request("xacro/expand", client.of(ROBOT));
    assert_eq!(expanded["ok"], Value::Bool(true), "{expanded}");
}

#[test]
fn the_first_answer_about_a_part_knows_its_robot() {
    let folder = pan_tilt();
    let part = "src/pan_tilt/parts/part.xacro";
    write(&folder, part, "<robot><link name=\"a\"b=\"c\"/></robot>");
    let robot = "<robot name=\"far\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:include filename=\"../parts/part.xacro\"/><link name=\"a\"/></robot>";
    write(&folder, "src/pan_tilt/robots/far.urdf.xacro", robot);
    let mut client = Client::with(folder, Options::default());
    client.open(part);
    let report = client.request("textDocument/diagnostic", client.of(part));
    let related = &report["items"][0]["relatedInformation"][0];
    assert_eq!(related["message"], "included here", "{report}");
    assert!(
        related["location"]["uri"]
            .as_str()
            .unwrap()
            .ends_with("robots/far.urdf.xacro"),
        "{report}"
    );
}
