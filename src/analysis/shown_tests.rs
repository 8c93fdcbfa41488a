//! Robots that are only shown, while others are simulated, and robots that drive.
use super::set_aside_tests::found;
use rules::Severity;

const MANIFEST: (&str, &str) = ("package.xml", "<package><name>arm</name></package>");

/// The severity of the first place of a rule in these files.
fn severity(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    found(files, rule).first().map(|found| found.1)
}

/// A robot with moments of inertia that no body has.
const IMPOSSIBLE: &str = "<robot name='r'><link name='base'><inertial><mass value='1'/>\
    <inertia ixx='1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link></robot>";

const BODY: &str = "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";

const SHAPE: &str = "<collision><geometry><sphere radius='0.1'/></geometry></collision>";

/// A robot for Gazebo of which a link that moves has no inertial.
fn robot(name: &str) -> String {
    format!(
        "<robot name='{name}'><link name='base'/><link name='arm'>{BODY}</link><joint name='b' type='fixed'><parent link='base'/>\
         <child link='arm'/></joint><link name='tip'>{SHAPE}</link><joint name='a' type='continuous'><parent link='base'/>\
         <child link='tip'/><axis xyz='0 0 1'/></joint><gazebo><plugin name='p' filename='p.so'/></gazebo></robot>"
    )
}

#[test]
fn robots_of_which_a_copy_is_simulated() {
    let shows = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='rviz'/>";
    let simulates =
        "<param textfile='$(find arm)/sim/sim.urdf'/><node pkg='gazebo_ros' type='spawn_model'/>";
    let of = |simulated: &str, launch: &str| {
        let (own, other) = (robot("arm"), robot(simulated));
        let complete = other.replace(SHAPE, &format!("{SHAPE}{BODY}"));
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", own.as_str()),
            ("sim/sim.urdf", complete.as_str()),
            ("launch/show.launch", launch),
            ("launch/sim.launch", simulates),
        ];
        severity("missing-inertial", &files)
    };
    assert_eq!(of("arm", shows), Some(Severity::Info));
    // another robot is simulated, and this one
    assert_eq!(of("hand", shows), Some(Severity::Warning));
    let both = shows.replace("rviz", "gazebo_ros");
    assert_eq!(of("arm", &both), Some(Severity::Warning));
}

#[test]
fn robots_that_a_launch_file_finds_by_a_name_that_it_puts_together() {
    let surface = "<robot name='r'><link name='base'><collision><geometry><sphere radius='1'/></geometry>\
                   <surface><friction><ode><mu>0</mu></ode></friction></surface></collision></link></robot>";
    let of = |name: &str, launch: &str| {
        let files = [
            (
                "package.xml",
                "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
            ),
            (name, surface),
            (
                "urdf/other.urdf",
                "<robot name='o'><link name='base'/></robot>",
            ),
            ("launch/arm.launch.py", launch),
            (
                "launch/more.launch.py",
                "get_package_share_directory('arm') + '/urdf/other.urdf'",
            ),
        ];
        severity("sdf-surface", &files)
    };
    let computed = "urdf = os.path.join(get_package_share_directory('arm'), 'urdf', os.environ['MODEL'] + '.xacro')";
    let drives = format!("{computed}\nNode(package='slam_toolbox', executable='async')");
    assert_eq!(of("urdf/base.xacro", &drives), Some(Severity::Info));
    // others may simulate what is only shown
    assert_eq!(of("urdf/base.xacro", computed), Some(Severity::Warning));
    let simulates = format!("{drives}\nNode(package='ros_gz_sim', executable='create')");
    assert_eq!(of("urdf/base.xacro", &simulates), Some(Severity::Warning));
    // the name that is written above
    let set = |model: &str| {
        let launch = simulates.replace("os.environ['MODEL']", "MODEL");
        of("urdf/base.xacro", &format!("MODEL = '{model}'\n{launch}"))
    };
    assert_eq!(set("base"), Some(Severity::Warning));
    assert_eq!(set("arm"), Some(Severity::Info));
}

#[test]
fn what_isaac_gym_reads_otherwise() {
    let robot = "<robot name='r'><link name='base'><visual><geometry><mesh filename='meshes/a.obj'/></geometry></visual>\
                 <inertial><mass value='1'/></inertial></link></robot>";
    let of = |rule: &str, program: &str| {
        let files = [
            ("assets/meshes/b.obj", ""),
            ("assets/urdf/arm.urdf", robot),
            ("tasks/arm.py", program),
        ];
        severity(rule, &files)
    };
    let isaac = "from isaacgym import gymapi\ngym.load_asset(sim, root, 'urdf/arm.urdf')";
    let other = isaac.replace("isaacgym", "viewer").replace("gymapi", "api");
    for rule in ["mesh-not-found", "missing-element"] {
        assert_eq!(of(rule, isaac), Some(Severity::Info), "{rule}");
        assert_eq!(of(rule, &other), Some(Severity::Error), "{rule}");
    }
}

#[test]
fn what_only_gazebo_reads_beside_isaac_gym() {
    let robot = "<robot name='r'><link name='base'><gazebo><selfCollide>true</selfCollide></gazebo><visual><geometry>\
                 <sphere radius='1'/></geometry></visual></link><gazebo><material>Gazebo/Red</material></gazebo></robot>";
    let of = |rule: &str, launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            (
                "tasks/arm.py",
                "from isaacgym import gymapi\nfile = 'urdf/arm.urdf'",
            ),
            ("launch/arm.launch", launch),
        ];
        severity(rule, &files)
    };
    let shows = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='rviz'/>";
    let simulates = shows.replace("rviz", "gazebo_ros");
    for rule in ["unknown-element", "gazebo-missing-reference"] {
        assert_eq!(of(rule, shows), Some(Severity::Info), "{rule}");
        assert_eq!(of(rule, &simulates), Some(Severity::Warning), "{rule}");
    }
}

#[test]
fn meshes_that_a_program_loads_beside_the_launch_file_of_an_exporter() {
    let exported = "<node pkg='gazebo_ros' type='spawn_model' args='-file $(find arm)/urdf/arm.urdf'/>\
                    <node name='fake_joint_calibration'/>";
    let of = |program: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", IMPOSSIBLE),
            ("launch/gazebo.launch", exported),
            ("run.py", program),
        ];
        severity("inertia-triangle-inequality", &files)
    };
    let loads = "kinematics = Chain.from_urdf_file('urdf/arm.urdf')";
    assert_eq!(of(loads), Some(Severity::Info));
    assert_eq!(of("pass"), Some(Severity::Warning));
}

#[test]
fn tags_without_prefix_in_workspaces_of_an_old_distribution() {
    let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><property name='a' value='1'/>\
                 <link name='base'/></robot>";
    let of = |other: (&str, &str)| {
        let catkin =
            "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>";
        let loads = "<param command='$(find xacro)/xacro $(find arm)/urdf/arm.xacro'/>";
        let files = [
            ("package.xml", catkin),
            ("urdf/arm.xacro", robot),
            ("launch/arm.launch", loads),
            other,
        ];
        severity("unprefixed-xacro-tag", &files)
    };
    let plugin =
        "<robot name='s'><gazebo><plugin filename='/opt/ros/kinetic/lib/p.so'/></gazebo></robot>";
    assert_eq!(of(("urdf/s.urdf", plugin)), Some(Severity::Info));
    let newer = plugin.replace("kinetic", "noetic");
    assert_eq!(of(("urdf/s.urdf", &newer)), Some(Severity::Error));
    let shows = "<node pkg=\"robot_state_publisher\" type=\"state_publisher\"/>";
    assert_eq!(of(("launch/show.launch", shows)), Some(Severity::Info));
    let prints = "def show(pose):\n    print pose.x\n";
    assert_eq!(of(("src/show.py", prints)), Some(Severity::Info));
    let prints = prints.replace(" pose.x", "(pose.x)");
    assert_eq!(of(("src/show.py", &prints)), Some(Severity::Error));
}

#[test]
fn no_twin_is_looked_for_among_hundreds_of_robots() {
    let shows = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='rviz'/>";
    let simulates =
        "<param textfile='$(find arm)/sim/sim.urdf'/><node pkg='gazebo_ros' type='spawn_model'/>";
    let of = |others: usize| {
        let (own, twin) = (
            robot("arm"),
            robot("arm").replace(SHAPE, &format!("{SHAPE}{BODY}")),
        );
        let names: Vec<String> = (0..others).map(|n| format!("parts/p{n}.urdf")).collect();
        let mut files = vec![
            MANIFEST,
            ("urdf/arm.urdf", own.as_str()),
            ("sim/sim.urdf", twin.as_str()),
            ("launch/show.launch", shows),
            ("launch/sim.launch", simulates),
        ];
        let part = "<robot name='p'><link name='base'/></robot>";
        files.extend(names.iter().map(|name| (name.as_str(), part)));
        severity("missing-inertial", &files)
    };
    assert_eq!(of(10), Some(Severity::Info));
    assert_eq!(of(300), Some(Severity::Warning));
}

#[test]
fn names_with_a_slash_in_workspaces_of_an_old_distribution() {
    let slashed = "<robot name='r'><link name='/base'/></robot>";
    let of = |plugin: &str| {
        let other =
            format!("<robot name='s'><gazebo><plugin filename='{plugin}'/></gazebo></robot>");
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", slashed),
            ("urdf/s.urdf", other.as_str()),
        ];
        severity("leading-slash-name", &files)
    };
    assert_eq!(of("/opt/ros/kinetic/lib/p.so"), Some(Severity::Info));
    assert_eq!(of("/opt/ros/humble/lib/p.so"), Some(Severity::Warning));
}

#[test]
fn folders_to_install_that_git_leaves_out() {
    let manifest =
        "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>";
    let of = |ignored: &str| {
        let files = [
            ("package.xml", manifest),
            (
                "CMakeLists.txt",
                "project(arm)\nfind_package(ament_cmake REQUIRED)\ninstall(DIRECTORY meshes/ DESTINATION share/${PROJECT_NAME}/meshes)\n",
            ),
            (
                "urdf/arm.urdf",
                "<robot name='r'><link name='base'/></robot>",
            ),
            (".gitignore", ignored),
        ];
        severity("installed-file-not-found", &files)
    };
    assert_eq!(of("meshes/\n"), Some(Severity::Info));
    assert_eq!(of("build/\n"), Some(Severity::Error));
}
