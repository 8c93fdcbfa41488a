//! Which findings are infos where nothing in a workspace leads to a file.
use super::{CheckOptions, Session, Setup};
use rules::Severity;
use vfs::testing::Tree;

const BROKEN: &str = "<robot name='r'><link name='base'><visual/></link></robot>";

/// The severity of a rule in one of these files, when a folder of them is checked.
pub(super) fn severity_below(
    folder: &str,
    files: &[(&str, &str)],
    file: &str,
    rule: &str,
) -> Option<Severity> {
    let tree = Tree::new();
    for (name, text) in files {
        tree.write(name, text);
    }
    let path = if folder.is_empty() {
        tree.root().to_owned()
    } else {
        tree.path(folder)
    };
    let setup = Setup {
        folders: vec![path.clone()],
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let report = crate::check(
        &session,
        &CheckOptions {
            paths: vec![path],
            ..CheckOptions::default()
        },
    );
    let is_it = |finding: &&rules::Finding| {
        let path = session.vfs.path(finding.span.file);
        finding.rule.name == rule && (file.is_empty() || path.ends_with(file))
    };
    report
        .findings
        .iter()
        .find(is_it)
        .map(|finding| finding.severity)
}

fn manifest(name: &str, person: &str) -> String {
    format!("<package><name>{name}</name><maintainer email='{person}'>P</maintainer></package>")
}

/// A workspace with a robot of its own, and a package of another repository.
fn workspace() -> Vec<(&'static str, String)> {
    vec![
        (
            "src/rover_description/package.xml",
            manifest("rover_description", "me@todo.todo"),
        ),
        ("src/rover_description/urdf/rover.urdf", BROKEN.to_owned()),
        (
            "src/rover_description/launch/show.launch",
            "<param textfile='rover.urdf'/>".to_owned(),
        ),
        ("src/gripper_stack/.travis.yml", String::new()),
        (
            "src/gripper_stack/gripper_description/package.xml",
            manifest("gripper_description", "they@lab.org"),
        ),
        (
            "src/gripper_stack/gripper_description/urdf/gripper.urdf",
            BROKEN.to_owned(),
        ),
        (
            "src/gripper_stack/gripper_description/launch/gripper.launch",
            "<param textfile='$(find gripper_description)/urdf/gripper.urdf'/>".to_owned(),
        ),
    ]
}

fn severity_of(file: &str, folder: &str, files: &[(&'static str, String)]) -> Option<Severity> {
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (*name, text.as_str()))
        .collect();
    severity_below(folder, &files, file, "missing-element")
}

#[test]
fn copied_repositories() {
    let own = workspace();
    assert_eq!(severity_of("gripper.urdf", "", &own), Some(Severity::Info));
    assert_eq!(severity_of("rover.urdf", "", &own), Some(Severity::Error));
    // somebody asks for it
    assert_eq!(
        severity_of("gripper.urdf", "src/gripper_stack", &own),
        Some(Severity::Error)
    );
    assert_eq!(
        severity_of(
            "gripper.urdf",
            "src/gripper_stack/gripper_description",
            &own
        ),
        Some(Severity::Error)
    );
    // a clone may be anybody's
    let cloned = [
        own.clone(),
        vec![("src/gripper_stack/.git/HEAD", String::new())],
    ]
    .concat();
    assert_eq!(
        severity_of("gripper.urdf", "", &cloned),
        Some(Severity::Error)
    );
    // without a mark it is no other repository
    let plain: Vec<_> = own
        .iter()
        .filter(|(name, _)| !name.ends_with(".yml"))
        .cloned()
        .collect();
    assert_eq!(
        severity_of("gripper.urdf", "", &plain),
        Some(Severity::Error)
    );
    // one that was released
    let released = [
        plain.clone(),
        vec![(
            "src/gripper_stack/gripper_description/CHANGELOG.rst",
            String::new(),
        )],
    ];
    assert_eq!(
        severity_of("gripper.urdf", "", &released.concat()),
        Some(Severity::Info)
    );
}

#[test]
fn settings_in_copied_repositories() {
    let arm = "<robot name='arm'><link name='base'/><link name='tip'/><joint name='elbow' type='revolute'>\
               <parent link='base'/><child link='tip'/><axis xyz='0 0 1'/>\
               <limit lower='-1' upper='1' effort='1' velocity='2'/></joint></robot>";
    let limits = "joint_limits:\n  elbows:\n    has_velocity_limits: true\n    max_velocity: 3.5\n";
    let of = |others: &[(&'static str, String)]| {
        let stack = "src/gripper_stack/arm_moveit_config";
        let mut files = workspace();
        let own = [
            ("package.xml", manifest("arm_moveit_config", "they@lab.org")),
            (".setup_assistant", ASSISTANT.to_owned()),
            ("config/arm.srdf", "<robot name='arm'/>".to_owned()),
            ("config/joint_limits.yaml", limits.to_owned()),
            (
                "launch/demo.launch",
                "<rosparam file='$(find arm_moveit_config)/config/joint_limits.yaml'/>".to_owned(),
            ),
        ];
        let names: Vec<(String, String)> = own
            .into_iter()
            .map(|(name, text)| (format!("{stack}/{name}"), text))
            .collect();
        files.push((
            "src/gripper_stack/arm_description/package.xml",
            manifest("arm_description", "they@lab.org"),
        ));
        files.push((
            "src/gripper_stack/arm_description/urdf/arm.urdf",
            arm.to_owned(),
        ));
        files.extend_from_slice(others);
        let files: Vec<(&str, &str)> = files
            .iter()
            .map(|(name, text)| (*name, text.as_str()))
            .chain(
                names
                    .iter()
                    .map(|(name, text)| (name.as_str(), text.as_str())),
            )
            .collect();
        severity_below(
            "",
            &files,
            "joint_limits.yaml",
            "joint-limits-unknown-joint",
        )
    };
    assert_eq!(of(&[]), Some(Severity::Info));
    // another launch file of the repository starts it, and nothing here starts that one
    let bringup = (
        "src/gripper_stack/gripper_description/launch/bringup.launch",
        "<include file='$(find arm_moveit_config)/launch/demo.launch'/>".to_owned(),
    );
    assert_eq!(of(std::slice::from_ref(&bringup)), Some(Severity::Info));
    let own = (
        "src/rover_description/launch/all.launch",
        "<include file='$(find gripper_description)/launch/bringup.launch'/>".to_owned(),
    );
    assert_eq!(of(&[bringup, own]), Some(Severity::Warning));
    let direct = (
        "src/rover_description/launch/all.launch",
        "<include file='$(find arm_moveit_config)/launch/demo.launch'/>".to_owned(),
    );
    assert_eq!(of(&[direct]), Some(Severity::Warning));
}

/// What the setup assistant of MoveIt remembers.
const ASSISTANT: &str = "moveit_setup_assistant_config:\n  URDF:\n    package: arm_description\n    relative_path: urdf/arm.urdf\n  SRDF:\n    relative_path: config/arm.srdf\n";

#[test]
fn copied_repositories_that_are_used() {
    for (name, text) in [
        (
            "src/rover_description/launch/all.launch",
            "<include file='$(find gripper_description)/launch/gripper.launch'/>",
        ),
        ("README.md", "roslaunch gripper_description gripper.launch"),
        (
            "src/rover_description/scripts/load.py",
            "package = 'gripper_description'",
        ),
        (
            "src/rover_description/urdf/all.xacro",
            "<robot xmlns:xacro='x'><xacro:include filename='$(find gripper_description)/urdf/gripper.urdf'/></robot>",
        ),
    ] {
        let all = [workspace(), vec![(name, text.to_owned())]].concat();
        assert_eq!(
            severity_of("gripper.urdf", "", &all),
            Some(Severity::Error),
            "{name}"
        );
    }
    // a package that needs one of its family
    let needs = |name: &str| {
        let text = manifest("rover_description", "me@todo.todo");
        let text = text.replace("</package>", &format!("<depend>{name}</depend></package>"));
        severity_of(
            "gripper.urdf",
            "",
            &[
                workspace(),
                vec![("src/rover_description/package.xml", text)],
            ]
            .concat(),
        )
    };
    assert_eq!(needs("gripper_driver"), Some(Severity::Error));
    assert_eq!(needs("gazebo_ros"), Some(Severity::Info));
    // what a comment says leads nowhere
    let comment = (
        "src/rover_description/launch/all.launch",
        "<!-- $(find gripper_description) gripper.launch -->".to_owned(),
    );
    assert_eq!(
        severity_of("gripper.urdf", "", &[workspace(), vec![comment]].concat()),
        Some(Severity::Info)
    );
}

#[test]
fn whose_a_package_is() {
    let with = |name: &str, person: &str| -> Vec<(&'static str, String)> {
        let change = |(path, text): (&'static str, String)| {
            if path.contains("gripper_description/package") {
                (path, manifest(name, person))
            } else {
                (path, text)
            }
        };
        workspace().into_iter().map(change).collect()
    };
    // the same people, or the same family of names
    assert_eq!(
        severity_of(
            "gripper.urdf",
            "",
            &with("gripper_description", "me@todo.todo")
        ),
        Some(Severity::Error)
    );
    assert_eq!(
        severity_of("gripper.urdf", "", &with("rover_gripper", "they@lab.org")),
        Some(Severity::Error)
    );
    assert_eq!(
        severity_of(
            "gripper.urdf",
            "",
            &with("gripper_description", "they@lab.org")
        ),
        Some(Severity::Info)
    );
    // a repository of packages that are all alike
    let alike: Vec<(&'static str, String)> = workspace()
        .into_iter()
        .map(|(path, text)| (path, text.replace("me@todo.todo", "some@lab.org")))
        .chain([("src/rover_description/.travis.yml", String::new())])
        .collect();
    assert_eq!(
        severity_of("gripper.urdf", "", &alike),
        Some(Severity::Error)
    );
}

#[test]
fn published_repositories_hold_what_is_released() {
    let files = |person: &str| {
        vec![
            (".github/workflows/ci.yml", String::new()),
            (
                "arm_description/package.xml",
                manifest("arm_description", "a@lab.org"),
            ),
            ("arm_description/CHANGELOG.rst", String::new()),
            ("arm_description/urdf/arm.urdf", BROKEN.to_owned()),
            (
                "cell_description/package.xml",
                manifest("cell_description", person),
            ),
            ("cell_description/urdf/cell.urdf", BROKEN.to_owned()),
        ]
    };
    assert_eq!(
        severity_of("arm.urdf", "", &files("b@lab.org")),
        Some(Severity::Error)
    );
    assert_eq!(
        severity_of("arm.urdf", "", &files("b@todo.todo")),
        Some(Severity::Info)
    );
}

/// The severity of the only place of a rule in a package of these files.
pub(super) fn severity_in(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    let manifest = (
        "package.xml",
        "<package><name>r</name><buildtool_depend>catkin</buildtool_depend></package>",
    );
    severity_below("", &[&[manifest], files].concat(), "", rule)
}

#[test]
fn lists_of_joints() {
    let list = |inside: &str| {
        format!(
            "<robot name='r'><joint name='a'><limit lower='0' upper='1'/></joint>{inside}</robot>"
        )
    };
    let severity = |inside: &str| severity_in("no-links", &[("urdf/list.urdf", &list(inside))]);
    assert_eq!(severity(""), Some(Severity::Info));
    assert_eq!(
        severity("<joint name='b' type='fixed'/>"),
        Some(Severity::Error)
    );
    assert_eq!(
        severity("<joint name='b'><parent link='x'/></joint>"),
        Some(Severity::Error)
    );
}

#[test]
fn properties_of_themselves() {
    let severity = |value: &str| {
        let robot = format!(
            "<robot name='r' xmlns:xacro='x'><property name='a' value='{value}'/><link name='b'/></robot>"
        );
        severity_in("unprefixed-xacro-tag", &[("urdf/r.urdf.xacro", &robot)])
    };
    assert_eq!(severity("${a}"), Some(Severity::Info));
    assert_eq!(severity("${ a }"), Some(Severity::Info));
    assert_eq!(severity("${b}"), Some(Severity::Error));
    assert_eq!(severity("1"), Some(Severity::Error));
}

#[test]
fn parts_in_texts_that_launch_files_pass_on() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:arg name='extra' default='none.xacro'/><xacro:property name='track' value='1'/>\
                 <xacro:include filename='$(arg extra)'/><link name='base'/></robot>";
    let extra = "<robot name='e' xmlns:xacro='x'><link name='wheel_${track}'/></robot>";
    let severity = |launch: &str| {
        let files = [
            ("urdf/r.urdf.xacro", robot),
            ("urdf/none.xacro", "<robot/>"),
            ("urdf/extra.xacro", extra),
            ("launch/a.launch.py", launch),
        ];
        severity_in("undefined-property", &files)
    };
    let passes = "part = 'extra.xacro'\nLaunch('r.launch.py', {'args': ['extra:=', part]}.items())";
    assert_eq!(severity(passes), None);
    assert_eq!(
        severity(&passes.replace("extra:=", "other:=")),
        Some(Severity::Error)
    );
    // the file itself is expanded
    assert_eq!(
        severity(
            "Command(['xacro ', FindPackageShare('r'), '/urdf/extra.xacro'])\nargs = 'extra:='"
        ),
        Some(Severity::Error)
    );
}

#[test]
fn interfaces_that_an_argument_decides_on() {
    let robot = |value: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:arg name='mode' default='slow'/><link name='base'/><joint name='j' type='continuous'>\
             <parent link='base'/><child link='w'/></joint><link name='w'/><ros2_control name='c' type='system'><hardware>\
             <plugin>mock_components/GenericSystem</plugin></hardware><joint name='j'><command_interface name='position'/>\
             <xacro:if value=\"${{'$(arg mode)' == 'fast'}}\"><command_interface name='{value}'/></xacro:if></joint>\
             </ros2_control></robot>"
        )
    };
    let settings = "go:\n  ros__parameters:\n    joints:\n      - j\n    command_interfaces:\n      - velocity\n";
    let severity = |value: &str| {
        let manifest = (
            "package.xml",
            "<package><name>r</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        );
        let files = [
            manifest,
            ("urdf/r.urdf.xacro", &robot(value)),
            ("config/c.yaml", settings),
        ];
        severity_below("", &files, "", "controller-unknown-interface")
    };
    assert_eq!(severity("velocity"), None);
    assert_eq!(severity("effort"), Some(Severity::Error));
}

#[test]
fn files_of_tests_that_have_to_be_refused() {
    for (name, expected) in [
        ("test/fail_two_parents.urdf", Severity::Info),
        ("test/urdf/invalid.urdf", Severity::Info),
        ("test/two_parents.urdf", Severity::Error),
        ("urdf/fail_two_parents.urdf", Severity::Error),
        ("test/failsafe.urdf", Severity::Error),
    ] {
        assert_eq!(
            severity_in("missing-element", &[(name, BROKEN)]),
            Some(expected),
            "{name}"
        );
    }
}

#[test]
fn files_that_only_tests_name() {
    let manifest = manifest("parser", "me@lab.org");
    let severity = |file: &str, tests: &[(&str, &str)]| {
        let mut files = vec![("package.xml", manifest.as_str()), (file, BROKEN)];
        files.extend(tests);
        severity_in("missing-element", &files)
    };
    let cpp = ("test/test_parser.cpp", "read(\"test/urdf/arm.urdf\");");
    assert_eq!(severity("test/urdf/arm.urdf", &[cpp]), Some(Severity::Info));
    let cmake = ("CMakeLists.txt", "add_rostest_gtest(t test/urdf/arm.urdf)");
    assert_eq!(
        severity("test/urdf/arm.urdf", &[cmake]),
        Some(Severity::Info)
    );
    let elsewhere = [
        ("more/package.xml", "<package><name>more</name></package>"),
        (
            "more/test/test_more.cpp",
            "read(find(\"parser\"), \"test/urdf/arm.urdf\");",
        ),
    ];
    assert_eq!(
        severity("test/urdf/arm.urdf", &elsewhere),
        Some(Severity::Info)
    );
    // a launch file loads it as well, or no test does
    let launch = (
        "launch/arm.launch",
        "<param textfile='$(find parser)/test/urdf/arm.urdf'/>",
    );
    assert_eq!(
        severity("test/urdf/arm.urdf", &[cpp, launch]),
        Some(Severity::Error)
    );
    assert_eq!(severity("test/urdf/arm.urdf", &[]), Some(Severity::Error));
    assert_eq!(severity("urdf/arm.urdf", &[cpp]), Some(Severity::Error));
}

#[test]
fn parameters_that_a_spawner_is_given() {
    let robot = "<robot name='r'><link name='base'/><link name='w'/><joint name='j' type='continuous'><parent link='base'/>\
                 <child link='w'/></joint><ros2_control name='c' type='system'><hardware><plugin>mock_components/GenericSystem</plugin>\
                 </hardware><joint name='j'><command_interface name='velocity'/></joint></ros2_control></robot>";
    let listed = "controller_manager:\n  ros__parameters:\n    drive:\n      type: diff_drive_controller/DiffDriveController\n";
    let severity = |launch: &str| {
        let files = [
            ("package.xml", &*manifest("r", "me@lab.org")),
            ("urdf/r.urdf", robot),
            ("config/c.yaml", listed),
            ("launch/r.launch.py", launch),
        ];
        severity_in("controller-without-parameters", &files)
    };
    let plain = "Node(executable='spawner', arguments=['drive'])  # r.urdf";
    let given = "Node(executable='spawner', arguments=['drive', '--param-file', path])";
    assert_eq!(severity(plain), Some(Severity::Warning));
    assert_eq!(severity(given), None);
}

#[test]
fn joints_of_an_absent_package() {
    let robot = |package: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:arg name='tool' default='none'/><link name='base'/><link name='w'/>\
             <joint name='j' type='continuous'><parent link='base'/><child link='w'/></joint>\
             <xacro:if value=\"${{'$(arg tool)' != 'none'}}\"><xacro:include filename='$(find {package})/tool.xacro'/></xacro:if></robot>"
        )
    };
    let settings =
        "grip:\n  ros__parameters:\n    joints: [j, finger]\n    command_interfaces: [position]\n";
    let severity = |package: &str| {
        let files = [
            ("package.xml", &*manifest("r", "me@lab.org")),
            ("tool.xacro", "<robot/>"),
            ("urdf/r.urdf.xacro", &robot(package)),
            ("config/c.yaml", settings),
        ];
        severity_in("controller-unknown-joint", &files)
    };
    assert_eq!(severity("somebodys_tool"), Some(Severity::Info));
    assert_eq!(severity("r"), Some(Severity::Error));
}

#[test]
fn parts_need_no_name() {
    let paint = "<robot><material name='grey'><color rgba='0.5 0.5 0.5 1'/></material></robot>";
    let robot = |part: &str| {
        format!(
            "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='base'/><xacro:include filename='{part}'/></robot>"
        )
    };
    let severity = |robot: &str| {
        let files = [("urdf/r.xacro", robot), ("urdf/paint.urdf", paint)];
        severity_below("", &files, "paint.urdf", "missing-robot-name")
    };
    assert_eq!(severity(&robot("paint.urdf")), None);
    assert_eq!(severity(&robot("other.urdf")), Some(Severity::Error));
}

#[test]
fn a_launch_file_that_means_another_folder_uses_no_copy() {
    let robot = "<robot name='r'><link name='base'/><link name='base'/></robot>";
    let severity = |path: &str| {
        let launch =
            format!("<launch><param name='robot_description' textfile='{path}'/></launch>");
        let files = [
            ("package.xml", &*manifest("arm", "me@lab.org")),
            ("urdf_backup/arm.urdf", robot),
            (
                "urdf/other.urdf",
                "<robot name='o'><link name='base'/></robot>",
            ),
            ("launch/a.launch", &launch),
        ];
        severity_in("duplicate-link-name", &files)
    };
    assert_eq!(severity("$(find arm)/urdf/arm.urdf"), Some(Severity::Info));
    assert_eq!(
        severity("$(find arm)/urdf_backup/arm.urdf"),
        Some(Severity::Error)
    );
}
