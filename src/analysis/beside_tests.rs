//! Which robots count for a file beside them, and what changes of these make of it.
use super::{CheckOptions, Session, Setup};
use rules::Severity;
use vfs::testing::Tree;

const MANIFEST: &str =
    "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>";

const SETTINGS: &str = "controller_manager:\n  ros__parameters:\n    go:\n      type: joint_trajectory_controller/JointTrajectoryController\n\
                        go:\n  ros__parameters:\n    joints:\n      - lift\n      - turn\n    command_interfaces:\n      - velocity\n";

/// A robot with two joints, hardware with these interfaces for commands, and a plugin that names a file.
fn robot(lift: &str, turn: &str, file: &str) -> String {
    let joint = |name: &str, inner: &str| format!("<joint name='{name}'>{inner}</joint>");
    format!(
        "<robot name='arm'><link name='base'/><link name='a'/><link name='b'/>\
         <joint name='lift' type='continuous'><parent link='base'/><child link='a'/></joint>\
         <joint name='turn' type='continuous'><parent link='a'/><child link='b'/></joint>\
         <ros2_control name='c' type='system'><hardware><plugin>mock_components/GenericSystem</plugin></hardware>{}{}\
         </ros2_control><gazebo><plugin name='c' filename='libgazebo_ros2_control.so'><parameters>$(find arm)/config/{file}\
         </parameters></plugin></gazebo></robot>",
        joint("lift", lift),
        joint("turn", turn)
    )
}

const VELOCITY: &str = "<command_interface name='velocity'/>";
const POSITION: &str = "<command_interface name='position'/>";

/// Where a package of these files has findings of a rule: the ends of their paths, with severities.
fn found(files: &[(&str, &str)], rule: &str) -> Vec<(String, Severity)> {
    let tree = Tree::new();
    tree.write("package.xml", MANIFEST);
    for (name, text) in files {
        tree.write(name, text);
    }
    let path = tree.root().to_owned();
    let setup = Setup {
        folders: vec![path.clone()],
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let report = session.check(&CheckOptions {
        paths: vec![path.clone()],
        ..CheckOptions::default()
    });
    let findings = report
        .findings
        .iter()
        .filter(|finding| finding.rule.name == rule);
    let place = |finding: &rules::Finding| {
        let file = session.vfs.path(finding.span.file);
        let inside = file.strip_prefix(&path).unwrap_or(&file).to_path_buf();
        inside.to_string_lossy().replace('\\', "/")
    };
    findings
        .map(|finding| (place(finding), finding.severity))
        .collect()
}

const RULE: &str = "controller-unknown-interface";

#[test]
fn a_copy_that_nothing_loads_offers_no_interface() {
    let (now, old) = (
        robot(VELOCITY, POSITION, "c.yaml"),
        robot(VELOCITY, VELOCITY, "c.yaml"),
    );
    let with = |launch: &str| {
        let files = [
            ("urdf/arm.urdf", now.as_str()),
            ("urdf/arm_old.urdf", old.as_str()),
            ("config/c.yaml", SETTINGS),
            ("launch/arm.launch.py", launch),
        ];
        found(&files, RULE)
    };
    assert_eq!(
        with("load('arm.urdf')"),
        [("config/c.yaml".to_owned(), Severity::Error)]
    );
    assert_eq!(with("load('arm.urdf', 'arm_old.urdf')"), []);
}

#[test]
fn the_folder_tells_files_of_one_name_apart() {
    let files = [
        ("urdf/one.urdf", &*robot(VELOCITY, VELOCITY, "one/c.yaml")),
        ("urdf/two.urdf", &*robot(VELOCITY, POSITION, "two/c.yaml")),
        ("config/one/c.yaml", SETTINGS),
        ("config/two/c.yaml", SETTINGS),
    ];
    assert_eq!(
        found(&files, RULE),
        [("config/two/c.yaml".to_owned(), Severity::Error)]
    );
}

#[test]
fn a_joint_with_a_mistake_says_nothing_of_the_others() {
    let of = |lift: &str, turn: &str| {
        let files = [
            ("urdf/arm.urdf", &*robot(lift, turn, "c.yaml")),
            ("config/c.yaml", SETTINGS),
        ];
        found(&files, RULE).len()
    };
    let misspelled = "<command_interface name='velocty'/>";
    assert_eq!(of(misspelled, VELOCITY), 0);
    assert_eq!(of(misspelled, POSITION), 1);
    assert_eq!(of(VELOCITY, POSITION), 1);
    // an element that ros2_control passes over is no mistake in another one
    let mimic = format!("<mimic joint='turn'/>{VELOCITY}");
    assert_eq!(of(&mimic, POSITION), 1);
}

#[test]
fn a_robot_without_hardware_offers_nothing() {
    let bare = "<robot name='arm'><link name='base'/><link name='a'/><link name='b'/>\
                <joint name='lift' type='continuous'><parent link='base'/><child link='a'/></joint>\
                <joint name='turn' type='continuous'><parent link='a'/><child link='b'/></joint></robot>";
    let of = |turn: &str| {
        let files = [
            ("urdf/arm.urdf", &*robot(VELOCITY, turn, "other.yaml")),
            ("urdf/shown.urdf", bare),
            ("config/c.yaml", SETTINGS),
        ];
        found(&files, RULE).len()
    };
    assert_eq!(of(VELOCITY), 0);
    assert_eq!(of(POSITION), 1);
}

#[test]
fn hardware_without_interfaces_exports_its_own() {
    let settings = format!("{SETTINGS}    state_interfaces:\n      - position\n");
    let of = |plugin: &str, lift: &str| {
        let robot = robot(lift, lift, "c.yaml").replace("mock_components/GenericSystem", plugin);
        let files = [("urdf/arm.urdf", &*robot), ("config/c.yaml", &settings)];
        found(&files, RULE).len()
    };
    let state = "<state_interface name='velocity'/>";
    assert_eq!(of("drives/BusSystem", ""), 0);
    assert_eq!(of("drives/BusSystem", state), 1);
    assert_eq!(of("mock_components/GenericSystem", ""), 2);
}

#[test]
fn what_gazebo_says_of_a_link_that_was_removed() {
    let of = |link: &str| {
        let robot = format!(
            "<robot name='r'><link name='{link}'/><link name='a'/><joint name='j' type='fixed'><parent link='foot'/>\
             <child link='a'/></joint><gazebo reference='foot'><material>Gazebo/Red</material></gazebo></robot>"
        );
        let found = found(&[("urdf/r.urdf", &robot)], "gazebo-unknown-reference");
        found.first().map(|(_, severity)| *severity)
    };
    assert_eq!(of("pedestal"), Some(Severity::Warning));
    assert_eq!(of("foot"), None);
}
