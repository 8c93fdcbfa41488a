//! What is right, and of no account for those who use the file.
use super::set_aside_tests::found;
use rules::Severity;

const MANIFEST: (&str, &str) = ("package.xml", "<package><name>arm</name></package>");

/// The severity of the first place of a rule in these files.
fn severity(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    found(files, rule).first().map(|found| found.1)
}

#[test]
fn blocks_of_hardware_that_meet_in_the_robot_of_the_assistant() {
    let block = "<ros2_control name='NAME' type='system'><hardware><plugin>mock_components/GenericSystem</plugin></hardware>\
                 <joint name='a'><command_interface name='position'/></joint></ros2_control>";
    let robot = |blocks: &str| {
        format!(
            "<robot name='r'><link name='base'/><link name='tip'/><joint name='a' type='continuous'>\
             <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/></joint>{blocks}</robot>"
        )
    };
    let (one, two) = (block.replace("NAME", "one"), block.replace("NAME", "two"));
    let both = robot(&format!("{one}{two}"));
    let single = robot(&one);
    let of = |launch: &str, assistant: &str| {
        let files = [
            ("arm/package.xml", MANIFEST.1),
            ("arm/urdf/arm.urdf", single.as_str()),
            (
                "config/package.xml",
                "<package><name>arm_config</name></package>",
            ),
            (assistant, "moveit_setup_assistant_config:\n"),
            ("config/config/arm.urdf", both.as_str()),
            ("arm/launch/arm.launch.py", launch),
        ];
        severity("ros2-control-duplicate-joint", &files)
    };
    let starts =
        "get_package_share_directory('arm') + '/urdf/arm.urdf', Node(package='controller_manager')";
    let assistant = "config/.setup_assistant";
    assert_eq!(of(starts, assistant), Some(Severity::Info));
    let shows = starts.replace("controller_manager", "viewer");
    assert_eq!(of(&shows, assistant), Some(Severity::Error));
    // nothing loads this one while another one is controlled
    assert_eq!(of(starts, "config/notes.txt"), Some(Severity::Info));
    assert_eq!(of(&shows, "config/notes.txt"), Some(Severity::Error));
    let own = starts.replace("'arm') + '/urdf", "'arm_config') + '/config");
    assert_eq!(of(&own, assistant), Some(Severity::Error));
}

#[test]
fn names_that_the_spawner_of_gazebo_gives() {
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            (
                "urdf/arm.urdf",
                "<robot name=''><link name='base'/></robot>",
            ),
            ("launch/arm.launch", launch),
        ];
        severity("missing-robot-name", &files)
    };
    let spawns = "<param name='d' textfile='$(find arm)/urdf/arm.urdf'/>\
                  <node pkg='gazebo_ros' type='spawn_model' args='-urdf -model arm -param d'/>";
    assert_eq!(of(spawns), Some(Severity::Info));
    let shows = format!("{spawns}<node pkg='robot_state_publisher'/>");
    assert_eq!(of(&shows), Some(Severity::Error));
    assert_eq!(of(&spawns.replace("-model arm", "")), Some(Severity::Error));
}

#[test]
fn spaces_that_split_no_arguments() {
    let robot = "<robot name='r'><link name='base'/><link name='tip'/><joint name='turn 1' type='continuous'>\
                 <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/></joint></robot>";
    let manifest = |build: &str| {
        format!("<package><name>arm</name><buildtool_depend>{build}</buildtool_depend></package>")
    };
    let of = |build: &str, others: &[(&str, &str)]| {
        let manifest = manifest(build);
        let own = [("package.xml", manifest.as_str()), ("urdf/arm.urdf", robot)];
        severity("invalid-name", &[&own, others].concat())
    };
    let loads = (
        "launch/arm.launch",
        "<param textfile='$(find arm)/urdf/arm.urdf'/>",
    );
    let starts = (
        "launch/control.launch",
        "<node type='spawner' args='turn 1_controller'/>",
    );
    assert_eq!(of("catkin", &[]), Some(Severity::Warning));
    assert_eq!(of("catkin", &[loads]), Some(Severity::Info));
    assert_eq!(of("catkin", &[loads, starts]), Some(Severity::Warning));
    // nobody can run it
    let loads = (
        "launch/arm.launch.py",
        "get_package_share_directory('arm') + '/urdf/arm.urdf'",
    );
    assert_eq!(of("ament_cmake", &[loads, starts]), Some(Severity::Info));
    let starts = (
        "launch/control.launch.py",
        "Node(executable='spawner', arguments='turn 1_controller'.split())",
    );
    assert_eq!(of("ament_cmake", &[loads, starts]), Some(Severity::Warning));
}

#[test]
fn values_that_a_program_writes() {
    let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:property name='v' value=\"${load_yaml('../made/values.yaml')}\"/><link name='${v}'/></robot>";
    let of = |ignored: &str| {
        let files = [MANIFEST, ("urdf/arm.xacro", robot), (".gitignore", ignored)];
        severity("expression-error", &files)
    };
    assert_eq!(of("/made/\n"), Some(Severity::Info));
    assert_eq!(of("/other/\n"), Some(Severity::Error));
}

#[test]
fn arguments_that_all_calls_give() {
    let robot = "<robot name='$(arg model)' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:arg name='model' default='a'/><link name='base'/></robot>";
    // the function is in another file
    let of = |arguments: &str| {
        let launch =
            format!("content = run_xacro(file='urdf/arm.xacro', arguments={{{arguments}}})");
        let files = [
            MANIFEST,
            ("urdf/arm.xacro", robot),
            ("launch/arm.launch.py", launch.as_str()),
        ];
        severity("use-before-definition", &files)
    };
    assert_eq!(of("'model': model"), Some(Severity::Info));
    let without = of("'other': model");
    assert!(without > Some(Severity::Info), "{without:?}");
}

#[test]
fn packages_in_defaults_that_all_calls_replace() {
    let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:arg name='values' default='$(find sim)/v.yaml'/><link name='base'/></robot>";
    let of = |launch: &str| {
        let files = [
            ("arm/package.xml", MANIFEST.1),
            ("sim/package.xml", "<package><name>sim</name></package>"),
            ("arm/urdf/arm.xacro", robot),
            ("arm/launch/arm.launch", launch),
        ];
        severity("missing-package-dependency", &files)
    };
    let gives = "<launch><param name='d' command=\"xacro '$(find arm)/urdf/arm.xacro' values:=x.yaml\"/></launch>";
    assert_eq!(of(gives), Some(Severity::Info));
    assert_eq!(
        of(&gives.replace(" values:=x.yaml", "")),
        Some(Severity::Warning)
    );
    assert_eq!(of(""), Some(Severity::Warning));
}

#[test]
fn launch_files_of_packages_that_were_put_aside() {
    let gone =
        "<launch>\n<param name='d' command=\"xacro '$(find arm)/urdf/gone.xacro'\"/>\n</launch>";
    let robot = "<robot name='arm'><link name='base'/></robot>";
    let of = |twin: &str, page: &str| {
        let files = [
            ("arm/package.xml", MANIFEST.1),
            ("arm/urdf/arm.urdf", robot),
            (
                "arm/launch/arm.launch",
                "<launch>\n<param textfile='$(find arm)/urdf/arm.urdf'/>\n</launch>",
            ),
            (
                "not_arm/package.xml",
                "<package><name>not_arm</name></package>",
            ),
            (twin, gone),
            ("README.md", page),
        ];
        severity("launched-file-not-found", &files)
    };
    let twin = "not_arm/launch/arm.launch";
    assert_eq!(of(twin, "An arm."), Some(Severity::Info));
    assert_eq!(
        of(twin, "The package not_arm is for the first arm."),
        Some(Severity::Warning)
    );
    // the other package has nothing at this place
    assert_eq!(
        of("not_arm/launch/show.launch", "An arm."),
        Some(Severity::Warning)
    );
}

#[test]
fn robots_whose_packages_are_missing() {
    let robot = "<robot name='r'><link name='base'><visual><geometry><mesh filename='package://far/a.stl'/></geometry></visual></link></robot>";
    let of = |others: &[(&str, &str)]| {
        severity(
            "package-not-found",
            &[&[("a/r.urdf", robot)], others].concat(),
        )
    };
    assert_eq!(of(&[]), Some(Severity::Warning));
    assert_eq!(
        of(&[("a/run.py", "print('no robot')")]),
        Some(Severity::Info)
    );
    // a program that is no part of ROS looks for no packages
    assert_eq!(of(&[("a/run.py", "load('r.urdf')")]), Some(Severity::Info));
    let launch = ("a/run.launch", "<param textfile='a/r.urdf'/>");
    assert_eq!(of(&[launch]), Some(Severity::Warning));
}

#[test]
fn launch_files_that_nobody_runs() {
    let of = |name: &str, build: &str| {
        let manifest = format!(
            "<package><name>arm</name><buildtool_depend>{build}</buildtool_depend></package>"
        );
        let find = match name.ends_with(".xml") {
            true => "find-pkg-share",
            false => "find",
        };
        let gone = format!(
            "<launch><param name='d' command=\"xacro '$({find} arm)/urdf/gone.xacro'\"/></launch>"
        );
        let files = [
            ("package.xml", manifest.as_str()),
            (
                "urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            (name, gone.as_str()),
        ];
        severity("launched-file-not-found", &files)
    };
    assert_eq!(of("launch/arm.launch", "catkin"), Some(Severity::Warning));
    assert_eq!(of("launch/arm.launch", "ament_cmake"), Some(Severity::Info));
    assert_eq!(
        of("launch/arm.launch.xml", "ament_cmake"),
        Some(Severity::Warning)
    );
}

#[test]
fn expressions_in_a_file_that_is_run_through_xacro() {
    let robot = "<robot name='r'><link name='base'><visual><geometry><box size='1 1 ${0.5/2}'/></geometry></visual></link></robot>";
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            ("launch/arm.launch", launch),
        ];
        severity("xacro-tags-in-urdf", &files)
    };
    let through = "<launch><arg name='model' default='$(find arm)/urdf/arm.urdf'/>\
                   <param name='robot_description' command='$(find xacro)/xacro $(arg model)'/></launch>";
    assert_eq!(of(through), Some(Severity::Info));
    let as_it_is =
        "<launch><param name='robot_description' textfile='$(find arm)/urdf/arm.urdf'/></launch>";
    assert_eq!(of(as_it_is), Some(Severity::Error));
    // what xacro made of it lies beside it
    let beside = |source: &str| {
        let made = format!(
            "<!-- |  This document was autogenerated by xacro from {source}  | -->\n<robot name='r'><link name='base'/></robot>"
        );
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            ("urdf/arm_made.urdf", made.as_str()),
        ];
        severity("xacro-tags-in-urdf", &files)
    };
    assert_eq!(beside("arm.urdf"), Some(Severity::Info));
    assert_eq!(beside("hand.urdf"), Some(Severity::Error));
}

#[test]
fn robots_whose_name_says_that_they_are_copies() {
    let robot = "<robot name='r'><link name='a'/><link name='a'/></robot>";
    let of = |path: &str| severity("duplicate-link-name", &[MANIFEST, (path, robot)]);
    assert_eq!(of("urdf/arm.urdf"), Some(Severity::Error));
    assert_eq!(of("urdf/arm copy.urdf"), Some(Severity::Info));
}

#[test]
fn paths_with_backslashes() {
    let of = |path: &str| {
        let launch = format!(
            "<launch><param name='robot_description' command='$(find xacro)/xacro \"$(find arm)/{path}\"'/></launch>"
        );
        let files = [
            MANIFEST,
            (
                "urdf/arm.urdf",
                "<robot name='r'><link name='base'/></robot>",
            ),
            ("launch/arm.launch", launch.as_str()),
        ];
        severity("launched-file-not-found", &files)
    };
    assert_eq!(of("urdf\\arm.urdf"), Some(Severity::Info));
    assert_eq!(of("urdf/hand.urdf"), Some(Severity::Warning));
    assert_eq!(of("urdf/arm.urdf"), None);
}

#[test]
fn tags_without_prefix_in_a_container_of_an_old_distribution() {
    let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:macro name='base'><link name='base'/></xacro:macro><base/></robot>";
    let of = |container: &str| {
        let files = [
            (
                "ros/package.xml",
                "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
            ),
            ("ros/urdf/arm.urdf.xacro", robot),
            ("Dockerfile", container),
        ];
        severity("unprefixed-macro-call", &files)
    };
    assert_eq!(
        of("FROM ubuntu\nRUN apt-get install ros-indigo-xacro"),
        Some(Severity::Info)
    );
    assert_eq!(of("FROM ros:noetic"), Some(Severity::Error));
    assert_eq!(
        of("FROM ros:noetic\nRUN ls /opt/ros/indigo"),
        Some(Severity::Error)
    );
}

#[test]
fn tags_without_prefix_where_the_first_page_installs_an_old_distribution() {
    let robot = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
                 <xacro:macro name='base'><link name='base'/></xacro:macro><base/></robot>";
    let of = |page: &str| {
        let files = [
            (
                "src/arm/package.xml",
                "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
            ),
            ("src/arm/urdf/arm.urdf.xacro", robot),
            ("src/camera/README.md", "apt install ros-noetic-camera"),
            ("README.md", page),
        ];
        severity("unprefixed-macro-call", &files)
    };
    assert_eq!(
        of("source /opt/ros/melodic/setup.bash"),
        Some(Severity::Info)
    );
    assert_eq!(of("apt install ros-noetic-xacro"), Some(Severity::Error));
    assert_eq!(
        of("apt install ros-melodic-xacro or ros-noetic-xacro"),
        Some(Severity::Error)
    );
}

#[test]
fn files_of_a_distribution_that_is_not_here() {
    let of = |path: &str| {
        let robot = format!(
            "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\
             <xacro:property name='limits' value=\"${{xacro.load_yaml('{path}')}}\"/><link name='base'/>\
             <link name='${{limits[0]}}'/></robot>"
        );
        let files = [MANIFEST, ("urdf/arm.urdf.xacro", robot.as_str())];
        severity("expression-error", &files)
    };
    assert_eq!(
        of("/opt/ros/humble/share/no_such_package/limits.yaml"),
        Some(Severity::Info)
    );
    assert_eq!(of("/no/such/limits.yaml"), Some(Severity::Error));
}

#[test]
fn srdfs_that_only_tests_name() {
    let arm = "<robot name='arm'><link name='base'/><link name='tip'/><joint name='elbow' type='revolute'>\
               <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/>\
               <limit lower='-1' upper='1' effort='1' velocity='2'/></joint></robot>";
    let srdf = "<robot name='arm'><group name='arm'><joint name='elbow'/></group>\
                <group_state name='bent' group='arm'><joint name='elbow' value='2'/></group_state></robot>";
    let of = |folder: &str, by: &str| {
        let [urdf, own] = ["urdf", "srdf"].map(|kind| format!("{folder}/arm.{kind}"));
        let files = [
            MANIFEST,
            (urdf.as_str(), arm),
            (own.as_str(), srdf),
            (by, &format!("\"{urdf}\", \"{own}\"")),
        ];
        severity("srdf-state-out-of-limits", &files)
    };
    assert_eq!(of("tests/arms", "tests/api.cpp"), Some(Severity::Info));
    assert_eq!(of("tests/arms", "src/node.cpp"), Some(Severity::Error));
    assert_eq!(of("config", "tests/api.cpp"), Some(Severity::Error));
}

#[test]
fn wheels_that_are_meshes() {
    // from corner to corner of a box
    let mesh = |[x, y, z]: [f64; 3]| {
        let facet = |points: [[f64; 3]; 3]| {
            let vertex = |[x, y, z]: [f64; 3]| format!("vertex {x} {y} {z}\n");
            let points: String = points.map(vertex).concat();
            format!("facet normal 0 0 0\nouter loop\n{points}endloop\nendfacet\n")
        };
        let (low, high) = ([-x, -y, -z], [x, y, z]);
        let sides = [
            facet([low, [x, -y, -z], high]),
            facet([low, high, [-x, y, z]]),
        ];
        format!("solid w\n{}endsolid w\n", sides.concat())
    };
    let of = |mesh: &str, diameter: &str| {
        let wheel = |side: &str, y: &str| {
            format!(
                "<link name='{side}'><visual><geometry><mesh filename='package://cart/wheel.stl'/></geometry></visual></link>\
                 <joint name='{side}_joint' type='continuous'><origin xyz='0 {y} 0'/><parent link='base'/><child link='{side}'/>\
                 <axis xyz='0 1 0'/></joint>"
            )
        };
        let robot = format!(
            "<robot name='cart'><link name='base'/>{}{}<gazebo><plugin name='d' filename='libgazebo_ros_diff_drive.so'>\
             <left_joint>l_joint</left_joint><right_joint>r_joint</right_joint><wheel_diameter>{diameter}</wheel_diameter>\
             </plugin></gazebo></robot>",
            wheel("l", "0.2"),
            wheel("r", "-0.2"),
        );
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("urdf/cart.urdf", robot.as_str()),
            ("wheel.stl", mesh),
        ];
        severity("plugin-wheel-mismatch", &files)
    };
    let round = mesh([0.1, 0.02, 0.1]);
    assert_eq!(of(&round, "0.1"), Some(Severity::Warning));
    assert_eq!(of(&round, "0.2"), None);
    // a wheel with its fork, or a roller
    assert_eq!(of(&mesh([0.1, 0.02, 0.15]), "0.1"), None);
    assert_eq!(of(&mesh([0.1, 0.4, 0.1]), "0.1"), None);
}

#[test]
fn paths_into_the_workspace_of_a_container() {
    let robot = "<robot name='r'><link name='base'><visual><geometry>\
        <mesh filename='file:///opt/ws/src/arm/a.stl'/></geometry></visual></link></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/arm.urdf", robot),
        ];
        severity("absolute-mesh-path", &[&own, others].concat())
    };
    assert_eq!(of(&[]), Some(Severity::Warning));
    assert_eq!(
        of(&[("Dockerfile", "WORKDIR /opt/ws\n")]),
        Some(Severity::Info)
    );
    assert_eq!(
        of(&[("Dockerfile", "WORKDIR /opt\n")]),
        Some(Severity::Warning)
    );
}

#[test]
fn arguments_that_are_keys_of_yaml() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:arg name='arms' default='1'/><xacro:arg name='hand' default='a'/>\
        <link name='base'/><xacro:if value='$(arg with_lidar)'/></robot>";
    let of = |yaml: &str| {
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/arm.xacro", robot),
            (
                "launch/arm.launch",
                "<param command='$(find arm)/load $(find arm)/urdf/arm.xacro'/>",
            ),
            ("config/arm.yaml", yaml),
        ];
        severity("undefined-arg", &files)
    };
    let of_robot = "load_arm:\n  arms: 2\n  hand: b\n  with_lidar: false\n";
    assert_eq!(of(of_robot), Some(Severity::Info));
    assert_eq!(
        of("load_arm:\n  hand: b\n  with_lidar: false\n"),
        Some(Severity::Error)
    );
}

#[test]
fn what_only_controllers_read() {
    let joint = "<joint name='a' type='revolute'><parent link='base'/><child link='tip'/><axis xyz='0 0 1'/>\
                 <limit lower='0' upper='1' effort='9' velocity='1'/><safety_controller soft_lower_limit='-0.5' soft_upper_limit='1' k_velocity='1'/></joint>";
    let robot = format!("<robot name='arm'><link name='base'/><link name='tip'/>{joint}</robot>");
    let of = |starts: &str| {
        let launch = format!("<param textfile='$(find arm)/urdf/arm.urdf'/>{starts}");
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot.as_str()),
            ("launch/arm.launch", &launch),
        ];
        severity("safety-limits-outside-limits", &files)
    };
    let (plans, controls, simulates) = (
        "<node pkg='moveit_ros_move_group'/>",
        "<node pkg='controller_manager'/>",
        "<node pkg='gazebo_ros'/>",
    );
    assert_eq!(of(plans), Some(Severity::Info));
    assert_eq!(of(simulates), Some(Severity::Info));
    assert_eq!(of(controls), Some(Severity::Warning));
    // others may control what is only shown here
    assert_eq!(of(""), Some(Severity::Warning));
}

#[test]
fn robots_for_gazebo_that_nothing_here_simulates() {
    let robot = "<robot name='arm'><link name='base'><inertial><mass value='1'/>\
                 <inertia ixx='0' ixy='0' ixz='0' iyy='0' iyz='0' izz='0'/></inertial></link>\
                 <gazebo><plugin name='p' filename='libgazebo_ros_p3d.so'/></gazebo></robot>";
    let of = |starts: &str| {
        let launch = format!("<param textfile='$(find arm)/urdf/arm.urdf'/>{starts}");
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            ("launch/arm.launch", &launch),
        ];
        severity("zero-inertia", &files)
    };
    assert_eq!(of(""), Some(Severity::Warning));
    assert_eq!(
        of("<node pkg='gazebo_ros' type='spawn_model'/>"),
        Some(Severity::Warning)
    );
    assert_eq!(
        of("<node pkg='moveit_ros_move_group'/>"),
        Some(Severity::Info)
    );
}

#[test]
fn fans_of_ros2_control_before_jazzy() {
    let of = |interface: &str, page: &str| {
        let robot = format!(
            "<robot name='r'><link name='base'/><link name='a'/><joint name='j' type='continuous'><parent link='base'/><child link='a'/></joint>\
             <ros2_control name='c' type='system'><hardware><plugin>x/Y</plugin></hardware><joint name='fan'>\
             <command_interface name='{interface}'/></joint></ros2_control></robot>"
        );
        let files = [
            ("package.xml", "<package><name>r</name></package>"),
            ("README.md", page),
            ("urdf/r.urdf", &robot),
        ];
        severity("ros2-control-unknown-joint", &files)
    };
    assert_eq!(of("state", "For Humble."), Some(Severity::Info));
    assert_eq!(of("state", "For Jazzy."), Some(Severity::Error));
    assert_eq!(of("position", "For Humble."), Some(Severity::Error));
}

#[test]
fn frames_of_sensors_that_a_launch_file_may_place() {
    let robot = "<robot name='r'><link name='base'/><gazebo reference='base'><sensor name='scan' type='gpu_lidar'/></gazebo></robot>";
    let of = |other: &str| {
        let files = [
            MANIFEST,
            ("urdf/r.urdf", robot),
            (
                "launch/sim.launch.py",
                "get_package_share_directory('arm') + '/urdf/r.urdf', Node(package='ros_gz_sim')",
            ),
            ("launch/other.launch.py", other),
        ];
        severity("sensor-without-frame", &files)
    };
    assert_eq!(of("Node(package='slam_toolbox')"), Some(Severity::Warning));
    assert_eq!(
        of("Node(executable='static_transform_publisher')"),
        Some(Severity::Info)
    );
}
