//! What is wrong only until a program changes a text or gets data, and what follows from tags that an old xacro takes.
use super::set_aside_tests::found;
use rules::Severity;

const MANIFEST: (&str, &str) = (
    "package.xml",
    "<package><name>lamp_description</name></package>",
);

fn severity(files: &[(&str, &str)], rule: &str) -> Option<Severity> {
    found(files, rule).first().map(|found| found.1)
}

#[test]
fn packages_that_a_program_replaces() {
    let robot = "<robot name='lamp' xmlns:xacro='x'><xacro:include filename='$(find lamp_parts)/urdf/bulb.xacro'/><link name='base'/></robot>";
    let of = |launch: &str| {
        let files = [
            MANIFEST,
            (
                "parts/package.xml",
                "<package><name>lamp_parts</name></package>",
            ),
            ("parts/urdf/bulb.xacro", "<robot/>"),
            ("lamp/package.xml", "<package><name>lamp</name></package>"),
            ("lamp/urdf/lamp.xacro", robot),
            ("lamp/launch/show.launch.py", launch),
        ];
        severity(files.get(1..).unwrap(), "missing-package-dependency")
    };
    let reads = "text = open('urdf/lamp.xacro').read()\n";
    let replaces = format!("{reads}text = text.replace('$(find lamp_parts)/urdf/', '')\n");
    assert_eq!(of(reads), Some(Severity::Warning));
    assert_eq!(of(&replaces), Some(Severity::Info));
}

#[test]
fn meshes_that_a_program_downloads() {
    let robot = "<robot name='lamp'><link name='base'><visual><geometry><mesh filename='shapes/lamp/base.stl'/></geometry></visual></link></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [MANIFEST, ("scenes/lamp.urdf", robot)];
        severity(&[&own, others].concat(), "mesh-not-found")
    };
    let script = (
        "bin/start",
        "#!/bin/sh\nwget http://example.com/data.tgz -O ~/data.tgz\n",
    );
    let page = ("README.md", "wget http://example.com/data.tgz");
    assert_eq!(of(&[]), Some(Severity::Error));
    assert_eq!(of(&[page]), Some(Severity::Error));
    assert_eq!(of(&[script]), Some(Severity::Info));
    // the folder is there, without this file
    let other = ("scenes/shapes/lamp/top.stl", "solid\nendsolid\n");
    assert_eq!(of(&[script, other]), Some(Severity::Error));
}

#[test]
fn meshes_that_a_page_says_where_to_get() {
    let robot = "<robot name='lamp'><link name='base'><visual><geometry><mesh filename='package://lamp_description/meshes/base.stl'/></geometry></visual></link></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [MANIFEST, ("urdf/lamp.urdf", robot)];
        severity(&[&own, others].concat(), "mesh-not-found")
    };
    let page = ("meshes/README.md", "Get base.stl from its maker.");
    assert_eq!(of(&[]), Some(Severity::Error));
    assert_eq!(of(&[page]), Some(Severity::Info));
    assert_eq!(
        of(&[page, ("meshes/top.stl", "solid\nendsolid\n")]),
        Some(Severity::Error)
    );
}

#[test]
fn meshes_that_a_script_downloads_by_their_names() {
    let robot = "<robot name='lamp'><link name='base'><visual><geometry><mesh filename='package://lamp_description/meshes/base.stl'/></geometry></visual></link></robot>";
    let of = |script: &str| {
        let files = [
            MANIFEST,
            ("urdf/lamp.urdf", robot),
            ("meshes/top.stl", "solid\nendsolid\n"),
            ("scripts/meshes.sh", script),
        ];
        severity(&files, "mesh-not-found")
    };
    assert_eq!(
        of("wget http://example.com/base.stl -P meshes"),
        Some(Severity::Info)
    );
    assert_eq!(
        of("wget http://example.com/top.stl -P meshes"),
        Some(Severity::Error)
    );
    assert_eq!(of("rm meshes/base.stl"), Some(Severity::Error));
}

#[test]
fn meshes_for_matlab() {
    let robot = "<robot name='lamp'><link name='base'><visual><geometry><mesh filename='base.stl'/></geometry></visual></link></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [("model/lamp.urdf", robot)];
        severity(&[&own, others].concat(), "mesh-not-found")
    };
    let program = (
        "arm.m",
        "robot = importrobot('lamp.urdf', MeshPath='shapes');",
    );
    let other = ("show.py", "load('lamp.urdf')");
    assert_eq!(of(&[program]), Some(Severity::Info));
    assert_eq!(of(&[program, other]), Some(Severity::Error));
}

#[test]
fn arguments_for_a_command_line() {
    let robot = "<robot name='lamp' xmlns:xacro='x'><link name='$(arg side)_base'/></robot>";
    let of = |others: &[(&str, &str)]| {
        let own = [MANIFEST, ("urdf/lamp.urdf.xacro", robot)];
        severity(&[&own, others].concat(), "undefined-arg")
    };
    let described = ("README.md", "| `urdf/lamp.urdf.xacro` | with a prefix |");
    let named = ("README.md", "The robot is lamp.urdf.xacro.");
    let shown = ("README.md", "| `xacro urdf/lamp.urdf.xacro` | to see it |");
    let loaded = (
        "launch/see.launch",
        "<param name='d' command='xacro $(find lamp_description)/urdf/lamp.urdf.xacro'/>",
    );
    assert_eq!(of(&[]), Some(Severity::Info));
    assert_eq!(of(&[described]), Some(Severity::Info));
    assert_eq!(of(&[named]), Some(Severity::Error));
    assert_eq!(of(&[shown]), Some(Severity::Error));
    assert_eq!(of(&[loaded]), Some(Severity::Error));
}

/// A robot whose links come from calls that have no prefix, with its SRDF.
fn called(prefix: &str) -> Vec<(String, Severity)> {
    let robot = format!(
        "<robot name='lamp' xmlns:xacro='x'>\
         <xacro:macro name='part' params='name'><link name='${{name}}'/>\
         <joint name='${{name}}_joint' type='fixed'><parent link='base'/><child link='${{name}}'/></joint></xacro:macro>\
         <link name='base'/><{prefix}part name='bulb'/><{prefix}part name='shade'/></robot>"
    );
    let srdf = "<robot name='lamp'><group name='all'><joint name='bulb_joint'/><joint name='cord_joint'/>\
                <link name='base'/></group></robot>";
    let launch = "<param name='d' command='xacro --inorder $(find lamp_description)/urdf/lamp.xacro'/>\
                  <param name='s' textfile='$(find lamp_description)/config/lamp.srdf'/>";
    let files = [
        MANIFEST,
        ("urdf/lamp.xacro", robot.as_str()),
        ("config/lamp.srdf", srdf),
        ("launch/see.launch", launch),
    ];
    found(&files, "srdf-unknown-joint")
}

#[test]
fn what_calls_without_prefix_make_is_not_unknown() {
    assert_eq!(called("").len(), 0);
    let file = "config/lamp.srdf".to_owned();
    assert_eq!(called("xacro:"), [(file, Severity::Error)]);
}

#[test]
fn includes_without_prefix() {
    let robot = |prefix: &str| {
        let declared = if prefix.is_empty() {
            ""
        } else {
            " xmlns:xacro='x'"
        };
        format!(
            "<robot name='lamp'{declared}><{prefix}include filename='bulb.xacro'/>\
             <link name='top'/><joint name='j' type='fixed'><parent link='top'/><child link='bulb'/></joint></robot>"
        )
    };
    let of = |prefix: &str, rule: &str| {
        let robot = robot(prefix);
        let launch =
            "<param command='$(find xacro)/xacro.py $(find lamp_description)/urdf/lamp.xacro'/>";
        let files = [
            MANIFEST,
            ("urdf/lamp.xacro", robot.as_str()),
            ("urdf/bulb.xacro", "<robot><link name='light'/></robot>"),
            ("launch/see.launch", launch),
        ];
        severity(&files, rule)
    };
    assert_eq!(of("", "undefined-link"), None);
    assert_eq!(of("", "unprefixed-xacro-tag"), Some(Severity::Info));
    assert_eq!(of("xacro:", "undefined-link"), Some(Severity::Error));
}

#[test]
fn paths_that_a_program_fills_in() {
    let of = |path: &str| {
        let robot = format!(
            "<robot name='r'><link name='a'><visual><geometry><mesh filename='{path}'/></geometry></visual></link></robot>"
        );
        let found = found(&[("r.urdf", &robot)], "mesh-not-found");
        found.first().map(|found| found.1)
    };
    assert_eq!(of("{FOLDER}/arm.stl"), Some(Severity::Info));
    assert_eq!(of("folder/arm.stl"), Some(Severity::Error));
    assert_eq!(of("{}/arm.stl"), Some(Severity::Error));
}
