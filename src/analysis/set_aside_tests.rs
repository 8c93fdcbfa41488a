//! Which findings are infos where a file is not in use, or for another program.

use crate::{CheckOptions, Session, Setup};
use rules::Severity;
use vfs::testing::Tree;

/// The places of a rule in a workspace of these files.
pub fn found(files: &[(&str, &str)], rule: &str) -> Vec<(String, Severity)> {
    let tree = Tree::new();
    for (name, text) in files {
        tree.write(name, text);
    }
    let setup = Setup { folders: vec![tree.root().to_owned()], ..Setup::default() };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let options = CheckOptions { paths: vec![tree.root().to_owned()], ..CheckOptions::default() };
    let report = session.check(&options);
    let of_rule = report.findings.iter().filter(|finding| finding.rule.name == rule);
    let place = |finding: &rules::Finding| {
        let path = session.vfs.path(finding.span.file);
        (path.strip_prefix(tree.root()).unwrap().display().to_string(), finding.severity)
    };
    of_rule.map(place).collect()
}

const BROKEN: &str = "<robot name='r'><link name='base'><visual/></link></robot>";

#[test]
fn old_files_that_nobody_uses() {
    let severity = |files: &[(&str, &str)]| found(files, "missing-element").first().map(|found| found.1);
    for (name, expected) in [
        ("urdf/arm.urdf", Severity::Error),
        ("urdf/golden.urdf", Severity::Error),
        ("urdf/deprecated/arm.urdf", Severity::Info),
        ("urdf/arm (copy).urdf", Severity::Info),
        ("old/arm.urdf", Severity::Info),
    ] {
        assert_eq!(severity(&[(name, BROKEN)]), Some(expected), "{name}");
    }
    let named = [("old/arm.urdf", BROKEN), ("old/see.launch", "<param textfile='old/arm.urdf'/>")];
    assert_eq!(severity(&named), Some(Severity::Error));
}

#[test]
fn packages_of_rosbuild() {
    let robot = "<robot name='r' xmlns:xacro='x'><property name='a' value='1'/><link name='base'/></robot>";
    let severity = |manifest: &str| {
        found(&[(manifest, "<package/>"), ("urdf/r.urdf.xacro", robot)], "unprefixed-xacro-tag")[0].1
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
fn references_that_fit_another_robot() {
    let part = "<robot><gazebo reference='lamp'><sensor name='eye' type='camera'/></gazebo></robot>";
    let robot = |links: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><link name='base'/>{links}<xacro:include filename='part.xacro'/></robot>"
        )
    };
    let lamp =
        "<link name='lamp'/><joint name='j' type='fixed'><parent link='base'/><child link='lamp'/></joint>";
    let severity = |robots: &[(&str, &str)]| {
        found(&[robots, &[("part.xacro", part)]].concat(), "gazebo-unknown-reference")
            .first()
            .map(|found| found.1)
    };
    let (with, without) = (robot(lamp), robot(""));
    let untaken = robot(&format!("<xacro:if value='0'>{lamp}</xacro:if>"));
    assert_eq!(severity(&[("a.urdf.xacro", &without)]), Some(Severity::Warning));
    assert_eq!(severity(&[("a.urdf.xacro", &without), ("b.urdf.xacro", &with)]), Some(Severity::Info));
    assert_eq!(severity(&[("a.urdf.xacro", &untaken)]), Some(Severity::Info));
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
        found(&[("r.urdf", &robot)], "com-outside-geometry").first().map(|found| found.1)
    };
    assert_eq!(severity(0.5, "fixed"), Some(Severity::Info));
    assert_eq!(severity(5.0, "fixed"), Some(Severity::Warning));
    assert_eq!(severity(0.5, "continuous"), Some(Severity::Warning));
}

#[test]
fn files_that_are_left_over() {
    let severity = |files: &[(&str, &str)]| {
        let manifest = ("package.xml", "<package><name>arm</name></package>");
        let all = [&[manifest, ("urdf/arm.urdf", BROKEN), ("urdf/new.urdf", BROKEN)], files].concat();
        found(&all, "missing-element").into_iter().find(|(name, _)| name == "urdf/arm.urdf").unwrap().1
    };
    let loads = |name: &str| format!("<launch><param textfile='$(find arm)/urdf/{name}'/></launch>");
    let new = loads("new.urdf");
    for (files, expected) in [
        (vec![], Severity::Error),
        (vec![("launch/show.launch", new.as_str())], Severity::Info),
        // the launch file loads nothing of this package
        (vec![("launch/show.launch", loads("other.urdf").as_str())], Severity::Error),
        (vec![("launch/show.launch", new.as_str()), ("README.md", "try arm.urdf")], Severity::Error),
        (
            vec![
                ("launch/show.launch", new.as_str()),
                ("urdf/cell.xacro", "<robot xmlns:xacro='x'><xacro:include filename='arm.urdf'/></robot>"),
                ("launch/cell.launch", "<param command='xacro $(find arm)/urdf/cell.xacro'/>"),
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
            vec![("launch/show.launch.py", "Command(['xacro ', LaunchConfiguration('model')]), 'new.urdf'")],
            Severity::Error,
        ),
        // this one has the source of the launched robot for its name
        (
            vec![
                ("urdf/arm.xacro", "<robot name='a'><link name='b'/></robot>"),
                ("launch/show.launch.py", "Command(['xacro ', LaunchConfiguration('model')]), 'arm.xacro'"),
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
            ("urdf/arm.urdf", "<robot name='arm'><link name='base'/></robot>"),
            ("launch/view.launch", shows),
            ("launch/sim.launch", simulates),
        ];
        found(&files, "inertia-triangle-inequality")[0].1
    };
    let shows = "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>";
    let simulates =
        "<param textfile='$(find arm)/urdf/arm.urdf'/><include file='$(find gazebo_ros)/x.launch'/>";
    assert_eq!(severity(shows, simulates), Severity::Info);
    assert_eq!(severity(shows, ""), Severity::Error);
    assert_eq!(severity(shows, &simulates.replace("arm.urdf", "view.urdf")), Severity::Error);
    assert_eq!(severity(&shows.replace("rviz", "gazebo_ros"), simulates), Severity::Error);
}

#[test]
fn descriptions_of_bullet_beside_its_programs() {
    let robot = "<robot name=''><link name='base'/></robot>";
    let severity = |files: &[(&str, &str)]| {
        found(&[&[("data/box.urdf", robot)], files].concat(), "missing-robot-name")[0].1
    };
    let program = ("examples/fall.py", "p.loadURDF('plane.urdf')");
    assert_eq!(severity(&[program]), Severity::Info);
    assert_eq!(severity(&[("examples/fall.py", "read('plane.urdf')")]), Severity::Error);
    // a package of ROS
    assert_eq!(severity(&[program, ("package.xml", "<package><name>r</name></package>")]), Severity::Error);
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
            ("urdf/arm.urdf", "<robot name='arm'><link name='base'/></robot>"),
            ("launch/view.launch", "<param textfile='$(find arm)/urdf/view.urdf'/><node pkg='rviz'/>"),
            ("launch/sim.launch", launch.as_str()),
        ];
        found(&files, "mesh-inconsistent-normals")[0].1
    };
    assert_eq!(severity("arm.urdf"), Severity::Info);
    assert_eq!(severity("view.urdf"), Severity::Warning);
}

#[test]
fn substitutions_that_a_program_replaces() {
    let robot = "<robot name='r' xmlns:xacro='x'><link name='base'/><gazebo><plugin name='p' filename='p.so'>\
                 <parameters>$(controllers)</parameters></plugin></gazebo></robot>";
    let severity =
        |program: &str| found(&[("urdf/r.urdf", robot), ("urdf/fill.py", program)], "expression-error")[0].1;
    assert_eq!(severity("open('r.urdf').read().replace('$(controllers)', path)"), Severity::Info);
    // an argument of that name was meant
    assert_eq!(severity("xacro r.urdf controllers:=x"), Severity::Error);
    assert_eq!(severity("open('other.urdf').read().replace('$(controllers)', path)"), Severity::Error);
}

#[test]
fn words_that_a_program_replaces() {
    let robot = "<robot name='r'><link name='base'><visual><geometry><box size='1 1 1'/></geometry>\
                 <material name='m'><color rgba='COLOR_RGBA'/></material></visual></link></robot>";
    let severity =
        |program: &str| found(&[("urdf/r.urdf", robot), ("urdf/fill.py", program)], "invalid-number")[0].1;
    assert_eq!(severity("open('r.urdf').read().replace('COLOR_RGBA', rgba)"), Severity::Info);
    assert_eq!(severity("open('r.urdf').read().replace('RGBA', rgba)"), Severity::Error);
}

#[test]
fn what_bullet_takes() {
    let robot = "<robot name='r'><link name='base'/><link name='arm'/><joint name='j' type='spherical'>\
                 <parent link='base'/><child link='arm'/></joint></robot>";
    let severity =
        |name: &str, text: &str| found(&[("urdf/r.urdf", robot), (name, text)], "unknown-joint-type")[0].1;
    assert_eq!(severity("run.py", "p.loadURDF('urdf/r.urdf')"), Severity::Info);
    assert_eq!(severity("run.py", "p.load('urdf/r.urdf')"), Severity::Error);
    assert_eq!(severity("r.launch", "p.loadURDF('urdf/r.urdf')"), Severity::Error);
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
        found(&files, "missing-element").into_iter().find(|(name, _)| name == "urdf/old/arm.urdf").unwrap().1
    };
    assert_eq!(severity("join(share, 'urdf', 'arm.urdf')"), Severity::Info);
    assert_eq!(severity("join(share, 'urdf', 'old', 'arm.urdf')"), Severity::Error);
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
        found.into_iter().find(|(name, _)| name == "gym/assets/dog/dog.urdf").unwrap().1
    };
    let launch = ("arm/launch/show.launch", "<param textfile='$(find arm)/urdf/arm.urdf'/>");
    assert_eq!(severity(&[]), Severity::Error);
    assert_eq!(severity(&[launch]), Severity::Info);
    // without launch files, programs load robots; not so tests, and what takes all files of a folder
    let program = |name: &'static str, text: &'static str| severity(&[(name, text)]);
    assert_eq!(program("run.py", "load('arm/urdf/arm.urdf')"), Severity::Info);
    assert_eq!(program("tests/run.py", "load('arm/urdf/arm.urdf')"), Severity::Error);
    assert_eq!(program("run.py", "load('arm/urdf/arm.urdf'), glob('*.urdf')"), Severity::Error);
    // what the launch file loads is elsewhere
    let foreign = ("arm/launch/show.launch", "<param textfile='$(find leg)/urdf/leg.urdf'/>");
    assert_eq!(severity(&[foreign]), Severity::Error);
    for script in ["load('assets/dog/dog.urdf')", "load('{root}/dog.urdf')", "load(f'{kind}.urdf')"] {
        assert_eq!(severity(&[launch, ("gym/run.py", script)]), Severity::Error, "{script}");
    }
    assert_eq!(severity(&[launch, ("gym/run.py", "load('assets/cat/dog.urdf')")]), Severity::Error);
    // a package has one of the same name and place
    let other = ("arm/dog/dog.urdf", BROKEN);
    let named = ("arm/launch/dog.launch", "<param textfile='$(find arm)/dog/dog.urdf'/>");
    assert_eq!(severity(&[launch, other, named]), Severity::Info);
    let cat = ("gym/assets/cat/dog.urdf", BROKEN);
    assert_eq!(severity(&[launch, cat, ("gym/run.py", "load('cat/dog.urdf')")]), Severity::Info);
}

#[test]
fn templates_that_a_script_fills() {
    let severity = |files: &[(&str, &str)]| {
        let all = [&[("urdf/arm_template.xacro", BROKEN)], files].concat();
        found(&all, "missing-element").first().unwrap().1
    };
    let script = ("scripts/fill.py", "parse('urdf/arm_template.xacro')");
    assert_eq!(severity(&[script]), Severity::Info);
    assert_eq!(severity(&[script, ("arm.launch", "xacro arm_template.xacro")]), Severity::Error);
}

#[test]
fn generated_files() {
    let with_head = |text: &str| {
        format!(
            "<?xml version='1.0'?>\n<!-- | This document was autogenerated by xacro from ../arm.urdf.xacro | -->\n{text}"
        )
    };
    let generated = with_head(BROKEN);
    // its source is elsewhere: this is the robot
    let places = found(&[("urdf/arm.urdf", &generated)], "missing-element");
    assert_eq!(places, [("urdf/arm.urdf".to_owned(), Severity::Error)]);
    let source = BROKEN.replace("<robot", "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'");
    let both = |generated: &str| {
        found(&[("urdf/arm.urdf", generated), ("arm.urdf.xacro", &source)], "missing-element")
    };
    assert_eq!(both(&generated), [("arm.urdf.xacro".to_owned(), Severity::Error)]);
    // what only the generated file has is said there
    let other = with_head(&BROKEN.replace("base", "hand"));
    assert_eq!(
        both(&other),
        [("arm.urdf.xacro".to_owned(), Severity::Error), ("urdf/arm.urdf".to_owned(), Severity::Info)]
    );
    let loaded = found(
        &[
            ("urdf/arm.urdf", &other),
            ("arm.urdf.xacro", &source),
            ("arm.launch", "<param textfile='urdf/arm.urdf'/>"),
        ],
        "missing-element",
    );
    assert_eq!(loaded.last(), Some(&("urdf/arm.urdf".to_owned(), Severity::Error)));
}

#[test]
fn files_of_gazebo_models() {
    let severity = |config: &str, further: &[(&str, &str)]| {
        let model = [("models/boat/model.config", config), ("models/boat/meshes/boat.urdf", BROKEN)];
        found(&[&model, further].concat(), "missing-element").first().map(|found| found.1)
    };
    let other = "<model><name>boat</name><sdf version='1.6'>model.sdf</sdf></model>";
    assert_eq!(severity(other, &[]), Some(Severity::Info));
    assert_eq!(severity("<model><sdf version='1.6'>boat.urdf</sdf></model>", &[]), Some(Severity::Error));
    let launch = ("models/boat/a.launch", "<param textfile='models/boat/meshes/boat.urdf'/>");
    assert_eq!(severity(other, &[launch]), Some(Severity::Error));
}

#[test]
fn launch_files_that_are_kept() {
    let robot = ("urdf/r.urdf", "<robot name='r'><link name='base'/></robot>");
    let call = "<launch><param command=\"xacro '$(find r)/urdf/gone.urdf.xacro'\"/></launch>";
    let manifest = ("package.xml", "<package><name>r</name></package>");
    let severity = |launch: &str| found(&[manifest, robot, (launch, call)], "launched-file-not-found")[0].1;
    assert_eq!(severity("launch/r.launch"), Severity::Warning);
    assert_eq!(severity("launch/past/r.launch"), Severity::Info);
}

#[test]
fn meshes_that_git_leaves_out() {
    let mesh = "<robot name='r'><link name='base'><visual><geometry><mesh filename='package://r/meshes/a.stl'/></geometry>\
                </visual></link></robot>";
    let manifest = ("package.xml", "<package><name>r</name></package>");
    let severity = |further: &[(&str, &str)]| {
        found(&[&[manifest, ("r.urdf", mesh)], further].concat(), "mesh-not-found")[0].1
    };
    assert_eq!(severity(&[]), Severity::Error);
    assert_eq!(severity(&[(".gitignore", "/meshes/\n")]), Severity::Info);
    // others are there: this one is misspelled
    assert_eq!(severity(&[(".gitignore", "/meshes/\n"), ("meshes/b.stl", "")]), Severity::Error);
}

#[test]
fn joints_that_hardware_registers() {
    let severity = |further: &[(&str, &str)]| {
        let files = [
            ("package.xml", "<package><name>r</name><buildtool_depend>catkin</buildtool_depend></package>"),
            ("r.launch", "<param textfile='$(find r)/r.urdf'/><rosparam file='$(find r)/c.yaml'/>"),
            (
                "r.urdf",
                "<robot name='r'><link name='base'/><link name='left'/><joint name='left_joint' type='fixed'>\
                        <parent link='base'/><child link='left'/></joint></robot>",
            ),
            (
                "c.yaml",
                "base:\n  type: diff_drive_controller/DiffDriveController\n  left_wheel: wheel_0\n  right_wheel: left_joint\n",
            ),
        ];
        found(&[&files, further].concat(), "controller-unknown-joint").first().map(|found| found.1)
    };
    assert_eq!(severity(&[]), Some(Severity::Error));
    let registers =
        ("src/base.cpp", "hardware_interface::JointStateHandle handle(name + std::to_string(i));");
    assert_eq!(severity(&[registers]), Some(Severity::Info));
}

/// The severity of the only place of a rule in a package of these files.
fn severity_in(rule: &str, files: &[(&str, &str)]) -> Option<Severity> {
    let manifest =
        ("package.xml", "<package><name>r</name><buildtool_depend>catkin</buildtool_depend></package>");
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
        severity_in("use-before-definition", &[("urdf/r.urdf.xacro", robot), ("r.launch", &launch)])
    };
    assert_eq!(severity("$(find xacro)/xacro.py"), Some(Severity::Info));
    assert_eq!(severity("$(find xacro)/xacro.py --inorder"), Some(Severity::Error));
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
        let files = [("urdf/r.urdf.xacro", robot), ("urdf/extra.xacro", extra), ("r.launch", &launch)];
        severity_in("undefined-property", &files)
    };
    assert_eq!(severity("$(find r)/urdf/extra.xacro"), None);
    assert_eq!(severity("$(find r)/urdf/other.xacro"), Some(Severity::Info));
}

#[test]
fn files_that_the_build_makes() {
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:include filename='$(find r)/urdf/leg.urdf'/><link name='base'/></robot>";
    let severity = |cmake: &str| {
        severity_in("include-not-found", &[("urdf/r.urdf.xacro", robot), ("CMakeLists.txt", cmake)])
    };
    let from_model = "generate_gazebo_urdf_file(${MODELS}/leg.dae)";
    assert_eq!(severity(from_model), Some(Severity::Info));
    assert_eq!(severity("set(PATCHED \"leg.urdf\")"), Some(Severity::Info));
    assert_eq!(severity("install(FILES urdf/leg.urdf DESTINATION share/r)"), Some(Severity::Error));
    assert_eq!(severity(&from_model.replace("leg", "arm")), Some(Severity::Error));
}

#[test]
fn macros_that_a_missing_file_may_define() {
    let robot = |include: &str| {
        format!(
            "<robot name='r' xmlns:xacro='x'><xacro:macro name='arm'>{include}<xacro:arm/></xacro:macro><xacro:arm/></robot>"
        )
    };
    let severity =
        |include: &str| severity_in("infinite-macro-recursion", &[("r.urdf.xacro", &robot(include))]);
    assert_eq!(severity("<xacro:include filename='$(find vendor_arm)/arm.xacro'/>"), None);
    assert_eq!(severity(""), Some(Severity::Error));
}

#[test]
fn shapes_that_are_commented_out() {
    let link = |body: &str| format!("<robot name='r'><link name='base'>{body}</link></robot>");
    let empty = |body: &str| severity_in("empty-geometry", &[("r.urdf", &link(body))]);
    let missing = |body: &str| severity_in("missing-element", &[("r.urdf", &link(body))]);
    let commented = "<visual><geometry><!-- <box size='1 1 1'/> --></geometry></visual>";
    assert_eq!(empty(commented), Some(Severity::Info));
    assert_eq!(missing("<collision><!-- <geometry/> --></collision>"), Some(Severity::Info));
    assert_eq!(empty("<visual><geometry/></visual>"), Some(Severity::Error));
    assert_eq!(missing("<collision><!-- no shape --></collision>"), Some(Severity::Error));
    // urdfdom loses what is behind it
    let collision = "<collision><geometry><box size='1 1 1'/></geometry></collision>";
    assert_eq!(empty(&format!("{commented}{collision}")), Some(Severity::Error));
}

#[test]
fn transmissions_beside_a_plugin_that_drives() {
    let robot = |plugin: &str| {
        format!(
            "<robot name='r'><link name='base'/><transmission name='t'><type>transmission_interface/SimpleTransmission</type>\
             <joint name='wheel'/></transmission><gazebo><plugin name='p' filename='{plugin}'/></gazebo></robot>"
        )
    };
    let severity =
        |plugin: &str| severity_in("transmission-unknown-joint", &[("r.urdf", robot(plugin).as_str())]);
    assert_eq!(severity("libgazebo_ros_skid_steer_drive.so"), Some(Severity::Info));
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
        found(&[("r.urdf", robot(moments).as_str())], "inertia-triangle-inequality")
            .first()
            .map(|found| found.1)
    };
    assert_eq!(severity("ixx='0.1' iyy='0.9' izz='0.1'"), Some(Severity::Info));
    assert_eq!(severity("ixx='0.1' iyy='0.1' izz='0.9'"), Some(Severity::Error));
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
        severity_in("redefined-macro", &[("a.xacro", &a), ("b.xacro", &b), ("r.urdf.xacro", &robot)])
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
    assert_eq!(severity("<param textfile='$(find r)/urdf/used.urdf'/>"), Some(Severity::Info));
    assert_eq!(
        severity("<param textfile='$(find r)/urdf/used.urdf'/><!-- first.xacro -->"),
        Some(Severity::Info)
    );
    let both =
        "<param textfile='$(find r)/urdf/used.urdf'/><param command=\"xacro '$(find r)/urdf/first.xacro'\"/>";
    assert_eq!(severity(both), Some(Severity::Error));
}
