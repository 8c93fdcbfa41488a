//! Files beside a robot: findings, definitions, references and renames in the arm of the examples.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::client::{Client, Options};
use super::positions::{offset, replace_all};
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
            false => write(
                to,
                entry.file_name().to_str().unwrap(),
                std::fs::read(entry.path()).unwrap(),
            ),
        }
    }
}

fn folder() -> PathBuf {
    let folder = fresh_folder();
    copy(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples/pick_arm"),
        &folder,
    );
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
        let uri = place
            .get("targetUri")
            .or_else(|| place.get("uri"))
            .unwrap()
            .as_str()
            .unwrap();
        let range = place
            .get("targetSelectionRange")
            .or_else(|| place.get("range"))
            .unwrap();
        let path = lsp_path(uri);
        let text = std::fs::read_to_string(&path).unwrap();
        let part = &text[offset(&text, &range["start"])..offset(&text, &range["end"])];
        let path = path
            .strip_prefix(folder)
            .unwrap()
            .file_name()
            .unwrap()
            .to_string_lossy()
            .into_owned();
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
        let name = path
            .strip_prefix(folder)
            .unwrap()
            .file_name()
            .unwrap()
            .to_string_lossy()
            .into_owned();
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
fn an_argument_in_a_name_of_srdf_is_one_of_its_file() {
    let folder = folder();
    let (text, file) = (
        std::fs::read_to_string(folder.join(SRDF)).unwrap(),
        format!("{SRDF}.xacro"),
    );
    std::fs::remove_file(folder.join(SRDF)).unwrap();
    let root = text.find("<robot").unwrap();
    let inside = root + text[root..].find('>').unwrap() + 1;
    let (name, end) = (
        "end_effector name=\"",
        text.find("parent_link=\"").unwrap() + "parent_link=\"".len(),
    );
    let link = &text[end..end + text[end..].find('"').unwrap()];
    let (first, rest) = link.split_at(3);
    assert!(text.contains(name));
    let arg = format!("<xacro:arg name=\"lead\" default=\"{first}\"/>");
    let tag = text[root..inside].replace(
        "<robot",
        "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\"",
    );
    let text = format!(
        "{}{tag}{arg}{}$(arg lead){rest}{}",
        &text[..root],
        &text[inside..end],
        &text[end + link.len()..]
    );
    write(&folder, &file, text);
    let paired = "src/pick_arm_moveit_config/.setup_assistant";
    let names = std::fs::read_to_string(folder.join(paired)).unwrap();
    write(
        &folder,
        paired,
        names.replace("pick_arm.srdf", "pick_arm.srdf.xacro"),
    );
    let mut client = Client::with(folder.clone(), Options::default());
    client.open(&file);
    let found = client.request("textDocument/definition", client.at(&file, ")t_to|ol"));
    assert!(!places(&folder, &found).is_empty());
    let found = client.request("textDocument/definition", client.at(&file, "$(arg le|ad)"));
    assert_eq!(places(&folder, &found), ["pick_arm.srdf.xacro lead"]);
    let counts = renamed(&mut client, &folder, (&file, "$(arg le|ad)"), "start").unwrap();
    assert_eq!(
        counts,
        BTreeMap::from([("pick_arm.srdf.xacro".to_owned(), 2)])
    );
}

#[test]
fn a_joint_of_a_macro_is_renamed_in_all_files() {
    for (file, at) in [
        (ARM, "name=\"${prefix}wr|ist\""),
        (SRDF, "name=\"left_wr|ist\""),
        (LIMITS, "left_wr|ist"),
    ] {
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
        assert_eq!(
            counts,
            expected
                .map(|(name, count)| (name.to_owned(), count))
                .into(),
            "{file}"
        );
        assert_eq!(check(&folder), "", "{file}");
    }
}

#[test]
fn a_link_of_a_macro_is_renamed_in_all_files() {
    let (mut client, folder) = started(&[GRIPPER]);
    let counts = renamed(
        &mut client,
        &folder,
        (GRIPPER, "link name=\"${prefix}to|ol\""),
        "grip",
    )
    .unwrap();
    assert!(counts["pick_arm.srdf"] == 2, "{counts:?}");
    assert_eq!(check(&folder), "");
}

#[test]
fn a_group_is_renamed_in_all_files() {
    let (mut client, folder) = started(&[SRDF]);
    let counts = renamed(
        &mut client,
        &folder,
        (SRDF, "group name=\"grip|per\""),
        "hand",
    )
    .unwrap();
    let expected = [("ompl_planning.yaml", 1), ("pick_arm.srdf", 4)];
    assert_eq!(
        counts,
        expected
            .map(|(name, count)| (name.to_owned(), count))
            .into()
    );
    assert_eq!(check(&folder), "");
}

#[test]
fn names_lead_to_the_robot_and_back() {
    let (mut client, folder) = started(&[SRDF, CONTROLLERS, ARM]);
    for (file, at, expected) in [
        (
            SRDF,
            "tip_link=\"left_|tool\"",
            "gripper_macro.xacro ${prefix}tool",
        ),
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
    for expected in [
        "pick_arm.srdf left_elbow",
        "controllers.yaml left_elbow",
        "joint_limits.yaml left_elbow",
    ] {
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
    client.edit(
        ROBOT,
        "parent=\"left_hand\">\n    <origin",
        "parent=\"left_hand\"><!-- -->\n    <origin",
    );
    client.edit(
        ROBOT,
        "<xacro:gripper prefix=\"left_\"",
        "<xacro:gripper prefix=\"right_\"",
    );
    let lacks = |client: &mut Client| {
        client
            .findings(SRDF)
            .iter()
            .any(|one| one.ends_with("srdf-unknown-link"))
    };
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
    assert_eq!(
        (
            count("ros2-control-unknown-joint"),
            count("controller-unknown-joint")
        ),
        (1, 0),
        "{found}"
    );
}

/// The labels that completion offers at `|` in a text that is put where `old` is, the best first.
fn offered(client: &mut Client, file: &str, old: &str, typed: &str) -> Vec<String> {
    client.edit(file, old, &typed.replace('|', ""));
    let answer = client.request("textDocument/completion", client.at(file, typed));
    client.edit(file, &typed.replace('|', ""), old);
    let mut items: Vec<(String, String)> = answer["items"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|item| {
            let text = |key: &str| item[key].as_str().unwrap_or_default().to_owned();
            (text("sortText"), text("label"))
        })
        .collect();
    items.sort();
    items.into_iter().map(|(_, label)| label).collect()
}

#[test]
fn names_are_completed_in_yaml() {
    let (moveit, kinematics, ompl) = (
        "src/pick_arm_moveit_config/config/moveit_controllers.yaml",
        "src/pick_arm_moveit_config/config/kinematics.yaml",
        "src/pick_arm_moveit_config/config/ompl_planning.yaml",
    );
    let (mut client, _) = started(&[CONTROLLERS, LIMITS, moveit, kinematics, ompl]);
    let driven = ["left_elbow", "left_finger", "left_shoulder"];
    for (file, old, typed, expected) in [
        (
            CONTROLLERS,
            "      - left_wrist\n",
            "      - |\n",
            &[
                "left_wrist",
                "left_finger",
                "left_thumb",
                "left_mount",
                "left_tool_mount",
            ][..],
        ),
        (
            CONTROLLERS,
            "joint: left_finger",
            "joint: left_fi|",
            &[
                "left_finger",
                "left_shoulder",
                "left_elbow",
                "left_wrist",
                "left_thumb",
                "left_mount",
                "left_tool_mount",
            ],
        ),
        (CONTROLLERS, "[position]", "[po|]", &["position"]),
        (
            CONTROLLERS,
            "[position, velocity]",
            "[position, |]",
            &["velocity"],
        ),
        (
            LIMITS,
            "  left_wrist:\n",
            "  left_|:\n",
            &["left_wrist", "left_finger", "left_thumb"],
        ),
        (
            LIMITS,
            "    max_velocity: 1.5\n",
            "    max|\n",
            &[
                "max_velocity",
                "max_acceleration",
                "max_position",
                "max_jerk",
                "has_position_limits",
                "has_jerk_limits",
                "min_position",
            ],
        ),
        (moveit, "      - left_finger\n", "      - |\n", &driven),
        (
            moveit,
            "    - gripper_controller\n",
            "    - g|\n",
            &["gripper_controller"],
        ),
        (kinematics, "arm:\n", "g|:\n", &["gripper", "arm", "all"]),
        (ompl, "gripper:\n", "g|:\n", &["gripper", "all"]),
        (
            ompl,
            "default_planner_config: RRTConnect",
            "default_planner_config: |",
            &["RRTConnect"],
        ),
        (
            kinematics,
            "kinematics_solver_timeout: 0.05",
            "kinematics_solver_timeout: |",
            &[],
        ),
    ] {
        let mut found = offered(&mut client, file, old, typed);
        let wanted: Vec<&str> = expected.to_vec();
        if file == moveit && expected.len() > 1 {
            found.sort();
            assert!(
                wanted
                    .iter()
                    .all(|name| found.iter().any(|label| label == name)),
                "{typed}: {found:?}"
            );
            continue;
        }
        assert_eq!(found, wanted, "{file}: {typed}");
    }
}

#[test]
fn names_and_elements_are_completed_in_srdf() {
    let (mut client, _) = started(&[SRDF]);
    let mut check = |old: &str, typed: &str, first: &[&str], never: &[&str]| {
        let found = offered(&mut client, SRDF, old, typed);
        assert_eq!(
            found.iter().take(first.len()).collect::<Vec<_>>(),
            first,
            "{typed}: {found:?}"
        );
        assert!(
            !never
                .iter()
                .any(|name| found.iter().any(|label| label == name)),
            "{typed}: {found:?}"
        );
    };
    check(
        "tip_link=\"left_tool\"",
        "tip_link=\"left_to|\"",
        &["left_tool"],
        &["left_wrist"],
    );
    check(
        "<joint name=\"left_wrist\" value=\"0.6\"/>",
        "<joint name=\"|\"/>",
        &["left_wrist"],
        &["left_elbow"],
    );
    check(
        "name=\"left_wrist\" value=\"0.6\"",
        "name=\"left_wrist\" value=\"|\"",
        &["0", "-1.9198621771937625"],
        &[],
    );
    check(
        "parent_group=\"arm\"",
        "parent_group=\"|\"",
        &["arm", "gripper", "all"],
        &[],
    );
    check(
        "<passive_joint name=\"left_thumb\"/>",
        "<pas|",
        &["passive_joint"],
        &["link", "ros2_control"],
    );
    check(
        "<group name=\"all\">\n    <group name=\"arm\"/>",
        "<group name=\"all\">\n    <|",
        &["link", "joint", "chain", "group"],
        &["visual", "group_state"],
    );
    check(
        "reason=\"User\"",
        "reason=\"|\"",
        &["Adjacent", "Never", "Default", "Always", "User"],
        &[],
    );
    check(
        "link2=\"left_hand\" reason",
        "link2=\"left_ha|\" reason",
        &["left_hand"],
        &["left_wrist"],
    );
}

#[test]
fn hover_says_what_names_mean() {
    let kinematics = "src/pick_arm_moveit_config/config/kinematics.yaml";
    let (mut client, _) = started(&[SRDF, CONTROLLERS, LIMITS, kinematics]);
    for (file, at, expected) in [
        (
            CONTROLLERS,
            "- left_el|bow",
            &[
                "**joint** `left_elbow` (revolute)",
                "2.0 rad/s",
                "left_upper_arm",
            ][..],
        ),
        (
            LIMITS,
            "left_sh|oulder:",
            &["**joint** `left_shoulder` (revolute)"],
        ),
        (
            SRDF,
            "joint name=\"left_th|umb\"",
            &["**joint** `left_thumb` (prismatic)", "mimics `left_finger`"],
        ),
        (SRDF, "tip_link=\"left_|tool\"", &["**link** `left_tool`"]),
        (
            SRDF,
            "group name=\"a|rm\">",
            &["**group** `arm`", "chain left_base → left_tool"],
        ),
        (
            kinematics,
            "a|rm:",
            &["**group** `arm`", "chain left_base → left_tool"],
        ),
        (SRDF, "passive_jo|int", &["A joint that nothing drives"]),
    ] {
        let params = client.at(file, at);
        let answer = client.request("textDocument/hover", params);
        let text = answer["contents"]["value"].as_str().unwrap_or_default();
        assert!(
            expected.iter().all(|part| text.contains(part)),
            "{file} {at}: {answer}"
        );
    }
}

#[test]
fn the_tree_lists_the_files_beside_the_robot() {
    let (mut client, _) = started(&[ROBOT]);
    let tree = client.request("xacro/tree", client.of(ROBOT));
    let mut kinds: Vec<&str> = tree["beside"]
        .as_array()
        .unwrap()
        .iter()
        .map(|file| file["kind"].as_str().unwrap())
        .collect();
    kinds.sort_unstable();
    let expected = [
        "controllers",
        "joint-limits",
        "kinematics",
        "moveit-controllers",
        "planners",
        "setup-assistant",
        "srdf",
    ];
    assert_eq!(kinds, expected);
}
