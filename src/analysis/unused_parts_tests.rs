//! Which findings are infos in parts of robots that nothing uses.
use super::set_aside_tests::found;
use rules::Severity;

/// The severity of the only place of a rule in a package of these files.
fn severity_in(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    let manifest = (
        "package.xml",
        "<package><name>r</name><buildtool_depend>catkin</buildtool_depend></package>",
    );
    let found = found(&[&[manifest], files].concat(), rule);
    assert!(found.len() < 2, "{found:?}");
    found.first().map(|found| found.1)
}

#[test]
fn macros_that_no_robot_calls() {
    let sensors = "<robot xmlns:xacro='x'><xacro:macro name='camera' params='prefix'><link name='${prefix}camera'/></xacro:macro>\
                   <xacro:macro name='pair' params='name'><xacro:camera frame='${name}'/></xacro:macro></robot>";
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:include filename='sensors.xacro'/><xacro:camera prefix='a_'/></robot>";
    let pair = robot.replace("</robot>", "<xacro:pair name='b'/></robot>");
    let launch = "<param command=\"xacro '$(find r)/urdf/other.urdf.xacro'\"/>";
    let severity = |robot: &str, launch: &str| {
        let other = robot.replace("name='r'", "name='other'");
        let files = [
            ("urdf/sensors.xacro", sensors),
            ("urdf/r.urdf.xacro", robot),
            ("urdf/other.urdf.xacro", other.as_str()),
            ("r.launch", launch),
        ];
        severity_in("missing-macro-param", &files)
    };
    assert_eq!(severity(robot, launch), Some(Severity::Info));
    assert_eq!(severity(&pair, launch), Some(Severity::Error));
    // a library by itself
    assert_eq!(severity(robot, "<launch/>"), Some(Severity::Error));
}

#[test]
fn definitions_behind_their_use() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:part/><xacro:macro name='part'><link name='base'/></xacro:macro></robot>";
    let severity = |command: &str| {
        let launch = format!("<param command=\"{command} '$(find r)/urdf/r.urdf.xacro'\"/>");
        severity_in(
            "use-before-definition",
            &[("urdf/r.urdf.xacro", robot), ("r.launch", &launch)],
        )
    };
    assert_eq!(severity("$(find xacro)/xacro.py"), Some(Severity::Info));
    assert_eq!(
        severity("$(find xacro)/xacro.py --inorder"),
        Some(Severity::Error)
    );
    assert_eq!(severity("$(find xacro)/xacro"), Some(Severity::Error));
}

#[test]
fn files_that_launch_files_pass_on() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:arg name='extra' default=''/><xacro:property name='track' value='1'/>\
                 <xacro:if value=\"${'$(arg extra)' != ''}\"><xacro:include filename='$(arg extra)'/></xacro:if>\
                 <link name='base'/></robot>";
    let extra = "<robot name='e' xmlns:xacro='x'><link name='wheel_${track}'/></robot>";
    let severity = |value: &str| {
        let launch = format!(
            "<launch><param name='d' command=\"xacro '$(find r)/urdf/r.urdf.xacro' extra:={value}\"/></launch>"
        );
        let files = [
            ("urdf/r.urdf.xacro", robot),
            ("urdf/extra.xacro", extra),
            ("r.launch", &launch),
        ];
        severity_in("undefined-property", &files)
    };
    assert_eq!(severity("$(find r)/urdf/extra.xacro"), None);
    assert_eq!(severity("$(find r)/urdf/other.xacro"), Some(Severity::Info));
}

#[test]
fn files_that_the_build_makes() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:include filename='$(find r)/urdf/leg.urdf'/><link name='base'/></robot>";
    let severity = |cmake: &str| {
        severity_in(
            "include-not-found",
            &[("urdf/r.urdf.xacro", robot), ("CMakeLists.txt", cmake)],
        )
    };
    let from_model = "generate_gazebo_urdf_file(${MODELS}/leg.dae)";
    assert_eq!(severity(from_model), Some(Severity::Info));
    assert_eq!(severity("set(PATCHED \"leg.urdf\")"), Some(Severity::Info));
    assert_eq!(
        severity("install(FILES urdf/leg.urdf DESTINATION share/r)"),
        Some(Severity::Error)
    );
    assert_eq!(
        severity(&from_model.replace("leg", "arm")),
        Some(Severity::Error)
    );
}

#[test]
fn macros_that_a_missing_file_may_define() {
    let robot = |include: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:macro name='arm'>{include}<xacro:arm/></xacro:macro><xacro:arm/></robot>"
        )
    };
    let severity = |include: &str| {
        severity_in(
            "infinite-macro-recursion",
            &[("r.urdf.xacro", &robot(include))],
        )
    };
    assert_eq!(
        severity("<xacro:include filename='$(find vendor_arm)/arm.xacro'/>"),
        None
    );
    assert_eq!(severity(""), Some(Severity::Error));
}

#[test]
fn shapes_that_are_commented_out() {
    let link = |body: &str| format!("<robot name='r'><link name='base'>{body}</link></robot>");
    let empty = |body: &str| severity_in("empty-geometry", &[("r.urdf", &link(body))]);
    let missing = |body: &str| severity_in("missing-element", &[("r.urdf", &link(body))]);
    let commented = "<visual><geometry><!-- <box size='1 1 1'/> --></geometry></visual>";
    assert_eq!(empty(commented), Some(Severity::Info));
    assert_eq!(
        missing("<collision><!-- <geometry/> --></collision>"),
        Some(Severity::Info)
    );
    assert_eq!(empty("<visual><geometry/></visual>"), Some(Severity::Error));
    assert_eq!(
        missing("<collision><!-- no shape --></collision>"),
        Some(Severity::Error)
    );
    // urdfdom loses what is behind it
    let collision = "<collision><geometry><box size='1 1 1'/></geometry></collision>";
    assert_eq!(
        empty(&format!("{commented}{collision}")),
        Some(Severity::Error)
    );
}

#[test]
fn transmissions_beside_a_plugin_that_drives() {
    let robot = |plugin: &str| {
        format!(
            "<robot name='r'><link name='base'/><transmission name='t'><type>transmission_interface/SimpleTransmission</type>\
             <joint name='wheel'/></transmission><gazebo><plugin name='p' filename='{plugin}'/></gazebo></robot>"
        )
    };
    let severity = |plugin: &str| {
        severity_in(
            "transmission-unknown-joint",
            &[("r.urdf", robot(plugin).as_str())],
        )
    };
    assert_eq!(
        severity("libgazebo_ros_skid_steer_drive.so"),
        Some(Severity::Info)
    );
    assert_eq!(severity("libgazebo_ros_control.so"), Some(Severity::Error));
}

#[test]
fn moments_about_the_own_joint() {
    let robot = |moments: &str| {
        let leg = |n: u32| {
            format!(
                "<joint name='j{n}' type='continuous'><parent link='base'/><child link='l{n}'/><axis xyz='0 1 0'/></joint>\
                 <link name='l{n}'><inertial><mass value='{n}'/><inertia {moments} ixy='0' ixz='0' iyz='0'/></inertial></link>"
            )
        };
        let legs: String = (1..=3).map(leg).collect();
        format!("<robot name='r'><link name='base'/>{legs}</robot>")
    };
    let severity = |moments: &str| {
        found(
            &[("r.urdf", robot(moments).as_str())],
            "inertia-triangle-inequality",
        )
        .first()
        .map(|found| found.1)
    };
    assert_eq!(
        severity("ixx='0.1' iyy='0.9' izz='0.1'"),
        Some(Severity::Info)
    );
    assert_eq!(
        severity("ixx='0.1' iyy='0.1' izz='0.9'"),
        Some(Severity::Error)
    );
}

#[test]
fn macros_that_take_turns() {
    let gripper = |size: u32| {
        format!(
            "<robot xmlns:xacro='x'><xacro:macro name='gripper' params='p'><link name='${{p}}{size}'/></xacro:macro></robot>"
        )
    };
    let robot = |between: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:include filename='a.xacro'/>{between}<xacro:include filename='b.xacro'/>\
             <xacro:gripper p='b_'/></robot>"
        )
    };
    let severity = |between: &str| {
        let (a, b, robot) = (gripper(85), gripper(140), robot(between));
        severity_in(
            "redefined-macro",
            &[("a.xacro", &a), ("b.xacro", &b), ("r.urdf.xacro", &robot)],
        )
    };
    assert_eq!(severity("<xacro:gripper p='a_'/>"), Some(Severity::Info));
    assert_eq!(severity(""), Some(Severity::Warning));
}

#[test]
fn parts_of_robots_that_are_not_in_use() {
    let part = "<robot name='p' xmlns:xacro='x'><link name='part'><visual/></link></robot>";
    let used = "<robot name='r'><link name='base'/></robot>";
    let robot = "<robot name='old' xmlns:xacro='x'><xacro:include filename='part.xacro'/></robot>";
    let severity = |launch: &str| {
        let files = [
            ("urdf/part.xacro", part),
            ("urdf/first.xacro", robot),
            ("urdf/used.urdf", used),
            ("r.launch", launch),
        ];
        severity_in("missing-element", &files)
    };
    assert_eq!(
        severity("<param textfile='$(find r)/urdf/used.urdf'/>"),
        Some(Severity::Info)
    );
    assert_eq!(
        severity("<param textfile='$(find r)/urdf/used.urdf'/><!-- first.xacro -->"),
        Some(Severity::Info)
    );
    let both = "<param textfile='$(find r)/urdf/used.urdf'/><param command=\"xacro '$(find r)/urdf/first.xacro'\"/>";
    assert_eq!(severity(both), Some(Severity::Error));
}
