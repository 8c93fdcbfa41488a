//! F25: edits that are made when an action is picked, and what cannot be made.

use serde_json::{Value, json};

use super::actions::{FILE, actions, robot, show, titled};
use super::client::{Client, Options};
use super::quick_fixes::cube;
use super::workspace::{ROBOT, UNIT, pan_tilt, write};

/// What a client says that asks for the edits of an action when the action is picked.
fn resolving() -> Value {
    json!({ "textDocument": { "codeAction": {
        "dataSupport": true, "resolveSupport": { "properties": ["edit"] } } } })
}

/// A client that asks for the edits of an action when the action is picked, and shows what cannot be made.
fn picking() -> Client {
    let mut capabilities = resolving();
    capabilities["textDocument"]["codeAction"]["disabledSupport"] = json!(true);
    Client::with(
        pan_tilt(),
        Options {
            capabilities,
            ..Options::default()
        },
    )
}

fn expanded(client: &mut Client, file: &str) -> String {
    let answer = client.request("xacro/expand", client.of(file));
    assert_eq!(answer["errors"], json!([]), "{answer}");
    let text = answer["urdf"].as_str().unwrap().to_owned();
    let lines = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("<!--"));
    lines.map(str::trim).collect::<Vec<_>>().join("\n")
}

#[test]
fn edits_are_made_when_an_action_is_picked() {
    let mut client = picking();
    show(
        &mut client,
        &robot("<!-- 🤖 --><link name=\"a\"/>\n<link name=\"l\"/>"),
    );
    let found = actions(
        &mut client,
        FILE,
        "«<link name=\"l\"/>»",
        &[],
        &["refactor"],
    );
    let action = titled(&found, "Wrap in `xacro:if`").clone();
    assert!(
        action["edit"].is_null() && !action["data"].is_null(),
        "{action}"
    );
    let resolved = client.request("codeAction/resolve", action.clone());
    let made = client.after(FILE, &resolved["edit"]);
    assert!(made.contains("<xacro:if value=\"true\">"), "{made}");
    // the text is another one: the client is to ask again
    client.edit(FILE, "name=\"l\"", "name=\"ll\"");
    let id = client.post("codeAction/resolve", action.clone());
    assert_eq!(client.reply(id)["error"]["code"], -32801);
    // what a client makes up leads nowhere
    let mut forged = action;
    forged["data"] =
        json!({ "uri": "file:///etc/passwd", "range": forged["data"]["range"], "version": null });
    let id = client.post("codeAction/resolve", forged);
    assert!(client.reply(id).get("error").is_some());
    // who does not ask gets the edits at once
    let mut plain = Client::start();
    show(&mut plain, &robot("<link name=\"l\"/>"));
    let found = actions(&mut plain, FILE, "«<link name=\"l\"/>»", &[], &["refactor"]);
    assert!(!titled(&found, "Wrap in `xacro:if`")["edit"].is_null());
    // quick fixes bring theirs along
    client.edit(FILE, "name=\"ll\"", "name=\"${m_0}\"");
    let fixes = super::actions::fixes(&mut client, FILE, "undefined-property");
    assert!(!titled(&fixes, "Add property `m_0`")["edit"].is_null());
}

/// A macro with comments, a number, an argument of the command line and a block.
const ARM: &str = "  <xacro:arg name=\"side\" default=\"left\"/>
  <xacro:property name=\"size\" value=\"2\"/>
  <xacro:macro name=\"arm\" params=\"name mass:=1.5 *at\">
    <!-- the upper part 🤖 -->
    <link name=\"${name}_$(arg side)\">
      <inertial><mass value=\"${mass * size}\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>
      <visual><xacro:insert_block name=\"at\"/><geometry><sphere radius=\"${mass}\"/></geometry></visual>
    </link>
  </xacro:macro>
  <xacro:arm name=\"a\" mass=\"-3\"><origin xyz=\"0 0 ${size}\"/></xacro:arm>
  <xacro:arm name=\"b\"><origin xyz=\"0 0 1\"/></xacro:arm>";

#[test]
fn a_macro_is_expanded_as_it_is_written() {
    for (mut client, lazy) in [(Client::start(), false), (picking(), true)] {
        show(&mut client, &robot(ARM));
        let before = expanded(&mut client, FILE);
        for (call, parts) in [
            (
                "<xacro:ar|m name=\"a\"",
                [
                    "<!-- the upper part 🤖 -->",
                    "\"a_$(arg side)\"",
                    "${(-3) * size}",
                    "xyz=\"0 0 ${size}\"",
                    "radius=\"-3\"",
                ],
            ),
            (
                "<xacro:ar|m name=\"b\"",
                [
                    "<!-- the upper part 🤖 -->",
                    "\"b_$(arg side)\"",
                    "${1.5 * size}",
                    "xyz=\"0 0 1\"",
                    "radius=\"1.5\"",
                ],
            ),
        ] {
            let found = actions(&mut client, FILE, call, &[], &["refactor.inline"]);
            let mut action = titled(&found, "Expand macro call `arm`").clone();
            assert_eq!(action["title"], "Expand macro call `arm`");
            if lazy {
                action = client.request("codeAction/resolve", action);
            }
            let changed = client.after(FILE, &action["edit"]);
            assert!(parts.iter().all(|part| changed.contains(part)), "{changed}");
            show(&mut client, &changed);
            assert_eq!(expanded(&mut client, FILE), before);
        }
        assert!(
            !client.text(FILE).contains("<xacro:arm "),
            "{}",
            client.text(FILE)
        );
    }
}

#[test]
fn a_macro_is_expanded_fully_when_that_is_asked_for() {
    let mut client = Client::start();
    show(&mut client, &robot(ARM));
    let found = actions(
        &mut client,
        FILE,
        "<xacro:ar|m name=\"a\"",
        &[],
        &["refactor.inline"],
    );
    let changed = client.after(FILE, &titled(&found, "with evaluated values")["edit"]);
    assert!(changed.contains("<link name=\"a_left\">"), "{changed}");
    assert!(
        changed.contains("<mass value=\"-6.0\"/>") || changed.contains("<mass value=\"-6\"/>"),
        "{changed}"
    );
}

#[test]
fn a_macro_whose_text_means_something_else_outside_is_not_expanded() {
    let offered = |client: &mut Client, text: &str, call: &str| {
        show(client, &robot(text));
        let found = actions(client, FILE, call, &[], &["refactor.inline"]);
        found
            .iter()
            .any(|action| action["title"] == "Expand macro call `m`")
    };
    let mut client = Client::start();
    let with = |params: &str, body: &str, call: &str| {
        format!(
            "<xacro:macro name=\"m\" params=\"{params}\"><link name=\"🤖{body}\"/></xacro:macro>{call}"
        )
    };
    assert!(offered(
        &mut client,
        &with("a", "${a}", "<xacro:m a=\"x\"/>"),
        "<xacro:|m a"
    ));
    // the call's value is no term of an expression
    assert!(!offered(
        &mut client,
        &with(
            "a",
            "${a * 2}",
            "<xacro:m a=\"$(arg x)\"/><xacro:arg name=\"x\" default=\"1\"/>"
        ),
        "<xacro:|m a"
    ));
    // `b` of the caller is another one than that of the macro
    let nested = "<xacro:property name=\"b\" value=\"1\"/><xacro:macro name=\"m\" params=\"a\"><xacro:property name=\"b\" value=\"2\"/>\
                  <link name=\"🤖${a}${b}\"/></xacro:macro><xacro:m a=\"x\"/><link name=\"${b}\"/>";
    assert!(!offered(&mut client, nested, "<xacro:|m a"));
    // a broken file is left alone
    let broken = with("a", "${a}", "<xacro:m a=\"x\"/><link>");
    assert!(!offered(&mut client, &broken, "<xacro:|m a"));
    // a client that asks for edits later is not offered what it could not have then, but may be told why
    let mut client = picking();
    show(&mut client, &robot(nested));
    let found = actions(&mut client, FILE, "<xacro:|m a", &[], &["refactor.inline"]);
    let refused = titled(&found, "Expand macro call `m`");
    assert!(
        refused["disabled"]["reason"]
            .as_str()
            .unwrap()
            .contains("would change the robot"),
        "{refused}"
    );
    assert!(
        refused["edit"].is_null() && refused["data"].is_null(),
        "{refused}"
    );
    let mut silent = Client::with(
        pan_tilt(),
        Options {
            capabilities: resolving(),
            ..Options::default()
        },
    );
    assert!(!offered(&mut silent, nested, "<xacro:|m a"));
}

#[test]
fn an_unsaved_macro_of_another_file_is_expanded() {
    let mut client = Client::start();
    client.open(ROBOT);
    client.open(UNIT);
    client.edit(UNIT, "<!-- A motor", "<!-- 🤖 A motor");
    client.edit(UNIT, "effort=\"3\"", "effort=\"4\"");
    let found = actions(
        &mut client,
        ROBOT,
        "<xacro:un|it name=\"tilt\"",
        &[],
        &["refactor.inline"],
    );
    let changed = client.after(ROBOT, &titled(&found, "Expand macro call `unit`")["edit"]);
    for part in [
        "<link name=\"tilt_body\">",
        "${m0 * 2}",
        "effort=\"4\"",
        "xyz=\"0 0 ${m0 / 3}\"",
        "<axis xyz=\"0 1 0\"/>",
    ] {
        assert!(changed.contains(part), "{part}: {changed}");
    }
}

#[test]
fn a_link_is_split_into_two() {
    let mut client = Client::start();
    let link = "  <link name=\"🤖\">
    <visual>
      <geometry><sphere radius=\"1\"/></geometry>
    </visual>
    <collision>
      <origin xyz=\"0 0 1\"/>
      <geometry><sphere radius=\"2\"/></geometry>
    </collision>
  </link>";
    show(&mut client, &robot(link));
    let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor.rewrite"]);
    let made = client.after(FILE, &titled(&found, "Split link `🤖`")["edit"]);
    let expected = "    </visual>
  </link>
  <link name=\"🤖_collision\">
    <collision>
      <origin xyz=\"0 0 1\"/>
      <geometry><sphere radius=\"2\"/></geometry>
    </collision>
  </link>
  <joint name=\"🤖_collision_joint\" type=\"fixed\">
    <parent link=\"🤖\"/>
    <child link=\"🤖_collision\"/>
  </joint>
</robot>";
    assert!(made.contains(expected), "{made}");
    // what a macro brings along cannot be moved, and what is there is not made again
    for text in [
        link.replace("<visual>", "<xacro:more/><visual>"),
        format!("{link}<link name=\"🤖_collision\"/>"),
        link.replace("</collision>", ""),
    ] {
        show(&mut client, &robot(&text));
        let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor.rewrite"]);
        assert!(
            !found
                .iter()
                .any(|action| action["title"].as_str().unwrap().contains("Split")),
            "{found:?}"
        );
    }
}

const MESH: &str = "src/pan_tilt/meshes/cube.stl";

fn with_mesh(inertial: &str) -> String {
    robot(&format!(
        "  <link name=\"🤖\">\n    {inertial}\n    <collision>\n      <origin xyz=\"1 0 0\"/>\n      <geometry>\n        \
         <mesh filename=\"package://pan_tilt/meshes/cube.stl\" scale=\"1 1 2\"/>\n      </geometry>\n    </collision>\n  </link>"
    ))
}

#[test]
fn inertia_follows_from_a_closed_mesh() {
    let mut client = Client::start();
    write(&client.folder, MESH, cube(1.0));
    show(
        &mut client,
        &with_mesh("<inertial>\n      <mass value=\"12\"/>\n    </inertial>"),
    );
    let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor.rewrite"]);
    let action = titled(
        &found,
        "Compute inertia from mesh `cube.stl` (2 m³, 6 kg/m³)",
    );
    let made = client.after(FILE, &action["edit"]);
    assert!(
        made.contains("<origin xyz=\"1.5 0.5 1\" rpy=\"0 0 0\"/>\n      <mass value=\"12\"/>"),
        "{made}"
    );
    // 1 m, 1 m and 2 m
    let inertia = "<inertia ixx=\"5\" ixy=\"0\" ixz=\"0\" iyy=\"5\" iyz=\"0\" izz=\"2\"/>";
    assert!(made.contains(inertia), "{made}");
    // without a mass it is that of a substance
    show(&mut client, &with_mesh(""));
    let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor.rewrite"]);
    let made = client.after(FILE, &titled(&found, "steel (7850 kg/m³)")["edit"]);
    assert!(made.contains("\n      <mass value=\"15700\"/>\n"), "{made}");
    show(&mut client, &made);
    let left = client.findings(FILE);
    assert!(
        !left
            .iter()
            .any(|found| found.contains("inertia") && !found.ends_with("root-link-inertia")),
        "{left:?}"
    );
}

#[test]
fn an_open_mesh_has_no_inertia_and_says_why() {
    let mut client = picking();
    let mut open = cube(1.0);
    open.truncate(84 + 11 * 50);
    open[80] = 11;
    write(&client.folder, MESH, open);
    show(
        &mut client,
        &with_mesh("<inertial><mass value=\"12\"/></inertial>"),
    );
    let found = actions(&mut client, FILE, "<li|nk", &[], &["refactor.rewrite"]);
    let refused = titled(&found, "Compute inertia from mesh `cube.stl`");
    let reason = refused["disabled"]["reason"].as_str().unwrap();
    assert_eq!(reason, "mesh `cube.stl` is not closed: it has 3 open edges");
    assert_eq!(refused["edit"], Value::Null);
    // clients that cannot show it are not offered it
    let mut plain = Client::start();
    write(&plain.folder, MESH, &cube(1.0)[..84]);
    show(
        &mut plain,
        &with_mesh("<inertial><mass value=\"12\"/></inertial>"),
    );
    let found = actions(&mut plain, FILE, "<li|nk", &[], &["refactor.rewrite"]);
    assert!(
        !found
            .iter()
            .any(|action| action["title"].as_str().unwrap().contains("mesh")),
        "{found:?}"
    );
}
