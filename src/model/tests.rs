use super::{Kinematics, NameMarks, Robot, ShapeKind, tag_start};
use expand::{Expansion, Request, Sources, expand};
use packages::{PackageOptions, Packages};
use vfs::testing::Tree;

fn expanded(text: &str) -> Expansion {
    let tree = Tree::new();
    tree.write("r.xacro", text);
    let env = tree.environment(&[]);
    let packages = Packages::new(tree.vfs().clone(), &env, PackageOptions::default());
    let sources = Sources {
        vfs: tree.vfs(),
        packages: &packages,
        env: &env,
    };
    let file = tree.path("r.xacro").display().to_string();
    expand(
        sources,
        &Request {
            file,
            ..Request::default()
        },
    )
}

fn robot(body: &str) -> (Expansion, Robot) {
    let expansion = expanded(&format!(
        "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>{body}</robot>"
    ));
    let robot = Robot::of(&expansion).unwrap();
    (expansion, robot)
}

/// Links `a b c`, joints `name:parent>child`.
fn chain(links: &str, joints: &str) -> (Robot, Kinematics) {
    let mut body: String = links
        .split_whitespace()
        .map(|name| format!("<link name='{name}'/>"))
        .collect();
    for joint in joints.split_whitespace() {
        let (name, ends) = joint.split_once(':').unwrap();
        let (parent, child) = ends.split_once('>').unwrap();
        body.push_str(&format!(
            "<joint name='{name}'><parent link='{parent}'/><child link='{child}'/></joint>"
        ));
    }
    let (_, robot) = robot(&body);
    let kinematics = Kinematics::of(&robot);
    (robot, kinematics)
}

#[test]
fn links_and_joints_with_their_values() {
    let (_, robot) = robot(
        "<xacro:property name='p' value='left_'/><link name='${p}arm'/><link/>\
         <joint name='j' type='fixed'><parent link='world'/><child link='${p}arm'/><child link='x'/></joint>\
         <gazebo><link name='not mine'/></gazebo>",
    );
    assert!(robot.is_entry() && robot.names_are_known());
    let names: Vec<_> = robot
        .links
        .iter()
        .map(|link| link.name.as_ref().map(|name| name.value.as_str()))
        .collect();
    assert_eq!(names, [Some("left_arm"), None]);
    assert!(
        !robot
            .links
            .get(0)
            .unwrap()
            .name
            .as_ref()
            .unwrap()
            .is_literal()
    );
    let joint = &robot.joints.get(0).unwrap();
    assert_eq!(joint.kind.as_ref().unwrap().value, "fixed");
    assert_eq!(
        joint
            .ends()
            .map(|(parent, child)| (parent.as_str(), child.as_str())),
        Some(("world", "left_arm"))
    );
}

#[test]
fn unknown_names_are_no_names() {
    let (_, robot) = robot("<link name='${oops}'/>");
    assert!(!robot.names_are_known());
    assert_eq!(
        robot.links.get(0).unwrap().name.as_ref().unwrap().name(),
        None
    );
}

#[test]
fn names_may_be_what_their_known_part_fits() {
    let may = |name: &str, wanted: &str| {
        let (_, robot) = robot(&format!("<link name='{name}'/>"));
        robot
            .links
            .get(0)
            .unwrap()
            .name
            .as_ref()
            .unwrap()
            .may_be(wanted)
    };
    for (name, fits, does_not) in [
        ("${oops}", "gone", ""),
        ("left_${oops}", "left_hand", "hand"),
        ("${oops}_hand", "left_hand", "left_foot"),
        ("a_${oops}_b_${1/0}_c", "a_x_b_y_c", "a_x_c"),
        ("${oops}_a", "x_a", "_b"),
        ("hand", "hand", "foot"),
        ("{prefix}hand", "left_hand", ""),
    ] {
        assert!(may(name, fits), "{name} {fits}");
        assert!(
            does_not.is_empty() || !may(name, does_not),
            "{name} {does_not}"
        );
    }
}

#[test]
fn what_is_no_robot() {
    assert!(Robot::of(&expanded("<sdf/>")).is_none());
    assert!(
        !Robot::of(&expanded("<robot><link name='a'/></robot>"))
            .unwrap()
            .is_entry()
    );
    assert!(
        !Robot::of(&expanded("<robot name='r'/>"))
            .unwrap()
            .is_entry()
    );
}

#[test]
fn children_are_ordered_by_joint_name() {
    let (robot, kinematics) = chain("a b c d", "j3:a>b j10:a>c J:a>d");
    let names: Vec<_> = kinematics
        .child_joints(0)
        .iter()
        .map(|&joint| robot.joints.get(joint).unwrap().shown())
        .collect();
    assert_eq!(names, ["J", "j10", "j3"]);
    assert_eq!(kinematics.roots(&robot), [0]);
}

#[test]
fn what_names_say_is_shared_until_one_is_different() {
    let (before, old) = robot("<link name='a'><inertial><mass value='1'/></inertial></link>");
    let shares = |body: &str| {
        let (now, _) = robot(body);
        let new = Robot::again(&now, Some((&before, &old))).unwrap();
        std::ptr::eq(old.naming(), new.naming())
    };
    assert!(shares(
        "<link name='a'><inertial><mass value='2'/></inertial></link>"
    ));
    for body in [
        "<link name='b'/>",
        "<link name='${undefined}'/>",
        "<link/>",
        "<link name='a'/><link name='a'/>",
        "<link name='a'/><joint name='a' type='fixed'><parent link='a'/><child link='a'/></joint>",
    ] {
        assert!(!shares(body), "{body}");
    }
}

#[test]
fn names_that_rules_look_for() {
    let naming = |links, joints| {
        let (robot, _) = chain(links, joints);
        let naming = robot.naming();
        let found = [
            (naming.has_repeated_link, "link"),
            (naming.has_repeated_joint, "joint"),
            (naming.has_shared_name, "shared"),
            (naming.has_loop, "loop"),
            (naming.has_doubtful, "doubtful"),
            (!naming.cycles.is_empty(), "cycle"),
        ];
        let found: Vec<&str> = found
            .into_iter()
            .filter_map(|(is_there, what)| is_there.then_some(what))
            .collect();
        (found.join(" "), naming.marks)
    };
    let words = |links, joints| naming(links, joints).0;
    assert_eq!(words("a b", "x:a>b"), "");
    assert_eq!(words("a b b", "x:a>b x:a>b"), "link joint");
    assert_eq!(words("a b", "a:a>b b:b>a"), "shared cycle");
    assert_eq!(words("a b", "x:a>b y:b>b"), "loop");
    assert_eq!(words("a {b}", "x:a>c"), "doubtful");
    let mark = |name| naming(name, "").1;
    let none = NameMarks::default();
    assert_eq!(mark("a_1.b/c-d"), none);
    assert_eq!(
        mark("aB"),
        NameMarks {
            capital: true,
            ..none
        }
    );
    assert_eq!(
        mark("/__a"),
        NameMarks {
            slash: true,
            ..none
        }
    );
    assert_eq!(
        mark("__a"),
        NameMarks {
            underscores: true,
            ..none
        }
    );
    assert_eq!(
        mark("é"),
        NameMarks {
            capital: true,
            unusual: true,
            ..none
        }
    );
    assert!(robot("<link name=''/>").1.naming().marks.empty);
    // an end that names no link has a name all the same
    assert!(naming("a", "x:a>{b}").1.unusual);
}

#[test]
fn roots_and_missing_ends() {
    let (robot, kinematics) = chain("a b b c", "x:a>b y:nowhere>c");
    assert_eq!(kinematics.roots(&robot), [0]);
    assert_eq!(kinematics.ends(1), None);
    assert_eq!(kinematics.link("b"), Some(1));
}

#[test]
fn cycles_are_found_beside_a_root() {
    let cycles = |links, joints| chain(links, joints).1.cycles();
    assert_eq!(cycles("r a b", "x:a>b y:b>a"), [[0, 1]]);
    assert_eq!(cycles("r a b c", "x:r>a y:a>b z:b>a w:b>c"), [[1, 2]]);
    assert!(cycles("r a b", "x:r>a y:r>b z:a>b").is_empty());
    assert!(cycles("a", "x:a>a").is_empty());
}

#[test]
fn paths_go_up_and_down_and_end_in_circles() {
    let (robot, kinematics) = chain("r a b c d", "x:r>a y:a>b z:r>c");
    let link = |name| kinematics.link(name).unwrap();
    let names = |path: Vec<usize>| {
        path.into_iter()
            .map(|i| robot.joints.get(i).unwrap().shown())
            .collect::<String>()
    };
    assert_eq!(names(kinematics.ancestor_joints(link("b")).collect()), "yx");
    assert_eq!(
        kinematics.path(link("b"), link("c")).map(names).as_deref(),
        Some("yxz")
    );
    assert_eq!(
        kinematics.path(link("b"), link("a")).map(names).as_deref(),
        Some("y")
    );
    assert_eq!(kinematics.path(link("b"), link("d")), None);
    let (_, kinematics) = chain("a b", "x:a>b y:b>a");
    assert_eq!(kinematics.ancestor_joints(0).count(), 2);
}

#[test]
fn params_of_interfaces_have_their_text_without_blanks() {
    let (expansion, robot) = robot(
        "<ros2_control><joint name='j'><state_interface name='position'><param name='initial_value'>\n 1.5 \n\
         </param></state_interface></joint></ros2_control>",
    );
    let text = robot.controls[0].joints[0].states[0]
        .param("initial_value")
        .unwrap();
    assert_eq!(text.number(), Some(1.5));
    let place = expansion.place(text.origin).unwrap();
    assert_eq!(
        expansion
            .files
            .first()
            .unwrap()
            .source
            .document
            .slice(place.range),
        "1.5"
    );
}

#[test]
fn a_long_chain_needs_no_stack() {
    let links: Vec<String> = (0..5_000).map(|i| format!("l{i}")).collect();
    let joints: Vec<String> = (1..5_000)
        .map(|i| format!("j{i}:l{}>l{i}", i - 1))
        .collect();
    let (robot, kinematics) = chain(&links.join(" "), &joints.join(" "));
    assert!(kinematics.cycles().is_empty());
    assert_eq!(kinematics.roots(&robot), [0]);
}

#[test]
fn tags_begin_in_the_source() {
    let (expansion, robot) = robot("\n  <link\n name='a'/>");
    let place = expansion
        .place(tag_start(&expansion, robot.links.get(0).unwrap().element))
        .unwrap();
    assert_eq!(
        expansion
            .files
            .first()
            .unwrap()
            .source
            .document
            .slice(place.range),
        "<link"
    );
}

/// A robot of a version, a joint with an origin and a limit, a link with a capsule.
fn versioned(version: &str, origin: &str) -> Robot {
    let text = format!(
        "<robot name='r'{version}><link name='a'><visual><geometry><capsule radius='1' length='2'/></geometry>\
         </visual></link><joint name='j' type='revolute'><origin {origin}/>\
         <limit lower='0' upper='1' acceleration='2' jerk='3'/></joint></robot>"
    );
    Robot::of(&expanded(&text)).unwrap()
}

#[test]
fn quaternions_count_from_version_1_1_on() {
    use std::f64::consts::FRAC_PI_2;
    let table = [
        ("", "quat_xyzw='0 0 1 1'", Some([0.0; 3])),
        (
            " version='1.0'",
            "quat_xyzw='0 0 1 1' rpy='0 0 1'",
            Some([0.0, 0.0, 1.0]),
        ),
        (
            " version='1.1'",
            "quat_xyzw='0 0 1 1'",
            Some([0.0, 0.0, FRAC_PI_2]),
        ),
        (
            " version='1.2'",
            "quat_xyzw='3 0 0 3'",
            Some([FRAC_PI_2, 0.0, 0.0]),
        ),
        (" version='1.1'", "quat_xyzw='0 0 0 0'", Some([0.0; 3])),
        (" version='1.1'", "rpy='0 0 1'", Some([0.0, 0.0, 1.0])),
        (" version='1.1'", "quat_xyzw='0 0 1 1' rpy='0 0 0'", None),
        (" version='1.1'", "quat_xyzw='0 0 1'", None),
    ];
    for (version, origin, expected) in table {
        let robot = versioned(version, origin);
        let pose = robot.joints.get(0).unwrap().origin.as_ref().unwrap();
        let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        let found = pose.angles();
        let is_same = found
            .zip(expected)
            .map_or(found.is_none() && expected.is_none(), |(a, b)| near(a, b));
        assert!(is_same, "{version} {origin}: {found:?}");
        assert_eq!(
            pose.transform().is_some(),
            expected.is_some(),
            "{version} {origin}"
        );
    }
}

#[test]
fn capsules_and_the_limits_of_version_1_2() {
    for (version, expected) in [("", [false; 3]), (" version='1.2'", [true, false, true])] {
        let robot = versioned(version, "");
        let limit = robot.joints.get(0).unwrap().limit.as_ref().unwrap();
        assert_eq!(limit.dynamic.each_ref().map(Option::is_some), expected);
        let ShapeKind::Capsule { radius, length } =
            &robot.links.get(0).unwrap().visuals[0].shape().unwrap().kind
        else {
            panic!("no capsule");
        };
        let number =
            |text: &Option<super::AttrValue>| text.as_ref().and_then(super::AttrValue::number);
        assert_eq!((number(radius), number(length)), (Some(1.0), Some(2.0)));
    }
}
