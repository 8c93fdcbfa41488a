//! F3: what is offered: names, values, files, attributes.

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::position;
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, pan_tilt, write};

/// A client that knows all of completion.
pub fn able() -> Client {
    let item = json!({ "snippetSupport": true, "insertReplaceSupport": true, "labelDetailsSupport": true });
    let capabilities = json!({ "textDocument": { "completion": { "completionItem": item } } });
    Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    )
}

pub fn both() -> Client {
    let mut client = able();
    client.open(ROBOT);
    client.open(UNIT);
    client
}

fn items(client: &mut Client, file: &str, at: &str) -> Vec<Value> {
    let answer = client.request("textDocument/completion", client.at(file, at));
    answer["items"].as_array().unwrap().clone()
}

fn labels(client: &mut Client, file: &str, at: &str) -> Vec<String> {
    sorted(&Value::Array(items(client, file, at)))
}

/// The labels as an editor shows them.
pub fn sorted(items: &Value) -> Vec<String> {
    let mut items = items.as_array().unwrap().clone();
    items.sort_by_key(|item| item["sortText"].as_str().unwrap().to_owned());
    items
        .iter()
        .map(|item| item["label"].as_str().unwrap().to_owned())
        .collect()
}

/// The labels at the end of the robot, cut off behind its calls, with `tail` typed there.
#[track_caller]
pub fn at_the_end(tail: &str) -> Vec<String> {
    let mut client = able();
    let text = ROBOT_TEXT.replace("</robot>\n", tail);
    client.open_with(ROBOT, &text);
    let mut params = client.of(ROBOT);
    params["position"] = position(&text, text.len());
    sorted(&client.request("textDocument/completion", params)["items"])
}

#[track_caller]
pub fn check(tail: &str, expected: &[&str], unexpected: &[&str]) {
    let found = at_the_end(tail);
    for label in expected {
        assert!(
            found.iter().any(|found| found == label),
            "`{label}` at `{tail}`: {found:?}"
        );
    }
    for label in unexpected {
        assert!(
            found.iter().all(|found| found != label),
            "no `{label}` at `{tail}`: {found:?}"
        );
    }
}

pub fn item(client: &mut Client, file: &str, at: &str, label: &str) -> Value {
    let items = items(client, file, at);
    let found = items.iter().find(|item| item["label"] == label);
    found
        .unwrap_or_else(|| panic!("`{label}` at {at}: {items:?}"))
        .clone()
}

#[test]
fn links_are_offered_at_the_end_of_a_cut_file() {
    check(
        "<joint name=\"j\" type=\"fixed\"><parent link=\"",
        &["desk", "pan_body", "tilt_body"],
        &["pan"],
    );
    check(
        "<joint name=\"j\" type=\"fixed\"><child link=\"pan",
        &["desk", "pan_body", "tilt_body"],
        &[],
    );
    check(
        "<gazebo reference=\"",
        &["desk", "pan_body", "pan", "tilt"],
        &[],
    );
}

#[test]
fn a_block_that_is_given_to_a_macro_has_the_attributes_of_its_element() {
    check(
        "<xacro:unit name=\"third\" parent=\"desk\"><origin ",
        &["xyz", "rpy"],
        &["name"],
    );
}

#[test]
fn joints_are_offered_where_joints_are_named() {
    check(
        "<joint name=\"j\" type=\"revolute\"><mimic joint=\"",
        &["pan", "tilt"],
        &["desk"],
    );
    check(
        "<transmission name=\"t\"><joint name=\"",
        &["pan", "tilt"],
        &["desk"],
    );
    check(
        "<ros2_control name=\"c\" type=\"system\"><joint name=\"",
        &["pan", "tilt"],
        &["desk"],
    );
    check("<link name=\"", &[], &["desk", "pan_body"]);
}

#[test]
fn keys_of_yaml_files_are_offered() {
    check("<link name=\"${cam['", &["fov", "mass"], &["m0"]);
    check("<link name=\"${cam.", &["fov", "mass"], &["m0"]);
    check("<link name=\"${cam['mass']['", &["head"], &["fov"]);
    check("<link name=\"${cam[", &["'fov'", "'mass'", "m0"], &[]);
    let mut client = able();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace("</robot>", "<link name=\"${cam['']}\"/></robot>"),
    );
    let fov = item(&mut client, ROBOT, "cam['|']", "fov");
    assert_eq!(fov["labelDetails"]["description"], "1.2");
}

#[test]
fn attributes_that_are_missing_are_offered_with_their_units() {
    check(
        "<joint name=\"j\" type=\"revolute\"><limit lower=\"-1\" ",
        &["upper", "effort"],
        &["lower"],
    );
    let mut client = both();
    client.edit(UNIT, "effort=\"3\" velocity=\"2\"", " ");
    let velocity = item(&mut client, UNIT, "upper=\"1.57\" | ", "velocity");
    assert!(
        velocity["labelDetails"]["description"]
            .as_str()
            .unwrap()
            .starts_with("rad/s")
    );
    client.edit(ROBOT, "axis=\"0 1 0\"", "");
    let found = labels(&mut client, ROBOT, "parent=\"pan_body\" |");
    assert_eq!(found, ["axis"], "no block, nothing twice");
    check("<robot xmlns:", &[], &["desk"]);
}

#[test]
fn words_and_values_are_offered() {
    check(
        "<joint name=\"j\" type=\"",
        &["revolute", "fixed", "planar"],
        &["desk"],
    );
    check(
        "<joint name=\"j\" type=\"fixed\"><origin rpy=\"",
        &["0 0 0", "${pi/2} 0 0"],
        &[],
    );
    check(
        "<xacro:property name=\"a\" scope=\"",
        &["parent", "global"],
        &[],
    );
    check(
        "<xacro:arg name=\"sim\" default=\"true\"/><xacro:if value=\"",
        &["${}", "$(arg sim)"],
        &["$(arg mount)"],
    );
    check(
        "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material><link name=\"l\"><visual><material name=\"",
        &["red"],
        &[],
    );
}

#[test]
fn expressions_know_names_and_their_values() {
    check(
        "<link name=\"${",
        &["m0", "cam", "pi", "radians", "sin", "len", "xacro"],
        &["name", "axis"],
    );
    check("<link name=\"${2 * ", &["m0"], &[]);
    check("<link name=\"${xacro.", &["load_yaml"], &["m0"]);
    check("<link name=\"${1.", &[], &["m0"]);
    let mut client = both();
    client.edit(UNIT, "${m0 * 2}", "${m0 * }");
    let m0 = item(&mut client, UNIT, "${m0 * |}", "m0");
    assert_eq!(m0["labelDetails"]["description"], "0.15");
    let axis = item(&mut client, UNIT, "${m0 * |}", "axis");
    assert_eq!(axis["labelDetails"]["description"], "default '0 0 1'");
}

#[test]
fn substitutions_know_arguments_and_packages() {
    check(
        "<link name=\"$(",
        &["arg", "find", "env", "optenv", "dirname", "eval", "cwd"],
        &[],
    );
    check("<link name=\"$(arg ", &["mount"], &["m0"]);
    check("<link name=\"$(find ", &["pan_tilt", "lens"], &[]);
    check("<link name=\"$", &["${}", "$(arg )"], &[]);
}

#[test]
fn files_are_offered_where_files_are_named() {
    let folder = pan_tilt();
    write(&folder, "src/pan_tilt/meshes/head.stl", [0; 84]);
    write(&folder, "src/pan_tilt/meshes/notes.txt", "-");
    let mut client = Client::with(folder, Options::default());
    let mesh = "<link name=\"l\"><visual><geometry><mesh filename=\"";
    for (tail, expected, unexpected) in [
        (
            format!("{mesh}package://"),
            vec!["pan_tilt", "lens"],
            vec![],
        ),
        (
            format!("{mesh}package://pan_tilt/"),
            vec!["meshes", "config"],
            vec!["package.xml"],
        ),
        (
            format!("{mesh}package://pan_tilt/meshes/"),
            vec!["head.stl"],
            vec!["notes.txt"],
        ),
        (
            format!("{mesh}file://$(find pan_tilt)/meshes/"),
            vec!["head.stl"],
            vec![],
        ),
        (format!("{mesh}/etc/"), vec![], vec!["passwd", "ssl"]),
        (
            "<xacro:include filename=\"".to_owned(),
            vec!["unit.xacro", "$(find pan_tilt)/"],
            vec!["pan_tilt.urdf.xacro"],
        ),
        (
            "<xacro:property name=\"y\" value=\"${xacro.load_yaml('../config/".to_owned(),
            vec!["cam.yaml"],
            vec![],
        ),
        (
            "<xacro:property name=\"y\" value=\"${xacro.load_yaml('$(find ".to_owned(),
            vec!["pan_tilt"],
            vec![],
        ),
    ] {
        client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>\n", &tail));
        let found = labels(&mut client, ROBOT, &format!("{tail}|"));
        for label in expected {
            assert!(
                found.iter().any(|found| found == label),
                "`{label}` at `{tail}`: {found:?}"
            );
        }
        for label in unexpected {
            assert!(
                found.iter().all(|found| found != label),
                "no `{label}` at `{tail}`: {found:?}"
            );
        }
        client.notify("textDocument/didClose", client.of(ROBOT));
    }
}

#[test]
fn macro_bodies_know_their_parameters_and_patterns() {
    let mut client = both();
    client.edit(UNIT, "<parent link=\"${parent}\"/>", "<parent link=\"\"/>");
    let found = labels(&mut client, UNIT, "<parent link=\"|");
    assert_eq!(found[0], "${name}_body");
    assert!(
        ["${parent}", "desk", "tilt_body"]
            .iter()
            .all(|label| found.iter().any(|f| f == label)),
        "{found:?}"
    );
    assert_eq!(labels(&mut client, UNIT, "insert_block name=\"|at"), ["at"]);
}

#[test]
fn arguments_that_become_links_are_links() {
    let mut client = both();
    client.edit(ROBOT, "parent=\"pan_body\"", "parent=\"\"");
    let found = labels(&mut client, ROBOT, "name=\"tilt\" parent=\"|");
    assert!(found.iter().any(|label| label == "pan_body"), "{found:?}");
}

#[test]
fn nothing_is_offered_in_comments_and_verbatim_text() {
    for tail in [
        "<!-- <",
        "<!-- ",
        "<![CDATA[ <",
        "<?xacro <",
        "<link name=\"a\"",
        "<link name=",
    ] {
        assert_eq!(at_the_end(tail), [""; 0], "{tail}");
    }
    check(
        "<!-- xacro-lint: ",
        &["disable-next-line", "disable", "enable", "disable-file"],
        &["link"],
    );
    check(
        "<!-- xacro-lint: disable-next-line ",
        &["unused-property", "orphan-link"],
        &["link"],
    );
    check("<!-- xacro", &["xacro-lint:", "xacro-root:"], &[]);
    let mut client = both();
    client.edit(UNIT, "<!-- A motor", "<!-- xacro-root: -->\n<!-- A motor");
    assert_eq!(
        labels(&mut client, UNIT, "xacro-root: |"),
        ["pan_tilt.urdf.xacro"]
    );
}

#[test]
fn unsaved_includes_count() {
    let mut client = both();
    client.edit(
        UNIT,
        "name=\"unit\" params=\"name",
        "name=\"motor\" params=\"gear name",
    );
    client.edit(
        UNIT,
        "<link name=\"${name}_body\">",
        "<link name=\"${name}_frame\">",
    );
    client.edit(ROBOT, "</robot>", "<xacro:\n<xacro:motor \n</robot>");
    let motor = item(&mut client, ROBOT, "<xacro:|\n", "xacro:motor");
    assert!(
        motor["textEdit"]["newText"]
            .as_str()
            .unwrap()
            .contains("gear=")
    );
    let found = labels(&mut client, ROBOT, "<xacro:motor |\n");
    assert_eq!(found, ["gear", "name", "parent", "axis"]);
}

#[test]
fn files_of_nobody_are_not_told() {
    let foreign = pan_tilt();
    write(
        &foreign,
        "secret.xacro",
        "<robot><xacro:macro name=\"secret\"/><xacro:property name=\"key\" value=\"1\"/></robot>",
    );
    let mut client = able();
    let include = format!(
        "<xacro:include filename=\"{}\"/>",
        foreign.join("secret.xacro").display()
    );
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace(
            "</robot>",
            &format!("{include}<xacro:un<link name=\"${{k\"/></robot>"),
        ),
    );
    for at in ["<xacro:un|<", "${k|"] {
        let found = labels(&mut client, ROBOT, at);
        assert!(
            !found.is_empty()
                && found
                    .iter()
                    .all(|label| label != "xacro:secret" && label != "key"),
            "{found:?}"
        );
    }
    std::fs::remove_dir_all(foreign).unwrap();
}
