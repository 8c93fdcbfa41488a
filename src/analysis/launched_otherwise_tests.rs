//! Which findings are infos where launch files only show a robot or cannot run, where nothing is built, and where a name is wrong.
use super::unused_tests::severity_below;
use rules::Severity;

const AMENT: &str = "<package format='3'><name>arm_config</name><buildtool_depend>ament_cmake</buildtool_depend></package>";
const CATKIN: &str = "<package format='2'><name>arm_config</name><buildtool_depend>catkin</buildtool_depend></package>";
const SRDF: &str = "<robot name='arm'><group name='arm'><link name='lost'/></group></robot>";
const ASSISTANT: &str = "moveit_setup_assistant_config:\n  URDF:\n    package: arm_config\n    relative_path: config/arm.urdf\n  \
    SRDF:\n    relative_path: config/arm.srdf\n";
const ARM: &str = "<robot name='arm'><link name='base'/></robot>";

/// The robot of an SRDF that has a link which the robot lacks, loaded by this launch file.
fn check_srdf(manifest: &str, (launch, text): (&str, &str), expected: Severity) {
    let files = [
        ("src/arm_config/package.xml", manifest),
        ("src/arm_config/.setup_assistant", ASSISTANT),
        ("src/arm_config/config/arm.srdf", SRDF),
        ("src/arm_config/config/arm.urdf", ARM),
        (launch, text),
    ];
    let found = severity_below("", &files, "arm.srdf", "srdf-unknown-link");
    assert_eq!(found, Some(expected), "{launch}");
}

#[test]
fn an_srdf_that_only_roslaunch_could_load() {
    let ros1 = "<launch><param name='s' textfile=\"$(find arm_config)/config/arm.srdf\"/></launch>";
    let plan = "src/arm_config/launch/plan.launch";
    check_srdf(AMENT, (plan, ros1), Severity::Info);
    let named = "src/arm_config/launch/plan.launch.xml";
    check_srdf(AMENT, (named, ros1), Severity::Info);
    check_srdf(CATKIN, (plan, ros1), Severity::Error);
    let ros2 =
        "<launch><arg name='s' default='$(find-pkg-share arm_config)/config/arm.srdf'/></launch>";
    check_srdf(AMENT, (named, ros2), Severity::Error);
}

#[test]
fn an_srdf_beside_the_sources_of_a_catkin_workspace() {
    let files = |folder: &str| {
        let own = |name: &str| format!("{folder}/arm_config/{name}");
        let launch =
            "<launch><param name='s' textfile='$(find arm_config)/config/arm.srdf'/></launch>";
        let files = [
            (own("package.xml"), CATKIN),
            (own(".setup_assistant"), ASSISTANT),
            (own("config/arm.srdf"), SRDF),
            (own("config/arm.urdf"), ARM),
            (own("launch/plan.launch"), launch),
            ("src/one/package.xml".to_owned(), CATKIN),
            ("src/two/package.xml".to_owned(), CATKIN),
            ("src/three/package.xml".to_owned(), CATKIN),
        ];
        let listed: Vec<(&str, &str)> = files
            .iter()
            .map(|(name, text)| (name.as_str(), *text))
            .collect();
        severity_below("", &listed, "arm.srdf", "srdf-unknown-link")
    };
    assert_eq!(files("src"), Some(Severity::Error));
    assert_eq!(files("kept_aside"), Some(Severity::Info));
}

#[test]
fn a_robot_that_is_only_shown() {
    const ROBOT: &str = "<robot name='arm'><link name='base'/><link name='left'/><link name='right'/>\
        <joint name='l' type='revolute'><parent link='base'/><child link='left'/><axis xyz='0 0 1'/>\
        <limit lower='0' upper='1' effort='1' velocity='1'/></joint>\
        <joint name='r' type='revolute'><parent link='base'/><child link='right'/><axis xyz='0 0 1'/>\
        <limit lower='0' upper='1' effort='1' velocity='1'/><mimic joint='l' multiplier='-1'/></joint></robot>";
    let severity = |launch: &str| {
        let files = [
            ("package.xml", CATKIN),
            ("urdf/arm.urdf", ROBOT),
            ("launch/show.launch", launch),
        ];
        severity_below("", &files, "arm.urdf", "mimic-range-exceeds-limits")
    };
    let show = "<launch><param name='robot_description' textfile='$(find arm_config)/urdf/arm.urdf'/>\
        <node pkg='rviz' type='rviz' name='rviz'/></launch>";
    assert_eq!(severity(show), Some(Severity::Info));
    let spawn = show.replace("rviz", "gazebo_ros");
    assert_eq!(severity(&spawn), Some(Severity::Warning));
    assert_eq!(severity("<launch/>"), Some(Severity::Warning));
}

#[test]
fn a_uri_that_names_the_wrong_package() {
    let severity = |mesh: &str| {
        let robot = format!(
            "<robot name='arm'><link name='base'><visual><geometry><mesh filename='package://arm/{mesh}'/></geometry></visual>\
             </link></robot>"
        );
        let files = [
            ("arm_config/package.xml", CATKIN),
            ("arm_config/urdf/arm.urdf", robot.as_str()),
            ("arm/package.xml", "<package><name>arm</name></package>"),
            ("arm/shapes/base.stl", "solid base\nendsolid base\n"),
        ];
        severity_below("", &files, "arm.urdf", "missing-package-dependency")
    };
    assert_eq!(severity("shapes/base.stl"), Some(Severity::Warning));
    assert_eq!(severity("shapes/gone.stl"), Some(Severity::Warning));
    // declared, it would not be found either
    assert_eq!(severity("meshes/base.stl"), Some(Severity::Info));
}
