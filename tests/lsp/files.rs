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

/// The workspace as `colcon build --symlink-install` leaves it.
#[cfg(unix)]
fn installed_by_links(folder: &std::path::Path) -> (String, String) {
    let share = "install/pan_tilt/share/pan_tilt";
    write(folder, "install/COLCON_IGNORE", "");
    write(
        folder,
        "install/pan_tilt/share/ament_index/resource_index/packages/pan_tilt",
        "",
    );
    std::fs::create_dir_all(folder.join(share).join("urdf")).unwrap();
    std::fs::create_dir_all(folder.join(share).join("config")).unwrap();
    for file in [
        "package.xml",
        "urdf/unit.xacro",
        "urdf/pan_tilt.urdf.xacro",
        "config/cam.yaml",
    ] {
        let link = folder.join(share).join(file);
        std::os::unix::fs::symlink(folder.join("src/pan_tilt").join(file), link).unwrap();
    }
    (
        format!("{share}/urdf/pan_tilt.urdf.xacro"),
        format!("{share}/urdf/unit.xacro"),
    )
}

#[cfg(unix)]
#[test]
fn an_installed_link_is_its_source() {
    let folder = super::workspace::pan_tilt();
    let (robot, unit) = installed_by_links(&folder);
    let mut client = Client::with(folder, super::client::Options::default());
    client.open(&unit);
    assert_eq!(client.diagnostics(&unit), Vec::<Value>::new());
    client.open(&robot);
    client.edit(&robot, "name=\"pan\" parent", "nam=\"pan\" parent");
    let codes = |client: &mut Client, file: &str| -> Vec<String> {
        let found = client.diagnostics(file);
        let codes = found
            .iter()
            .map(|it| it["code"].as_str().unwrap().to_owned());
        codes.collect()
    };
    let found = codes(&mut client, &robot);
    assert!(!found.is_empty());
    client.edit(&robot, "nam=\"pan\" parent", "name=\"pan\" parent");
    assert_eq!(codes(&mut client, &robot), Vec::<String>::new());
    // what an installed file names is found in the sources, unless it is open by another name
    let place = client.at(&robot, "cam|.yaml");
    let target = client.request("textDocument/definition", place);
    assert!(
        target
            .to_string()
            .contains(&client.uri("src/pan_tilt/config/cam.yaml")),
        "{target}"
    );
}

#[cfg(unix)]
#[test]
fn a_file_that_is_open_twice_has_its_findings_once() {
    let folder = super::workspace::pan_tilt();
    let (robot, _) = installed_by_links(&folder);
    let mut client = Client::with(folder, super::client::Options::default());
    let count = |client: &mut Client, file: &str| client.diagnostics(file).len();
    client.open(&robot);
    client.edit(&robot, "parent=\"pan_body\"", "parent=\"nothing\"");
    let findings = count(&mut client, &robot);
    assert!(findings > 0);
    // the source comes in as it is on disk: it counts, and the link keeps the text that was typed in it
    client.open(ROBOT);
    assert!(client.eventually(|client| count(client, &robot) == 0));
    assert_eq!(count(&mut client, ROBOT), 0);
    client.edit(ROBOT, "parent=\"pan_body\"", "parent=\"nothing\"");
    assert_eq!(count(&mut client, ROBOT), findings);
    client.edit(&robot, "parent=\"nothing\"", "parent=\"none\"");
    assert_eq!(count(&mut client, &robot), 0);
    assert_eq!(count(&mut client, ROBOT), findings);
    let closed = client.of(ROBOT);
    client.notify("textDocument/didClose", closed);
    assert!(client.eventually(|client| count(client, &robot) == findings));
}

#[test]
fn a_part_in_an_installed_copy_has_no_false_errors() {
    let folder = super::workspace::pan_tilt();
    let share = "install/pan_tilt/share/pan_tilt";
    write(&folder, "install/COLCON_IGNORE", "");
    for file in [
        "package.xml",
        "urdf/unit.xacro",
        "urdf/pan_tilt.urdf.xacro",
        "config/cam.yaml",
    ] {
        let text = std::fs::read(folder.join("src/pan_tilt").join(file)).unwrap();
        write(&folder, &format!("{share}/{file}"), text);
    }
    let mut client = Client::with(folder, super::client::Options::default());
    let unit = format!("{share}/urdf/unit.xacro");
    // the workspace is searched, which leaves out what is installed
    client.request("workspace/symbol", json!({ "query": "unit" }));
    client.open(&unit);
    assert_eq!(client.diagnostics(&unit), Vec::<Value>::new());
}
