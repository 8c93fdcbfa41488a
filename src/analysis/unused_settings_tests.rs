//! Which findings in settings of controllers are infos: nothing loads the file.
use super::unused_tests::{severity_below, severity_in};
use rules::Severity;

#[test]
fn settings_that_no_text_names() {
    let robot = "<robot name='r'><link name='base'/><joint name='wheel' type='continuous'><parent link='base'/>\
                 <child link='w'/></joint><link name='w'/><ros2_control name='c' type='system'><hardware>\
                 <plugin>mock_components/GenericSystem</plugin></hardware><joint name='wheel'>\
                 <command_interface name='position'/></joint></ros2_control></robot>";
    let settings = "controller_manager:\n  ros__parameters:\n    go:\n      type: velocity_controllers/JointGroupVelocityController\n\
                    go:\n  ros__parameters:\n    joints:\n      - wheel\n";
    let severity = |launch: &str| {
        let files = [
            (
                "package.xml",
                "<package><name>r</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
            ),
            ("urdf/r.urdf", robot),
            ("config/one.yaml", settings),
            ("config/two.yaml", settings),
            ("launch/r.launch.py", launch),
        ];
        severity_below("", &files, "two.yaml", "controller-unknown-interface")
    };
    assert_eq!(severity("load('r.urdf')"), Some(Severity::Error));
    assert_eq!(severity("load('r.urdf', 'one.yaml')"), Some(Severity::Info));
    assert_eq!(
        severity("load('r.urdf', 'one.yaml')  # 'two.yaml'"),
        Some(Severity::Info)
    );
    assert_eq!(
        severity("load('r.urdf', 'two.yaml')"),
        Some(Severity::Error)
    );
    // a file of that name in another package
    let far = "load('r.urdf', 'one.yaml', '$(find far)/config/two.yaml')";
    assert_eq!(severity(far), Some(Severity::Info));
    assert_eq!(severity(&far.replace("far", "r")), Some(Severity::Error));
}

#[test]
fn settings_without_a_manager_that_no_text_names() {
    let robot = "<robot name='r'><link name='base'/><link name='w'/><joint name='wheel' type='continuous'><parent link='base'/>\
                 <child link='w'/></joint></robot>";
    let settings = "left:\n  go:\n    type: position_controllers/JointPositionController\n    joint: wheel\n\
                    \n  turn:\n    type: position_controllers/JointPositionController\n    joint: fork\n";
    let manager = "controller_manager:\n  ros__parameters:\n    update_rate: 50\n    show:\n      type: joint_state_broadcaster/JointStateBroadcaster\n";
    let severity = |launch: &str| {
        let files = [
            ("urdf/r.urdf", robot),
            ("config/one.yaml", manager),
            ("config/two.yaml", settings),
            ("launch/r.launch", launch),
        ];
        severity_in("controller-unknown-joint", &files)
    };
    let load =
        "<param textfile='$(find r)/urdf/r.urdf'/><rosparam file='$(find r)/config/one.yaml'/>";
    assert_eq!(severity(load), Some(Severity::Info));
    let both = load.replace(
        "one.yaml'/>",
        "one.yaml'/><rosparam file='$(find r)/config/two.yaml'/>",
    );
    assert_eq!(severity(&both), Some(Severity::Error));
}

#[test]
fn settings_that_nothing_can_load() {
    let robot = "<robot name='r'><link name='base'/><link name='w'/><link name='v'/><joint name='wheel' type='continuous'>\
                 <parent link='base'/><child link='w'/></joint><joint name='lift' type='continuous'><parent link='base'/>\
                 <child link='v'/></joint></robot>";
    let hardware = "<ros2_control name='c' type='system'><hardware><plugin>mock_components/GenericSystem</plugin></hardware>\
                    <joint name='wheel'/></ros2_control></robot>";
    let settings = "controller_manager:\n  ros__parameters:\n    go:\n      type: velocity_controllers/JointGroupVelocityController\n\
                    go:\n  ros__parameters:\n    joints:\n      - wheel\n      - lift\n      - fork\n";
    let manifest =
        "<package><name>r</name><buildtool_depend>ament_cmake</buildtool_depend></package>";
    let severity = |robot: &str, launch: (&str, &str)| {
        let files = [
            ("package.xml", manifest),
            ("urdf/r.urdf", robot),
            ("config/two.yaml", settings),
            launch,
        ];
        severity_below("", &files, "two.yaml", "controller-unknown-joint")
    };
    let load = |text: &'static str| ("launch/r.launch.py", text);
    assert_eq!(
        severity(robot, load("load('r.urdf')")),
        Some(Severity::Info)
    );
    assert_eq!(
        severity(robot, load("load('r.urdf', 'two.yaml')")),
        Some(Severity::Error)
    );
    assert_eq!(
        severity(robot, load("load('r.urdf', kind + '_two.yaml')")),
        Some(Severity::Error)
    );
    let old = "<launch><rosparam file='$(find r)/config/two.yaml'/></launch>";
    assert_eq!(
        severity(robot, ("launch/r.launch", old)),
        Some(Severity::Info)
    );
    // hardware is there: somebody begins
    let with_hardware = robot.replace("</robot>", hardware);
    assert_eq!(
        severity(&with_hardware, load("load('r.urdf')")),
        Some(Severity::Error)
    );
}

#[test]
fn srdfs_that_other_programs_than_moveit_read() {
    let arm = "<robot name='arm'><link name='base'/><link name='tip'/><joint name='elbow' type='revolute'>\
               <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/>\
               <limit lower='-1' upper='1' effort='1' velocity='2'/></joint></robot>";
    let srdf = "<robot name='other'><group name='arm'><joint name='elbow'/></group></robot>";
    let of = |program: &str, launch: &str| {
        let files = [
            ("arm.urdf", arm),
            ("arm.srdf", srdf),
            ("walk.py", program),
            ("launch/a.launch.py", launch),
        ];
        severity_below("", &files, "arm.srdf", "srdf-robot-name")
    };
    let reads = "import pinocchio as pin\npin.loadReferenceConfigurations(model, 'arm.srdf')\npin.buildModelFromUrdf('arm.urdf')\n";
    let launch = "load('arm.urdf', 'arm.srdf')";
    assert_eq!(of(reads, launch), Some(Severity::Info));
    let by_another = reads.replace("pinocchio", "plan");
    assert_eq!(of(&by_another, launch), Some(Severity::Warning));
    let with_moveit = format!("{launch}  # for move_group");
    assert_eq!(of(reads, &with_moveit), Some(Severity::Warning));
}
