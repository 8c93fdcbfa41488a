use super::super::{CheckOptions, Session, Setup, TestOptions, Tests};
use vfs::testing::Tree;

const ROBOT: &str = "<robot name='r' xmlns:xacro='x'>
<xacro:arg name='side' default='left'/><xacro:arg name='sim' default='False'/>
<xacro:macro name='arm' params='reach'>
<link name='$(arg side)_arm'><inertial><mass value='${2 * reach}'/></inertial></link>
<joint name='elbow' type='revolute'>
<parent link='base'/><child link='$(arg side)_arm'/><axis xyz='0 1 0'/>
<limit lower='-1' upper='${reach}' effort='5' velocity='2'/>
</joint>
</xacro:macro>
<link name='base'/>
<xacro:arm reach='1.5'/>
</robot>";

/// Test the robot with an entry of the configuration behind `file`.
fn test(root: &str, files: &[(&str, &str)], update: bool) -> (Tree, Tests) {
    let tree = Tree::new();
    tree.write("package.xml", "<package><name>r</name></package>");
    tree.write("r.xacro", ROBOT);
    tree.write(
        "xacro-lint.toml",
        &format!("[[roots]]\nfile = 'r.xacro'\n{root}"),
    );
    for (name, text) in files {
        tree.write(name, text);
    }
    let session = Session::new(
        &tree.environment(&[]),
        Setup {
            about: tree.root().to_owned(),
            ..Setup::default()
        },
    );
    let check = CheckOptions {
        paths: vec![tree.root().to_owned()],
        ..CheckOptions::default()
    };
    let tests = crate::test(
        &session.unwrap(),
        &TestOptions {
            check,
            filter: None,
            update,
        },
    );
    (tree, tests)
}

/// What fails, each with the text of its place; none when the configuration is wrong.
fn failures((tree, tests): &(Tree, Tests)) -> Vec<String> {
    assert!(tests.invalid.is_empty(), "{:?}", tests.invalid);
    let text = |finding: &rules::Finding| {
        let text = &tree
            .vfs()
            .text(tests.report.path(finding.span.file))
            .unwrap()
            .text;
        format!(
            "{} @{}",
            finding.message,
            finding
                .span
                .range
                .slice(text)
                .lines()
                .next()
                .unwrap_or_default()
        )
    };
    let found = tests.report.findings.iter().map(text);
    found
        .map(|text| text.replace(&format!("{}/", tree.root().display()), ""))
        .collect()
}

/// Check what fails of one expectation.
fn check_failures(expected_of_robot: &str, expected: &[&str]) {
    let found = failures(&test(
        &format!("[[roots.expect]]\n{expected_of_robot}"),
        &[],
        false,
    ));
    assert_eq!(found, expected, "{expected_of_robot}");
}

#[test]
fn what_holds() {
    for expectation in [
        "",
        "root = 'base'\nlinks = ['base', '$(arg side)_arm']\nno-links = ['camera']",
        "joints = ['elbow']\nno-joints = ['shoulder']",
        "link-count = 2\njoint-count = 1\nmoving-joint-count = 1",
        "chains = [['base', 'left_arm']]",
        "mass = 3",
        "mass = 2.9\nmass-tolerance = 0.2",
        "joint.elbow = { type = 'revolute', parent = 'base', child = '$(arg side)_arm', lower = -1, upper = 1.5, effort = 5, velocity = 2 }",
        "joint.elbow = { upper = 1.4, tolerance = 0.1 }",
        "command-interfaces = { elbow = [] }",
        "when = { side = 'left', sim = false }\nlink-count = 2",
    ] {
        check_failures(expectation, &[]);
    }
}

#[test]
fn what_fails() {
    check_failures(
        "root = 'world'",
        &["root link is `base`, expected `world` @base"],
    );
    check_failures("links = ['left_am']", &["missing link `left_am` @<robot"]);
    check_failures(
        "no-links = ['left_arm']",
        &["link `left_arm` is not expected @$(arg side)_arm"],
    );
    check_failures(
        "no-joints = ['elbow']",
        &["joint `elbow` is not expected @elbow"],
    );
    check_failures("link-count = 3", &["robot has 2 links, expected 3 @<robot"]);
    check_failures(
        "chains = [['left_arm', 'base']]",
        &["link `base` is not below link `left_arm` @base"],
    );
    check_failures(
        "mass = 4",
        &["total mass is 3 kg, expected 4 kg ± 0.001 @<robot"],
    );
    check_failures(
        "joint.elbow = { type = 'fixed', mimic = 'knee', upper = 2, velocity = 2.0 }",
        &[
            "type of joint `elbow` is `revolute`, expected `fixed` @revolute",
            "mimicked joint of joint `elbow` is missing, expected `knee` @<joint",
            "upper limit of joint `elbow` is 1.5 rad, expected 2 rad ± 0.001 @${reach}",
        ],
    );
    check_failures(
        "command-interfaces = { elbow = ['position'] }",
        &["command interfaces of joint `elbow` are none, expected `position` @<robot"],
    );
    check_failures(
        "links = ['$(arg sid)_arm']",
        &["unknown argument `sid` in the expectation @[[roots.expect]]"],
    );
    check_failures(
        "when = { side = 'up' }",
        &["no robot has the arguments `side:=up` @[[roots.expect]]"],
    );
}

#[test]
fn failures_lead_to_the_call() {
    let (_tree, tests) = test("[[roots.expect]]\njoint.elbow.upper = 2", &[], false);
    let messages: Vec<&str> = tests.report.findings[0]
        .related
        .iter()
        .map(|related| related.message.as_str())
        .collect();
    assert_eq!(messages, ["in this call of macro `arm`", "expected here"]);
}

#[test]
fn robots_that_are_rejected() {
    let with = |text: &str| {
        failures(&test(
            "[[roots.expect]]\nlinks = ['gone']",
            &[("r.xacro", text)],
            false,
        ))
    };
    let robot = |inner: &str| format!("<robot name='r' xmlns:xacro='x'>{inner}</robot>");
    assert_eq!(
        with(&robot("<link name='${a}'/>")),
        ["property `a` is not defined @a"]
    );
    assert_eq!(with("<sdf/>"), ["the root element is not `robot` @"]);
    assert_eq!(with(&robot("<link name='a'/><link name='b'/>")).len(), 2);
    let package = robot("<xacro:include filename='$(find gone)/a.xacro'/><link name='a'/>");
    assert_eq!(with(&package).len(), 1);
}

#[test]
fn combinations_are_tests() {
    let root = "args = { side = ['left', 'right'] }\n[[roots.expect]]\nlinks = ['left_arm']";
    let tests = test(root, &[], false).1;
    let passed: Vec<bool> = tests
        .cases
        .iter()
        .map(|case| case.failures.is_empty())
        .collect();
    assert_eq!(passed, [true, false]);
    assert_eq!(
        tests.cases[1].root.args,
        [("side".to_owned(), "right".to_owned())]
    );
}

#[test]
fn snapshots() {
    let root = "args = { side = ['left', 'right'] }\n[[roots.expect]]\nexpands-to = 'kept/$(arg side).urdf'";
    let found = failures(&test(root, &[], false));
    assert!(
        found[0].starts_with("cannot read `kept/left.urdf`"),
        "{found:?}"
    );
    let (tree, tests) = test(root, &[], true);
    assert!(tests.report.findings.is_empty());
    let updates: Vec<(&std::path::Path, bool)> = tests
        .updates
        .iter()
        .map(|update| {
            (
                update.path.strip_prefix(tree.root()).unwrap(),
                update.exists,
            )
        })
        .collect();
    assert_eq!(
        updates,
        [
            ("kept/left.urdf".as_ref(), false),
            ("kept/right.urdf".as_ref(), false)
        ]
    );
    let written: Vec<&str> = tests
        .updates
        .iter()
        .map(|update| update.text.as_str())
        .collect();
    let files = [
        ("kept/left.urdf", written[0]),
        ("kept/right.urdf", written[1]),
    ];
    assert!(failures(&test(root, &files, false)).is_empty());
    assert!(test(root, &files, true).1.updates.is_empty());
    // the spelling of numbers and white space do not count
    let other = written[0].replace("1.5", "1.50").replace('\n', "\r\n");
    assert!(failures(&test(root, &[("kept/left.urdf", &other), files[1]], false)).is_empty());
    let changed = written[0].replace("\"1.5\"", "\"1.6\"");
    assert_eq!(
        failures(&test(
            root,
            &[("kept/left.urdf", &changed), files[1]],
            false
        )),
        ["`upper` of `limit` is `1.5`, but `1.6` in `kept/left.urdf` @${reach}"]
    );
    // a robot that one does not tell from another
    let root = root.replace("$(arg side)", "one");
    let conflict = test(&root, &[], true);
    assert!(conflict.1.updates.is_empty());
    let found = failures(&conflict);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(
        found[0].starts_with("`kept/one.urdf` is also the file of `r.xacro side:=left`"),
        "{found:?}"
    );
}

#[test]
fn files_that_are_no_snapshots() {
    let refused = |name: &str| {
        let root = format!("[[roots.expect]]\nexpands-to = '{name}'");
        let (tree, tests) = test(&root, &[("kept/garbage.urdf", "no robot")], true);
        assert!(
            tests.updates.is_empty() || name == "kept/garbage.urdf",
            "{name}"
        );
        let found = failures(&(tree, tests));
        found
            .first()
            .map(|found| found.split(" @").next().unwrap_or_default().to_owned())
    };
    let outside = |name: &str| {
        refused(name).is_some_and(|why| why.contains("it is outside of the workspace"))
    };
    assert!(outside("../../../../../../../../../../tmp/other.urdf"));
    assert!(outside("/tmp/other.urdf"));
    assert_eq!(
        refused("r.xacro").as_deref(),
        Some("cannot use file `r.xacro`: its name must end with `.urdf` or `.xml`")
    );
    assert_eq!(refused("kept/garbage.urdf"), None);
    let root = "[[roots.expect]]\nexpands-to = 'kept/garbage.urdf'";
    let found = failures(&test(root, &[("kept/garbage.urdf", "no robot")], false));
    assert!(
        found[0].starts_with("`kept/garbage.urdf` is not a well-formed robot description"),
        "{found:?}"
    );
}

#[cfg(unix)]
#[test]
fn links_out_of_the_workspace() {
    let outside = Tree::new();
    let (tree, _) = test("", &[], false);
    std::os::unix::fs::symlink(outside.root(), tree.path("out")).unwrap();
    std::os::unix::fs::symlink(outside.path("gone.urdf"), tree.path("gone.urdf")).unwrap();
    for name in ["out/a.urdf", "gone.urdf"] {
        let text =
            format!("[[roots]]\nfile = 'r.xacro'\n[[roots.expect]]\nexpands-to = '{name}'\n");
        tree.write("xacro-lint.toml", &text);
        let setup = Setup {
            about: tree.root().to_owned(),
            ..Setup::default()
        };
        let session = Session::new(&tree.environment(&[]), setup).unwrap();
        let check = CheckOptions {
            paths: vec![tree.root().to_owned()],
            ..CheckOptions::default()
        };
        let tests = crate::test(
            &session,
            &TestOptions {
                check,
                filter: None,
                update: true,
            },
        );
        assert!(
            tests.updates.is_empty() && tests.report.findings.len() == 1,
            "{name}"
        );
    }
}

#[test]
fn configurations_that_keep_tests_from_running() {
    for root in [
        "exclude = 1",
        "[[roots.expect]]\nlnks = []",
        "[[roots]]\nfile = 'gone.xacro'",
    ] {
        assert_eq!(test(root, &[], false).1.invalid.len(), 1, "{root}");
    }
}

#[test]
fn choices_of_launch_files() {
    let launch = "DeclareLaunchArgument('arm_side', default_value='left', choices=['left', 'right'])\n\
                  DeclareLaunchArgument('rviz', default_value='true', choices=['true', 'false'])\n\
                  Command(['xacro ', FindPackageShare('r'), '/r.xacro', ' side:=', LaunchConfiguration('arm_side'), ' sim:=true'])\n";
    let tests = test(
        "choices = 'launch'",
        &[("launch/r.launch.py", launch)],
        false,
    )
    .1;
    let args: Vec<String> = tests
        .cases
        .iter()
        .map(|case| {
            case.root
                .args
                .iter()
                .map(|(name, value)| format!("{name}:={value}"))
                .collect()
        })
        .collect();
    assert_eq!(args, ["side:=left", "side:=right"]);
}
