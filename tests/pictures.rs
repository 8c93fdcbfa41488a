//! The still pictures of the documentation show the examples as they are. `UPDATE=1` draws them anew.
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
const GRIPPER: &str = "two_joint_gripper/src/two_joint_gripper_description/urdf/two_joint_gripper.urdf.xacro";

/// Pictures with the arguments that make them.
const PICTURES: [(&str, &str, &str); 5] = [
    ("render-cell.png", CELL, "--size 640x480"),
    ("render-cell.svg", CELL, "--size 640x480"),
    ("render-arm.png", ARM, "--size 640x480 --joint joint_2=20deg --joint joint_3=30deg"),
    ("render-gripper.png", GRIPPER, "--size 640x480 --frames --joint shoulder=35deg --joint elbow=-60deg"),
    ("render-tree.svg", GRIPPER, "--tree"),
];

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Draw a picture into `folder`.
fn draw((name, robot, options): (&str, &str, &str), folder: &Path) -> PathBuf {
    let cwd = repository().join("docs/examples");
    let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), cwd.join("none").display().to_string())]);
    let env = Environment { vars, cwd };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut stdin = std::io::empty();
    let path = folder.join(name);
    let line = ["render", robot, "-o", path.to_str().unwrap()].into_iter().chain(options.split_whitespace());
    let args: Vec<String> = line.map(str::to_owned).collect();
    let code = cli::run(&args, &env, &mut Io::plain(&mut out, &mut err, &mut stdin));
    assert_eq!((code, String::from_utf8(err).unwrap().as_str()), (0, ""), "{name}");
    assert!(out.is_empty());
    path
}

fn pixels(path: &Path) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(fs::read(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    bytes.truncate(info.buffer_size());
    (info.width, info.height, bytes)
}

/// The part of two pictures that differs by more than machines may differ in their arithmetic.
fn difference(a: &Path, b: &Path) -> f64 {
    let ((w, h, a), (v, g, b)) = (pixels(a), pixels(b));
    assert_eq!((w, h, a.len()), (v, g, b.len()));
    let far = a.chunks(3).zip(b.chunks(3)).filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8));
    far.count() as f64 / f64::from(w * h)
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
        assert!(same, "{name} is old: run `UPDATE=1 cargo test --test pictures`");
        let again = draw(picture, &folder.join("again"));
        assert_eq!(fs::read(&new).unwrap(), fs::read(again).unwrap(), "{name}: other bytes the second time");
    }
}
