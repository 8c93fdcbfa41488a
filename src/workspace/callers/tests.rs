//! Callers of robots, and what they give.

use std::sync::Arc;

use super::Callers;
use packages::{PackageOptions, Packages};
use vfs::testing::Tree;

/// The callers in a tree of files.
pub(super) fn callers_in(tree: &Tree) -> Callers {
    let environment = tree.environment(&[]);
    let packages = Packages::new(tree.vfs().clone(), &environment, PackageOptions::default());
    Callers::new(Arc::new(packages))
}

#[test]
fn launch_files_of_other_packages_count() {
    let tree = Tree::new();
    tree.write(
        "ws/src/arm/package.xml",
        "<package><name>arm</name></package>",
    );
    tree.write("ws/src/arm/urdf/arm.urdf.xacro", "<robot/>");
    tree.write(
        "ws/src/bringup/launch/arm.launch.py",
        "Command(['xacro ', share('arm') / 'arm.urdf.xacro', ' side:=', 'left'])",
    );
    tree.write(
        "ws/src/leg/launch/leg.launch.py",
        "find('leg'), 'arm.urdf.xacro leg:=1'",
    );
    tree.write(
        "ws/src/leg/package.xml",
        "<package><name>leg</name></package>",
    );
    tree.write("ws/build/arm.launch.py", "'arm.urdf.xacro built:=1'");
    tree.write("ws/src/arm/CHANGELOG.rst", "arm.urdf.xacro log:=1");
    let callers = callers_in(&tree);
    let found = callers.of(&tree.path("ws/src/arm/urdf/arm.urdf.xacro"));
    let args: Vec<_> = found.iter().flat_map(|caller| &caller.args).collect();
    assert_eq!(args.len(), 1);
    assert_eq!(
        (args[0].name.as_str(), args[0].value.as_deref()),
        ("side", Some("left"))
    );
    assert!(
        callers
            .of(&tree.path("ws/src/arm/urdf/hand.urdf.xacro"))
            .is_empty()
    );
}

#[test]
fn configurations_give_arguments_and_pass_them_on() {
    let tree = Tree::new();
    for package in ["arm_base", "arm_site", "other"] {
        tree.write(
            &format!("ws/src/{package}/package.xml"),
            &format!("<package><name>{package}</name></package>"),
        );
    }
    tree.write("ws/src/arm_base/urdf/arm.xacro", "<robot/>");
    tree.write(
        "ws/src/arm_base/config/config.yaml",
        "urdf:\n  path: urdf/arm.xacro\nurdf_params:\n  - side: left\n",
    );
    tree.write(
        "ws/src/arm_site/config/config.yaml",
        "based_on_package: \"arm_base\"\nurdf_params:\n  - mode: fast\n",
    );
    tree.write(
        "ws/src/other/config/config.yaml",
        "urdf_params:\n  - leg: 1\n",
    );
    let found = callers_in(&tree).of(&tree.path("ws/src/arm_base/urdf/arm.xacro"));
    let given = found.iter().map(|caller| {
        caller
            .args
            .iter()
            .map(|arg| arg.name.as_str())
            .collect::<Vec<_>>()
    });
    assert_eq!(
        given.collect::<Vec<_>>(),
        [vec!["side"], vec!["mode", "side"]]
    );
}

#[test]
fn what_an_edited_description_mentions() {
    let tree = Tree::new();
    tree.write(
        "ws/src/arm/package.xml",
        "<package><name>arm</name></package>",
    );
    let (robot, part) = ("ws/src/arm/urdf/arm.xacro", "ws/src/arm/urdf/part.xacro");
    tree.write(robot, "<robot><include filename='part.xacro'/></robot>");
    tree.write(part, "<robot/>");
    let callers = callers_in(&tree);
    let is_mentioned = || callers.mention_file(&tree.path(part));
    assert!(is_mentioned());
    let text = "<robot><include filename='gone.xacro'/></robot>";
    tree.vfs()
        .set_buffer(&tree.path(robot), Some(text.to_owned()));
    callers.edit_description(&tree.path(robot));
    assert!(!is_mentioned());
}
