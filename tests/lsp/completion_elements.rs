//! F3: completion of elements: those a parent takes, whole ones, and the root of an empty file.

use serde_json::json;

use super::client::{Client, Options};
use super::completion::{able, at_the_end, both, check, item, sorted};
use super::positions::position;
use super::workspace::{ROBOT, pan_tilt, write};

#[test]
fn only_macros_of_the_context_are_offered() {
    check(
        "<",
        &[
            "xacro:unit",
            "link",
            "joint",
            "xacro:property",
            "ros2_control",
        ],
        &["xacro:lens", "box"],
    );
}

#[test]
fn parents_decide_about_elements() {
    check(
        "<joint name=\"j\" type=\"fixed\"><parent link=\"desk\"/><",
        &["child", "origin"],
        &["parent", "mass"],
    );
    check(
        "<link name=\"l\"><visual><geometry><",
        &["box", "mesh"],
        &["link", "origin"],
    );
    check(
        "<link name=\"l\"><xacro:if value=\"1\"><",
        &["visual", "inertial"],
        &["geometry"],
    );
    check("<joint name=\"j\" type=\"fixed\"></", &["joint"], &["link"]);
    assert_eq!(
        at_the_end("<joint name=\"j\" type=\"fixed\"></jo"),
        ["joint"]
    );
    assert_eq!(
        at_the_end("<joint name=\"j\" type=\"fixed\"><")[..2],
        ["parent", "child"]
    );
}

#[test]
fn an_empty_file_gets_a_root_with_its_namespace() {
    let mut client = able();
    client.open_with(ROBOT, "<");
    let robot = item(&mut client, ROBOT, "<|", "robot");
    assert!(
        robot["textEdit"]["newText"]
            .as_str()
            .unwrap()
            .contains("xmlns:xacro=\"http://www.ros.org/wiki/xacro\"")
    );
    client.edit(ROBOT, "<", "rob");
    let robot = item(&mut client, ROBOT, "rob|", "robot");
    assert!(
        robot["textEdit"]["newText"]
            .as_str()
            .unwrap()
            .starts_with("<robot"),
        "{robot}"
    );
    client.edit(ROBOT, "rob", "<robot name=\"r\" xmlns:");
    let namespace = item(&mut client, ROBOT, "xmlns:|", "xmlns:xacro");
    assert_eq!(
        namespace["textEdit"]["newText"],
        "xmlns:xacro=\"http://www.ros.org/wiki/xacro\""
    );
}

#[test]
fn elements_are_offered_between_tags_when_asked_for() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "  li\n</robot>");
    let link = item(&mut client, ROBOT, "  li|\n", "link");
    assert!(
        link["textEdit"]["newText"]
            .as_str()
            .unwrap()
            .starts_with("<link name=")
    );
    let mut params = client.at(ROBOT, "  li|\n");
    params["context"] = json!({ "triggerKind": 2, "triggerCharacter": " " });
    assert_eq!(
        client.request("textDocument/completion", params)["items"],
        json!([])
    );
}

#[test]
fn whole_elements_are_offered_as_children_of_a_robot() {
    let (joint, optical) = (
        "joint revolute with limit",
        "link and joint of an optical frame",
    );
    check("<jo", &["joint", joint], &[]);
    check("li", &["link", optical], &[]);
    check("<ro", &["ros2_control with a joint"], &[]);
    check("<link name=\"x\"><", &["visual"], &[joint, optical]);
    let mut client = both();
    client.edit(ROBOT, "</robot>", "  <jo\n</robot>");
    let found = item(&mut client, ROBOT, "<jo|", joint);
    let text = found["textEdit"]["newText"].as_str().unwrap();
    assert!(
        text.starts_with("joint name=\"${1:joint}\" type=\"revolute\">\n\t<parent"),
        "{text}"
    );
    // an editor without snippets gets the text alone
    let mut plain = Client::start();
    plain.open(ROBOT);
    plain.edit(ROBOT, "</robot>", "  <jo\n</robot>");
    let found = item(&mut plain, ROBOT, "<jo|", joint);
    let text = found["textEdit"]["newText"].as_str().unwrap();
    assert!(
        text.contains("<limit lower=\"-1.57\" upper=\"1.57\"") && !text.contains('$'),
        "{text}"
    );
}

#[test]
fn a_robot_can_be_begun_in_an_empty_file() {
    let folder = pan_tilt();
    let file = "src/pan_tilt/urdf/new.urdf.xacro";
    write(&folder, file, "");
    let item = json!({ "snippetSupport": true });
    let capabilities = json!({ "textDocument": { "completion": { "completionItem": item } } });
    let mut client = Client::with(
        folder,
        Options {
            capabilities,
            ..Options::default()
        },
    );
    for typed in ["rob", "<rob", "<?xml version=\"1.0\"?>\nrob"] {
        client.open_with(file, typed);
        let mut params = client.of(file);
        params["position"] = position(typed, typed.len());
        let found = client.request("textDocument/completion", params)["items"].clone();
        assert!(
            sorted(&found).first().is_some_and(|first| first == "robot"),
            "{typed}: {found:?}"
        );
        client.notify("textDocument/didClose", client.of(file));
    }
}
