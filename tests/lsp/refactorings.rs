//! F25: macros and files made of elements, prefixes, and the same thing written in another way.

use serde_json::{Value, json};

use super::actions::{FILE, actions, fixes, robot, show, titled};
use super::client::{Client, Options};
use super::workspace::{ROBOT, UNIT, pan_tilt, write};

/// The text after the action of this title at a marked text.
#[track_caller]
fn after(client: &mut Client, marked: &str, title: &str) -> String {
    let found = actions(client, FILE, marked, &[], &["refactor"]);
    client.after(FILE, &titled(&found, title)["edit"])
}

fn titles(actions: &[Value]) -> Vec<&str> {
    actions
        .iter()
        .map(|action| action["title"].as_str().unwrap())
        .collect()
}

fn expanded(client: &mut Client, file: &str) -> String {
    let answer = client.request("xacro/expand", client.of(file));
    assert_eq!(answer["errors"], json!([]), "{answer}");
    answer["urdf"].as_str().unwrap().to_owned()
}

#[test]
fn a_macro_is_made_of_elements_and_expands_to_the_same() {
    let mut client = Client::start();
    let text = robot(
        "  <xacro:property name=\"m\" value=\"2\"/>\n  <link name=\"🤖\"/><link name=\"a\">\n    <inertial>\n      \
         <mass value=\"${m * pi}\"/>\n    </inertial>\n  </link>\n  <link name=\"b_${m}\"/>",
    );
    show(&mut client, &text);
    let before = expanded(&mut client, FILE);
    let marked = "«<link name=\"a\">\n    <inertial>\n      <mass value=\"${m * pi}\"/>\n    </inertial>\n  \
                  </link>\n  <link name=\"b_${m}\"/>»";
    let changed = after(
        &mut client,
        marked,
        "Extract selection to macro `extracted`",
    );
    assert!(
        changed.contains("<xacro:macro name=\"extracted\" params=\"m\">\n    <link"),
        "{changed}"
    );
    assert!(
        changed.contains("  <xacro:extracted m=\"${m}\"/>\n"),
        "{changed}"
    );
    show(&mut client, &changed);
    assert_eq!(expanded(&mut client, FILE), before);
    // what defines something for others, or takes a block of the macro around, stays
    show(
        &mut client,
        &robot("<xacro:property name=\"m\" value=\"2\"/>\n<link name=\"b_${m}\"/>"),
    );
    let marked = "«<xacro:property name=\"m\" value=\"2\"/>\n<link name=\"b_${m}\"/>»";
    let found = actions(&mut client, FILE, marked, &[], &["refactor.extract"]);
    assert!(
        !titles(&found).iter().any(|title| title.contains("macro")),
        "{found:?}"
    );
}

#[test]
fn names_of_a_macro_get_a_prefix() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot(
            "  <link name=\"base\"/>\n  <xacro:macro name=\"arm\" params=\"on\">\n    <link name=\"tip\"/>\n    \
             <joint name=\"j\" type=\"fixed\"><parent link=\"${on}\"/><child link=\"tip\"/></joint>\n    \
             <gazebo reference=\"tip\"/>\n  </xacro:macro>\n  <xacro:arm on=\"base\"/>",
        ),
    );
    let before = expanded(&mut client, FILE);
    let changed = after(&mut client, "<link na|me=\"tip\"", "to names");
    assert!(changed.contains("params=\"on prefix:=''\""), "{changed}");
    assert_eq!(changed.matches("\"${prefix}tip\"").count(), 3, "{changed}");
    assert!(changed.contains("<joint name=\"j\""), "{changed}");
    show(&mut client, &changed);
    assert_eq!(expanded(&mut client, FILE), before);
    let found = actions(
        &mut client,
        FILE,
        "<link na|me=\"base\"",
        &[],
        &["refactor.rewrite"],
    );
    assert!(
        !titles(&found).iter().any(|title| title.contains("prefix")),
        "{found:?}"
    );
}

#[test]
fn angles_are_written_in_degrees_and_back() {
    let mut client = Client::start();
    let joint = "<joint name=\"🤖\" type=\"revolute\"><origin xyz=\"0 0 1\" rpy=\"0 -1.5708 ${radians(45)}\"/>\
                 <limit lower=\"-1\" upper=\"3.14159\" effort=\"1\" velocity=\"2\"/></joint>";
    show(&mut client, &robot(joint));
    let changed = after(&mut client, "rpy=\"0 -1.5|708", "Convert angle to");
    assert!(
        changed.contains("rpy=\"0 ${radians(-90)} ${radians(45)}\""),
        "{changed}"
    );
    let changed = after(&mut client, "upper=\"3.|14159", "Convert angle to");
    assert!(changed.contains("upper=\"${radians(180)}\""), "{changed}");
    let changed = after(&mut client, "${radi|ans(45)}", "Convert angle to");
    assert!(changed.contains("-1.5708 0.785398163397448\""), "{changed}");
    for place in ["xyz=\"0 0 |1", "effort=\"|1", "rpy=\"|0"] {
        let found = actions(&mut client, FILE, place, &[], &["refactor.rewrite"]);
        assert!(
            !titles(&found).iter().any(|title| title.contains("angle")),
            "{place}: {found:?}"
        );
    }
}

#[test]
fn attributes_and_paths_are_written_in_their_usual_form() {
    let mut client = Client::start();
    write(
        &client.folder,
        "src/pan_tilt/meshes/head.stl",
        "solid head\nendsolid head\n",
    );
    let text = robot(
        "<link name=\"🤖\"><visual><origin rpy=\"0 0 1\" xyz=\"1 2 3\"/><geometry>\
         <mesh filename=\"file://WS/src/pan_tilt/meshes/head.stl\"/></geometry></visual></link>\n\
         <xacro:include filename=\"unit.xacro\"/>",
    );
    let text = text.replace(
        "WS",
        client.folder.to_str().unwrap().trim_start_matches('/'),
    );
    show(&mut client, &text.replace("file://", "file:///"));
    let changed = after(&mut client, "<ori|gin rpy", "Sort attributes");
    assert!(
        changed.contains("<origin xyz=\"1 2 3\" rpy=\"0 0 1\"/>"),
        "{changed}"
    );
    let changed = after(&mut client, "pan_tilt/mesh|es/head.stl", "Convert path to");
    assert!(
        changed.contains("\"package://pan_tilt/meshes/head.stl\""),
        "{changed}"
    );
    let changed = after(&mut client, "filename=\"un|it.xacro", "Convert path to");
    assert!(
        changed.contains("\"$(find pan_tilt)/urdf/unit.xacro\""),
        "{changed}"
    );
    show(&mut client, &changed);
    assert!(expanded(&mut client, FILE).contains("<link name=\"🤖\">"));
}

#[test]
fn a_plain_description_becomes_one_for_xacro() {
    let mut client = Client::start();
    show(
        &mut client,
        "<robot name=\"plain 🤖\">\n  <link name=\"a\"/>\n  <note text=\"${x} costs $5\"/>\n</robot>\n",
    );
    let changed = after(&mut client, "<ro|bot", "Convert to a xacro file");
    assert!(
        changed.contains("<robot name=\"plain 🤖\" xmlns:xacro="),
        "{changed}"
    );
    show(&mut client, &changed);
    assert!(expanded(&mut client, FILE).contains("text=\"${x} costs $5\""));
    let found = actions(&mut client, FILE, "<ro|bot", &[], &["refactor"]);
    assert!(
        !titles(&found).contains(&"Convert to a xacro file"),
        "{found:?}"
    );
}

#[test]
fn a_link_gets_an_inertial_to_fill_in() {
    let mut client = Client::start();
    show(&mut client, &robot("  <link name=\"🤖\"/>"));
    let changed = after(&mut client, "<li|nk", "Add `inertial`");
    assert!(
        changed.contains("\n      <mass value=\"1\"/>\n      <inertia ixx="),
        "{changed}"
    );
    assert!(
        changed.contains("\n    </inertial>\n  </link>"),
        "{changed}"
    );
    show(&mut client, &changed);
    let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor"]);
    assert!(
        !titles(&found)
            .iter()
            .any(|title| title.contains("inertial")),
        "{found:?}"
    );
}

/// A client that makes and renames files.
fn with_files() -> Client {
    let operations = json!(["create", "rename", "delete"]);
    let capabilities = json!({ "workspace": { "workspaceEdit": {
        "documentChanges": true, "resourceOperations": operations } } });
    Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    )
}

#[test]
fn elements_are_moved_to_a_file_that_is_included() {
    let mut client = with_files();
    client.open(UNIT);
    client.edit(UNIT, "name=\"unit\"", "name=\"🤖unit\"");
    show(
        &mut client,
        &robot("  <link name=\"🤖\"/>\n  <link name=\"tool\"/>\n  <link name=\"tip\"/>"),
    );
    let before = expanded(&mut client, FILE);
    let marked = "«<link name=\"tool\"/>\n  <link name=\"tip\"/>»";
    let found = actions(&mut client, FILE, marked, &[], &["refactor.extract"]);
    let changes = &titled(&found, "Move selection to `tool.xacro`")["edit"]["documentChanges"];
    let file = client.uri("src/pan_tilt/urdf/tool.xacro");
    assert_eq!(
        (&changes[0]["kind"], &changes[0]["uri"]),
        (&json!("create"), &json!(file))
    );
    write(
        &client.folder,
        "src/pan_tilt/urdf/tool.xacro",
        changes[1]["edits"][0]["newText"].as_str().unwrap(),
    );
    let changed = client.after_edits(FILE, changes[2]["edits"].as_array().unwrap());
    assert!(
        changed.contains("  <xacro:include filename=\"tool.xacro\"/>\n</robot>"),
        "{changed}"
    );
    show(&mut client, &changed);
    assert_eq!(expanded(&mut client, FILE), before);
    // a file of this name is there now
    show(&mut client, &robot("  <link name=\"tool\"/>"));
    let found = actions(
        &mut client,
        FILE,
        "«<link name=\"tool\"/>»",
        &[],
        &["refactor.extract"],
    );
    titled(&found, "Move selection to `tool_2.xacro`");
    // clients that cannot make files are not asked to
    let mut plain = Client::start();
    show(&mut plain, &robot("  <link name=\"tool\"/>"));
    let found = actions(
        &mut plain,
        FILE,
        "«<link name=\"tool\"/>»",
        &[],
        &["refactor.extract"],
    );
    assert!(
        !titles(&found).iter().any(|title| title.contains("Move")),
        "{found:?}"
    );
}

#[test]
fn a_urdf_with_tags_of_xacro_is_renamed() {
    let mut client = with_files();
    let file = "src/pan_tilt/urdf/plain.urdf";
    client.open_with(
        file,
        &robot("<xacro:property name=\"a\" value=\"🤖\"/><link name=\"${a}\"/>"),
    );
    let found = fixes(&mut client, file, "xacro-tags-in-urdf");
    let rename = &titled(&found, "`plain.urdf.xacro`")["edit"]["documentChanges"][0];
    assert_eq!(rename["kind"], "rename");
    assert!(
        rename["newUri"]
            .as_str()
            .unwrap()
            .ends_with("/plain.urdf.xacro"),
        "{rename}"
    );
}

#[test]
fn what_hides_a_name_of_python_gets_another_name() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot("<xacro:property name=\"e\" value=\"2\"/>\n<!-- 🤖 --><link name=\"l${e}\"/>"),
    );
    let found = fixes(&mut client, FILE, "shadowed-builtin");
    let changed = client.after(FILE, &titled(&found, "Rename `e` to `e_`")["edit"]);
    assert!(
        changed.contains("name=\"e_\"") && changed.contains("l${e_}"),
        "{changed}"
    );
}

#[test]
fn a_definition_is_moved_in_front_of_its_use() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot(
            "  <!-- 🤖 -->\n  <link name=\"l${late}\"/>\n  <xacro:property name=\"late\" value=\"2\"/>\n  <link name=\"m\"/>",
        ),
    );
    let found = fixes(&mut client, FILE, "use-before-definition");
    let changed = client.after(FILE, &titled(&found, "Move definition")["edit"]);
    let expected = robot(
        "  <xacro:property name=\"late\" value=\"2\"/>\n  <!-- 🤖 -->\n  <link name=\"l${late}\"/>\n  <link name=\"m\"/>",
    );
    assert_eq!(changed, expected);
    show(&mut client, &changed);
    assert!(expanded(&mut client, FILE).contains("\"l2\""));
}

#[test]
fn nothing_is_made_of_broken_text_and_unsaved_includes_count() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    // the new macro takes no name that an unsaved include gives
    client.edit(UNIT, "name=\"unit\"", "name=\"extracted\"");
    let found = actions(
        &mut client,
        ROBOT,
        "«<link name=\"$(arg mount)\"/>»",
        &[],
        &["refactor.extract"],
    );
    titled(&found, "Extract selection to macro `extracted_2`");
    client.edit(ROBOT, "</robot>", "<link name=\"");
    let found = actions(
        &mut client,
        ROBOT,
        "«<link name=\"$(arg mount)\"/>»",
        &[],
        &["refactor"],
    );
    assert_eq!(titles(&found), Vec::<&str>::new());
}

/// A text STL of one triangle.
const MESH: &str = "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  \
                    endloop\n endfacet\nendsolid a\n";

#[test]
fn a_mesh_of_text_is_written_as_binary_by_a_command() {
    let mut client = Client::start();
    write(&client.folder, "src/pan_tilt/meshes/head.stl", MESH);
    let text = robot(
        "<link name=\"🤖\"><visual><geometry><mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry>\
         </visual></link>",
    );
    show(&mut client, &text);
    let found = fixes(&mut client, FILE, "ascii-stl");
    let command = &titled(&found, "binary STL")["command"];
    let params = json!({ "command": command["command"], "arguments": command["arguments"] });
    client.request("workspace/executeCommand", params.clone());
    let bytes = std::fs::read(client.folder.join("src/pan_tilt/meshes/head.stl")).unwrap();
    assert_eq!((bytes.len(), &bytes[..6]), (84 + 50, b"binary".as_slice()));
    assert!(client.eventually(|client| {
        client.request("xacro/roots", client.of(FILE));
        !client
            .diagnostics(FILE)
            .iter()
            .any(|found| found["code"] == "ascii-stl")
    }));
    // a second time there is nothing to do, and no other file is touched
    let id = client.post("workspace/executeCommand", params);
    assert!(
        client.reply(id)["error"]["message"]
            .as_str()
            .unwrap()
            .contains("needs no change")
    );
    let other =
        json!({ "command": "xacro.rewriteMesh", "arguments": [{ "uri": client.uri(FILE) }] });
    let id = client.post("workspace/executeCommand", other);
    assert!(
        client.reply(id)["error"]["message"]
            .as_str()
            .unwrap()
            .contains("not an STL file")
    );
}

#[test]
fn an_argument_that_no_macro_knows_is_removed() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.edit(ROBOT, "axis=\"0 1 0\">", "axis=\"0 1 0\" 🤖color=\"red\">");
    client.edit(ROBOT, "🤖color", "color");
    let found = fixes(&mut client, ROBOT, "unknown-macro-param");
    let changed = client.after(ROBOT, &titled(&found, "Remove `color`")["edit"]);
    assert!(changed.contains("axis=\"0 1 0\"><origin"), "{changed}");
}

#[test]
fn angles_are_noted_in_degrees_and_taken_from_the_note() {
    let mut client = Client::start();
    show(
        &mut client,
        &robot("<joint name=\"🤖\" type=\"fixed\"><origin rpy=\"0 -1.5708 0\"/></joint>"),
    );
    let changed = after(&mut client, "rpy=\"0 -1.5|708", "Add comment");
    assert!(
        changed.contains("<origin rpy=\"0 -1.5708 0\"/> <!-- rpy in degrees: 0 -90 0 -->"),
        "{changed}"
    );
    show(&mut client, &changed.replace("-90", "45"));
    let changed = after(&mut client, "rpy=\"0 -1.5|708", "from the comment");
    assert!(
        changed.contains("<origin rpy=\"0 0.785398163397448 0\"/> <!-- rpy in degrees: 0 45 0 -->"),
        "{changed}"
    );
}
