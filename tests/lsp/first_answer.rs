//! What is said first after an edit is the whole truth: what a new server and the command line say of the same texts.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::short;
use super::workspace::{fresh_folder, write};

const ROBOT: &str = "src/cart/urdf/cart.urdf.xacro";
const WHEEL: &str = "src/cart/urdf/wheel.xacro";
const SIZES: &str = "src/cart/config/sizes.yaml";

const ROBOT_TEXT: &str = r#"<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/>
  <xacro:property name="sizes" value="${xacro.load_yaml('../config/sizes.yaml')}"/>
  <xacro:property name="half" value="${sizes['deck']['width'] / 2}"/>
  <link name="deck">
    <visual><geometry><box size="0.4 ${2 * half} 0.1"/></geometry></visual>
  </link>
  <xacro:wheel name="left" side="1"/>
  <xacro:wheel name="right" side="-1"/>
</robot>
"#;
const WHEEL_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="radius" value="0.1"/>
  <xacro:macro name="wheel" params="name side">
    <link name="${name}_wheel">
      <visual><geometry><cylinder radius="${radius}" length="0.04"/></geometry></visual>
    </link>
    <joint name="${name}_axle" type="continuous">
      <parent link="deck"/>
      <child link="${name}_wheel"/>
      <origin xyz="0 ${side * half} 0" rpy="${-pi/2} 0 0"/>
      <axis xyz="0 0 1"/>
    </joint>
  </xacro:macro>
</robot>
"#;
const SIZES_TEXT: &str = "deck:\n  width: 0.5\n";

/// Edits, each on top of those before.
const EDITS: [(&str, &str, &str); 12] = [
    (
        ROBOT,
        "xacro:property name=\"half\"",
        "property name=\"half\"",
    ),
    (WHEEL, "<parent link=\"deck\"/>", "<parent link=\"decks\"/>"),
    (
        ROBOT,
        "<property name=\"half\"",
        "<xacro:property name=\"half\"",
    ),
    (SIZES, "width", "breadth"),
    (WHEEL, "link=\"decks\"", "link=\"deck\""),
    (WHEEL, "name=\"radius\"", "name=\"radiusx\""),
    (SIZES, "breadth", "width"),
    (ROBOT, "<link name=\"deck\">", "<link name=\"deck>"),
    (WHEEL, "name=\"radiusx\"", "name=\"radius\""),
    (ROBOT, "<link name=\"deck>", "<link name=\"deck\">"),
    (ROBOT, "<xacro:wheel name=\"right\" side=\"-1\"/>", ""),
    (WHEEL, "type=\"continuous\"", "type=\"revolute\""),
];

fn workspace(texts: &[(&str, String)]) -> std::path::PathBuf {
    let folder = fresh_folder();
    let manifest = "<package format=\"3\"><name>cart</name><version>0.0.0</version><description>a cart</description>\
                    <maintainer email=\"a@b.c\">a</maintainer><license>MIT</license></package>";
    write(&folder, "src/cart/package.xml", manifest);
    for (file, text) in texts {
        write(&folder, file, text);
    }
    folder
}

fn start(texts: &[(&str, String)], pulls: bool) -> Client {
    let capabilities = if pulls {
        json!({ "textDocument": { "diagnostic": {} } })
    } else {
        Value::Null
    };
    let mut client = Client::with(
        workspace(texts),
        Options {
            capabilities,
            ..Options::default()
        },
    );
    client.open(ROBOT);
    client.open(WHEEL);
    client
}

/// An edit of an open file, or of the YAML file on the disk.
fn edit(client: &mut Client, (file, old, new): (&str, &str, &str)) {
    if client.is_open(file) {
        return client.edit(file, old, new);
    }
    let path = client.folder.join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(old), "`{old}` in {file}");
    std::fs::write(&path, text.replacen(old, new, 1)).unwrap();
    let change = json!({ "uri": client.uri(file), "type": 2 });
    client.notify(
        "workspace/didChangeWatchedFiles",
        json!({ "changes": [change] }),
    );
}

/// What the server says of the open files before it does anything else.
fn first(client: &mut Client, edited: &str, before: &[Value], pulls: bool) -> Vec<Vec<Value>> {
    if pulls {
        let pull = |file| {
            client.request("textDocument/diagnostic", client.of(file))["items"]
                .as_array()
                .unwrap()
                .clone()
        };
        return [ROBOT, WHEEL].map(pull).to_vec();
    }
    if client.is_open(edited) {
        client.diagnostics(edited);
    } else {
        // nothing says for which state of the disk findings are, but that they are others
        assert!(client.eventually(|client| client.diagnostics(ROBOT) != before));
    }
    // everything that was published together with it stands in front of this answer
    client.request("textDocument/documentSymbol", client.of(ROBOT));
    [ROBOT, WHEEL].map(|file| client.diagnostics(file)).to_vec()
}

/// Errors and warnings of a file, by line and rule, without the notes at calls.
fn shown(found: &[Value]) -> BTreeSet<String> {
    let is_note = |item: &Value| {
        item["message"]
            .as_str()
            .unwrap()
            .starts_with("this call causes: ")
    };
    let heavy = found
        .iter()
        .filter(|item| item["severity"].as_i64() <= Some(2) && !is_note(item));
    heavy
        .map(short)
        .map(|line| {
            line.split('-').next().unwrap().to_owned() + " " + line.rsplit(' ').next().unwrap()
        })
        .collect()
}

/// The same as the command line says it.
fn checked(folder: &Path, file: &str) -> BTreeSet<String> {
    let program = Command::new(env!("CARGO_BIN_EXE_xacro-lint"))
        .args([
            "check",
            "--format",
            "json",
            "--show",
            "all",
            "--no-group",
            "--exit-zero",
            ".",
        ])
        .current_dir(folder)
        .env_remove("ROS_PACKAGE_PATH")
        .env("AMENT_PREFIX_PATH", folder.join("none"))
        .output()
        .unwrap();
    let report: Value = serde_json::from_slice(&program.stdout).unwrap();
    let own = report
        .as_array()
        .unwrap()
        .iter()
        .filter(|finding| finding["filename"] == file);
    let heavy =
        own.filter(|finding| ["error", "warning"].contains(&finding["severity"].as_str().unwrap()));
    let place = |finding: &Value| {
        let at = &finding["location"];
        format!(
            "{}:{} {}",
            at["row"],
            at["column"].as_i64().unwrap() - 1,
            finding["name"].as_str().unwrap()
        )
    };
    heavy.map(place).collect()
}

fn check_first_answers(pulls: bool) {
    let mut texts = vec![
        (ROBOT, ROBOT_TEXT.to_owned()),
        (WHEEL, WHEEL_TEXT.to_owned()),
        (SIZES, SIZES_TEXT.to_owned()),
    ];
    let mut client = start(&texts, pulls);
    // the one that was opened last: what is said of the other one depends on what is open
    let mut said = first(&mut client, WHEEL, &[], pulls);
    for (file, old, new) in EDITS {
        edit(&mut client, (file, old, new));
        said = first(&mut client, file, &said[0], pulls);
        let text = &mut texts.iter_mut().find(|(name, _)| *name == file).unwrap().1;
        *text = text.replacen(old, new, 1);
        let what = format!("{old} -> {new} in {file}");
        let mut other = start(&texts, pulls);
        let fresh = first(&mut other, WHEEL, &[], pulls);
        for ((said, fresh), file) in said.iter().zip(&fresh).zip([ROBOT, WHEEL]) {
            let plain = |found: &[Value], folder: &Path| -> Vec<String> {
                found
                    .iter()
                    .map(|item| item.to_string().replace(&folder.display().to_string(), ""))
                    .collect()
            };
            assert_eq!(
                plain(said, &client.folder),
                plain(fresh, &other.folder),
                "{what}: {file}"
            );
            assert_eq!(
                shown(said),
                checked(&other.folder, file),
                "{what}: {file}, on the command line"
            );
        }
    }
}

#[test]
fn what_is_pushed_first_is_the_whole_truth() {
    check_first_answers(false);
}

#[test]
fn what_is_pulled_first_is_the_whole_truth() {
    check_first_answers(true);
}
