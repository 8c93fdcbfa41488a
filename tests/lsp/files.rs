//! F29: files that are made, renamed and deleted in the editor.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::client::{Client, uri};
use super::workspace::{ROBOT, UNIT, write};

const MESH: &str = "src/pan_tilt/meshes/head.stl";
const LENS: &str = "src/lens/urdf/lens.xacro";

fn with_mesh() -> Client {
    let mut client = Client::start();
    write(&client.folder, MESH, "solid head\nendsolid head\n");
    client.open(ROBOT);
    client.open(UNIT);
    let visual = "<!-- 🤖 --><link name=\"$(arg mount)\"><visual><geometry>\
        <mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry></visual></link>";
    client.edit(ROBOT, "<link name=\"$(arg mount)\"/>", visual);
    client
}

/// The open files that change when a file or folder gets another path.
fn renamed(client: &mut Client, old: &str, new: &str) -> BTreeMap<String, String> {
    let files = json!([{ "oldUri": client.uri(old), "newUri": client.uri(new) }]);
    let edit = client.request("workspace/willRenameFiles", json!({ "files": files }));
    let mut changed = BTreeMap::new();
    for (file, _) in edit["changes"].as_object().into_iter().flatten() {
        let name = [ROBOT, UNIT, LENS]
            .into_iter()
            .find(|name| uri(&client.folder.join(name)) == *file);
        let name = name.unwrap();
        let text = client.after(name, &edit);
        changed.insert(name.to_owned(), text);
    }
    changed
}

#[test]
fn a_mesh_keeps_its_users() {
    let mut client = with_mesh();
    let changed = renamed(&mut client, MESH, "src/pan_tilt/meshes/lens.stl");
    assert_eq!(changed.len(), 1);
    assert!(
        changed[ROBOT].contains("\"package://pan_tilt/meshes/lens.stl\""),
        "{}",
        changed[ROBOT]
    );
    let changed = renamed(&mut client, MESH, "src/lens/meshes/head.stl");
    assert!(
        changed[ROBOT].contains("\"package://lens/meshes/head.stl\""),
        "{}",
        changed[ROBOT]
    );
}

#[test]
fn includes_and_yaml_keep_their_users() {
    let mut client = with_mesh();
    let changed = renamed(&mut client, UNIT, "src/pan_tilt/parts/motor.xacro");
    assert!(
        changed[ROBOT].contains("filename=\"../parts/motor.xacro\""),
        "{}",
        changed[ROBOT]
    );
    let changed = renamed(
        &mut client,
        "src/pan_tilt/config/cam.yaml",
        "src/pan_tilt/config/eye.yaml",
    );
    assert!(
        changed[ROBOT].contains("load_yaml('$(find pan_tilt)/config/eye.yaml')"),
        "{}",
        changed[ROBOT]
    );
    // the file that moves finds its own includes again
    let changed = renamed(&mut client, ROBOT, "src/pan_tilt/pan_tilt.urdf.xacro");
    assert!(
        changed[ROBOT].contains("filename=\"urdf/unit.xacro\""),
        "{}",
        changed[ROBOT]
    );
    assert!(
        changed[ROBOT].contains("package://pan_tilt/meshes/head.stl"),
        "{}",
        changed[ROBOT]
    );
}

#[test]
fn folders_take_their_files_along() {
    let mut client = with_mesh();
    let changed = renamed(&mut client, "src/pan_tilt/meshes", "src/pan_tilt/models");
    assert!(
        changed[ROBOT].contains("\"package://pan_tilt/models/head.stl\""),
        "{}",
        changed[ROBOT]
    );
    // what moves together is found as before
    assert!(renamed(&mut client, "src/pan_tilt/urdf", "src/pan_tilt/description").is_empty());
    assert!(renamed(&mut client, "src/pan_tilt", "src/pan_tilt_description").is_empty());
}

#[test]
fn unsaved_and_broken_texts_are_changed_too() {
    let mut client = with_mesh();
    client.edit(
        UNIT,
        "<link name=\"${name}_body\">",
        "<link name=\"${name}_body\"><visual><geometry>\
        <mesh filename=\"package://pan_tilt/meshes/head.stl\"/></geometry></visual>",
    );
    client.edit(ROBOT, "</robot>", "<link name=\"");
    let changed = renamed(&mut client, MESH, "src/pan_tilt/meshes/🤖.stl");
    assert_eq!(changed.len(), 2);
    assert!(
        changed
            .values()
            .all(|text| text.contains("\"package://pan_tilt/meshes/🤖.stl\"")),
        "{changed:?}"
    );
}

#[test]
fn files_that_come_and_go_are_noticed() {
    let mut client = with_mesh();
    let missing = |client: &mut Client| -> usize {
        // what was sent meanwhile is read with the answer
        let _: Value = client.request("xacro/roots", client.of(ROBOT));
        client
            .diagnostics(ROBOT)
            .iter()
            .filter(|found| found["code"] == "include-not-found")
            .count()
    };
    client.edit(ROBOT, "filename=\"unit.xacro\"", "filename=\"more.xacro\"");
    assert_eq!(missing(&mut client), 1);
    write(
        &client.folder,
        "src/pan_tilt/urdf/more.xacro",
        super::workspace::UNIT_TEXT,
    );
    let files = json!({ "files": [{ "uri": client.uri("src/pan_tilt/urdf/more.xacro") }] });
    client.notify("workspace/didCreateFiles", files.clone());
    assert!(client.eventually(|client| missing(client) == 0));
    std::fs::remove_file(client.folder.join("src/pan_tilt/urdf/more.xacro")).unwrap();
    client.notify("workspace/didDeleteFiles", files);
    assert!(client.eventually(|client| missing(client) == 1));
}

#[test]
fn who_opens_an_installed_copy_is_offered_the_source() {
    const COPY: &str = "install/pan_tilt/share/pan_tilt/urdf/unit.xacro";
    for shows in [true, false] {
        let folder = super::workspace::pan_tilt();
        write(&folder, COPY, super::workspace::UNIT_TEXT);
        write(
            &folder,
            "install/pan_tilt/share/ament_index/resource_index/packages/pan_tilt",
            "",
        );
        let manifest = std::fs::read(folder.join("src/pan_tilt/package.xml")).unwrap();
        write(
            &folder,
            "install/pan_tilt/share/pan_tilt/package.xml",
            manifest,
        );
        let capabilities = json!({ "window": { "showDocument": { "support": shows } } });
        let mut client = super::client::Client::with(
            folder,
            super::client::Options {
                capabilities,
                ..Default::default()
            },
        );
        client.open(UNIT);
        client.open(COPY);
        let method = if shows {
            "window/showMessageRequest"
        } else {
            "window/showMessage"
        };
        let told = |client: &mut Client| {
            let said = client.asked.iter().chain(&client.notes);
            let mut said = said.filter(|said| said["method"] == method);
            said.next().map(|said| said["params"].clone())
        };
        let said = client.wait(told, || "nothing said of the copy".to_owned());
        let message = said["message"].as_str().unwrap();
        assert!(
            message.starts_with("`unit.xacro` is an installed copy"),
            "{message}"
        );
        assert!(
            message.ends_with("src/pan_tilt/urdf/unit.xacro`"),
            "{message}"
        );
        let actions = if shows {
            json!([{ "title": "Open Source" }])
        } else {
            Value::Null
        };
        assert_eq!(said["actions"], actions);
    }
}
