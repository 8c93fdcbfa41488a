//! F3: completion, with the documentation of single items.

use serde_json::{Value, json};

use super::client::{Client, Options, position};
use super::workspace::{ROBOT, ROBOT_TEXT, UNIT, pan_tilt, write};

/// A client that knows all of completion.
fn able() -> Client {
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

fn both() -> Client {
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
fn sorted(items: &Value) -> Vec<String> {
    let mut items = items.as_array().unwrap().clone();
    items.sort_by_key(|item| item["sortText"].as_str().unwrap().to_owned());
    items
        .iter()
        .map(|item| item["label"].as_str().unwrap().to_owned())
        .collect()
}

/// The labels at the end of the robot, cut off behind its calls, with `tail` typed there.
#[track_caller]
fn at_the_end(tail: &str) -> Vec<String> {
    let mut client = able();
    let text = ROBOT_TEXT.replace("</robot>\n", tail);
    client.open_with(ROBOT, &text);
    let mut params = client.of(ROBOT);
    params["position"] = position(&text, text.len());
    sorted(&client.request("textDocument/completion", params)["items"])
}

#[track_caller]
fn check(tail: &str, expected: &[&str], unexpected: &[&str]) {
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

fn item(client: &mut Client, file: &str, at: &str, label: &str) -> Value {
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
fn calls_are_snippets_with_what_the_macro_requires() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<xacro:un\n</robot>");
    let unit = item(&mut client, ROBOT, "<xacro:un|\n", "xacro:unit");
    let text = unit["textEdit"]["newText"].as_str().unwrap();
    assert_eq!(unit["insertTextFormat"], 2);
    assert!(
        text.contains("name=\"$1\" parent=\"$2\"") && !text.contains("axis"),
        "{text}"
    );
    assert!(
        text.contains("<origin") && text.ends_with("</xacro:unit>$0"),
        "{text}"
    );
    assert_eq!(unit["labelDetails"]["description"], "unit.xacro");
    assert_eq!(
        client.slice(ROBOT, &unit["textEdit"]["replace"]),
        "xacro:un"
    );
}

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
fn columns_are_utf16() {
    let mut client = able();
    let text = ROBOT_TEXT.replace("</robot>", "<!-- 🤖🤖 --><xacro:un</robot>");
    client.open_with(ROBOT, &text);
    let unit = item(&mut client, ROBOT, "<xacro:un|<", "xacro:unit");
    assert_eq!(client.slice(ROBOT, &unit["textEdit"]["insert"]), "xacro:un");
}

#[test]
fn clients_that_know_little_get_plain_items() {
    let mut client = Client::start();
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", "<xacro:un</robot>"));
    let unit = item(&mut client, ROBOT, "<xacro:un|<", "xacro:unit");
    assert_eq!(unit["textEdit"]["newText"], "xacro:unit");
    assert!(unit["textEdit"]["range"].is_object() && unit.get("labelDetails").is_none());
    assert!(unit.get("insertTextFormat").is_none());
}

#[test]
fn a_setting_turns_snippets_off() {
    let item = json!({ "snippetSupport": true });
    let capabilities = json!({ "textDocument": { "completion": { "completionItem": item } } });
    let settings = json!({ "completion": { "snippets": false } });
    let mut client = Client::with(
        pan_tilt(),
        Options {
            capabilities,
            settings,
            ..Options::default()
        },
    );
    client.open_with(ROBOT, &ROBOT_TEXT.replace("</robot>", "<xacro:un</robot>"));
    client.wait(
        |client| {
            client
                .asked
                .iter()
                .any(|m| m["method"] == "workspace/configuration")
                .then_some(())
        },
        || "settings".into(),
    );
    let unit = item_when(&mut client, |item| item.get("insertTextFormat").is_none());
    assert_eq!(unit["textEdit"]["newText"], "xacro:unit");
}

/// The item of the macro `unit`, asked for until it is as expected: settings come some time after the start.
fn item_when(client: &mut Client, is: impl Fn(&Value) -> bool) -> Value {
    for _ in 0..100 {
        let found = item(client, ROBOT, "<xacro:un|<", "xacro:unit");
        if is(&found) {
            return found;
        }
    }
    panic!("the item never is as expected");
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
fn documentation_comes_when_an_item_is_looked_at() {
    let mut client = both();
    client.edit(ROBOT, "</robot>", "<xacro:un\n</robot>");
    let unit = item(&mut client, ROBOT, "<xacro:un|\n", "xacro:unit");
    assert!(unit.get("documentation").is_none());
    let resolved = client.request("completionItem/resolve", unit.clone());
    let text = resolved["documentation"]["value"].as_str().unwrap();
    assert!(
        text.contains("A motor with its bracket.") && text.contains("axis='0 0 1'"),
        "{text}"
    );
    assert_eq!(resolved["textEdit"], unit["textEdit"]);
    let limit = item(&mut client, UNIT, "<|limit", "limit");
    let resolved = client.request("completionItem/resolve", limit);
    assert!(
        resolved["documentation"]["value"]
            .as_str()
            .unwrap()
            .contains("velocity")
    );
}

#[test]
fn forged_items_come_back_as_they_are() {
    let mut client = both();
    let good =
        json!({ "uri": client.uri(ROBOT), "topic": { "about": "macro", "name": "nothing" } });
    let foreign =
        json!({ "uri": "file:///etc/passwd", "topic": { "about": "property", "name": "root" } });
    for data in [
        json!(null),
        json!(7),
        json!({ "uri": 3 }),
        json!(["x"]),
        good,
        foreign,
    ] {
        let item = json!({ "label": "x", "data": data });
        let resolved = client.request("completionItem/resolve", item);
        assert_eq!(resolved["label"], "x");
        assert!(resolved.get("documentation").is_none());
    }
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

#[test]
fn long_lists_are_cut_and_say_so() {
    let mut client = able();
    let many: String = (0..300)
        .map(|n| format!("<xacro:property name=\"value_{n}\" value=\"{n}\"/>"))
        .collect();
    client.open_with(
        ROBOT,
        &ROBOT_TEXT.replace(
            "</robot>",
            &format!("{many}<link name=\"${{value_2\"/></robot>"),
        ),
    );
    let answer = client.request("textDocument/completion", client.at(ROBOT, "${value_2|"));
    assert_eq!(answer["isIncomplete"], true);
    let items = answer["items"].as_array().unwrap();
    assert!(
        items.len() <= 200 && items.iter().any(|item| item["label"] == "value_299"),
        "{}",
        items.len()
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
