//! What users of the library see.

use std::path::Path;

use super::{Options, expand};
use vfs::testing::Tree;

const XACRO: &str = "xmlns:xacro='http://www.ros.org/wiki/xacro'";

fn arm(body: &str) -> Tree {
    let tree = Tree::new();
    tree.write("arm/package.xml", "<package><name>arm</name></package>");
    tree.write("arm/meshes/base.stl", "");
    tree.write(
        "arm/urdf/part.xacro",
        &format!("<robot {XACRO}>\n<xacro:macro name='part'>\n{body}\n</xacro:macro></robot>"),
    );
    tree.write(
        "arm/urdf/arm.urdf.xacro",
        &format!(
            "<robot name='arm' {XACRO}>\n<xacro:include filename='part.xacro'/>\n\
             <xacro:arg name='side' default='left'/>\n<xacro:part/>\n</robot>"
        ),
    );
    tree
}

fn name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

#[test]
fn a_robot_and_where_it_came_from() {
    let tree = arm("<link name='$(arg side)_base'/>");
    let robot = expand(
        tree.path("arm/urdf/arm.urdf.xacro"),
        &Options::new().arg("side", "right"),
    );
    assert_eq!(robot.problems(), []);
    let text = robot.text().unwrap();
    let line = text
        .lines()
        .position(|line| line.contains("right_base"))
        .unwrap() as u32
        + 1;
    let source = robot.source_of_line(line).unwrap();
    assert_eq!(
        (name(&source.path), source.line, source.column),
        ("part.xacro".to_owned(), 3, 1)
    );
    assert_eq!(robot.source_of_line(0), None);
    assert_eq!(robot.source_of_line(10_000), None);
    assert_eq!(
        robot.files().map(name).collect::<Vec<_>>(),
        ["arm.urdf.xacro", "part.xacro"]
    );
    assert_eq!(
        robot.resolve("package://arm/meshes/base.stl"),
        Some(tree.path("arm/meshes/base.stl"))
    );
    assert_eq!(robot.resolve("package://arm/meshes/lid.stl"), None);
}

#[test]
fn all_that_went_wrong() {
    let tree = arm("<link name='${lenght}'/><link name='${widht}'/>");
    let robot = expand(tree.path("arm/urdf/arm.urdf.xacro"), &Options::new());
    assert_eq!(robot.text(), None);
    let shown: Vec<String> = robot
        .problems()
        .iter()
        .map(|problem| problem.to_string())
        .collect();
    let [first, second] = shown.as_slice() else {
        panic!("{shown:?}")
    };
    assert!(
        first.ends_with("part.xacro:3:15: error: property `lenght` is not defined"),
        "{first}"
    );
    assert!(
        second.contains("part.xacro:3:") && second.contains("`widht`"),
        "{second}"
    );
    let calls = &robot.problems()[0].calls;
    assert_eq!(
        calls
            .iter()
            .map(|call| (name(&call.path), call.line))
            .collect::<Vec<_>>(),
        [("arm.urdf.xacro".to_owned(), 4)]
    );
}

#[test]
fn a_file_that_is_not_there() {
    let robot = expand("no/such/robot.xacro", &Options::new());
    assert_eq!((robot.text(), robot.problems().len()), (None, 1));
    assert!(robot.problems()[0].is_error && robot.problems()[0].location.is_none());
}

/// The public items, as they are declared: a change here is a change for users.
#[test]
fn the_interface() {
    let source = include_str!("lib.rs");
    let items = source
        .lines()
        .map(str::trim)
        .filter(|line| line.starts_with("pub "));
    let found: Vec<&str> = items
        .map(|line| line.trim_end_matches([' ', '{', ',']))
        .collect();
    assert_eq!(
        found,
        [
            "pub struct Options",
            "pub fn new() -> Self",
            "pub fn arg(mut self, name: impl Into<String>, value: impl Into<String>) -> Self",
            "pub fn package_path(mut self, folder: impl Into<PathBuf>) -> Self",
            "pub struct Robot",
            "pub struct Problem",
            "pub is_error: bool",
            "pub message: String",
            "pub help: Option<String>",
            "pub location: Option<Location>",
            "pub calls: Vec<Location>",
            "pub struct Location",
            "pub path: PathBuf",
            "pub line: u32",
            "pub column: u32",
            "pub fn expand(file: impl AsRef<Path>, options: &Options) -> Robot",
            "pub fn text(&self) -> Option<&str>",
            "pub fn problems(&self) -> &[Problem]",
            "pub fn files(&self) -> impl Iterator<Item = &Path>",
            "pub fn source_of_line(&self, line: u32) -> Option<Location>",
            "pub fn resolve(&self, uri: &str) -> Option<PathBuf>",
        ]
    );
}
