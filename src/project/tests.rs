//! Settings read from YAML.

#![allow(clippy::unwrap_used)] // a test may fail loudly

use super::{ExpectedName, ProjectNameKind, YamlSettings, word_at};

/// The names in a text, each with its kind and the text it stands at.
fn check_names(text: &str, expected: &[(&str, ProjectNameKind)]) {
    let root = yaml::load(text, "a.yaml").unwrap();
    let settings = YamlSettings::of(&root).unwrap_or_default();
    let names = settings.names();
    let found: Vec<(&str, ProjectNameKind)> = names
        .iter()
        .map(|(name, kind)| (name.name.as_str(), *kind))
        .collect();
    assert_eq!(found, expected, "{text}");
    for (name, _) in names {
        assert!(
            name.range.slice(text).contains(name.name.as_str()),
            "{text}: {name:?}"
        );
    }
}

#[test]
fn names_in_settings() {
    let joint = |name| (name, ProjectNameKind::Joint);
    let group = |name| (name, ProjectNameKind::Group);
    for (text, expected) in [
        (
            "arm_controller:\n  ros__parameters:\n    joints: [a, 'b']\n",
            vec![joint("a"), joint("b")],
        ),
        (
            "/ns/arm_controller:\n  ros__parameters:\n    joints:\n    - a\n",
            vec![joint("a")],
        ),
        (
            "ns:\n  arm:\n    ros__parameters:\n      joint: a\n",
            vec![joint("a")],
        ),
        (
            "arm:\n  type: position_controllers/JointPositionController\n  joint: a\n",
            vec![joint("a")],
        ),
        (
            "states:\n  ros__parameters:\n    extra_joints: [a]\n",
            vec![joint("a")],
        ),
        (
            "drive:\n  ros__parameters:\n    front_joint_names: [a]\n    joint: b\n",
            vec![joint("b")],
        ),
        (
            "controller_manager:\n  ros__parameters:\n    drive: {type: carts/Drive}\ndrive:\n  ros__parameters:\n    front_joint_names: [a]\n",
            vec![joint("a")],
        ),
        (
            "arm:\n  ros__parameters:\n    joints: [$(var p)a, b]\n",
            vec![joint("b")],
        ),
        (
            "base:\n  ros__parameters:\n    left_wheel_names: [a]\n    right_wheel_names: b\n",
            vec![joint("a"), joint("b")],
        ),
        (
            "controller_names: [c]\nc:\n  joints: [a]\n",
            vec![joint("a")],
        ),
        (
            "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    joints: [a]\n",
            vec![joint("a")],
        ),
        // a list beside that of the manager is not read
        (
            "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    joints: [a]\n\
             controller_names: [d]\nd:\n  type: x\n  joints: [b]\n",
            vec![joint("a")],
        ),
        (
            "controller_list:\n- name: c\n  joints: [a]\n",
            vec![joint("a")],
        ),
        (
            "joint_limits:\n  a:\n    has_velocity_limits: true\n    max_velocity: 1\n",
            vec![joint("a")],
        ),
        ("joint_limits:\n  a:\n    lower: 1\n", vec![]),
        ("arm:\n  kinematics_solver: kdl\n", vec![group("arm")]),
        (
            "planner_configs:\n  RRT: {type: x}\narm:\n  planner_configs: [RRT]\n",
            vec![group("arm")],
        ),
        ("- 1\n- b\n", vec![]),
    ] {
        check_names(text, &expected);
    }
}

#[test]
fn what_the_setup_assistant_wrote_down() {
    let text = "moveit_setup_assistant_config:\n  URDF:\n    package: arm_description\n    relative_path: urdf/arm.xacro\n    xacro_args: \"side:=left  sim:=true\"\n  SRDF:\n    relative_path: config/arm.srdf\n";
    let assistant = YamlSettings::of(&yaml::load(text, "a").unwrap())
        .unwrap()
        .assistant
        .unwrap();
    assert_eq!(
        assistant.given(),
        [("side", "left"), ("sim", "true")].map(|(a, b)| (a.to_owned(), b.to_owned()))
    );
    assert_eq!(assistant.srdf.unwrap().name, "config/arm.srdf");
}

/// What is wanted at `|`, with what was typed and the other names beside it.
fn check_word(name: &str, text: &str, expected: Option<(ExpectedName, &str, &[&str])>) {
    let offset = text.find('|').unwrap();
    let text = text.replace('|', "");
    let found = word_at(name, &text, offset as u32);
    let found = found.as_ref().map(|word| {
        let taken: Vec<&str> = word.taken.iter().map(String::as_str).collect();
        (word.wanted, word.range.slice(&text), taken)
    });
    assert_eq!(
        found,
        expected.map(|(wanted, typed, taken)| (wanted, typed, taken.to_vec())),
        "{text}"
    );
}

#[test]
fn words_that_are_typed() {
    use ExpectedName::{
        CommandInterface, Controller, Group, Joint, JointInterface, Limit, Planner, StateInterface,
    };
    let arm = "arm:\n  ros__parameters:\n";
    for (text, expected) in [
        (
            "    joints:\n      - a\n      - b|\n      - c\n",
            Some((Joint, "b", &["a", "c"][..])),
        ),
        (
            "    joints:\n    - a\n    - |\n    gains: 1\n",
            Some((Joint, "", &["a"][..])),
        ),
        (
            "    joints: [a, 'b|', c]\n",
            Some((Joint, "b", &["a", "c"][..])),
        ),
        (
            "    joints: [a,\n      b, # [\n      |",
            Some((Joint, "", &["a", "b"][..])),
        ),
        ("    joint: |\n", Some((Joint, "", &[][..]))),
        ("    front_joint_names: |\n", Some((Joint, "", &[][..]))),
        (
            "    command_interfaces: [position]\n    state_interfaces: [po|]\n",
            Some((StateInterface, "po", &[][..])),
        ),
        (
            "    command_interfaces:\n      - p|",
            Some((CommandInterface, "p", &[][..])),
        ),
        (
            "    interface_names: [|",
            Some((JointInterface, "", &[][..])),
        ),
        (
            "    gains:\n      a: {p: 1.0}\n      b|\n",
            Some((Joint, "b", &["a"][..])),
        ),
        ("    joints: [] # |\n", None),
        ("    update_rate: |\n", None),
        ("    joi|\n", None),
    ] {
        check_word("a.yaml", &format!("{arm}{text}"), expected);
    }
    for (name, text, expected) in [
        (
            "a.yaml",
            "joint_limits:\n  a:\n    max_velocity: 1.0\n  |\n",
            Some((Joint, "", &["a"][..])),
        ),
        (
            "a.yaml",
            "joint_limits:\n  a:\n    has|\n",
            Some((Limit, "has", &[][..])),
        ),
        (
            "a.yaml",
            "controller_list:\n  - name: c\n    joints: [|]\n",
            Some((Joint, "", &[][..])),
        ),
        (
            "a.yaml",
            "controller_names:\n  - |\n",
            Some((Controller, "", &[][..])),
        ),
        (
            "a.yaml",
            "moveit_simple_controller_manager:\n  controller_names: [a]\n  |",
            Some((Controller, "", &["controller_names"][..])),
        ),
        ("kinematics.yaml", "|", Some((Group, "", &[][..]))),
        (
            "a.yaml",
            "arm:\n  kinematics_solver: kdl\nha|",
            Some((Group, "ha", &["arm"][..])),
        ),
        (
            "a.yaml",
            "planner_configs:\n  RRT: {}\narm:\n  planner_configs:\n    - |",
            Some((Planner, "", &[][..])),
        ),
        ("a.yaml", "move_group_name: |", Some((Group, "", &[][..]))),
        (
            "a.yaml",
            "{joint_limits: {a: {max_velocity: 1}, |",
            Some((Joint, "", &["a"][..])),
        ),
        ("a.yaml", "fov: |", None),
        ("a.yaml", "|", None),
    ] {
        check_word(name, text, expected);
    }
}

#[test]
fn broken_text_is_read_as_well() {
    let text = "joints: [{a: 'b, \"c\n - - x:\n\t[}]: é# {\n---\n- [\n";
    for offset in 0..=text.len() {
        let _ = word_at("a.yaml", text, offset as u32);
    }
}
