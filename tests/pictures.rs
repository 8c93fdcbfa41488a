//! The still pictures of the documentation show the examples as they are. `UPDATE=1` draws them again.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

const CELL: &str = "measuring_cell/src/measuring_cell/urdf/measuring_cell.xacro";
const ARM: &str = "industrial_arm/src/lunder6_support/urdf/lunder6.xacro";
const GRIPPER: &str =
    "two_joint_gripper/src/two_joint_gripper_description/urdf/two_joint_gripper.urdf.xacro";

/// Pictures with the arguments that make them.
const PICTURES: [(&str, &str, &str); 5] = [
    ("render-cell.png", CELL, "--size 640x480"),
    ("render-cell.svg", CELL, "--size 640x480"),
    (
        "render-arm.png",
        ARM,
        "--size 640x480 --joint joint_2=20deg --joint joint_3=30deg",
    ),
    (
        "render-gripper.png",
        GRIPPER,
        "--size 640x480 --frames --joint shoulder=35deg --joint elbow=-60deg",
    ),
    ("render-tree.svg", GRIPPER, "--tree"),
];

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Draw a picture into `folder`.
fn draw((name, robot, options): (&str, &str, &str), folder: &Path) -> PathBuf {
    let cwd = repository().join("docs/examples");
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        cwd.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd,
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut stdin = std::io::empty();
    let path = folder.join(name);
    let line = ["render", robot, "-o", path.to_str().unwrap()]
        .into_iter()
        .chain(options.split_whitespace());
    let args: Vec<String> = line.map(str::to_owned).collect();
    let code = cli::run(&args, &env, &mut Io::plain(&mut out, &mut err, &mut stdin));
    assert_eq!(
        (code, String::from_utf8(err).unwrap().as_str()),
        (0, ""),
        "{name}"
    );
    assert!(out.is_empty());
    path
}

fn pixels(path: &Path) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(fs::read(path).unwrap()))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    bytes.truncate(info.buffer_size());
    (info.width, info.height, bytes)
}

/// The part of two pictures that differs by more than machines may differ in their arithmetic.
fn difference(a: &Path, b: &Path) -> f64 {
    let ((w, h, a), (v, g, b)) = (pixels(a), pixels(b));
    assert_eq!((w, h, a.len()), (v, g, b.len()));
    let far = a
        .chunks(3)
        .zip(b.chunks(3))
        .filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8));
    far.count() as f64 / f64::from(w * h)
}

/// An arm of URDF 1.1 or 1.2; the three shapes that stand for a capsule in 1.0 are given, and so are both rotations.
fn arm(
    version: &str,
    limit: &str,
    capsule: impl Fn(&str, f64, f64) -> String,
    turns: [&str; 2],
) -> String {
    let [lying, tilted] = turns;
    let (upper, fore) = (
        capsule("xyz=\"0 0 0.25\"", 0.06, 0.4),
        capsule(&format!("xyz=\"0.2 0 0\" {lying}"), 0.05, 0.3),
    );
    let joint = |name: &str, kind: &str, [parent, child]: [&str; 2], origin: &str| {
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/><origin {origin}/>\
             <axis xyz=\"0 1 0\"/><limit lower=\"-2\" upper=\"2\" effort=\"10\" velocity=\"1\" {limit}/></joint>"
        )
    };
    let shape = |shape: &str| format!("<visual><geometry>{shape}</geometry></visual>");
    let base = shape("<cylinder radius=\"0.15\" length=\"0.1\"/>");
    let flange = shape("<box size=\"0.04 0.2 0.1\"/>");
    format!(
        "<robot name=\"arm\" {version}><link name=\"base_link\">{base}</link><link name=\"upper_arm\">{upper}</link>\
         <link name=\"forearm\">{fore}</link><link name=\"flange\">{flange}</link>{}{}{}</robot>",
        joint(
            "shoulder",
            "revolute",
            ["base_link", "upper_arm"],
            "xyz=\"0 0 0.05\""
        ),
        joint(
            "elbow",
            "revolute",
            ["upper_arm", "forearm"],
            "xyz=\"0 0 0.5\""
        ),
        joint(
            "wrist",
            "fixed",
            ["forearm", "flange"],
            &format!("xyz=\"0.42 0 0\" {tilted}")
        ),
    )
}

#[test]
fn capsules_and_quaternions_are_drawn_as_what_they_stand_for() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("newer_urdf");
    fs::create_dir_all(&folder).unwrap();
    let capsule = |origin: &str, radius: f64, length: f64| {
        format!(
            "<visual><origin {origin}/><geometry><capsule radius=\"{radius}\" length=\"{length}\"/></geometry></visual>"
        )
    };
    // the ends lie along the axis of the cylinder: z, and x for the one that is turned
    let shapes = |origin: &str, radius: f64, length: f64| {
        let visual = |origin: &str, shape: &str| {
            format!("<visual><origin {origin}/><geometry>{shape}</geometry></visual>")
        };
        let ends = if origin.contains("rpy") {
            [
                format!("{} 0 0", 0.2 - length / 2.0),
                format!("{} 0 0", 0.2 + length / 2.0),
            ]
        } else {
            [
                format!("0 0 {}", 0.25 - length / 2.0),
                format!("0 0 {}", 0.25 + length / 2.0),
            ]
        };
        let cylinder = visual(
            origin,
            &format!("<cylinder radius=\"{radius}\" length=\"{length}\"/>"),
        );
        let ends = ends.map(|end| {
            visual(
                &format!("xyz=\"{end}\""),
                &format!("<sphere radius=\"{radius}\"/>"),
            )
        });
        format!("{cylinder}{}", ends.concat())
    };
    let quaternions = [
        "quat_xyzw=\"0 0.70710678 0 0.70710678\"",
        "quat_xyzw=\"0.3826834 0 0 0.9238795\"",
    ];
    let angles = ["rpy=\"0 1.5707963 0\"", "rpy=\"0.7853982 0 0\""];
    let draw = |name: &str, text: String| {
        let robot = folder.join(name).with_extension("urdf");
        fs::write(&robot, text).unwrap();
        draw((name, robot.to_str().unwrap(), "--size 480x400"), &folder)
    };
    let newer = draw(
        "version_1_1.png",
        arm("version=\"1.1\"", "", capsule, quaternions),
    );
    let newest = arm(
        "version=\"1.2\"",
        "acceleration=\"2\" deceleration=\"2\" jerk=\"3\"",
        capsule,
        quaternions,
    );
    let newest = draw("version_1_2.png", newest);
    let older = draw("version_1_0.png", arm("", "", shapes, angles));
    assert_eq!(
        fs::read(&newer).unwrap(),
        fs::read(newest).unwrap(),
        "limits are not drawn"
    );
    let part = difference(&newer, &older);
    assert!(
        part < 0.005,
        "{part} of the picture differs from that of cylinders, spheres and angles"
    );
    // older robots know no quaternions: urdfdom ignores them
    let ignored = draw(
        "ignored.png",
        arm("version=\"1.0\"", "", capsule, quaternions),
    );
    let part = difference(&newer, &ignored);
    assert!(
        part > 0.05,
        "{part} of the picture shows that a quaternion counts for nothing in URDF 1.0"
    );
}

#[test]
fn the_pictures_of_the_documentation_are_up_to_date() {
    let images = repository().join("docs/images");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    for picture in PICTURES {
        let name = picture.0;
        let new = draw(picture, &folder);
        let stored = images.join(name);
        if std::env::var_os("UPDATE").is_some() {
            fs::copy(&new, &stored).unwrap();
        }
        let same = match name.ends_with(".png") {
            true => difference(&stored, &new) < 0.002,
            false => fs::read_to_string(&stored).unwrap() == fs::read_to_string(&new).unwrap(),
        };
        assert!(
            same,
            "{name} is old: run `UPDATE=1 cargo test --test pictures`"
        );
        let again = draw(picture, &folder.join("again"));
        assert_eq!(
            fs::read(&new).unwrap(),
            fs::read(again).unwrap(),
            "{name}: other bytes the second time"
        );
    }
}
