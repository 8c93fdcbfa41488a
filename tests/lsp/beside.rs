//! Files beside a robot: findings, definitions, references and renames in the arm of the examples.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::client::{Client, Options, offset, replace_all};
use super::workspace::{fresh_folder, write};

const ROBOT: &str = "src/pick_arm_description/urdf/pick_arm.urdf.xacro";
const ARM: &str = "src/pick_arm_description/urdf/arm_macro.xacro";
const GRIPPER: &str = "src/pick_arm_description/urdf/gripper_macro.xacro";
const SRDF: &str = "src/pick_arm_moveit_config/config/pick_arm.srdf";
const CONTROLLERS: &str = "src/pick_arm_bringup/config/controllers.yaml";
const LIMITS: &str = "src/pick_arm_moveit_config/config/joint_limits.yaml";

fn copy(from: &Path, to: &Path) {
    for entry in std::fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy(&entry.path(), &target),
            false => write(to, entry.file_name().to_str().unwrap(), std::fs::read(entry.path()).unwrap()),
        }
    }
}

fn folder() -> PathBuf {
    let folder = fresh_folder();
    copy(&Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples/pick_arm"), &folder);
    folder
}

fn started(files: &[&str]) -> (Client, PathBuf) {
    let folder = folder();
    let mut client = Client::with(folder.clone(), Options::default());
    files.iter().for_each(|file| client.open(file));
    (client, folder)
}

/// The places of an answer: file names with the texts of their lines.
fn places(folder: &Path, answer: &Value) -> Vec<String> {
    let list = answer.as_array().cloned().unwrap_or_default();
    let place = |place: &Value| {
        let uri = place.get("targetUri").or_else(|| place.get("uri")).unwrap().as_str().unwrap();
        let range = place.get("targetSelectionRange").or_else(|| place.get("range")).unwrap();
        let path = lsp_path(uri);
        let text = std::fs::read_to_string(&path).unwrap();
        let part = &text[offset(&text, &range["start"])..offset(&text, &range["end"])];
        let path = path.strip_prefix(folder).unwrap().file_name().unwrap().to_string_lossy().into_owned();
        format!("{path} {part}")
    };
    list.iter().map(place).collect()
}

fn lsp_path(uri: &str) -> PathBuf {
    PathBuf::from(uri.strip_prefix("file://").unwrap())
}

/// Make the edits of a rename on the disk; how many there are in each file, or the message of the error.
fn renamed(
    client: &mut Client,
    folder: &Path,
    (file, at): (&str, &str),
    new: &str,
) -> Result<BTreeMap<String, usize>, String> {
    let mut counts = BTreeMap::new();
    for (uri, edits) in client.changes_of_rename(file, at, new)? {
        let path = lsp_path(&uri);
        let mut text = std::fs::read_to_string(&path).unwrap();
        let count = replace_all(&mut text, &edits, new);
        std::fs::write(&path, text).unwrap();
        let name = path.strip_prefix(folder).unwrap().file_name().unwrap().to_string_lossy().into_owned();
        counts.insert(name, count);
    }
    Ok(counts)
}

/// What the command line says of the folder.
fn check(folder: &Path) -> String {
    let command = std::process::Command::new(env!("CARGO_BIN_EXE_xacro-lint"))
        .args(["check", "--output-format", "concise"])
        .current_dir(folder)
        .output()
        .unwrap();
    String::from_utf8(command.stdout).unwrap()
}

#[test]
fn a_joint_of_a_macro_is_renamed_in_all_files() {
    for (file, at) in
        [(ARM, "name=\"${prefix}wr|ist\""), (SRDF, "name=\"left_wr|ist\""), (LIMITS, "left_wr|ist")]
    {
        let (mut client, folder) = started(&[file]);
        let counts = renamed(&mut client, &folder, (file, at), "roll").unwrap();
        let expected = [
            ("arm_macro.xacro", 1),
            ("control_macro.xacro", 1),
            ("controllers.yaml", 1),
            ("joint_limits.yaml", 1),
            ("moveit_controllers.yaml", 1),
            ("pick_arm.srdf", 1),
        ];
        assert_eq!(counts, expected.map(|(name, count)| (name.to_owned(), count)).into(), "{file}");
        assert_eq!(check(&folder), "", "{file}");
    }
}

#[test]
fn a_link_of_a_macro_is_renamed_in_all_files() {
    let (mut client, folder) = started(&[GRIPPER]);
    let counts = renamed(&mut client, &folder, (GRIPPER, "link name=\"${prefix}to|ol\""), "grip").unwrap();
    assert!(counts["pick_arm.srdf"] == 2, "{counts:?}");
    assert_eq!(check(&folder), "");
}

#[test]
fn a_group_is_renamed_in_all_files() {
    let (mut client, folder) = started(&[SRDF]);
    let counts = renamed(&mut client, &folder, (SRDF, "group name=\"grip|per\""), "hand").unwrap();
    let expected = [("ompl_planning.yaml", 1), ("pick_arm.srdf", 4)];
    assert_eq!(counts, expected.map(|(name, count)| (name.to_owned(), count)).into());
    assert_eq!(check(&folder), "");
}

#[test]
fn names_lead_to_the_robot_and_back() {
    let (mut client, folder) = started(&[SRDF, CONTROLLERS, ARM]);
    for (file, at, expected) in [
        (SRDF, "tip_link=\"left_|tool\"", "gripper_macro.xacro ${prefix}tool"),
        (CONTROLLERS, "- left_|elbow", "arm_macro.xacro ${name}"),
        (SRDF, "group=\"ar|m\"", "pick_arm.srdf arm"),
    ] {
        let at = client.at(file, at);
        let answer = client.request("textDocument/definition", at);
        let found = places(&folder, &answer);
        assert!(found.iter().any(|place| place == expected), "{found:?}");
    }
    let mut params = client.at(ARM, "name=\"${prefix}el|bow\"");
    params["context"] = json!({ "includeDeclaration": false });
    let answer = client.request("textDocument/references", params);
    let found = places(&folder, &answer);
    for expected in
        ["pick_arm.srdf left_elbow", "controllers.yaml left_elbow", "joint_limits.yaml left_elbow"]
    {
        assert!(found.iter().any(|place| place == expected), "{found:?}");
    }
}

#[test]
fn findings_follow_edits_of_the_robot_and_of_the_file() {
    let (mut client, _) = started(&[SRDF, ROBOT]);
    assert!(client.findings(SRDF).is_empty());
    client.edit(SRDF, "tip_link=\"left_tool\"", "tip_link=\"left_tol\"");
    assert_eq!(client.findings(SRDF), ["4:43-51 srdf-unknown-link"]);
    client.edit(SRDF, "tip_link=\"left_tol\"", "tip_link=\"left_tool\"");
    assert!(client.findings(SRDF).is_empty());
    client.edit(ROBOT, "parent=\"left_hand\">\n    <origin", "parent=\"left_hand\"><!-- -->\n    <origin");
    client.edit(ROBOT, "<xacro:gripper prefix=\"left_\"", "<xacro:gripper prefix=\"right_\"");
    let lacks =
        |client: &mut Client| client.findings(SRDF).iter().any(|one| one.ends_with("srdf-unknown-link"));
    assert!(client.eventually(lacks));
}

#[test]
fn a_joint_with_another_name_is_one_finding_at_each_place() {
    let folder = folder();
    let arm = std::fs::read_to_string(folder.join(ARM)).unwrap();
    write(&folder, ARM, arm.replace("wrist", "wrst"));
    let found = check(&folder);
    let count = |rule: &str| found.matches(&format!("[{rule}]")).count();
    assert_eq!(count("srdf-unknown-joint"), 1, "{found}");
    assert_eq!(count("joint-limits-unknown-joint"), 1, "{found}");
    // the state has a value, for the old name
    assert_eq!(count("srdf-incomplete-group-state"), 0, "{found}");
    // the controller names what `<ros2_control>` has as well, where it is reported
    assert_eq!((count("ros2-control-unknown-joint"), count("controller-unknown-joint")), (1, 0), "{found}");
}
