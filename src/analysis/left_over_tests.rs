//! Files of a package that nothing uses, beside others that are used.
use super::set_aside_tests::{BROKEN, found};
use rules::Severity;

const MANIFEST: (&str, &str) = ("package.xml", "<package><name>lamp</name></package>");

fn severity_of(file: &str, files: &[(&str, &str)], rule: &str) -> Option<Severity> {
    let places = found(files, rule);
    places
        .iter()
        .find(|(name, _)| name == file)
        .map(|found| found.1)
}

#[test]
fn a_program_or_build_file_loads_another_one() {
    let of = |others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            ("urdf/sketch.urdf", BROKEN),
            ("urdf/lamp.urdf", BROKEN),
        ];
        severity_of(
            "urdf/sketch.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    for (name, text, expected) in [
        ("scripts/move.py", "load('urdf/lamp.urdf')", Severity::Info),
        (
            "scripts/move.py",
            "load('urdf/sketch.urdf', 'urdf/lamp.urdf')",
            Severity::Error,
        ),
        ("scripts/move.py", "load('urdf/gone.urdf')", Severity::Error),
        (
            "CMakeLists.txt",
            "xacro_add_files(urdf/lamp.urdf TARGET a)",
            Severity::Info,
        ),
        (
            "CMakeLists.txt",
            "install(FILES urdf/lamp.urdf DESTINATION x)",
            Severity::Error,
        ),
        ("README.md", "the robot is lamp.urdf", Severity::Error),
    ] {
        assert_eq!(of(&[(name, text)]), Some(expected), "{name}: {text}");
    }
    // a program of another package picks one of several
    let elsewhere = [
        ("p/package.xml", MANIFEST.1),
        ("p/urdf/sketch.urdf", BROKEN),
        ("p/urdf/lamp.urdf", BROKEN),
        ("tests/move.py", "load('lamp', 'urdf/lamp.urdf')"),
    ];
    let found = severity_of("p/urdf/sketch.urdf", &elsewhere, "missing-element");
    assert_eq!(found, Some(Severity::Error));
}

#[test]
fn a_launch_file_loads_one_of_another_package() {
    let of = |name: &str| {
        let launch = format!("<param textfile='$(find lamp)/urdf/{name}'/>");
        let files = [
            ("lamp/package.xml", MANIFEST.1),
            ("lamp/urdf/lamp.urdf", BROKEN),
            ("run/package.xml", "<package><name>run</name></package>"),
            ("run/urdf/sketch.urdf", BROKEN),
            ("run/launch/run.launch", launch.as_str()),
        ];
        severity_of("run/urdf/sketch.urdf", &files, "missing-element")
    };
    assert_eq!(of("lamp.urdf"), Some(Severity::Info));
    assert_eq!(of("gone.urdf"), Some(Severity::Error));
}

#[test]
fn variants_of_a_part_of_a_robot() {
    let of = |others: &[(&str, &str)]| {
        let own = [
            ("hand/package.xml", "<package><name>hand</name></package>"),
            ("hand/urdf/hand_a.urdf", BROKEN),
            (
                "hand/urdf/hand_b.urdf",
                "<robot name='b'><link name='b'/></robot>",
            ),
            ("lamp/package.xml", MANIFEST.1),
        ];
        severity_of(
            "hand/urdf/hand_a.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    let includes = (
        "lamp/urdf/lamp.xacro",
        "<robot name='l' xmlns:xacro='x'><xacro:include filename='$(find hand)/urdf/hand_b.urdf'/></robot>",
    );
    let loads = (
        "lamp/launch/a.launch",
        "<param textfile='$(find hand)/urdf/hand_a.urdf'/>",
    );
    assert_eq!(of(&[]), Some(Severity::Error));
    assert_eq!(of(&[includes]), Some(Severity::Info));
    assert_eq!(of(&[includes, loads]), Some(Severity::Error));
}

#[test]
fn a_path_in_a_package_means_the_file_there() {
    let of = |folder: &str| {
        let launch = format!("path = get_package_share_path('lamp') / '{folder}lamp.urdf'");
        let files = [
            MANIFEST,
            ("lamp/urdf/lamp.urdf", BROKEN),
            ("urdf/lamp.urdf", BROKEN),
            ("launch/show.launch.py", launch.as_str()),
        ];
        severity_of("lamp/urdf/lamp.urdf", &files, "missing-element")
    };
    assert_eq!(of("urdf/"), Some(Severity::Info));
    assert_eq!(of("lamp/urdf/"), Some(Severity::Error));
    assert_eq!(of(""), Some(Severity::Error));
}

#[test]
fn drawn_folders_name_nothing() {
    let of = |page: &str| {
        let files = [
            MANIFEST,
            ("urdf/sketch.urdf", BROKEN),
            ("urdf/lamp.urdf", BROKEN),
            ("README.md", page),
            (
                "launch/show.launch",
                "<param textfile='$(find lamp)/urdf/lamp.urdf'/>",
            ),
        ];
        severity_of("urdf/sketch.urdf", &files, "missing-element")
    };
    assert_eq!(
        of("+ urdf\n    > lamp.urdf\n    > sketch.urdf\n"),
        Some(Severity::Info)
    );
    assert_eq!(of("urdf\n  |-- sketch.urdf\n"), Some(Severity::Info));
    assert_eq!(of("load:\n    - sketch.urdf\n"), Some(Severity::Error));
    assert_eq!(of("    cat a > sketch.urdf\n"), Some(Severity::Error));
}

#[test]
fn generated_files_whose_source_is_gone() {
    let head = "<?xml version='1.0'?>\n<!-- | This document was autogenerated by xacro from gone.xacro | -->\n";
    let generated = format!("{head}{BROKEN}");
    let of = |others: &[(&str, &str)]| {
        let own = [MANIFEST, ("urdf/made.urdf", generated.as_str())];
        severity_of(
            "urdf/made.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    let other = ("urdf/lamp.urdf", BROKEN);
    let named = ("README.md", "load made.urdf");
    let loads = (
        "launch/show.launch",
        "<param command='xacro $(arg model)'/><arg name='model' default='$(find lamp)/urdf/lamp.urdf'/>",
    );
    assert_eq!(of(&[other]), Some(Severity::Error));
    assert_eq!(of(&[other, loads]), Some(Severity::Info));
    assert_eq!(of(&[other, loads, named]), Some(Severity::Error));
}

#[test]
fn robots_that_a_launch_file_with_a_default_may_be_given() {
    let of = |others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            ("urdf/sketch.urdf", BROKEN),
            (
                "urdf/lamp.urdf",
                "<robot name='l'><link name='base'/></robot>",
            ),
        ];
        severity_of(
            "urdf/sketch.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    let given = "<param command='xacro $(arg model)'/><arg name='model'";
    let shows = format!("{given} default='$(find lamp)/urdf/lamp.urdf'/>");
    let asks = format!("{given}/>");
    let runs = "<param textfile='$(find lamp)/urdf/lamp.urdf'/>";
    let (show, ask) = (
        ("launch/show.launch", &*shows),
        ("launch/ask.launch", &*asks),
    );
    let run = ("launch/run.launch", runs);
    assert_eq!(of(&[show]), Some(Severity::Error));
    assert_eq!(of(&[ask, run]), Some(Severity::Error));
    assert_eq!(of(&[show, run]), Some(Severity::Info));
}

#[test]
fn semantic_descriptions_that_nothing_reads() {
    let srdf = "<robot name='lamp'><group name='all'><link name='base'/></group>\
                <group_state name='up' group='legs'/></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            (
                "urdf/lamp.urdf",
                "<robot name='lamp'><link name='base'/></robot>",
            ),
            ("config/lamp.srdf", srdf),
        ];
        severity_of(
            "config/lamp.srdf",
            &[&own, others].concat(),
            "srdf-unknown-group",
        )
    };
    let loads = "<param textfile='$(find lamp)/urdf/lamp.urdf'/>";
    let both = format!("{loads}<param textfile='$(find lamp)/config/lamp.srdf'/>");
    let computed = format!("{loads}<param textfile='$(arg name).srdf'/>");
    assert_eq!(of(&[]), Some(Severity::Error));
    assert_eq!(of(&[("launch/show.launch", loads)]), Some(Severity::Info));
    assert_eq!(of(&[("launch/show.launch", &both)]), Some(Severity::Error));
    assert_eq!(
        of(&[("launch/show.launch", &computed)]),
        Some(Severity::Error)
    );
}

#[test]
fn trials_outside_of_packages() {
    let of = |name: &str| {
        let files = [
            ("lamp/package.xml", MANIFEST.1),
            ("lamp/urdf/lamp.urdf", BROKEN),
            (
                "lamp/launch/show.launch",
                "<param textfile='$(find lamp)/urdf/lamp.urdf'/>",
            ),
            ("notes/deep/try.urdf", BROKEN),
            (
                name,
                "<arg name='m' default='/home/me/notes/deep/try.urdf'/><param textfile='$(arg m)'/>",
            ),
        ];
        severity_of("notes/deep/try.urdf", &files, "missing-element")
    };
    assert_eq!(of("lamp/launch/test_it.launch"), Some(Severity::Info));
    assert_eq!(of("lamp/launch/it.launch"), Some(Severity::Error));
}

#[test]
fn packages_in_a_folder_of_others() {
    let of = |folder: &str| {
        let package = format!("{folder}/eye/package.xml");
        let robot = format!("{folder}/eye/urdf/eye.urdf");
        let files = [
            ("lamp/package.xml", MANIFEST.1),
            ("lamp/urdf/lamp.urdf", BROKEN),
            (
                package.as_str(),
                "<package><name>eye</name><maintainer email='they@lab.org'>P</maintainer></package>",
            ),
            (robot.as_str(), BROKEN),
        ];
        severity_of(&robot, &files, "missing-element")
    };
    assert_eq!(of("third_party"), Some(Severity::Info));
    assert_eq!(of("sensors"), Some(Severity::Error));
}

#[test]
fn what_says_that_a_robot_is_for_an_old_xacro() {
    let robot =
        "<robot name='r' xmlns:xacro='x'><property name='a' value='1'/><link name='base'/></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [
            (
                "package.xml",
                "<package><name>lamp</name><buildtool_depend>catkin</buildtool_depend></package>",
            ),
            ("urdf/lamp.xacro", robot),
        ];
        severity_of(
            "urdf/lamp.xacro",
            &[&own, others].concat(),
            "unprefixed-xacro-tag",
        )
    };
    let python = |text: &'static str| ("scripts/move.py", text);
    assert_eq!(of(&[]), Some(Severity::Error));
    assert_eq!(of(&[python("from Tkinter import *")]), Some(Severity::Info));
    assert_eq!(
        of(&[python("from tkinter import *")]),
        Some(Severity::Error)
    );
    let both = [
        python("from Tkinter import *"),
        ("scripts/go.py", "#!/usr/bin/env python3"),
    ];
    assert_eq!(of(&both), Some(Severity::Error));
    let editor = |name: &str| format!("{{\"paths\": [\"/opt/ros/{name}/lib\"]}}");
    let (old, new) = (editor("melodic"), editor("noetic"));
    assert_eq!(of(&[(".vscode/settings.json", &old)]), Some(Severity::Info));
    assert_eq!(
        of(&[(".vscode/settings.json", &new)]),
        Some(Severity::Error)
    );
    let launch = (
        "launch/show.launch",
        "<param name='d' command='xacro --inorder $(find lamp)/urdf/lamp.xacro'/>",
    );
    assert_eq!(of(&[launch]), Some(Severity::Warning));
    assert_eq!(
        of(&[launch, python("from Tkinter import *")]),
        Some(Severity::Info)
    );
}

#[test]
fn files_that_programs_only_write() {
    let of = |program: &str| {
        let files = [
            MANIFEST,
            ("urdf/dump.urdf", BROKEN),
            ("scripts/dump.py", program),
        ];
        severity_of("urdf/dump.urdf", &files, "missing-element")
    };
    assert_eq!(
        of("out = open(path + '/urdf/dump.urdf', 'w')"),
        Some(Severity::Info)
    );
    assert_eq!(
        of("tree.write(path + '/urdf/dump.urdf')"),
        Some(Severity::Info)
    );
    assert_eq!(
        of("text = open(path + '/urdf/dump.urdf').read()"),
        Some(Severity::Error)
    );
    assert_eq!(of(""), Some(Severity::Error));
}

#[test]
fn descriptions_for_a_controller_manager_alone() {
    let block = "<ros2_control name='c' type='system'><hardware><plugin>mock_components/GenericSystem</plugin></hardware>\
                 <joint name='turn'><command_interface name='position'/></joint></ros2_control>";
    let of = |links: &str, page: &str| {
        let robot = format!("<robot name='r'>{links}{block}</robot>");
        let files = [
            (
                "package.xml",
                "<package><name>lamp</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
            ),
            ("urdf/lamp.urdf", robot.as_str()),
            ("README.md", page),
        ];
        severity_of("urdf/lamp.urdf", &files, "ros2-control-unknown-joint")
    };
    let one = "<link name='base'/>";
    let two = "<link name='base'/><link name='top'/><joint name='j' type='fixed'><parent link='base'/><child link='top'/></joint>";
    assert_eq!(of(one, "for humble"), Some(Severity::Info));
    assert_eq!(of(one, "for jazzy"), Some(Severity::Error));
    assert_eq!(of(one, ""), Some(Severity::Error));
    assert_eq!(of(two, "for humble"), Some(Severity::Error));
}

#[test]
fn semantic_descriptions_that_a_program_makes() {
    let assistant = "moveit_setup_assistant_config:\n  URDF:\n    package: lamp\n    relative_path: urdf/lamp.urdf\n  SRDF:\n    relative_path: config/lamp.srdf\n";
    let of = |assistant: &str, others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            (
                "urdf/lamp.urdf",
                "<robot name='lamp'><link name='base'/></robot>",
            ),
            (".setup_assistant", assistant),
        ];
        severity_of(
            ".setup_assistant",
            &[&own, others].concat(),
            "setup-assistant-file-not-found",
        )
    };
    let source = ("config/srdf/parts.srdf.xacro", "<robot name='lamp'/>");
    let builder = ("launch/demo.launch.py", "MoveItConfigsBuilder('lamp')");
    assert_eq!(of(assistant, &[builder]), Some(Severity::Warning));
    assert_eq!(of(assistant, &[builder, source]), Some(Severity::Info));
    // the assistant itself asks for another file
    assert_eq!(of(assistant, &[]), Some(Severity::Info));
    // written on Windows
    let of_windows = assistant.replace("config/", "config\\");
    assert_eq!(of(&of_windows, &[builder]), Some(Severity::Info));
}

#[test]
fn what_a_robot_in_use_shares_with_a_sketch() {
    let sketch = "<robot name='s' xmlns:xacro='x'><xacro:include filename='lamp.urdf'/><link name='s'><visual/></link></robot>";
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/lamp.urdf", BROKEN),
            ("urdf/sketch.urdf.xacro", sketch),
            (
                "urdf/other.urdf",
                "<robot name='o'><link name='o'/></robot>",
            ),
            ("launch/show.launch", launch),
        ];
        let severity = |file: &str| severity_of(file, &files, "missing-element");
        (
            severity("urdf/sketch.urdf.xacro"),
            severity("urdf/lamp.urdf"),
        )
    };
    let (info, error) = (Some(Severity::Info), Some(Severity::Error));
    assert_eq!(
        of("<param textfile='$(find lamp)/urdf/lamp.urdf'/>"),
        (info, error)
    );
    assert_eq!(
        of("<param textfile='$(find lamp)/urdf/other.urdf'/>"),
        (info, info)
    );
}

#[test]
fn what_the_builder_of_moveit_finds() {
    let of = |launch: &str| {
        let files = [
            ("lamp/package.xml", MANIFEST.1),
            ("lamp/urdf/lamp.urdf", BROKEN),
            ("plan/package.xml", "<package><name>plan</name></package>"),
            ("plan/config/lamp.urdf.xacro", BROKEN),
            ("plan/launch/plan.launch.py", launch),
        ];
        severity_of("plan/config/lamp.urdf.xacro", &files, "missing-element")
    };
    let loads = "path = get_package_share_path('lamp') / 'urdf/lamp.urdf'";
    assert_eq!(of(loads), Some(Severity::Info));
    let builds = format!("{loads}\nMoveItConfigsBuilder('lamp')");
    assert_eq!(of(&builds), Some(Severity::Error));
}

#[test]
fn kinematics_of_matlab() {
    let robot = "<robot name='r'><link name='base'><inertial><mass value='1'/>\
                 <inertia ixx='1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link></robot>";
    let of = |program: &str| {
        let files = [MANIFEST, ("urdf/lamp.urdf", robot), ("src/go.m", program)];
        severity_of("urdf/lamp.urdf", &files, "inertia-triangle-inequality")
    };
    let loads = "robot = importrobot('lamp.urdf');";
    assert_eq!(of(loads), Some(Severity::Info));
    let computes = format!("{loads} t = inverseDynamics(robot, q);");
    assert_eq!(of(&computes), Some(Severity::Warning));
}

#[test]
fn launch_files_that_spawn_other_models() {
    let of = |launch: &str, others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            ("urdf/lamp.urdf", BROKEN),
            ("launch/lamp.launch", launch),
        ];
        severity_of(
            "urdf/lamp.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    let spawns = "<node pkg='gazebo_ros' type='spawn_model' args='-sdf -file models/lamp/model.sdf -model l'/>";
    assert_eq!(of(spawns, &[]), Some(Severity::Info));
    assert_eq!(of("<node pkg='rviz'/>", &[]), Some(Severity::Error));
    let loads = ("launch/show.launch", "<param textfile='urdf/other.urdf'/>");
    assert_eq!(of(spawns, &[loads]), Some(Severity::Error));
    assert_eq!(
        of(spawns, &[("README.md", "the robot is lamp.urdf")]),
        Some(Severity::Error)
    );
}

#[test]
fn packages_that_are_not_built() {
    let of = |mark: &str, others: &[(&str, &str)]| {
        let mark = format!("src/parts/{mark}");
        let own = [
            ("src/parts/lamp/package.xml", MANIFEST.1),
            ("src/parts/lamp/urdf/lamp.urdf", BROKEN),
            (mark.as_str(), ""),
        ];
        severity_of(
            "src/parts/lamp/urdf/lamp.urdf",
            &[&own, others].concat(),
            "missing-element",
        )
    };
    assert_eq!(of("COLCON_IGNORE", &[]), Some(Severity::Info));
    assert_eq!(of("README", &[]), Some(Severity::Error));
    // a package inside of another one is not built either
    let outer = [
        (
            "src/parts/package.xml",
            "<package><name>parts</name></package>",
        ),
        ("src/parts/CMakeLists.txt", "project(parts)"),
    ];
    assert_eq!(of("README", &outer), Some(Severity::Info));
    // its own launch files are not installed; those of the package around it may load its files
    let load = "<param textfile='lamp/urdf/lamp.urdf'/>";
    let inside = [
        outer[0],
        outer[1],
        ("src/parts/lamp/launch/lamp.launch", load),
    ];
    assert_eq!(of("README", &inside), Some(Severity::Info));
    let outside = [outer[0], outer[1], ("src/parts/launch/lamp.launch", load)];
    assert_eq!(of("README", &outside), Some(Severity::Error));
}

#[test]
fn files_that_were_downloaded_once_more() {
    let severity = |name: &str, program: &str| {
        let name = format!("models/{name}");
        let files = [(name.as_str(), BROKEN), ("run.py", program)];
        severity_of(&name, &files, "missing-element")
    };
    assert_eq!(severity("arm (1).urdf", ""), Some(Severity::Info));
    assert_eq!(
        severity("arm (1).urdf", "load('models/arm (1).urdf')"),
        Some(Severity::Error)
    );
    assert_eq!(severity("arm (left).urdf", ""), Some(Severity::Error));
}
