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
    let report = crate::check(
        &session,
        &CheckOptions {
            paths: vec![path.clone()],
            ..CheckOptions::default()
        },
    );
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

const SHOW_FAST: &str = "<launch><param name='robot_description' command='$(find xacro)/xacro $(find arm)/urdf/fast.urdf'/></launch>";
const SHOW_SLOW: &str = "<launch><param name='robot_description' command='$(find xacro)/xacro $(find arm)/urdf/slow.urdf'/></launch>";

#[test]
fn one_of_several_robots_is_started_with_a_controller() {
    let (fast, slow) = (
        robot(VELOCITY, VELOCITY, "c.yaml"),
        robot(VELOCITY, POSITION, "c.yaml"),
    );
    let of = |launch: &str| {
        let files = [
            ("urdf/fast.urdf", &*fast),
            ("urdf/slow.urdf", &*slow),
            ("config/c.yaml", SETTINGS),
            ("config/other.yaml", SETTINGS),
            ("launch/slow.launch", launch),
            ("launch/show_fast.launch", SHOW_FAST),
            ("launch/show_slow.launch", SHOW_SLOW),
        ];
        let mut found = found(&files, RULE);
        found.retain(|(file, _)| file == "config/c.yaml");
        found
    };
    let starts = |robot: &str| {
        format!(
            "<param name='robot_description' command='$(find xacro)/xacro $(find arm)/urdf/{robot}.urdf'/>"
        )
    };
    let spawns = "<node pkg='controller_manager' exec='spawner' args='go'/>";
    let (fast, slow) = (starts("fast"), starts("slow"));
    assert_eq!(
        of(&format!("<launch>{slow}{spawns}</launch>")),
        [("config/c.yaml".to_owned(), Severity::Warning)]
    );
    assert_eq!(of(&format!("<launch>{slow}</launch>")), []);
    assert_eq!(of(&format!("<launch>{fast}{spawns}</launch>")), []);
    assert_eq!(of(&format!("<launch>{slow}{fast}{spawns}</launch>")), []);
    // the controller of that name has its parameters in another file
    let other = "<rosparam file='$(find arm)/config/other.yaml'/>";
    assert_eq!(of(&format!("<launch>{slow}{other}{spawns}</launch>")), []);
}

#[test]
fn another_controller_of_the_joint_fits_the_robot() {
    let (fast, slow) = (
        robot(VELOCITY, VELOCITY, "c.yaml"),
        robot(VELOCITY, POSITION, "c.yaml"),
    );
    let launch = "<launch><param name='robot_description' command='$(find xacro)/xacro $(find arm)/urdf/slow.urdf'/>\
                  <node pkg='controller_manager' exec='spawner' args='go turn_slowly'/></launch>";
    let of = |more: &str| {
        let settings = format!("{SETTINGS}{more}");
        let files = [
            ("urdf/fast.urdf", &*fast),
            ("urdf/slow.urdf", &*slow),
            ("config/c.yaml", &*settings),
            ("launch/slow.launch", launch),
            ("launch/show_fast.launch", SHOW_FAST),
            ("launch/show_slow.launch", SHOW_SLOW),
        ];
        found(&files, RULE).len()
    };
    let other = |interface: &str| {
        format!(
            "turn_slowly:\n  ros__parameters:\n    joints: [turn]\n    command_interfaces: [{interface}]\n"
        )
    };
    assert_eq!(of(""), 1);
    assert_eq!(of(&other("position")), 0);
    assert_eq!(of(&other("effort")), 2);
}

#[test]
fn a_condition_of_another_joint_offers_nothing() {
    let of = |other: &str| {
        let included = format!(
            "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='more' params='prefix'>\
             <ros2_control name='d' type='system'><joint name='{other}'><xacro:if value='false'>{VELOCITY}</xacro:if></joint>\
             </ros2_control></xacro:macro></robot>"
        );
        let robot = robot(VELOCITY, POSITION, "c.yaml").replace(
            "<robot name='arm'>",
            "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:include filename='more.xacro'/>",
        );
        let files = [
            ("urdf/arm.urdf.xacro", &*robot),
            ("urdf/more.xacro", &included),
            ("config/c.yaml", SETTINGS),
        ];
        found(&files, RULE).len()
    };
    assert_eq!(of("${prefix}finger"), 1);
    assert_eq!(of("${prefix}turn"), 0);
    assert_eq!(of("${prefix}"), 0);
}

#[test]
fn blocks_of_one_name_are_read_together() {
    let listed = "/**:\n  controller_manager:\n    ros__parameters:\n      go:\n        type: joint_trajectory_controller/JointTrajectoryController\n";
    let block = |name: &str, joint: &str| {
        format!(
            "/**:\n  {name}:\n    ros__parameters:\n      joints: [{joint}]\n      command_interfaces: [velocity]\n"
        )
    };
    let of = |joint: &str| {
        let settings = format!("{listed}{}{}", block("go", joint), block("stay", "lift"));
        let files = [
            ("urdf/arm.urdf", &*robot(VELOCITY, POSITION, "c.yaml")),
            ("config/c.yaml", &settings),
        ];
        [RULE, "controller-without-parameters"].map(|rule| found(&files, rule).len())
    };
    assert_eq!(of("turn"), [1, 0]);
    assert_eq!(of("lift"), [0, 0]);
}

/// A robot that a switch makes of one of two texts, and an SRDF that names a joint and a link of it.
fn painted(plain: &str, bright: &str, more: &str, rule: &str) -> usize {
    let robot = format!(
        "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='bright' default='false'/><link name='base'/>\
         <xacro:if value='$(arg bright)'>{bright}</xacro:if><xacro:unless value='$(arg bright)'>{plain}</xacro:unless></robot>"
    );
    let srdf = format!(
        "<robot name='arm'><group name='all'><link name='base'/><link name='hand'/><joint name='tilt'/>{more}</group></robot>"
    );
    let files = [("urdf/arm.urdf.xacro", &*robot), ("config/arm.srdf", &srdf)];
    found(&files, rule).len()
}

/// A joint from the base to the hand.
fn hinge(name: &str, kind: &str) -> String {
    format!("<joint name='{name}' type='{kind}'><parent link='base'/><child link='hand'/></joint>")
}

const HAND: &str = "<link name='hand'/>";

#[test]
fn a_link_that_joints_need_is_missing_in_one_variant() {
    let (bare, whole) = (
        hinge("tilt", "continuous"),
        format!("{HAND}{}", hinge("tilt", "continuous")),
    );
    let of = |plain: &str| painted(plain, &whole, "", "srdf-unknown-link");
    assert_eq!(of(&bare), 1);
    assert_eq!(of(&whole), 0);
    // without its joint it is a part that only the other variant has
    assert_eq!(of(""), 0);
}

#[test]
fn a_joint_has_another_name_in_one_variant() {
    let with = |name: &str, kind: &str| format!("{HAND}{}", hinge(name, kind));
    let of = |plain: &str, more: &str| {
        painted(
            plain,
            &with("tilt", "continuous"),
            more,
            "srdf-unknown-joint",
        )
    };
    assert_eq!(of(&with("bend", "continuous"), ""), 1);
    assert_eq!(of(&with("tilt", "continuous"), ""), 0);
    // a variant that holds the link still, and an SRDF that knows both names
    assert_eq!(of(&with("bend", "fixed"), ""), 0);
    assert_eq!(of(&with("bend", "continuous"), "<joint name='bend'/>"), 0);
}

#[test]
fn a_link_has_another_name_in_one_variant() {
    let with = |link: &str, kind: &str| {
        let joint = hinge("tilt", kind).replace("'hand'", &format!("'{link}'"));
        format!("<link name='{link}'/>{joint}")
    };
    let of = |plain: &str, kind: &str, more: &str| {
        painted(
            &with(plain, kind),
            &with("hand", kind),
            more,
            "srdf-unknown-link",
        )
    };
    assert_eq!(of("palm", "continuous", ""), 1);
    assert_eq!(of("hand", "continuous", ""), 0);
    // two tools that are mounted in one place, and an SRDF that knows both names
    assert_eq!(of("palm", "fixed", ""), 0);
    assert_eq!(of("palm", "continuous", "<link name='palm'/>"), 0);
}

#[test]
fn a_joint_is_missing_in_one_variant() {
    let whole = format!("{HAND}{}", hinge("tilt", "fixed"));
    let of = |plain: &str| painted(plain, &whole, "", "srdf-unknown-joint");
    assert_eq!(of(HAND), 1);
    assert_eq!(of(&whole), 0);
    // without its link it is a part that only the other variant has
    assert_eq!(of(""), 0);
}

#[test]
fn a_controller_in_a_comment_of_a_launch_file_is_not_started() {
    let more =
        "stay:\n  ros__parameters:\n    joints: [lift]\n    command_interfaces: [velocity]\n";
    let settings = format!("{SETTINGS}{more}");
    let starts = |folder: &str, controllers: &str| {
        format!(
            "<launch><param name='robot_description' command='$(find xacro)/xacro $(find arm)/urdf/arm.urdf'/>\
             <rosparam file='$(find arm)/config/{folder}/c.yaml'/>{controllers}</launch>"
        )
    };
    let spawns =
        |name: &str| format!("<node pkg='controller_manager' exec='spawner' args='{name}'/>");
    let of = |go: &str| {
        let launch = starts("one", &format!("{}{go}", spawns("stay")));
        let files = [
            ("urdf/arm.urdf", &*robot(VELOCITY, POSITION, "other.yaml")),
            ("config/one/c.yaml", &settings),
            ("config/two/c.yaml", more),
            ("launch/one.launch", &launch),
            ("launch/two.launch", &starts("two", &spawns("go"))),
        ];
        found(&files, RULE)
    };
    let at = |severity| vec![("config/one/c.yaml".to_owned(), severity)];
    assert_eq!(of(&spawns("go")), at(Severity::Error));
    assert_eq!(
        of(&format!("<!-- {} -->", spawns("go"))),
        at(Severity::Info)
    );
}

#[test]
fn a_file_of_few_joints_that_is_loaded_for_a_robot_elsewhere() {
    let robot = "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='p' default=''/><link name='base'/>\
                 <link name='a'/><joint name='lift' type='continuous'><parent link='base'/><child link='a'/></joint></robot>";
    let settings = SETTINGS.replace("      - lift\n", "");
    let starts = |package: &str| {
        format!(
            "<launch><param name='robot_description' command='$(find xacro)/xacro $(find {package})/urdf/arm.urdf.xacro'/>\
             <rosparam file='$(find arm)/config/c.yaml'/></launch>"
        )
    };
    let of = |other: &str| {
        let files = [
            ("urdf/arm.urdf.xacro", robot),
            ("config/c.yaml", &settings),
            ("launch/arm.launch", &starts("arm")),
            ("launch/other.launch", &starts(other)),
        ];
        found(&files, "controller-unknown-joint").len()
    };
    assert_eq!(of("arm"), 1);
    assert_eq!(of("elsewhere"), 0);
}

#[test]
fn a_robot_in_a_file_of_the_same_name_elsewhere() {
    let robot = |name: &str, joints: &[&str]| {
        let moves = joints.iter().map(|joint| {
            format!(
                "<link name='{joint}_link'/><joint name='{joint}' type='continuous'><parent link='base'/>\
                 <child link='{joint}_link'/></joint>"
            )
        });
        let moves: String = moves.collect();
        format!("<robot name='{name}'><link name='base'/>{moves}</robot>")
    };
    let all = ["lift", "turn", "slide"];
    let state = all.map(|joint| format!("<joint name='{joint}' value='0'/>"));
    let srdf = format!(
        "<robot name='pair'><group name='g'><chain base_link='base' tip_link='lift_link'/></group>\
         <group_state name='s' group='g'>{}</group_state></robot>",
        state.concat()
    );
    let paired_with = |file: &str| {
        let files = [
            ("urdf/pair.urdf", robot("pair", &["lift", "turn"])),
            (file, robot("tool", &all)),
            (
                "moveit/package.xml",
                MANIFEST.replace("arm", "arm_moveit_config"),
            ),
            ("moveit/config/tool.srdf", srdf.clone()),
        ];
        let files: Vec<(&str, &str)> = files
            .iter()
            .map(|(name, text)| (*name, text.as_str()))
            .collect();
        found(&files, "srdf-unknown-joint").len()
    };
    assert_eq!(paired_with("urdf/other.urdf"), 1);
    assert_eq!(paired_with("urdf/tool.urdf"), 0);
}

#[test]
fn joints_of_a_variant_that_is_not_the_default() {
    let main = "<robot name='arm' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arg name='dof' default='1'/>\
        <xacro:property name='dof' value='$(arg dof)'/><link name='base'/><xacro:macro name='arm' params=\"prefix:=''\">\
        <link name='${prefix}tip'/><joint name='${prefix}lift' type='fixed'><parent link='base'/><child link='${prefix}tip'/></joint>\
        </xacro:macro><xacro:if value='${dof == 2}'><xacro:include filename='long.xacro'/><xacro:long prefix=''/></xacro:if>\
        <xacro:unless value='${dof == 2}'><xacro:arm prefix='a_'/></xacro:unless></robot>";
    let long = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:macro name='long' params='prefix'>\
        <joint name='${prefix}turn' type='fixed'><parent link='base'/><child link='x'/></joint></xacro:macro></robot>";
    let of = |joint: &str| {
        let settings = format!(
            "controller_names: [go]\ngo:\n  type: FollowJointTrajectory\n  joints: [{joint}]\n"
        );
        let files = [
            ("urdf/arm.urdf.xacro", main),
            ("urdf/long.xacro", long),
            ("config/controllers.yaml", settings.as_str()),
            (
                "config/arm.srdf",
                "<robot name='arm'><group name='g'><link name='base'/></group></robot>",
            ),
        ];
        found(&files, "moveit-controller-unknown-joint").len()
    };
    assert_eq!(of("turn"), 0);
    // the robot reads that file, with a prefix
    assert_eq!(of("lift"), 1);
    assert_eq!(of("tilt"), 1);
}

#[test]
fn semantic_descriptions_that_are_for_another_robot_that_is_loaded() {
    let robot = |name: &str, more: &str| {
        format!(
            "<robot name='{name}'><link name='palm'/><link name='thumb'/><joint name='t' type='fixed'>\
             <parent link='palm'/><child link='thumb'/></joint>{more}</robot>"
        )
    };
    let coupler = "<link name='coupler'/><joint name='c' type='fixed'><parent link='palm'/><child link='coupler'/></joint>";
    let (bare, whole) = (robot("hand", ""), robot("coupled", coupler));
    let of = |launch: &str, link: &str| {
        let srdf = format!(
            "<robot name='hand'><group name='g'><link name='palm'/><link name='thumb'/><joint name='t'/></group>\
             <disable_collisions link1='thumb' link2='{link}' reason='Never'/></robot>"
        );
        let files = [
            ("urdf/hand.urdf", bare.as_str()),
            ("urdf/coupled.urdf", whole.as_str()),
            ("config/hand.srdf", srdf.as_str()),
            (
                "launch/plan.launch",
                "<param textfile='$(find arm)/urdf/hand.urdf'/><param textfile='$(find arm)/config/hand.srdf'/>",
            ),
            ("launch/upload.launch", launch),
        ];
        found(&files, "srdf-unknown-link").len()
    };
    let uploads = "<param textfile='$(find arm)/urdf/coupled.urdf'/>";
    assert_eq!(of(uploads, "coupler"), 0);
    assert_eq!(of(uploads, "cupler"), 1);
    // nothing loads the other one
    assert_eq!(of("", "coupler"), 1);
}

/// A robot with one joint that turns.
fn robot_with(joint: &str) -> String {
    format!(
        "<robot name='arm'><link name='base'/><link name='a'/><joint name='{joint}' type='continuous'>\
         <parent link='base'/><child link='a'/></joint></robot>"
    )
}

#[test]
fn robots_that_launch_files_load_instead_of_that_of_the_assistant() {
    let assistant = "moveit_setup_assistant_config:\n  URDF:\n    package: arm\n    relative_path: urdf/first.urdf\n  SRDF:\n    relative_path: config/arm.srdf\n";
    let controllers = "controller_list:\n  - name: hand\n    action_ns: go\n    type: FollowJointTrajectory\n    joints:\n      - finger\n";
    let (first, second) = (robot_with("lift"), robot_with("finger"));
    let of = |loaded: &str| {
        let launch =
            format!("<launch><param command=\"xacro '$(find arm)/urdf/{loaded}'\"/></launch>");
        let files = [
            (".setup_assistant", assistant),
            ("urdf/first.urdf", first.as_str()),
            ("urdf/second.urdf", second.as_str()),
            ("config/controllers.yaml", controllers),
            ("launch/planning_context.launch", launch.as_str()),
        ];
        found(&files, "moveit-controller-unknown-joint").len()
    };
    assert_eq!(of("first.urdf"), 1);
    assert_eq!(of("second.urdf"), 0);
}

#[test]
fn joints_in_files_that_an_argument_selects_by_their_folder() {
    let root = "<robot name='arm' xmlns:xacro='x'><xacro:arg name='hand' default=''/><link name='base'/><link name='a'/>\
                <joint name='lift' type='continuous'><parent link='base'/><child link='a'/></joint>\
                <xacro:unless value=\"${'$(arg hand)' == ''}\"><xacro:include filename='$(find arm)/hands/$(arg hand)/urdf/$(arg hand).xacro'/>\
                </xacro:unless></robot>";
    let hand = "<robot xmlns:xacro='x'><xacro:macro name='hand' params='prefix'><link name='${prefix}f'/>\
                <joint name='${prefix}finger' type='continuous'><parent link='a'/><child link='${prefix}f'/></joint></xacro:macro></robot>";
    let settings = SETTINGS.replace("turn", "finger");
    let launch = "Command(['xacro ', get_package_share_directory('arm') + '/urdf/arm.xacro'])\nparameters=['config/arm.yaml']";
    let of = |place: &str| {
        let files = [
            ("urdf/arm.xacro", root),
            (place, hand),
            ("config/arm.yaml", settings.as_str()),
            ("launch/arm.launch.py", launch),
        ];
        found(&files, "controller-unknown-joint").len()
    };
    assert_eq!(of("hands/soft/urdf/soft.xacro"), 0);
    assert_eq!(of("hands/soft/soft.xacro"), 1);
}

#[test]
fn parts_of_an_srdf_that_an_argument_selects() {
    let arm = robot_with("lift");
    let whole = |group: &str| {
        format!(
            "<robot name='arm' xmlns:xacro='x'><xacro:arg name='hand' default='none'/>{group}\
             <xacro:include filename='pairs/$(arg hand).srdf.xacro'/></robot>"
        )
    };
    let group = "<group name='all'><joint name='lift'/></group>";
    let part = "<robot name='arm'><disable_collisions link1='a' link2='finger' reason='Adjacent'/></robot>";
    let none = "<robot name='arm'/>";
    let of = |part_of: &str| {
        let whole = whole(group);
        let files = [
            ("urdf/arm.urdf", arm.as_str()),
            ("config/arm.srdf.xacro", whole.as_str()),
            ("config/pairs/none.srdf.xacro", none),
            (part_of, part),
        ];
        found(&files, "srdf-unknown-link").len()
    };
    assert_eq!(of("config/pairs/soft.srdf.xacro"), 0);
    assert_eq!(of("config/other.srdf"), 1);
}
