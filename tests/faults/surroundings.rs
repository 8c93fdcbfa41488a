//! What else surrounds the program: the stack that a shell gives it, and a build without the viewer.

use std::fs;
use std::process::Command;

use super::{LINT, folder, write};

#[test]
fn nesting_is_no_matter_of_the_stack_that_a_shell_gives() {
    let folder = folder();
    let (open, close) = ("<a>".repeat(100_000), "</a>".repeat(100_000));
    write(
        &folder,
        "deep.urdf",
        &format!("<robot name=\"deep\">{open}{close}</robot>"),
    );
    for kilobytes in [256, 512, 1024, 2048, 8192, 16_384] {
        let script = format!("ulimit -S -s {kilobytes} && exec \"$0\" expand deep.urdf");
        let run = Command::new("sh")
            .args(["-c", &script, LINT])
            .current_dir(&folder)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(
            run.status.code() == Some(2) && said.contains("nested more than"),
            "{kilobytes} KB: {said}"
        );
    }
}

#[test]
fn nesting_has_no_end() {
    std::thread::scope(|scope| {
        for (open, close) in [
            ("<xacro:if value=\"1\">", "</xacro:if>"),
            ("<xacro:macro name=\"m\">", "</xacro:macro>"),
            ("<link name=\"a\">", "</link>"),
            ("<group>", "</group>"),
        ] {
            scope.spawn(move || check_nested(open, close));
        }
    });
}

/// All commands end, with a status of their own.
fn check_nested(open: &str, close: &str) {
    let folder = folder();
    let nested = format!(
        "<robot name=\"r\">{}{}</robot>",
        open.repeat(100_000),
        close.repeat(100_000)
    );
    for name in ["r.urdf.xacro", "r.urdf", "r.srdf"] {
        for command in ["check", "expand", "tree", "format"] {
            write(&folder, name, &nested);
            let done = Command::new(LINT)
                .arg(command)
                .arg(name)
                .current_dir(&folder)
                .output()
                .unwrap();
            let status = done.status;
            assert!(
                status.code().is_some(),
                "{command} {name} with {open}: {status}"
            );
        }
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn preview_of_a_build_without_the_viewer_says_how_to_get_it() {
    if viewer::SCRIPT.is_some() {
        println!("skip: this build has the viewer; the suite `preview` opens it");
        return;
    }
    let folder = folder();
    fs::write(
        folder.join("r.urdf"),
        "<robot name=\"r\"><link name=\"a\"/></robot>",
    )
    .unwrap();
    let said = Command::new(LINT)
        .args(["preview", "r.urdf"])
        .current_dir(&folder)
        .output()
        .unwrap();
    let error = String::from_utf8(said.stderr).unwrap();
    assert_eq!(said.status.code(), Some(2), "{error}");
    assert!(
        error.starts_with("error: this program was built without the viewer; run `npm ci`"),
        "{error}"
    );
    assert_eq!(
        (error.lines().count(), said.stdout.len()),
        (1, 0),
        "{error}"
    );
}
