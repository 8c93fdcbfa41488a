//! Settings read from YAML.

#![allow(clippy::unwrap_used)] // a test may fail loudly

use super::{Kind, Settings};

/// The names in a text, each with its kind and the text it stands at.
fn check_names(text: &str, expected: &[(&str, Kind)]) {
    let root = yaml::load(text, "a.yaml").unwrap();
    let settings = Settings::of(&root).unwrap_or_default();
    let names = settings.names();
    let found: Vec<(&str, Kind)> = names.iter().map(|(name, kind)| (name.name.as_str(), *kind)).collect();
    assert_eq!(found, expected, "{text}");
    for (name, _) in names {
        assert!(name.range.slice(text).contains(name.name.as_str()), "{text}: {name:?}");
    }
}

#[test]
fn names_in_settings() {
    let joint = |name| (name, Kind::Joint);
    let group = |name| (name, Kind::Group);
    for (text, expected) in [
        ("arm_controller:\n  ros__parameters:\n    joints: [a, 'b']\n", vec![joint("a"), joint("b")]),
        ("/ns/arm_controller:\n  ros__parameters:\n    joints:\n    - a\n", vec![joint("a")]),
        ("ns:\n  arm:\n    ros__parameters:\n      joint: a\n", vec![joint("a")]),
        ("arm:\n  type: position_controllers/JointPositionController\n  joint: a\n", vec![joint("a")]),
        ("states:\n  ros__parameters:\n    extra_joints: [a]\n", vec![joint("a")]),
        ("drive:\n  ros__parameters:\n    front_joint_names: [a]\n    joint: b\n", vec![joint("b")]),
        (
            "controller_manager:\n  ros__parameters:\n    drive: {type: carts/Drive}\ndrive:\n  ros__parameters:\n    front_joint_names: [a]\n",
            vec![joint("a")],
        ),
        ("arm:\n  ros__parameters:\n    joints: [$(var p)a, b]\n", vec![joint("b")]),
        (
            "base:\n  ros__parameters:\n    left_wheel_names: [a]\n    right_wheel_names: b\n",
            vec![joint("a"), joint("b")],
        ),
        ("controller_names: [c]\nc:\n  joints: [a]\n", vec![joint("a")]),
        (
            "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    joints: [a]\n",
            vec![joint("a")],
        ),
        ("controller_list:\n- name: c\n  joints: [a]\n", vec![joint("a")]),
        ("joint_limits:\n  a:\n    has_velocity_limits: true\n    max_velocity: 1\n", vec![joint("a")]),
        ("joint_limits:\n  a:\n    lower: 1\n", vec![]),
        ("arm:\n  kinematics_solver: kdl\n", vec![group("arm")]),
        ("planner_configs:\n  RRT: {type: x}\narm:\n  planner_configs: [RRT]\n", vec![group("arm")]),
        ("- 1\n- b\n", vec![]),
    ] {
        check_names(text, &expected);
    }
}

#[test]
fn what_the_setup_assistant_wrote_down() {
    let text = "moveit_setup_assistant_config:\n  URDF:\n    package: arm_description\n    relative_path: urdf/arm.xacro\n    xacro_args: \"side:=left  sim:=true\"\n  SRDF:\n    relative_path: config/arm.srdf\n";
    let assistant = Settings::of(&yaml::load(text, "a").unwrap()).unwrap().assistant.unwrap();
    assert_eq!(
        assistant.given(),
        [("side", "left"), ("sim", "true")].map(|(a, b)| (a.to_owned(), b.to_owned()))
    );
    assert_eq!(assistant.srdf.unwrap().name, "config/arm.srdf");
}
