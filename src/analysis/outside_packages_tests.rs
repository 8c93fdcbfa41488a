//! Descriptions that belong to no package, beside what uses robots.
use super::set_aside_tests::found;
use rules::Severity;

/// A robot with a color that is nowhere, and with a moment of inertia that is far too large.
const ROBOT: &str = "<robot name='r'><link name='base'><visual><geometry><box size='1 1 1'/></geometry>\
    <material name='paint'/></visual><collision><geometry><box size='1 1 1'/></geometry></collision><inertial><mass value='1'/>\
    <inertia ixx='90' ixy='0' ixz='0' iyy='80' iyz='0' izz='70'/></inertial></link></robot>";

const OTHER: (&str, &str) = (
    "arm/urdf/arm.urdf",
    "<robot name='a'><link name='a'/></robot>",
);
const MANIFEST: (&str, &str) = ("arm/package.xml", "<package><name>arm</name></package>");
const LAUNCH: (&str, &str) = (
    "arm/launch/arm.launch",
    "<param textfile='$(find arm)/urdf/arm.urdf'/>",
);

/// The severity of a rule in the description of no package.
fn severity(rule: &str, path: &str, others: &[(&str, &str)]) -> Option<Severity> {
    let files = [&[(path, ROBOT)], others].concat();
    let places = found(&files, rule);
    places
        .into_iter()
        .find(|place| place.0 == path)
        .map(|place| place.1)
}

#[test]
fn what_only_ros_reads() {
    let color = |others: &[(&str, &str)]| severity("undefined-material", "data/r.urdf", others);
    // nobody knows who loads it
    assert_eq!(color(&[]), Some(Severity::Warning));
    assert_eq!(
        color(&[OTHER, MANIFEST, LAUNCH]),
        Some(Severity::Info),
        "nothing loads it"
    );
    let launches = (
        "run.launch",
        "<param textfile='data/r.urdf'/><node pkg='rviz'/>",
    );
    assert_eq!(
        color(&[OTHER, MANIFEST, LAUNCH, launches]),
        Some(Severity::Warning)
    );
    let program = ("see.py", "load('data/r.urdf')");
    assert_eq!(color(&[program]), Some(Severity::Info));
    // in a package, others may load it
    let own = ("data/package.xml", "<package><name>data</name></package>");
    assert_eq!(color(&[own, program]), Some(Severity::Warning));
}

#[test]
fn masses_that_a_program_computes_with() {
    let inertia = |program: &str| {
        let files = [("see.py", program)];
        severity("implausible-inertia", "data/r.urdf", &files)
    };
    assert_eq!(
        inertia("import pinocchio\nload('data/r.urdf')"),
        Some(Severity::Warning)
    );
    assert_eq!(inertia("load('data/r.urdf')"), Some(Severity::Info));
}

#[test]
fn folders_of_others() {
    let color = |path: &str| severity("undefined-material", path, &[]);
    assert_eq!(color("external/lib/r.urdf"), Some(Severity::Info));
    assert_eq!(color("internal/lib/r.urdf"), Some(Severity::Warning));
}

#[test]
fn pieces_of_robots() {
    let of = |root: &str, launch: &str| {
        let piece = format!("<{root} name='camera'><sensor/></{root}>");
        let files = [
            ("arm/package.xml", "<package><name>arm</name></package>"),
            ("arm/urdf/camera.urdf", piece.as_str()),
            ("arm/launch/arm.launch", launch),
        ];
        let found = found(&files, "unknown-root-element");
        found.first().map(|found| found.1)
    };
    let loads = "<param textfile='$(find arm)/urdf/camera.urdf'/>";
    assert_eq!(of("link", "<launch/>"), Some(Severity::Info));
    assert_eq!(of("link", loads), Some(Severity::Error));
    assert_eq!(of("robo", "<launch/>"), Some(Severity::Error));
}
