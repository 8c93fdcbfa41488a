//! Load a robot: expand it, read the URDF, find its meshes.
//!
//! `cargo run -p xacro-expand --example load -- FILE [NAME:=VALUE ...]`
#![allow(clippy::print_stdout, clippy::print_stderr)] // it is a program for the command line

use std::process::ExitCode;

use urdf_rs::Geometry;
use xacro_expand::{Options, expand};

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(file) = arguments.next() else {
        eprintln!("usage: load FILE [NAME:=VALUE ...]");
        return ExitCode::from(2);
    };
    let given = arguments
        .filter_map(|text| Some(text.split_once(":=")?).map(|(a, b)| (a.to_owned(), b.to_owned())));
    let options = given.fold(Options::new(), |options, (name, value)| {
        options.arg(name, value)
    });
    let loaded = expand(&file, &options);
    for problem in loaded.problems() {
        eprintln!("{problem}");
    }
    let Some(text) = loaded.text() else {
        return ExitCode::FAILURE;
    };
    let robot = match urdf_rs::read_from_string(text) {
        Ok(robot) => robot,
        Err(error) => {
            eprintln!("{file}: error: {error}");
            return ExitCode::FAILURE;
        }
    };
    println!(
        "{}: {} links, {} joints",
        robot.name,
        robot.links.len(),
        robot.joints.len()
    );
    for geometry in robot
        .links
        .iter()
        .flat_map(|link| &link.visual)
        .map(|visual| &visual.geometry)
    {
        if let Geometry::Mesh { filename, .. } = geometry {
            match loaded.resolve(filename) {
                Some(path) => println!("{filename}: {}", path.display()),
                None => println!("{filename}: not found"),
            }
        }
    }
    ExitCode::SUCCESS
}
