//! What is wrong in the calls of launch files.
use crate::set_aside_tests::found;
use crate::{CheckOptions, Session, Setup};
use rules::Severity;
use vfs::testing::Tree;

const ROBOT: &str = "<robot name='r' xmlns:xacro='x'><xacro:arg name='use_sim' default='false'/>\
                     <xacro:if value='$(arg use_sim)'><xacro:include filename='part.xacro'/></xacro:if><link name='a'/></robot>";

/// Check the calls of a launch file: severity and message of what the rules of launch files say.
fn check_launch(launch: &str, files: &[(&str, &str)], expected: &[&str]) {
    let tree = Tree::new();
    tree.write(
        "arm/package.xml",
        "<package format='3'><name>arm</name></package>",
    );
    tree.write("arm/urdf/arm.urdf.xacro", ROBOT);
    tree.write(
        "arm/urdf/part.xacro",
        "<robot xmlns:xacro='x'><xacro:arg name='inner' default=''/></robot>",
    );
    tree.write(
        "bringup/package.xml",
        "<package format='3'><name>bringup</name></package>",
    );
    tree.write("bringup/launch/arm.launch.py", launch);
    for (name, text) in files {
        tree.write(name, text);
    }
    let (about, folders) = (tree.root().to_owned(), vec![tree.root().to_owned()]);
    let setup = Setup {
        about,
        folders,
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let options = CheckOptions {
        paths: vec![tree.root().to_owned()],
        ..CheckOptions::default()
    };
    let report = crate::check(&session, &options);
    let found = report
        .findings
        .iter()
        .filter(|f| ["PKG009", "PKG010", "PKG018"].contains(&f.rule.code));
    let found: Vec<String> = found
        .map(|f| {
            let text = session.vfs.text(&session.vfs.path(f.span.file)).unwrap();
            let help = f.help.clone().unwrap_or_default();
            let near = ["did you mean ", "correct the path: "]
                .iter()
                .find_map(|lead| help.strip_prefix(lead))
                .unwrap_or("");
            format!(
                "{} {} @{} {near}",
                f.severity,
                f.message,
                f.span.range.slice(&text.text)
            )
        })
        .collect();
    let found: Vec<&str> = found.iter().map(|text| text.trim_end()).collect();
    assert_eq!(found, expected, "{launch}");
}

fn command(rest: &str) -> String {
    format!("Command(['xacro ', FindPackageShare('arm'), '/urdf/arm.urdf.xacro'{rest}])\n")
}

#[test]
fn arguments_that_no_robot_knows() {
    check_launch(&command(", ' use_sim:=true', ' inner:=1'"), &[], &[]);
    let declared = "DeclareLaunchArgument('colour', default_value='red')\n";
    check_launch(
        &(declared.to_owned()
            + &command(", ' use_simm:=true', ' colour:=', LaunchConfiguration('colour')")),
        &[],
        &[
            "error unknown argument `use_simm` of `arm.urdf.xacro` @use_simm `use_sim`?",
            "warning unknown argument `colour` of `arm.urdf.xacro` @colour",
        ],
    );
    let process = "xacro.process_file(get_package_share_directory('arm') + '/urdf/arm.urdf.xacro', mappings={'colour': 'x'})";
    // nobody who starts it can give another value
    check_launch(
        process,
        &[],
        &["info unknown argument `colour` of `arm.urdf.xacro` @colour"],
    );
    let like = process.replace("colour", "sim_use_case");
    check_launch(
        &like,
        &[],
        &["warning unknown argument `sim_use_case` of `arm.urdf.xacro` @sim_use_case"],
    );
}

#[test]
fn what_was_not_read_may_know_them() {
    for part in [
        "<xacro:include filename='$(find gone)/a.xacro'/>",
        "<xacro:include filename='gone.xacro'/>",
    ] {
        let part = format!("<robot xmlns:xacro='x'>{part}</robot>");
        check_launch(
            &command(", ' colour:=x'"),
            &[("arm/urdf/part.xacro", &part)],
            &["info unknown argument `colour` of `arm.urdf.xacro` @colour"],
        );
    }
}

#[test]
fn launch_files_that_take_any_robot() {
    let launch = "DeclareLaunchArgument('kind', default_value='arm')\nDeclareLaunchArgument('h')\n\
                  Command(['xacro ', FindPackageShare('arm'), '/urdf/', LaunchConfiguration('kind'), '.urdf.xacro', ' hand:=', LaunchConfiguration('h')])\n";
    let hand = "<robot name='h' xmlns:xacro='x'><xacro:arg name='hand' default=''/><link name='$(arg hand)a'/></robot>";
    let include = "IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('bringup'), \
                   '/launch/arm.launch.py']), launch_arguments={'kind': 'hand'}.items())\n";
    let files = [
        ("arm/urdf/hand.urdf.xacro", hand),
        ("bringup/launch/hand.launch.py", include),
    ];
    check_launch(launch, &files, &[]);
    check_launch(
        launch,
        &files[..1],
        &["warning unknown argument `hand` of `arm.urdf.xacro` @hand"],
    );
}

#[test]
fn descriptions_that_are_not_there() {
    let gone = command("").replace("arm.urdf", "gone.urdf");
    check_launch(
        &gone,
        &[],
        &[
            "warning file `$(find arm)/urdf/gone.urdf.xacro` does not exist @'/urdf/gone.urdf.xacro'",
        ],
    );
    check_launch(&gone.replace("'arm'", "'elsewhere'"), &[], &[]);
    check_launch(&gone, &[("arm/urdf/gone.urdf.xacro.in", "<robot/>")], &[]);
    let misspelled = command("").replace("arm.urdf", "Arm.urdf");
    check_launch(
        &misspelled,
        &[],
        &[
            "warning file `$(find arm)/urdf/Arm.urdf.xacro` does not exist @'/urdf/Arm.urdf.xacro' \
             there is `urdf/arm.urdf.xacro`",
        ],
    );
}

#[test]
fn descriptions_that_are_loaded_as_they_are() {
    let load = "open(get_package_share_directory('arm') + '/urdf/gone.urdf').read()\n";
    let gone = "warning file `$(find arm)/urdf/gone.urdf` does not exist @'/urdf/gone.urdf'";
    check_launch(load, &[], &[gone]);
    check_launch(load, &[("arm/urdf/gone.urdf", "<robot/>")], &[]);
    check_launch(&load.replace("'arm'", "'elsewhere'"), &[], &[]);
    // a program that makes the file, or looks for it
    check_launch(&format!("{load}os.path.exists(path)"), &[], &[]);
    check_launch(&format!("{load}open(path, 'w')"), &[], &[]);
    let build = "add_custom_command(OUTPUT gone.urdf COMMAND xacro)";
    check_launch(load, &[("arm/CMakeLists.txt", build)], &[]);
}

#[test]
fn descriptions_for_xacro_that_are_loaded_as_they_are() {
    let read = "open(get_package_share_directory('arm') + '/urdf/arm.urdf.xacro').read()\n";
    let load = &format!("{read}LaunchDescription([])\n");
    let plain = "warning `$(find arm)/urdf/arm.urdf.xacro` is loaded without xacro, so its xacro elements have no effect \
                 @'/urdf/arm.urdf.xacro'";
    check_launch(load, &[], &[plain]);
    check_launch(&format!("xacro_file = {load}"), &[], &[plain]);
    // a test, say
    check_launch(read, &[], &[]);
    for runs in [
        "import xacro\n",
        "expand_xacro(text)\n",
        "Command(['xacro ', p])\n",
        "Command([clean_up, ' ', p])\n",
    ] {
        check_launch(&format!("{load}{runs}"), &[], &[]);
    }
    check_launch(&format!("{load}Command(['cat ', p])\n"), &[], &[plain]);
    let values =
        "<robot name='r' xmlns:xacro='x'><xacro:arg name='a' default='1'/><link name='a'/></robot>";
    check_launch(load, &[("arm/urdf/arm.urdf.xacro", values)], &[]);
    let used = values.replace("<link name='a'/>", "<link name='$(arg a)'/>");
    check_launch(load, &[("arm/urdf/arm.urdf.xacro", &used)], &[plain]);
    // a block that is inserted outside of a macro is left over
    let left_over = "<robot name='r' xmlns:xacro='x'><link name='a'><xacro:insert_block name='origin'/></link></robot>";
    check_launch(load, &[("arm/urdf/arm.urdf.xacro", left_over)], &[]);
}

#[test]
fn descriptions_that_the_same_launch_file_expands_too() {
    let path = "$(find arm)/urdf/arm.urdf.xacro";
    let load = format!("<param name='robot_description' textfile='{path}'/>");
    let of = |more: &str, expected: &[&str]| {
        let launch = format!("<launch>{load}{more}</launch>");
        check_launch("", &[("bringup/launch/view.launch", &launch)], expected);
    };
    of(
        "",
        &[
            "warning `$(find arm)/urdf/arm.urdf.xacro` is loaded without xacro, so its xacro elements have no effect \
             @$(find arm)/urdf/arm.urdf.xacro",
        ],
    );
    of(
        &format!("<param name='robot_description' command='xacro {path}'/>"),
        &[],
    );
}

#[test]
fn arguments_of_a_robot_that_its_srdf_gets_as_well() {
    let robot = "<robot name='arm' xmlns:xacro='x'><xacro:arg name='size' default='1'/><link name='a$(arg size)'/></robot>";
    let srdf = "<robot name='arm' xmlns:xacro='x'/>";
    let call = |name: &str, file: &str| {
        format!("<param name='{name}' command='xacro $(find arm)/{file} size:=2'/>")
    };
    let check = |calls: &str, expected: Severity| {
        let launch = format!("<launch>{calls}</launch>");
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/arm.urdf.xacro", robot),
            ("config/arm.srdf.xacro", srdf),
            ("launch/view.launch", &launch),
        ];
        let found = found(&files, "unknown-launch-argument");
        let severities: Vec<Severity> = found.iter().map(|one| one.1).collect();
        assert_eq!(severities, [expected], "{launch}");
    };
    let own = call("robot_description_semantic", "config/arm.srdf.xacro");
    let both = call("robot_description", "urdf/arm.urdf.xacro") + &own;
    check(&both, Severity::Info);
}

#[test]
fn a_word_without_a_value_leaves_the_default() {
    let robot = "<robot name='arm' xmlns:xacro='x'><xacro:arg name='prefix' default='arm_'/><link name='$(arg prefix)base'/>\
                 <link name='tip'/><joint name='j' type='fixed'><parent link='arm_base'/><child link='tip'/></joint></robot>";
    let count = |word: &str| {
        let launch = format!(
            "<launch><param name='robot_description' command='xacro $(find arm)/urdf/arm.urdf.xacro {word}'/></launch>"
        );
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/arm.urdf.xacro", robot),
            ("launch/view.launch", &launch),
        ];
        found(&files, "undefined-link").len()
    };
    assert_eq!(count("prefix:="), 0);
    assert_eq!(count("prefix:=left_"), 1);
}

#[test]
fn descriptions_that_users_of_a_package_make() {
    let severity = |ignored: &str| {
        let files = [
            ("arm/package.xml", "<package><name>arm</name></package>"),
            (
                "arm/base.urdf",
                "<robot name='base'><link name='base'/></robot>",
            ),
            (
                "arm/launch/view.launch",
                "<launch><param name='robot_description' command='xacro $(find arm)/arm.urdf'/></launch>",
            ),
            (".gitignore", ignored),
        ];
        let found = found(&files, "launched-file-not-found");
        found.first().map(|one| one.1)
    };
    assert_eq!(severity("*.bag\n"), Some(Severity::Warning));
    assert_eq!(severity("arm.urdf\n"), Some(Severity::Info));
}

#[test]
fn transforms_of_joints_that_nobody_publishes() {
    let robot = |plugin: &str| {
        format!(
            "<robot name='cart'><link name='base_link'/><link name='wheel'/><joint name='wheel_joint' type='continuous'>\
             <parent link='base_link'/><child link='wheel'/><axis xyz='0 1 0'/></joint><gazebo><plugin \
             name='drive' filename='libgazebo_ros_diff_drive.so'>{plugin}</plugin></gazebo></robot>"
        )
    };
    let count = |plugin: &str, node: &str| {
        let launch = format!(
            "<launch><param name='robot_description' textfile='$(find cart)/cart.urdf'/>\
             <node name='r' pkg='robot_state_publisher' type='robot_state_publisher'/>\
             <node pkg='tf2_ros' type='static_transform_publisher' name='t' args='0 0.2 0 0 0 0 base_link wheel'/>{node}</launch>"
        );
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("cart.urdf", &robot(plugin)),
            ("launch/view.launch", &launch),
        ];
        found(&files, "duplicate-transform").len()
    };
    let gazebo = "<node pkg='gazebo_ros' type='spawn_model' name='s'/>";
    let states = "<node pkg='joint_state_publisher' type='joint_state_publisher' name='j'/>";
    assert_eq!(count("", ""), 0);
    assert_eq!(count("", gazebo), 0);
    assert_eq!(count("", states), 1);
    assert_eq!(count("<publishWheelTF>true</publishWheelTF>", gazebo), 1);
    assert_eq!(
        count(
            "",
            "<node pkg='controller_manager' type='spawner' name='c'/>"
        ),
        1
    );
}

#[test]
fn arguments_of_a_robot_without_any() {
    let plain = "<robot name='r' xmlns:xacro='x'><xacro:property name='length' value='1'/><link name='a'/></robot>";
    let of = |robot: &str, name: &str| {
        let command = format!("$(find xacro)/xacro $(find arm)/r.urdf.xacro {name}:=$(arg mode)");
        let launch =
            format!("<launch><arg name='mode'/><param name='d' command='{command}'/></launch>");
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("r.urdf.xacro", robot),
            ("launch/a.launch", launch.as_str()),
        ];
        let all = found(&files, "unknown-launch-argument");
        all.first().map(|found| found.1)
    };
    assert_eq!(of(plain, "sim_mode"), Some(Severity::Info));
    // it had the argument once, or has others
    let once = plain.replace("<link", "<!-- <xacro:arg name='sim_mode'/> --><link");
    assert_eq!(of(&once, "sim_mode"), Some(Severity::Warning));
    let other = plain.replace("<link", "<xacro:arg name='other' default=''/><link");
    assert_eq!(of(&other, "sim_mode"), Some(Severity::Warning));
    // robots that start together have the same names without it
    assert_eq!(of(plain, "prefix"), Some(Severity::Warning));
}

#[test]
fn controllers_that_no_parameters_know() {
    const SETTINGS: &str =
        "controller_manager:\n  ros__parameters:\n    go_controller:\n      type: a/B\n";
    let of = |words: &str, path: &str, settings: &str| {
        let launch = format!(
            "Node(package='controller_manager', executable='spawner', arguments=[{words}])\nload('r.urdf')"
        );
        let files = [
            ("package.xml", "<package><name>cart</name></package>"),
            ("r.urdf", "<robot name='r'><link name='a'/></robot>"),
            ("config/controllers.yaml", settings),
            (path, launch.as_str()),
        ];
        let all = found(&files, "spawned-controller-not-found");
        all.first().map(|found| found.1)
    };
    let launch = "launch/a.launch.py";
    assert_eq!(
        of("'go_control'", launch, SETTINGS),
        Some(Severity::Warning)
    );
    assert_eq!(of("'go_controller'", launch, SETTINGS), None);
    assert_eq!(
        of("'go_control', '--param-file', a", launch, SETTINGS),
        None
    );
    // some file has the name, or none is about controllers
    assert_eq!(
        of("'go_control'", launch, &format!("{SETTINGS}# go_control\n")),
        None
    );
    assert_eq!(of("'go_control'", launch, "speed: 1\n"), None);
    assert_eq!(
        of("'go_control'", "old/a.launch.py", SETTINGS),
        Some(Severity::Info)
    );
}

/// Check what a rule says of a launch file for a robot: severities and files.
fn check_files(rule: &str, path: &str, launch: &str, more: &[(&str, &str)], expected: &[&str]) {
    let launch =
        format!("here = get_package_share_directory('cart')\n{launch}\nopen(here + '/r.urdf')");
    let mut files = vec![
        ("package.xml", "<package><name>cart</name></package>"),
        ("r.urdf", "<robot name='r'><link name='a'/></robot>"),
        (path, launch.as_str()),
    ];
    files.extend(more);
    let all = found(&files, rule);
    let shown = all
        .iter()
        .map(|(file, severity)| format!("{severity} {file}"));
    assert_eq!(shown.collect::<Vec<_>>(), expected, "{launch}");
}

#[test]
fn files_that_are_not_there() {
    let check = |launch: &str, more: &[(&str, &str)], expected: &[&str]| {
        let path = "launch/a.launch.py";
        check_files("launched-file-not-found", path, launch, more, expected);
    };
    let node = "Node(package='a', executable='b', parameters=[here + '/config/a.yaml'])";
    check(node, &[], &["warning launch/a.launch.py"]);
    check(node, &[("config/a.yaml", "")], &[]);
    // where it is looked for, it may be made
    check(
        &format!("if os.path.exists(x):\n    pass\n{node}"),
        &[],
        &[],
    );
    // RViz starts without its settings
    let rviz = "Node(package='rviz2', executable='rviz2', arguments=['-d', here + '/a.rviz'])";
    check(rviz, &[], &["info launch/a.launch.py"]);
    let elsewhere = [("rviz/a.rviz", "")];
    check(rviz, &elsewhere, &["warning launch/a.launch.py"]);
    // a package that was renamed or copied
    let other = "other = get_package_share_directory('bot')\nopen(other + '/r.urdf')";
    check(other, &[], &["warning launch/a.launch.py"]);
    let manifest = "<package><name>cart</name><depend>bot</depend></package>";
    check(other, &[("package.xml", manifest)], &[]);
    check(&other.replace("r.urdf", "s.urdf"), &[], &[]);
    // programs of others have settings of the same name
    let others = "other = get_package_share_directory('bot')\nNode(package='a', executable='b', parameters=[other + '/a.yaml'])";
    check(others, &[("a.yaml", "")], &[]);
    // the map is recorded; tests need not run
    let map = "Node(package='a', executable='b', parameters=[here + '/maps/a.yaml'])";
    check(map, &[], &["info launch/a.launch.py"]);
    let path = "test/a.launch.py";
    check_files(
        "launched-file-not-found",
        path,
        node,
        &[],
        &["info test/a.launch.py"],
    );
    // of other packages, launch files are looked at that such a one includes
    let include = "there = get_package_share_directory('tools')\nIncludeLaunchDescription(there + '/launch/b.launch.py')";
    let inner = "from launch import LaunchDescription\nhere = get_package_share_directory('cart')\nNode(package='a', executable='b', parameters=[here + '/config/b.yaml'])";
    let inner = [
        ("package.xml", "<package><name>cart</name></package>"),
        ("tools/package.xml", "<package><name>tools</name></package>"),
        ("tools/launch/b.launch.py", inner),
    ];
    check(include, &inner, &["warning tools/launch/b.launch.py"]);
    check("", &inner, &[]);
}

#[test]
fn files_that_are_not_installed() {
    const AMENT: &str =
        "project(cart)\nament_package()\ninstall(FILES r.urdf DESTINATION share/cart)\n";
    let check = |path: &str, build: &str, expected: &[&str]| {
        let node = "Node(package='a', executable='b', parameters=[here + '/config/a.yaml'])";
        let more = [("config/a.yaml", ""), ("CMakeLists.txt", build)];
        check_files("launched-file-not-installed", path, node, &more, expected);
    };
    let launch = "launch/a.launch.py";
    check(launch, AMENT, &["warning launch/a.launch.py"]);
    let installed = format!("{AMENT}install(DIRECTORY config DESTINATION share/cart)");
    check(launch, &installed, &[]);
    // rules that are not known may be for it; packages for ROS 1 run in their sources, as tests do
    let unknown = format!("{AMENT}install(DIRECTORY ${{FOLDERS}} DESTINATION share/cart)");
    check(launch, &unknown, &[]);
    check(launch, &AMENT.replace("ament", "catkin"), &[]);
    check("test/a.launch.py", AMENT, &["info test/a.launch.py"]);
}
