//! What is read off launch files, scripts and pages.
use std::path::Path;

use super::Caller;
use super::file_names::may_call;
use super::read::caller;

/// The descriptions that a file calls, and the arguments with their values.
type Called<'a> = (&'a [&'a str], &'a [(&'a str, Option<&'a str>)]);

fn called(name: &str, text: &str) -> Option<Caller> {
    caller(Path::new(name), text)
}

fn check_caller(name: &str, text: &str, expected: Option<Called<'_>>) {
    let found = called(name, text).map(|caller| {
        let mut names: Vec<String> = caller.descriptions.into_keys().collect();
        names.sort_unstable();
        (
            names,
            caller
                .args
                .into_iter()
                .map(|arg| (arg.name, arg.value))
                .collect::<Vec<_>>(),
        )
    });
    let expected = expected.map(|(names, args)| {
        let args = args
            .iter()
            .map(|(name, value)| ((*name).to_owned(), value.map(str::to_owned)));
        (
            names
                .iter()
                .map(|name| (*name).to_owned())
                .collect::<Vec<_>>(),
            args.collect::<Vec<_>>(),
        )
    });
    assert_eq!(found, expected, "{text}");
}

#[test]
fn launch_files_in_xml() {
    let text = r#"<launch><arg name="side" default="left"/><arg name="who"/>
        <param name="d" command="$(find xacro)/xacro '$(find arm)/urdf/arm.urdf.xacro' side:=$(arg side) who:=$(arg who) n:=2"/>
        </launch>"#;
    let args = [("side", Some("left")), ("who", None), ("n", Some("2"))];
    check_caller("a.launch", text, Some((&["arm.urdf.xacro"], &args)));
}

#[test]
fn launch_files_in_python() {
    let text = r#"Command([FindExecutable(name="xacro"), " ", PathJoinSubstitution([pkg, "urdf", "arm.urdf.xacro"]),
        " ", "name:=", "arm", " ", "kind:=", kind, " sim:=true"])"#;
    let args = [("name", Some("arm")), ("kind", None), ("sim", Some("true"))];
    check_caller("a.launch.py", text, Some((&["arm.urdf.xacro"], &args)));
    let text = "<arg name='model' default='$(find a)/urdf/$(arg kind)_base.xacro'/> command='$(find xacro)/xacro $(arg model) x:=1'";
    let found = called("a.launch", text).unwrap();
    assert_eq!(found.endings, ["_base.xacro", ""]);
    let text = "doc = xacro.parse(open(path))\nxacro.process_doc(doc, mappings={'side': side})";
    check_caller("b.launch.py", text, Some((&[], &[("side", None)])));
    let text = r#"xacro.process_file(os.path.join(share, 'arm.xacro'), mappings={'side': 'left', "kind": kind})"#;
    let args = [("side", Some("left")), ("kind", None)];
    check_caller("test_arm.py", text, Some((&["arm.xacro"], &args)));
}

#[test]
fn pages_and_scripts() {
    let text = "Run `xacro urdf/arm.xacro side:=left`. See arm.urdf.";
    check_caller(
        "README.md",
        text,
        Some((&["arm.urdf", "arm.xacro"], &[("side", Some("left"))])),
    );
    check_caller(
        "README.md",
        "<xacro:include filename=\"$(find arm)/urdf/arm.xacro\"/>",
        None,
    );
    check_caller(
        "README.md",
        "├── urdf\n│   └── arm.xacro  # the arm\n",
        None,
    );
    check_caller(
        "CMakeLists.txt",
        "install(FILES urdf/arm.xacro DESTINATION share)",
        None,
    );
    check_caller(
        "CMakeLists.txt",
        "xacro_add_files(urdf/arm.xacro)",
        Some((&["arm.xacro"], &[])),
    );
    check_caller("a.py", "'.xacro' x:=1", None);
    check_caller("a.py", "arm.urdf_old", None);
    check_caller(
        "ä.md",
        "ä:=ö ä.urdf",
        Some((&["ä.urdf"], &[("ä", Some("ö"))])),
    );
}

#[test]
fn folders_in_front_of_names() {
    for (text, folders, package) in [
        ("arm.urdf", "", None),
        ("'$(find arm)/urdf/old/arm.urdf'", "urdf/old", Some("arm")),
        ("join(share, 'urdf', \"old\", 'arm.urdf')", "urdf/old", None),
        ("share / 'urdf' / 'arm.urdf'", "urdf", None),
        ("['xacro ', 'arm.urdf']", "", None),
        ("../urdf/arm.urdf", "urdf", None),
        (
            "[FindPackageShare('arm'), 'urdf', 'arm.urdf']",
            "urdf",
            Some("arm"),
        ),
        (
            "join(get_package_share_directory(\"arm\"),\n 'arm.urdf')",
            "",
            Some("arm"),
        ),
        ("join(get('arm'), 'arm.urdf')", "", None),
    ] {
        let found = called("a.launch.py", text).unwrap();
        let written = &found.descriptions["arm.urdf"][0];
        let package = package.map(str::to_owned);
        assert_eq!(
            (&*written.folders, &written.package),
            (Path::new(folders), &package),
            "{text}"
        );
    }
}

#[test]
fn comments_call_nothing() {
    let text = "<launch><!-- xacro old.urdf.xacro --><param command='xacro arm.xacro'/><!-- a:=1 --></launch>";
    check_caller("a.launch", text, Some((&["arm.xacro"], &[])));
    let text = "# xacro old.urdf.xacro a:=1\nrun('arm.xacro', 'b#:=2')  # or hand.xacro\n";
    check_caller("a.launch.py", text, Some((&["arm.xacro"], &[])));
    check_caller(
        "a.sh",
        "xacro 'it#s.xacro' # x.xacro",
        Some((&["s.xacro"], &[])),
    );
    check_caller("a.launch.py", "# only arm.xacro", None);
    let yaml = "urdf:\n  # the arm\n  path: arm.xacro\n  urdf_params:\n    # side\n    - side: left # or right\n    - size: big\n";
    check_caller(
        "a.yaml",
        yaml,
        Some((
            &["arm.xacro"],
            &[("side", Some("left")), ("size", Some("big"))],
        )),
    );
    let idle = "<launch><arg name='old' default='old.urdf'/><param textfile='arm.urdf'/></launch>";
    check_caller("a.launch", idle, Some((&["arm.urdf"], &[])));
    let read =
        "<launch><arg name='old' default='old.urdf'/><param textfile='$(arg old)'/></launch>";
    check_caller("a.launch", read, Some((&["old.urdf"], &[])));
}

#[test]
fn which_files_are_read() {
    for (name, expected) in [
        ("a.launch.py", true),
        ("a.launch", true),
        ("CMakeLists.txt", true),
        ("a.urdf.xacro", false),
        ("a.urdf.xml", false),
        ("package.xml", false),
        ("CHANGELOG.rst", false),
        ("a.stl", false),
    ] {
        assert_eq!(may_call(name), expected, "{name}");
    }
}
