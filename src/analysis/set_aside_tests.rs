//! Which findings are infos where a file is not in use, or for another program.
use super::{CheckOptions, Session, Setup};
use rules::Severity;
use vfs::testing::Tree;

/// The places of a rule in a workspace of these files.
pub fn found(files: &[(&str, &str)], rule: &str) -> Vec<(String, Severity)> {
    let tree = Tree::new();
    for (name, text) in files {
        tree.write(name, text);
    }
    let setup = Setup {
        folders: vec![tree.root().to_owned()],
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let options = CheckOptions {
        paths: vec![tree.root().to_owned()],
        ..CheckOptions::default()
    };
    let report = crate::check(&session, &options);
    let of_rule = report
        .findings
        .iter()
        .filter(|finding| finding.rule.name == rule);
    let place = |finding: &rules::Finding| {
        let path = session.vfs.path(finding.span.file);
        (
            path.strip_prefix(tree.root())
                .unwrap()
                .display()
                .to_string(),
            finding.severity,
        )
    };
    of_rule.map(place).collect()
}

pub const BROKEN: &str = "<robot name='r'><link name='base'><visual/></link></robot>";

#[test]
fn old_files_that_nobody_uses() {
    let severity =
        |files: &[(&str, &str)]| found(files, "missing-element").first().map(|found| found.1);
    for (name, expected) in [
        ("urdf/arm.urdf", Severity::Error),
        ("urdf/golden.urdf", Severity::Error),
        ("urdf/deprecated/arm.urdf", Severity::Info),
        ("urdf/arm (copy).urdf", Severity::Info),
        ("old/arm.urdf", Severity::Info),
    ] {
        assert_eq!(severity(&[(name, BROKEN)]), Some(expected), "{name}");
    }
    let named = [
        ("old/arm.urdf", BROKEN),
        ("old/see.launch", "<param textfile='old/arm.urdf'/>"),
    ];
    assert_eq!(severity(&named), Some(Severity::Error));
    // beside a robot that is not kept, a launch file that is kept says nothing
    let other = ("urdf/new.urdf", "<robot name='n'><link name='n'/></robot>");
    let beside = [named[0], named[1], other];
    assert_eq!(severity(&beside), Some(Severity::Info));
    let page = ("README.md", "xacro old/arm.urdf");
    assert_eq!(
        severity(&[named[0], named[1], other, page]),
        Some(Severity::Error)
    );
    let page = ("README.md", "The folder old/ keeps arm.urdf.");
    assert_eq!(
        severity(&[named[0], named[1], other, page]),
        Some(Severity::Info)
    );
}

#[test]
fn packages_of_rosbuild() {
    let robot =
        "<robot name='r' xmlns:xacro='x'><property name='a' value='1'/><link name='base'/></robot>";
    let severity = |manifest: &str| {
        found(
            &[(manifest, "<package/>"), ("urdf/r.urdf.xacro", robot)],
            "unprefixed-xacro-tag",
        )[0]
        .1
    };
    assert_eq!(severity("manifest.xml"), Severity::Info);
    assert_eq!(severity("other.xml"), Severity::Error);
    // launch files that run xacro as it was then
    let launched = |command: &str| {
        let launch = format!("<param command=\"{command} '$(find r)/urdf/r.urdf.xacro'\"/>");
        let files = [
            ("package.xml", "<package><name>r</name></package>"),
            ("r.launch", launch.as_str()),
            ("urdf/r.urdf.xacro", robot),
        ];
        found(&files, "unprefixed-xacro-tag")[0].1
    };
    assert_eq!(launched("$(find xacro)/xacro.py"), Severity::Info);
    assert_eq!(launched("$(find xacro)/xacro --inorder"), Severity::Warning);
    assert_eq!(launched("$(find xacro)/xacro"), Severity::Error);
}

#[test]
fn limits_that_an_old_xacro_inserts() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:macro name='m' params='*stop'><joint name='j' type='revolute'>\
        <parent link='base'/><child link='arm'/><insert_block name='stop'/></joint></xacro:macro><link name='base'/>\
        <link name='arm'/><xacro:m><limit lower='0' upper='1' effort='1' velocity='1'/></xacro:m></robot>";
    let severity = |robot: &str, command: &str| {
        let launch = format!("<param command=\"{command} '$(find r)/urdf/r.urdf.xacro'\"/>");
        let files = [
            ("package.xml", "<package><name>r</name></package>"),
            ("r.launch", launch.as_str()),
            ("urdf/r.urdf.xacro", robot),
        ];
        found(&files, "missing-joint-limit")[0].1
    };
    let (old, new) = ("$(find xacro)/xacro.py", "$(find xacro)/xacro");
    assert_eq!(severity(robot, old), Severity::Info);
    assert_eq!(severity(robot, new), Severity::Error);
    let without = robot.replace("<insert_block name='stop'/>", "");
    assert_eq!(severity(&without, old), Severity::Error);
}

#[test]
fn references_that_fit_another_robot() {
    let part =
        "<robot><gazebo reference='lamp'><sensor name='eye' type='camera'/></gazebo></robot>";
    let robot = |links: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><link name='base'/>{links}<xacro:include filename='part.xacro'/></robot>"
        )
    };
    let lamp = "<link name='lamp'/><joint name='j' type='fixed'><parent link='base'/><child link='lamp'/></joint>";
    let severity = |robots: &[(&str, &str)]| {
        found(
            &[robots, &[("part.xacro", part)]].concat(),
            "gazebo-unknown-reference",
        )
        .first()
        .map(|found| found.1)
    };
    let (with, without) = (robot(lamp), robot(""));
    let untaken = robot(&format!("<xacro:if value='0'>{lamp}</xacro:if>"));
    assert_eq!(
        severity(&[("a.urdf.xacro", &without)]),
        Some(Severity::Warning)
    );
    assert_eq!(
        severity(&[("a.urdf.xacro", &without), ("b.urdf.xacro", &with)]),
        Some(Severity::Info)
    );
    assert_eq!(
        severity(&[("a.urdf.xacro", &untaken)]),
        Some(Severity::Info)
    );
}

#[test]
fn centers_of_small_parts() {
    let link = |name: &str, mass: f64, x: f64| {
        format!(
            "<link name='{name}'><inertial><origin xyz='{x} 0 0'/><mass value='{mass}'/>\
             <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1.5'/></inertial>\
             <collision><geometry><box size='0.2 0.2 0.2'/></geometry></collision></link>"
        )
    };
    let severity = |mass: f64, joint: &str| {
        let robot = format!(
            "<robot name='r'>{}{}<joint name='j' type='{joint}'><parent link='base'/><child link='lamp'/></joint></robot>",
            link("base", 20.0, 0.0),
            link("lamp", mass, 0.6)
        );
        found(&[("r.urdf", &robot)], "com-outside-geometry")
            .first()
            .map(|found| found.1)
    };
    assert_eq!(severity(0.5, "fixed"), Some(Severity::Info));
    assert_eq!(severity(5.0, "fixed"), Some(Severity::Warning));
    assert_eq!(severity(0.5, "continuous"), Some(Severity::Warning));
}

#[test]
fn files_that_are_left_over() {
    let severity = |files: &[(&str, &str)]| {
        let manifest = ("package.xml", "<package><name>arm</name></package>");
        let all = [
            &[
                manifest,
                ("urdf/arm.urdf", BROKEN),
                ("urdf/new.urdf", BROKEN),
            ],
            files,
        ]
        .concat();
        found(&all, "missing-element")
            .into_iter()
            .find(|(name, _)| name == "urdf/arm.urdf")
            .unwrap()
            .1
    };
    let loads =
        |name: &str| format!("<launch><param textfile='$(find arm)/urdf/{name}'/></launch>");
    let new = loads("new.urdf");
    for (files, expected) in [
        (vec![], Severity::Error),
        (vec![("launch/show.launch", new.as_str())], Severity::Info),
        // the launch file loads nothing of this package
        (
            vec![("launch/show.launch", loads("other.urdf").as_str())],
            Severity::Error,
        ),
        (
            vec![
                ("launch/show.launch", new.as_str()),
                ("README.md", "try arm.urdf"),
            ],
            Severity::Error,
        ),
        (
            vec![
                ("launch/show.launch", new.as_str()),
                (
                    "urdf/cell.xacro",
                    "<robot xmlns:xacro='x'><xacro:include filename='arm.urdf'/></robot>",
                ),
                (
                    "launch/cell.launch",
                    "<param command='xacro $(find arm)/urdf/cell.xacro'/>",
                ),
            ],
            Severity::Error,
        ),
        // whoever calls the launch file names the robot
        (
            vec![(
                "launch/show.launch",
                "<param command='xacro $(arg model)'/><arg name='model' default='new.urdf'/>",
            )],
            Severity::Error,
        ),
        (
            vec![(
                "launch/show.launch.py",
                "Command(['xacro ', LaunchConfiguration('model')]), 'new.urdf'",
            )],
            Severity::Error,
        ),
        // this one has the source of the launched robot for its name
        (
            vec![
                ("urdf/arm.xacro", "<robot name='a'><link name='b'/></robot>"),
                (
                    "launch/show.launch.py",
                    "Command(['xacro ', LaunchConfiguration('model')]), 'arm.xacro'",
                ),
            ],
            Severity::Info,
        ),
    ] {
        assert_eq!(severity(&files), expected, "{files:?}");
    }
}

#[test]
fn robots_that_are_only_shown() {
    let robot = "<robot name='r'><link name='base'><inertial><mass value='1'/>\
                 <inertia ixx='1' ixy='0' ixz='0' iyy='0.1' iyz='0' izz='0.1'/></inertial></link></robot>";
    let severity = |shows: &str, simulates: &str| {
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/view.urdf", robot),
            (
                "urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            ("launch/view.launch", shows),
            ("launch/sim.launch", simulates),
        ];
        found(&files, "inertia-triangle-inequality")[0].1
    };
    let shows = "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>";
    let simulates = "<param textfile='$(find arm)/urdf/arm.urdf'/><include file='$(find gazebo_ros)/x.launch'/>";
    assert_eq!(severity(shows, simulates), Severity::Info);
    assert_eq!(severity(shows, ""), Severity::Warning);
    assert_eq!(
        severity(shows, &simulates.replace("arm.urdf", "view.urdf")),
        Severity::Warning
    );
    assert_eq!(
        severity(&shows.replace("rviz", "gazebo_ros"), simulates),
        Severity::Warning
    );
    // Gazebo Sim refuses it
    assert_eq!(
        severity(&shows.replace("rviz", "ros_gz_sim"), simulates),
        Severity::Error
    );
}

#[test]
fn descriptions_of_bullet_beside_its_programs() {
    let robot = "<robot name=''><link name='base'/></robot>";
    let severity = |files: &[(&str, &str)]| {
        found(
            &[&[("data/box.urdf", robot)], files].concat(),
            "missing-robot-name",
        )[0]
        .1
    };
    let program = ("examples/fall.py", "p.loadURDF('plane.urdf')");
    assert_eq!(severity(&[program]), Severity::Info);
    assert_eq!(
        severity(&[("examples/fall.py", "read('plane.urdf')")]),
        Severity::Error
    );
    // a package of ROS
    assert_eq!(
        severity(&[
            program,
            ("package.xml", "<package><name>r</name></package>")
        ]),
        Severity::Error
    );
    let launch = ("launch/box.launch", "<param textfile='data/box.urdf'/>");
    assert_eq!(severity(&[program, launch]), Severity::Error);
}

#[test]
fn contacts_of_robots_that_are_only_shown() {
    // a tetrahedron with a face turned inside out
    let facets = ["0 1 2", "0 1 3", "1 2 3", "2 0 3"].map(|corners| {
        let points = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];
        let vertex = |n: &str| format!("vertex {}\n", points[n.parse::<usize>().unwrap()]);
        let vertices: String = corners.split(' ').map(vertex).collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    });
    let mesh = format!("solid part\n{}endsolid\n", facets.concat());
    let robot = "<robot name='r'><link name='base'><collision><geometry><mesh filename='part.stl'/></geometry>\
                 </collision></link></robot>";
    let severity = |simulated: &str| {
        let launch = format!(
            "<param textfile='$(find arm)/urdf/{simulated}'/><include file='$(find gazebo_ros)/x.launch'/>"
        );
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/view.urdf", robot),
            ("urdf/part.stl", mesh.as_str()),
            (
                "urdf/arm.urdf",
                "<robot name='arm'><link name='base'/></robot>",
            ),
            (
                "launch/view.launch",
                "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>",
            ),
            ("launch/sim.launch", launch.as_str()),
        ];
        found(&files, "mesh-inconsistent-normals")[0].1
    };
    assert_eq!(severity("arm.urdf"), Severity::Info);
    assert_eq!(severity("view.urdf"), Severity::Warning);
    // these take the convex hull
    let with_program = |program: &str| {
        let files = [
            ("urdf/r.urdf", robot),
            ("urdf/part.stl", mesh.as_str()),
            ("run.py", program),
        ];
        found(&files, "mesh-inconsistent-normals")[0].1
    };
    assert_eq!(
        with_program("import mujoco\nload('r.urdf')"),
        Severity::Info
    );
    assert_eq!(
        with_program("import fcl\nload('r.urdf')"),
        Severity::Warning
    );
}

#[test]
fn substitutions_that_a_program_replaces() {
    let robot = "<robot name='r' xmlns:xacro='x'><link name='base'/><gazebo><plugin name='p' filename='p.so'>\
                 <parameters>$(controllers)</parameters></plugin></gazebo></robot>";
    let severity = |program: &str| {
        found(
            &[("urdf/r.urdf", robot), ("urdf/fill.py", program)],
            "expression-error",
        )[0]
        .1
    };
    assert_eq!(
        severity("open('r.urdf').read().replace('$(controllers)', path)"),
        Severity::Info
    );
    // an argument of that name was meant
    assert_eq!(severity("xacro r.urdf controllers:=x"), Severity::Error);
    assert_eq!(
        severity("open('other.urdf').read().replace('$(controllers)', path)"),
        Severity::Error
    );
}

#[test]
fn words_that_a_program_replaces() {
    let robot = "<robot name='r'><link name='base'><visual><geometry><box size='1 1 1'/></geometry>\
                 <material name='m'><color rgba='COLOR_RGBA'/></material></visual></link></robot>";
    let severity = |program: &str| {
        found(
            &[("urdf/r.urdf", robot), ("urdf/fill.py", program)],
            "invalid-number",
        )[0]
        .1
    };
    assert_eq!(
        severity("open('r.urdf').read().replace('COLOR_RGBA', rgba)"),
        Severity::Info
    );
    assert_eq!(
        severity("open('r.urdf').read().replace('RGBA', rgba)"),
        Severity::Error
    );
}

#[test]
fn what_bullet_takes() {
    let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='spherical'>\
                 <parent link='base'/><child link='arm'/></joint></robot>";
    let severity = |name: &str, text: &str| {
        found(
            &[("urdf/r.urdf", robot), (name, text)],
            "unknown-joint-type",
        )[0]
        .1
    };
    assert_eq!(
        severity("run.py", "p.loadURDF('urdf/r.urdf')"),
        Severity::Info
    );
    assert_eq!(severity("run.py", "p.load('urdf/r.urdf')"), Severity::Error);
    assert_eq!(
        severity("r.launch", "p.loadURDF('urdf/r.urdf')"),
        Severity::Error
    );
}

#[test]
fn what_raisim_takes() {
    let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='revolute'>\
                 <origin xyz='0, 0, 1'/><parent link='base'/><child link='arm'/></joint></robot>";
    let severity = |rule: &str, program: &str| {
        found(&[("urdf/r.urdf", robot), ("run.py", program)], rule)[0].1
    };
    let loads = "import raisimpy as raisim\nworld.addArticulatedSystem('urdf/r.urdf')";
    for rule in ["missing-joint-limit", "invalid-number"] {
        assert_eq!(severity(rule, loads), Severity::Info, "{rule}");
        assert_eq!(
            severity(rule, "p.load('urdf/r.urdf')"),
            Severity::Error,
            "{rule}"
        );
    }
}

#[test]
fn blanks_in_front_of_the_declaration() {
    let robot = "\n<?xml version='1.0'?>\n<robot name='r'><link name='base'/></robot>";
    let severity = |name: &str, launch: &str| {
        found(&[(name, robot), ("r.launch", launch)], "xml-syntax-error")[0].1
    };
    let read = "<param name='robot_description' textfile='urdf/r.urdf'/>";
    let run = "<param name='robot_description' command='xacro urdf/r.urdf'/>";
    assert_eq!(severity("urdf/r.urdf", read), Severity::Warning);
    assert_eq!(severity("urdf/r.urdf", run), Severity::Error);
    assert_eq!(severity("urdf/r.xacro", read), Severity::Error);
}

#[test]
fn equal_names_in_other_folders() {
    let severity = |launch: &str| {
        let files = [
            ("package.xml", "<package><name>arm</name></package>"),
            ("urdf/old/arm.urdf", BROKEN),
            ("urdf/arm.urdf", BROKEN),
            ("launch/show.launch.py", launch),
        ];
        found(&files, "missing-element")
            .into_iter()
            .find(|(name, _)| name == "urdf/old/arm.urdf")
            .unwrap()
            .1
    };
    assert_eq!(severity("join(share, 'urdf', 'arm.urdf')"), Severity::Info);
    assert_eq!(
        severity("join(share, 'urdf', 'old', 'arm.urdf')"),
        Severity::Error
    );
    assert_eq!(severity("join(folder, 'arm.urdf')"), Severity::Error);
}

#[test]
fn copies_outside_of_packages() {
    let severity = |files: &[(&str, &str)]| {
        let robot = [
            ("arm/package.xml", "<package><name>arm</name></package>"),
            ("arm/urdf/arm.urdf", BROKEN),
            ("gym/assets/dog/dog.urdf", BROKEN),
        ];
        let found = found(&[&robot, files].concat(), "missing-element");
        found
            .into_iter()
            .find(|(name, _)| name == "gym/assets/dog/dog.urdf")
            .unwrap()
            .1
    };
    let launch = (
        "arm/launch/show.launch",
        "<param textfile='$(find arm)/urdf/arm.urdf'/>",
    );
    assert_eq!(severity(&[]), Severity::Error);
    assert_eq!(severity(&[launch]), Severity::Info);
    // without launch files, programs load robots; not so tests, and what takes all files of a folder
    let program = |name: &'static str, text: &'static str| severity(&[(name, text)]);
    assert_eq!(
        program("run.py", "load('arm/urdf/arm.urdf')"),
        Severity::Info
    );
    assert_eq!(
        program("tests/run.py", "load('arm/urdf/arm.urdf')"),
        Severity::Error
    );
    assert_eq!(
        program("run.py", "load('arm/urdf/arm.urdf'), glob('*.urdf')"),
        Severity::Error
    );
    // what the launch file loads is elsewhere
    let foreign = (
        "arm/launch/show.launch",
        "<param textfile='$(find leg)/urdf/leg.urdf'/>",
    );
    assert_eq!(severity(&[foreign]), Severity::Error);
    for script in [
        "load('assets/dog/dog.urdf')",
        "load('{root}/dog.urdf')",
        "load(f'{kind}.urdf')",
    ] {
        assert_eq!(
            severity(&[launch, ("gym/run.py", script)]),
            Severity::Error,
            "{script}"
        );
    }
    assert_eq!(
        severity(&[launch, ("gym/run.py", "load('assets/cat/dog.urdf')")]),
        Severity::Error
    );
    // a package has one of the same name and place
    let other = ("arm/dog/dog.urdf", BROKEN);
    let named = (
        "arm/launch/dog.launch",
        "<param textfile='$(find arm)/dog/dog.urdf'/>",
    );
    assert_eq!(severity(&[launch, other, named]), Severity::Info);
    let cat = ("gym/assets/cat/dog.urdf", BROKEN);
    assert_eq!(
        severity(&[launch, cat, ("gym/run.py", "load('cat/dog.urdf')")]),
        Severity::Info
    );
}

#[test]
fn templates_that_a_script_fills() {
    let severity = |files: &[(&str, &str)]| {
        let all = [&[("urdf/arm_template.xacro", BROKEN)], files].concat();
        found(&all, "missing-element").first().unwrap().1
    };
    let script = ("scripts/fill.py", "parse('urdf/arm_template.xacro')");
    assert_eq!(severity(&[script]), Severity::Info);
    assert_eq!(
        severity(&[script, ("arm.launch", "xacro arm_template.xacro")]),
        Severity::Error
    );
}
