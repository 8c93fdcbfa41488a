//! Package look-up over temporary workspaces.

use std::path::PathBuf;

use super::{PackageOptions, Packages, RosVersion};
use vfs::testing::Tree;

const INDEX: &str = "share/ament_index/resource_index/packages";

fn package(tree: &Tree, folder: &str, name: &str) {
    tree.write(
        &format!("{folder}/package.xml"),
        &format!("<package><name>{name}</name></package>"),
    );
}

fn options(tree: &Tree) -> PackageOptions {
    PackageOptions {
        system: tree.path("opt/ros"),
        ..PackageOptions::default()
    }
}

fn packages(tree: &Tree, vars: &[(&str, &str)], options: PackageOptions) -> Packages {
    Packages::new(tree.vfs().clone(), &tree.environment(vars), options)
}

/// `step path` with the root of the tree left out, or the nearest name.
fn find(tree: &Tree, packages: &Packages, name: &str, from: &str) -> String {
    let relative = |path: PathBuf| {
        path.strip_prefix(tree.root())
            .map_or_else(|_| path.clone(), PathBuf::from)
            .display()
            .to_string()
    };
    match packages.find(name, &tree.path(from)) {
        Ok(found) => format!("{} {}", found.step, relative(found.path)),
        Err(error) => {
            let near = packages.meant(&error.name, &tree.path(from));
            format!("none, near {near:?}")
        }
    }
}

/// A tree in which every step has package `p`, and each step one of its own.
fn full_tree() -> Tree {
    let tree = Tree::new();
    for folder in [
        "explicit/any",
        "ws/src/own",
        "ws/src/repo/p_folder",
        "ws/install/p/share/p",
        "ros/path/p",
        "opt/ros/jazzy/share/p",
    ] {
        package(&tree, folder, "p");
    }
    tree.write("ament/share/ament_index/resource_index/packages/p", "");
    package(&tree, "colcon/p/share/p", "p");
    tree
}

const FULL: [(&str, &str); 3] = [
    ("AMENT_PREFIX_PATH", "{root}/ament"),
    ("COLCON_PREFIX_PATH", "{root}/colcon"),
    ("ROS_PACKAGE_PATH", "{root}/ros/path"),
];

#[test]
fn steps_are_asked_in_order() {
    let tree = full_tree();
    let explicit = PackageOptions {
        explicit: vec!["explicit".into()],
        ..options(&tree)
    };
    let from = "ws/src/own/urdf/a.xacro";
    let found = find(&tree, &packages(&tree, &FULL, explicit), "p", from);
    assert_eq!(found, "package-path explicit/any");
    let expected = [
        ("ws/src/own", "own package ws/src/own"),
        ("ws/src/repo", "workspace ws/src/repo/p_folder"),
        ("ws/install", "overlay ws/install/p/share/p"),
        ("ament", "AMENT_PREFIX_PATH ament/share/p"),
        ("colcon", "COLCON_PREFIX_PATH colcon/p/share/p"),
        ("ros", "ROS_PACKAGE_PATH ros/path/p"),
        ("opt", "/opt/ros opt/ros/jazzy/share/p"),
    ];
    for (remove, expected) in expected {
        assert_eq!(
            find(&tree, &packages(&tree, &FULL, options(&tree)), "p", from),
            expected
        );
        std::fs::remove_dir_all(tree.path(remove)).unwrap();
    }
    assert_eq!(
        find(&tree, &packages(&tree, &FULL, options(&tree)), "p", from),
        "none, near None"
    );
}

#[test]
fn environment_can_come_first_or_not_at_all() {
    let tree = full_tree();
    let from = "ws/src/own/urdf/a.xacro";
    let first = PackageOptions {
        environment_first: true,
        ..options(&tree)
    };
    assert_eq!(
        find(&tree, &packages(&tree, &FULL, first.clone()), "p", from),
        "AMENT_PREFIX_PATH ament/share/p"
    );
    let ros = find(
        &tree,
        &packages(&tree, &FULL[2..], first.clone()),
        "p",
        from,
    );
    assert_eq!(ros, "ROS_PACKAGE_PATH ros/path/p");
    assert_eq!(
        find(&tree, &packages(&tree, &[], first.clone()), "p", from),
        "own package ws/src/own"
    );
    let explicit = PackageOptions {
        explicit: vec![tree.path("explicit")],
        ..first
    };
    assert_eq!(
        find(&tree, &packages(&tree, &FULL, explicit), "p", from),
        "package-path explicit/any"
    );
    let without = PackageOptions {
        use_environment: false,
        ..options(&tree)
    };
    let elsewhere = find(
        &tree,
        &packages(&tree, &FULL, without),
        "p",
        "elsewhere/a.xacro",
    );
    assert_eq!(elsewhere, "/opt/ros opt/ros/jazzy/share/p");
}

#[test]
fn failures_list_the_places_and_a_near_name() {
    let tree = full_tree();
    let explicit = PackageOptions {
        explicit: vec!["explicit".into()],
        ..options(&tree)
    };
    let error = packages(&tree, &FULL, explicit)
        .find("q", &tree.path("ws/src/own/a.xacro"))
        .unwrap_err();
    let tried: Vec<String> = error
        .tried
        .iter()
        .map(|(step, path)| {
            format!(
                "{step} {}",
                path.strip_prefix(tree.root()).unwrap().display()
            )
        })
        .collect();
    assert_eq!(
        tried,
        [
            "package-path explicit",
            "own package ws/src/own",
            "workspace ws",
            "overlay ws/install/q/share/q",
            "overlay ws/install/share/q",
            "overlay ws/devel/share/q",
            "AMENT_PREFIX_PATH ament/share/ament_index/resource_index/packages/q",
            "COLCON_PREFIX_PATH colcon/q/share/q",
            "COLCON_PREFIX_PATH colcon/share/q",
            "ROS_PACKAGE_PATH ros/path",
            "/opt/ros opt/ros/jazzy/share/q",
        ]
    );
    package(&tree, "ws/src/arm", "arm_description");
    let near = packages(&tree, &[], options(&tree))
        .meant("arm_descripton", &tree.path("ws/src/own/a.xacro"));
    assert_eq!(near.as_deref(), Some("arm_description"));
}

#[test]
fn the_package_that_is_meant() {
    let tree = Tree::new();
    package(&tree, "ws/src/arm", "arm_description");
    package(&tree, "ws/src/cell", "cell");
    tree.write(
        "ws/src/cell/package.xml",
        "<package><name>cell</name><export><metapackage/></export></package>",
    );
    let own = "<package><name>own</name><depend>far_arm_description</depend></package>";
    tree.write("ws/src/own/package.xml", own);
    let packages = packages(&tree, &[], options(&tree));
    for (name, expected) in [
        ("arm_descripton", Some("arm_description")),
        ("arm_decsripton", Some("arm_description")),
        ("am_desription3", None),
        ("arm", Some("arm_description")),
        ("description", Some("arm_description")),
        ("my_arm_description", Some("arm_description")),
        ("arm_des", None),
        ("tool_description", None),
        // the asking package depends on it: it exists elsewhere
        ("far_arm_description", None),
        // a package without files
        ("cell_gazebo", None),
    ] {
        let from = tree.path("ws/src/own/a.xacro");
        assert!(packages.find(name, &from).is_err(), "{name}");
        assert_eq!(packages.meant(name, &from).as_deref(), expected, "{name}");
    }
}

#[test]
fn strange_names_are_found_nowhere() {
    let tree = full_tree();
    let packages = packages(&tree, &FULL, options(&tree));
    for name in ["", ".", "..", "../ament", "p/../p", "/", "p\0", "p/"] {
        let error = packages
            .find(name, &tree.path("ws/src/own/a.xacro"))
            .unwrap_err();
        assert!(error.tried.is_empty(), "{name:?}");
    }
}

#[test]
fn the_own_package_is_named_by_its_manifest() {
    let tree = Tree::new();
    package(&tree, "folder_name", "real_name");
    package(&tree, "folder_name/test/inner", "inner");
    tree.write("folder_name/broken/package.xml", "<package/>");
    let packages = packages(&tree, &[], options(&tree));
    let owner = |file: &str| {
        packages
            .containing(&tree.path(file))
            .map(|package| package.name)
    };
    assert_eq!(
        owner("folder_name/urdf/a.xacro").as_deref(),
        Some("real_name")
    );
    assert_eq!(
        owner("folder_name/test/inner/a.xacro").as_deref(),
        Some("inner")
    );
    assert_eq!(
        owner("folder_name/test/inner/../a.xacro").as_deref(),
        Some("real_name")
    );
    assert_eq!(
        owner("folder_name/broken/a.xacro").as_deref(),
        Some("real_name")
    );
    assert_eq!(owner("other/a.xacro"), None);
    assert_eq!(
        find(&tree, &packages, "folder_name", "folder_name/urdf/a.xacro"),
        "none, near None"
    );
}

#[test]
fn workspaces() {
    let tree = Tree::new();
    package(&tree, "one/src/a", "a");
    package(&tree, "one/src/shared", "shared");
    package(&tree, "two/shared", "shared");
    package(&tree, "two/b", "b");
    package(&tree, "repo/x", "x");
    package(&tree, "repo/y", "y");
    tree.write("repo/.git/HEAD", "");
    let folders = PackageOptions {
        workspace_folders: vec!["one".into(), "two".into()],
        ..options(&tree)
    };
    let editor = packages(
        &tree,
        &[],
        PackageOptions {
            search_upward: false,
            ..folders.clone()
        },
    );
    let table = [
        ("shared", "one/src/a/x.xacro", "workspace one/src/shared"),
        ("shared", "two/b/x.xacro", "workspace two/shared"),
        ("shared", "elsewhere/x.xacro", "workspace one/src/shared"),
        ("y", "repo/x/x.xacro", "none, near None"),
    ];
    for (name, from, expected) in table {
        assert_eq!(find(&tree, &editor, name, from), expected, "{name} {from}");
    }
    let program = packages(&tree, &[], folders);
    assert_eq!(
        find(&tree, &program, "y", "repo/x/x.xacro"),
        "workspace repo/y"
    );
    assert_eq!(
        find(&tree, &program, "b", "repo/x/x.xacro"),
        "workspace two/b"
    );
}

#[test]
fn overlays_lie_beside_the_workspace() {
    let tree = Tree::new();
    package(&tree, "ws/src/repo/a", "a");
    package(&tree, "ws/install/share/merged", "merged");
    tree.write("ws/install/share/colcon-core/x", "");
    tree.write("ws/install/alone/share/alone/urdf/x", "");
    tree.write("ws/install/marked/share/marked/x", "");
    tree.write("ws/devel/share/developed/urdf/x", "");
    tree.write("ws/devel/share/elsewhere/cmake/x", "");
    tree.write(&format!("ws/install/{INDEX}/indexed"), "");
    for folder in ["ws", "ws/src", "ws/src/repo"] {
        let folders = vec![PathBuf::from(folder)];
        let editor = PackageOptions {
            workspace_folders: folders,
            search_upward: false,
            ..options(&tree)
        };
        let packages = packages(&tree, &[], editor);
        let table = [
            ("merged", "overlay ws/install/share/merged"),
            ("alone", "overlay ws/install/alone/share/alone"),
            ("developed", "overlay ws/devel/share/developed"),
            ("indexed", "overlay ws/install/share/indexed"),
            ("colcon-core", "none, near None"),
            ("elsewhere", "none, near None"),
        ];
        for (name, expected) in table {
            assert_eq!(
                find(&tree, &packages, name, "ws/src/repo/a/x.xacro"),
                expected,
                "{folder}"
            );
        }
    }
}

#[test]
fn an_installed_file_finds_what_is_installed_beside_it() {
    let tree = Tree::new();
    for name in ["a", "b"] {
        package(&tree, &format!("merged/share/{name}"), name);
        tree.write(&format!("merged/{INDEX}/{name}"), "");
        package(&tree, &format!("alone/{name}/share/{name}"), name);
        tree.write(&format!("alone/{name}/{INDEX}/{name}"), "");
        package(&tree, &format!("plain/share/{name}"), name);
    }
    tree.write("alone/.colcon_install_layout", "isolated");
    let packages = packages(&tree, &[], options(&tree));
    let table = [
        (
            "merged/share/a/urdf/a.xacro",
            "installed beside merged/share/b",
        ),
        (
            "alone/a/share/a/urdf/a.xacro",
            "installed beside alone/b/share/b",
        ),
        ("plain/share/a/urdf/a.xacro", "none, near None"),
    ];
    for (from, expected) in table {
        assert_eq!(find(&tree, &packages, "b", from), expected, "{from}");
    }
}

#[test]
fn an_installed_copy_has_a_source() {
    let tree = Tree::new();
    package(&tree, "ws/src/a", "a");
    package(&tree, "ws/install/a/share/a", "a");
    tree.write(&format!("ws/install/a/{INDEX}/a"), "");
    for file in [
        "ws/src/a/urdf/a.xacro",
        "ws/install/a/share/a/urdf/a.xacro",
        "ws/install/a/share/a/made.xacro",
    ] {
        tree.write(file, "<robot/>");
    }
    // built with --symlink-install
    #[cfg(unix)]
    std::os::unix::fs::symlink(
        tree.path("ws/src/a"),
        tree.path("ws/install/a/share/a/linked"),
    )
    .unwrap();
    let packages = packages(&tree, &[], options(&tree));
    let source = |file: &str| packages.source_of(&tree.path(file));
    assert_eq!(
        source("ws/install/a/share/a/urdf/a.xacro"),
        Some(tree.path("ws/src/a/urdf/a.xacro"))
    );
    assert_eq!(source("ws/install/a/share/a/made.xacro"), None);
    assert_eq!(source("ws/src/a/urdf/a.xacro"), None);
    assert_eq!(source("ws/install/a/share/a/linked/urdf/a.xacro"), None);
}

#[test]
fn prefixes_are_spelled_as_the_variable_spells_them() {
    let tree = Tree::new();
    tree.write(&format!("two/{INDEX}/p"), "");
    let table = [
        ("{root}/one:{root}/two", tree.path("two/share/p")),
        ("{root}/one::{root}/./two/", tree.path("./two/share/p")),
        ("two", PathBuf::from("two/share/p")),
        ("one/../two", PathBuf::from("one/../two/share/p")),
    ];
    tree.write("one/x", "");
    for (value, expected) in table {
        let packages = packages(&tree, &[("AMENT_PREFIX_PATH", value)], options(&tree));
        let found = packages.find("p", &tree.path("a.xacro")).unwrap();
        assert_eq!(found.path.as_os_str(), expected.as_os_str(), "{value}");
    }
}

#[test]
fn ros_package_path_is_crawled() {
    let tree = Tree::new();
    package(&tree, "path/group/a", "a");
    package(&tree, "path/group/a/nested", "nested");
    package(&tree, "direct", "direct");
    package(&tree, "path/ignored/i", "i");
    tree.write("path/ignored/CATKIN_IGNORE", "");
    let packages = packages(
        &tree,
        &[("ROS_PACKAGE_PATH", "{root}/path:direct")],
        options(&tree),
    );
    let table = [
        ("a", "ROS_PACKAGE_PATH path/group/a"),
        ("direct", "ROS_PACKAGE_PATH direct"),
        ("nested", "none, near None"),
        ("i", "none, near None"),
    ];
    for (name, expected) in table {
        assert_eq!(find(&tree, &packages, name, "x.xacro"), expected, "{name}");
    }
}

#[test]
fn distributions_go_newest_first_unless_one_is_named() {
    let tree = Tree::new();
    for distribution in ["humble", "jazzy", "noetic"] {
        package(&tree, &format!("opt/ros/{distribution}/share/p"), "p");
    }
    package(&tree, "opt/ros/noetic/share/old", "old");
    type Vars<'a> = &'a [(&'a str, &'a str)];
    let table: [(Vars<'_>, RosVersion, &str); 5] = [
        (&[], RosVersion::Ros2, "/opt/ros opt/ros/jazzy/share/p"),
        (&[], RosVersion::Ros1, "/opt/ros opt/ros/noetic/share/p"),
        (
            &[("ROS_DISTRO", "humble")],
            RosVersion::Ros2,
            "/opt/ros opt/ros/humble/share/p",
        ),
        (
            &[("AMENT_PREFIX_PATH", "{root}/opt/ros/humble")],
            RosVersion::Ros2,
            "/opt/ros opt/ros/humble/share/p",
        ),
        (
            &[("ROS_DISTRO", "gone")],
            RosVersion::Ros2,
            "/opt/ros opt/ros/jazzy/share/p",
        ),
    ];
    for (vars, target, expected) in table {
        let packages = packages(
            &tree,
            vars,
            PackageOptions {
                target,
                ..options(&tree)
            },
        );
        assert_eq!(find(&tree, &packages, "p", "x.xacro"), expected, "{vars:?}");
    }
    let sourced = packages(&tree, &[("ROS_DISTRO", "humble")], options(&tree));
    assert_eq!(find(&tree, &sourced, "old", "x.xacro"), "none, near None");
}

#[test]
fn the_table_of_all_packages_marks_shadowed_ones() {
    let tree = full_tree();
    package(&tree, "ament/share/q", "q");
    tree.write(&format!("ament/{INDEX}/q"), "");
    let all = packages(&tree, &FULL, options(&tree)).all(&tree.path("ws/src/own/a.xacro"));
    let lines: Vec<String> = all
        .iter()
        .map(|entry| {
            let path = entry.path.strip_prefix(tree.root()).unwrap().display();
            let mark = if entry.shadowed { " (shadowed)" } else { "" };
            format!("{}: {} {path}{mark}", entry.name, entry.step)
        })
        .collect();
    assert_eq!(
        lines,
        [
            "p: own package ws/src/own",
            "p: workspace ws/src/repo/p_folder (shadowed)",
            "p: overlay ws/install/p/share/p (shadowed)",
            "p: AMENT_PREFIX_PATH ament/share/p (shadowed)",
            "q: AMENT_PREFIX_PATH ament/share/q",
            "p: COLCON_PREFIX_PATH colcon/p/share/p (shadowed)",
            "p: ROS_PACKAGE_PATH ros/path/p (shadowed)",
            "p: /opt/ros opt/ros/jazzy/share/p (shadowed)",
        ]
    );
}

#[test]
fn answers_are_remembered_until_told_to_forget() {
    let tree = Tree::new();
    package(&tree, "ws/src/a", "a");
    let packages = packages(&tree, &[], options(&tree));
    assert_eq!(
        find(&tree, &packages, "b", "ws/src/a/x.xacro"),
        "none, near None"
    );
    package(&tree, "ws/src/b", "b");
    assert_eq!(
        find(&tree, &packages, "b", "ws/src/a/x.xacro"),
        "none, near None"
    );
    packages.forget();
    assert_eq!(
        find(&tree, &packages, "b", "ws/src/a/x.xacro"),
        "workspace ws/src/b"
    );
}

#[test]
fn threads_share_a_search() {
    let tree = full_tree();
    let packages = packages(&tree, &FULL, options(&tree));
    std::thread::scope(|scope| {
        for _ in 0..8 {
            scope.spawn(|| {
                for _ in 0..50 {
                    assert!(
                        packages
                            .find("p", &tree.path("ws/src/repo/x.xacro"))
                            .is_ok()
                    );
                    assert!(
                        packages
                            .find("none", &tree.path("ws/src/repo/x.xacro"))
                            .is_err()
                    );
                }
            });
        }
    });
}

#[test]
fn of_several_packages_of_one_name_the_one_in_the_same_workspace() {
    let tree = Tree::new();
    for copy in ["1/ros2/src", "2/ros2/src"] {
        tree.write(
            &format!("{copy}/arm/package.xml"),
            "<package><name>arm</name></package>",
        );
        tree.write(
            &format!("{copy}/cell/package.xml"),
            "<package><name>cell</name></package>",
        );
    }
    let options = PackageOptions {
        workspace_folders: vec![tree.root().to_owned()],
        ..PackageOptions::default()
    };
    let packages = Packages::new(tree.vfs().clone(), &tree.environment(&[]), options);
    for copy in ["1/ros2/src", "2/ros2/src"] {
        let found = packages
            .find("arm", &tree.path(&format!("{copy}/cell/urdf/r.xacro")))
            .unwrap();
        assert_eq!(found.path, tree.path(&format!("{copy}/arm")));
    }
}
