//! What launch files and programs do with robots decides what is worth a warning.
use super::set_aside_tests::found;
use rules::Severity;

const MANIFEST: (&str, &str) = ("package.xml", "<package><name>arm</name></package>");

/// A robot with moments of inertia that no body has.
const IMPOSSIBLE: &str = "<robot name='r'><link name='base'><inertial><mass value='1'/>\
    <inertia ixx='1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link></robot>";

/// The severity of the first place of a rule in these files.
fn severity(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    found(files, rule).first().map(|found| found.1)
}

#[test]
fn inertia_that_nothing_computes_with() {
    let of = |launch: &str, others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            ("urdf/arm.urdf", IMPOSSIBLE),
            ("launch/arm.launch", launch),
        ];
        severity("inertia-triangle-inequality", &[&own, others].concat())
    };
    let plans = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>";
    assert_eq!(of(plans, &[]), Some(Severity::Info));
    // what is only shown here may be simulated by others
    let shows = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='rviz'/>";
    assert_eq!(of(shows, &[]), Some(Severity::Warning));
    let simulates = "<include file='$(find gazebo_ros)/launch/empty_world.launch'/>";
    assert_eq!(
        of(plans, &[("launch/sim.launch", simulates)]),
        Some(Severity::Warning)
    );
    // Gazebo Classic takes the tensor, and Gazebo Sim refuses the robot
    let refuses = "Node(package='ros_gz_sim', executable='create')";
    assert_eq!(
        of(plans, &[("launch/sim.launch.py", refuses)]),
        Some(Severity::Error)
    );
    assert_eq!(
        of(plans, &[("scripts/hold.py", "import pinocchio")]),
        Some(Severity::Warning)
    );
    // a robot for Gazebo that it is a part of, and another one
    let simulated = |includes: &str| {
        let robot = format!(
            "<robot name='s' xmlns:xacro='x'>{includes}<gazebo><plugin name='p' filename='p.so'/></gazebo></robot>"
        );
        of(plans, &[("urdf/sim.xacro", robot.as_str())])
    };
    assert_eq!(
        simulated("<xacro:include filename='arm.urdf'/>"),
        Some(Severity::Warning)
    );
    assert_eq!(simulated(""), Some(Severity::Info));
    // a sign that is lost is a slip, whoever reads it
    let negative = IMPOSSIBLE.replace("iyy='0.1'", "iyy='-0.1'");
    let files = [
        MANIFEST,
        ("urdf/arm.urdf", negative.as_str()),
        ("launch/arm.launch", plans),
    ];
    assert_eq!(
        severity("inertia-not-positive-definite", &files),
        Some(Severity::Warning)
    );
}

#[test]
fn triangles_that_nothing_computes_with() {
    const TRIANGLES: usize = 20_001;
    let mesh = format!(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n{}",
        "f 1 2 3\n".repeat(TRIANGLES)
    );
    let robot = "<robot name='r'><link name='base'><collision><geometry><mesh filename='package://arm/a.obj'/></geometry>\
                 </collision></link></robot>";
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            ("a.obj", mesh.as_str()),
            ("launch/arm.launch", launch),
        ];
        severity("collision-mesh-too-detailed", &files)
    };
    let shows = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='rviz'/>";
    assert_eq!(of(shows), Some(Severity::Info));
    let plans = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>";
    assert_eq!(of(plans), Some(Severity::Warning));
    // nothing here says what it is for
    assert_eq!(of("<launch/>"), Some(Severity::Warning));
}

#[test]
fn inertia_of_another_robot_than_the_simulated_one() {
    let of = |loads: &str, simulates: &str| {
        let files = [
            MANIFEST,
            ("urdf/real.urdf", IMPOSSIBLE),
            (
                "urdf/sim.urdf",
                "<robot name='s'><link name='base'/></robot>",
            ),
            ("launch/real.launch", loads),
            ("launch/sim.launch", simulates),
        ];
        severity("inertia-triangle-inequality", &files)
    };
    let loads = "<param textfile='$(find arm)/urdf/real.urdf'/><node pkg='driver'/>";
    let simulates = "<param textfile='$(find arm)/urdf/sim.urdf'/><include file='$(find gazebo_ros)/x.launch'/>";
    assert_eq!(of(loads, simulates), Some(Severity::Info));
    // a launch file that simulates includes the one that loads it
    let includes = format!("{simulates}<include file='$(find arm)/launch/real.launch'/>");
    assert_eq!(of(loads, &includes), Some(Severity::Warning));
    assert_eq!(
        of(loads, &simulates.replace("sim.urdf", "real.urdf")),
        Some(Severity::Warning)
    );
}

#[test]
fn robots_that_only_programs_load() {
    let of = |program: &str, launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", IMPOSSIBLE),
            (
                "urdf/other.urdf",
                "<robot name='o'><link name='o'/></robot>",
            ),
            ("scripts/reach.py", program),
            ("launch/all.launch", launch),
        ];
        severity("inertia-triangle-inequality", &files)
    };
    // another robot is simulated with Gazebo Sim
    let simulates = "<node pkg='ros_gz_sim'/><param textfile='$(find arm)/urdf/other.urdf'/>";
    let reaches = "robot = ikpy.Chain.from_urdf_file('urdf/arm.urdf')";
    assert_eq!(of(reaches, simulates), Some(Severity::Info));
    let moves = "import mujoco\nmodel = load('urdf/arm.urdf')";
    assert_eq!(of(moves, simulates), Some(Severity::Error));
    let launches = simulates.replace("other.urdf", "arm.urdf");
    assert_eq!(of(reaches, &launches), Some(Severity::Error));
}

#[test]
fn robots_that_nothing_loads_beside_others() {
    let robot =
        "<robot name='r'><link name='base'/><link name='tip'><origin xyz='0 0 1'/></link></robot>";
    let of = |launch: &str, others: &[(&str, &str)]| {
        let own = [
            ("arm/package.xml", MANIFEST.1),
            (
                "arm/urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            ("arm/launch/arm.launch", launch),
            (
                "gripper/package.xml",
                "<package><name>gripper</name></package>",
            ),
            ("gripper/urdf/gripper.xacro", robot),
        ];
        severity("unknown-element", &[&own, others].concat())
    };
    let plans = "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>";
    assert_eq!(of(plans, &[]), Some(Severity::Info));
    // who only shows robots may have them for others
    let shows = plans.replace("moveit_ros_move_group", "rviz");
    assert_eq!(of(&shows, &[]), Some(Severity::Warning));
    // a page tells to use it; a robot that is loaded includes it; a launch file shows any robot
    let page = ("gripper/README.md", "xacro urdf/gripper.xacro");
    assert_eq!(of(plans, &[page]), Some(Severity::Warning));
    let whole = (
        "gripper/urdf/whole.xacro",
        "<robot name='w' xmlns:xacro='x'><xacro:include filename='gripper.xacro'/></robot>",
    );
    let shows_whole = (
        "gripper/launch/whole.launch",
        "<param command='xacro $(find gripper)/urdf/whole.xacro'/>",
    );
    assert_eq!(of(plans, &[whole, shows_whole]), Some(Severity::Warning));
    let shows_any = (
        "gripper/launch/show.launch",
        "<arg name='model'/><param command='xacro $(arg model)'/><node pkg='rviz'/>",
    );
    assert_eq!(of(plans, &[shows_any]), Some(Severity::Warning));
}

#[test]
fn errors_in_robots_that_nothing_loads_beside_others() {
    let of = |rule: &str, inner: &str| {
        let robot = format!("<robot name='g' xmlns:xacro='x'><link name='palm'/>{inner}</robot>");
        let files = [
            ("arm/package.xml", MANIFEST.1),
            (
                "arm/urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            (
                "arm/launch/arm.launch",
                "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>",
            ),
            (
                "gripper/package.xml",
                "<package><name>gripper</name></package>",
            ),
            ("gripper/urdf/gripper.xacro", robot.as_str()),
        ];
        severity(rule, &files)
    };
    assert_eq!(
        of("orphan-link", "<link name='finger'/>"),
        Some(Severity::Info)
    );
    // nobody can load it at all
    let missing = "<xacro:include filename='finger.xacro'/>";
    assert_eq!(of("include-not-found", missing), Some(Severity::Error));
    let computed = "<link name='${finger}'/>";
    assert_eq!(of("undefined-property", computed), Some(Severity::Error));
}

#[test]
fn errors_in_robots_beside_one_of_the_package_that_is_loaded() {
    let of = |loads: &str| {
        let launch = format!(
            "<param textfile='$(find arm)/urdf/{loads}'/><node pkg='moveit_ros_move_group'/>"
        );
        let missing =
            "<robot name='second' xmlns:xacro='x'><xacro:include filename='gone.xacro'/></robot>";
        let files = [
            ("src/arm/package.xml", MANIFEST.1),
            (
                "src/arm/urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            ("src/arm/urdf/second.xacro", missing),
            // any robot of the package may be given to it
            (
                "src/arm/launch/show.launch",
                "<param command='xacro $(arg model)'/>",
            ),
            ("src/run/package.xml", "<package><name>run</name></package>"),
            ("src/run/launch/arm.launch", launch.as_str()),
        ];
        severity("include-not-found", &files)
    };
    assert_eq!(of("arm.urdf"), Some(Severity::Info));
    assert_eq!(of("second.xacro"), Some(Severity::Error));
    assert_eq!(of("none.urdf"), Some(Severity::Error));
}

#[test]
fn gazebo_elements_of_a_flattened_copy() {
    let of = |launch: &str| {
        let robot = |name: &str| {
            format!(
                "<robot name='{name}'><link name='base'/><gazebo><plugin name='p' filename='p.so'/></gazebo>\
                 <gazebo reference='gone'><sensor name='s' type='ray'/></gazebo></robot>"
            )
        };
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", &*robot("arm")),
            ("urdf/arm.urdf.xacro", &*robot("arm")),
            (
                "launch/plan.launch",
                "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>",
            ),
            ("launch/run.launch", launch),
        ];
        let places = found(&files, "gazebo-unknown-reference");
        let own = places.iter().find(|(name, _)| name == "urdf/arm.urdf");
        own.map(|found| found.1)
    };
    let simulates =
        "<param command='xacro $(find arm)/urdf/arm.urdf.xacro'/><node pkg='gazebo_ros'/>";
    assert_eq!(of(simulates), Some(Severity::Info));
    assert_eq!(of("<node pkg='gazebo_ros'/>"), Some(Severity::Warning));
}

#[test]
fn references_of_gazebo_that_some_calls_lack() {
    let robot = "<robot name='arm' xmlns:xacro='x'><xacro:arg name='laser' default='true'/><link name='base'/>\
        <xacro:macro name='mount' params='n'><link name='${n}_mount'/><joint name='${n}' type='fixed'>\
        <parent link='base'/><child link='${n}_mount'/></joint></xacro:macro>\
        <xacro:if value='$(arg laser)'><xacro:mount n='laser'/></xacro:if>\
        <gazebo reference='laser_mount'><sensor name='s' type='ray'/></gazebo></robot>";
    let of = |calls: &[&str]| {
        let call = |laser: &&str| {
            format!(
                "<param command='xacro $(find arm)/urdf/arm.xacro laser:={laser}'/><node pkg='gazebo_ros'/>"
            )
        };
        let launch: String = calls.iter().map(call).collect();
        let launch = format!("<launch>{launch}</launch>");
        let files = [
            MANIFEST,
            ("urdf/arm.xacro", robot),
            ("launch/run.launch", launch.as_str()),
        ];
        severity("gazebo-unknown-reference", &files)
    };
    assert_eq!(of(&["false"]), Some(Severity::Warning));
    assert_eq!(of(&["false", "true"]), Some(Severity::Info));
    assert_eq!(of(&["true"]), None);
}

#[test]
fn simulators_with_models_of_their_own() {
    let of = |others: &[(&str, &str)]| {
        let own = [
            MANIFEST,
            ("urdf/arm.urdf", IMPOSSIBLE),
            (
                "launch/arm.launch",
                "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='mujoco_ros2_control'/>",
            ),
        ];
        severity("inertia-triangle-inequality", &[&own, others].concat())
    };
    assert_eq!(of(&[]), Some(Severity::Error));
    let model = ("mjcf/arm.xml", "<mujoco model='arm'><worldbody/></mujoco>");
    assert_eq!(of(&[model]), Some(Severity::Info));
    // the launch file that an exporter writes, unless something starts it
    let export = (
        "launch/gazebo.launch",
        "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='gazebo_ros'/>",
    );
    assert_eq!(of(&[model, export]), Some(Severity::Info));
    let starts = (
        "launch/all.launch",
        "<include file='$(find arm)/launch/gazebo.launch'/>",
    );
    assert!(of(&[model, export, starts]) > Some(Severity::Info));
}

#[test]
fn parts_that_are_simulated_alone() {
    let of = |loads: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.xacro", IMPOSSIBLE),
            (
                "urdf/planned.xacro",
                "<robot name='p' xmlns:xacro='x'><xacro:include filename='arm.xacro'/></robot>",
            ),
            (
                "launch/plan.launch",
                "<param command='xacro $(find arm)/urdf/planned.xacro'/><node pkg='moveit_ros_move_group'/>",
            ),
            ("launch/sim.launch", loads),
        ];
        severity("inertia-triangle-inequality", &files)
    };
    assert_eq!(of(""), Some(Severity::Info));
    // a launch file that spawns what another one loads belongs to all robots of its package
    assert!(of("<node pkg='gazebo_ros'/>") > Some(Severity::Info));
    let simulates = "<param command='xacro $(find arm)/urdf/arm.xacro'/><node pkg='gazebo_ros'/>";
    assert!(of(simulates) > Some(Severity::Info));
}

#[test]
fn transmissions_that_nothing_reads() {
    let robot = "<robot name='arm'><link name='base'/><link name='tip'/><joint name='turn' type='continuous'>\
        <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/></joint>\
        <transmission name='t'><type>transmission_interface/SimpleTransmission</type><joint name='other'>\
        <hardwareInterface>PositionJointInterface</hardwareInterface></joint><actuator name='m'/></transmission></robot>";
    let of = |launch: &str, others: &[(&str, &str)]| {
        let own = [
            (
                "package.xml",
                "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>",
            ),
            ("urdf/arm.urdf", robot),
            ("launch/arm.launch", launch),
        ];
        severity("transmission-unknown-joint", &[&own, others].concat())
    };
    let loads = |node: &str| {
        format!("<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='{node}' type='go'/>")
    };
    assert_eq!(
        of(&loads("moveit_ros_move_group"), &[]),
        Some(Severity::Info)
    );
    // what is only shown here may be controlled by others
    assert_eq!(of(&loads("rviz"), &[]), Some(Severity::Warning));
    assert_eq!(of(&loads("controller_manager"), &[]), Some(Severity::Error));
    assert_eq!(of(&loads("gazebo_ros"), &[]), Some(Severity::Error));
    let starts = (
        "launch/control.launch",
        "<include file='$(find arm)/launch/arm.launch'/><node pkg='controller_manager'/>",
    );
    assert_eq!(of(&loads("rviz"), &[starts]), Some(Severity::Error));
    assert_eq!(of("", &[]), Some(Severity::Error));
}

#[test]
fn plugins_of_ros_1_where_something_starts_gazebo_classic() {
    let of = |shows: &str, starts: &str| {
        let ament = |name: &str| {
            format!(
                "<package><name>{name}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
            )
        };
        let (arm, sim) = (ament("arm"), ament("sim"));
        let robot = "<robot name='r'><link name='base'/><gazebo><plugin name='c' filename='libgazebo_ros_control.so'/></gazebo></robot>";
        let files = [
            ("arm/package.xml", arm.as_str()),
            ("sim/package.xml", sim.as_str()),
            ("arm/urdf/arm.urdf", robot),
            (
                "sim/urdf/cart.urdf",
                "<robot name='c'><link name='c'/></robot>",
            ),
            ("arm/launch/show.launch.py", shows),
            ("sim/launch/sim.launch.py", starts),
        ];
        severity("ros1-gazebo-plugin", &files)
    };
    let load = |file: &str| {
        let package = if file == "cart.urdf" { "sim" } else { "arm" };
        format!("open(get_package_share_directory('{package}') + '/urdf/{file}')")
    };
    let shows = format!("{}\nNode(package='rviz2')", load("arm.urdf"));
    let starts = |file: &str| {
        format!(
            "{}\nNode(package='gazebo_ros', executable='spawn_entity.py')",
            load(file)
        )
    };
    assert_eq!(of(&shows, &starts("arm.urdf")), Some(Severity::Warning));
    assert_eq!(of(&shows, &starts("cart.urdf")), Some(Severity::Info));
    let selects = format!(
        "{}\nDeclareLaunchArgument('model', choices=['arm', 'cart'])",
        starts("cart.urdf")
    );
    assert_eq!(of(&shows, &selects), Some(Severity::Warning));
}

#[test]
fn limits_of_minus_one_that_no_controller_reads() {
    let robot = "<robot name='r'><link name='base'/><link name='tip'/><joint name='j' type='revolute'><parent link='base'/>\
        <child link='tip'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='-1' velocity='1'/></joint></robot>";
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", robot),
            ("launch/arm.launch", launch),
        ];
        severity("joint-limit-negative", &files)
    };
    let simulates =
        "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='gazebo_ros' type='spawn_model'/>";
    assert_eq!(of(simulates), Some(Severity::Info));
    let controls = format!("{simulates}<node pkg='controller_manager' type='spawner'/>");
    assert_eq!(of(&controls), Some(Severity::Warning));
    // nothing says what it is for
    assert_eq!(of("<launch/>"), Some(Severity::Warning));
}

#[test]
fn launch_files_of_an_exporter_that_nothing_starts() {
    const MOMENTS: &str = "inertia-triangle-inequality";
    const EXPORTED: &str = "<node name='spawn_model' args='-file $(find arm)/urdf/arm.urdf -urdf -model arm'/>\
        <include file='$(find gazebo_ros)/launch/empty_world.launch'/><node name='fake_joint_calibration'/>";
    const PLANS: &str =
        "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>";
    let of = |others: &[(&str, &str)]| {
        let own = [
            ("arm/package.xml", MANIFEST.1),
            ("arm/urdf/arm.urdf", IMPOSSIBLE),
            ("arm/launch/gazebo.launch", EXPORTED),
        ];
        severity(MOMENTS, &[&own, others].concat())
    };
    assert_eq!(
        of(&[("arm/launch/real.launch", PLANS)]),
        Some(Severity::Info)
    );
    // people wrote nothing else, it is started, or it is a copy in another package
    let shows = PLANS.replace("moveit_ros_move_group", "rviz");
    assert_eq!(
        of(&[("arm/launch/display.launch", &shows)]),
        Some(Severity::Warning)
    );
    let starts = "<include file='$(find arm)/launch/gazebo.launch'/>";
    let started = [
        ("arm/launch/real.launch", PLANS),
        ("arm/launch/sim.launch", starts),
    ];
    assert_eq!(of(&started), Some(Severity::Warning));
    let copied = [
        ("arm/launch/real.launch", PLANS),
        ("hall/package.xml", "<package><name>hall</name></package>"),
        ("hall/launch/gazebo.launch", EXPORTED),
    ];
    assert_eq!(of(&copied), Some(Severity::Warning));
}

#[test]
fn simulators_that_another_robot_is_started_with() {
    let of = |starts: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", IMPOSSIBLE),
            (
                "urdf/cart.urdf",
                "<robot name='cart'><link name='base'/></robot>",
            ),
            (
                "launch/show.launch",
                "<param textfile='$(find arm)/urdf/arm.urdf'/>",
            ),
            (
                "launch/cart.launch",
                "<param textfile='$(find arm)/urdf/cart.urdf'/>",
            ),
            (
                "launch/world.launch",
                "<include file='$(find gazebo_ros)/launch/empty_world.launch'/>",
            ),
            ("launch/all.launch", starts),
        ];
        severity("inertia-triangle-inequality", &files)
    };
    let starts = |robot: &str| {
        format!(
            "<include file='$(find arm)/launch/{robot}.launch'/><include file='$(find arm)/launch/world.launch'/>"
        )
    };
    assert_eq!(of(&starts("cart")), Some(Severity::Info));
    assert_eq!(of(&starts("show")), Some(Severity::Warning));
    // nothing says which robot it is for
    assert_eq!(of("<launch/>"), Some(Severity::Warning));
}

#[test]
fn robots_that_only_a_left_over_launch_file_loads() {
    let negative = IMPOSSIBLE.replace("iyy='0.1'", "iyy='-0.1'");
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            ("urdf/arm.urdf", negative.as_str()),
            (
                "urdf/cart.urdf",
                "<robot name='cart'><link name='base'/></robot>",
            ),
            (launch, "<param textfile='$(find arm)/urdf/arm.urdf'/>"),
            (
                "launch/cart.launch",
                "<param textfile='$(find arm)/urdf/cart.urdf'/><node pkg='moveit_ros_move_group'/>",
            ),
        ];
        severity("inertia-not-positive-definite", &files)
    };
    assert_eq!(of("launch/arm.launch"), Some(Severity::Warning));
    assert_eq!(of("launch/arm_backup.launch"), Some(Severity::Info));
    // all of it is kept
    let kept = [
        ("old/package.xml", MANIFEST.1),
        ("old/urdf/arm.urdf", negative.as_str()),
        (
            "old/launch/arm.launch",
            "<param textfile='$(find arm)/urdf/arm.urdf'/><node pkg='moveit_ros_move_group'/>",
        ),
    ];
    assert_eq!(
        severity("inertia-not-positive-definite", &kept),
        Some(Severity::Warning)
    );
}
