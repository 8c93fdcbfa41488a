//! What the disk can do to us: files that cannot be read, that vanish or change while they are read, that are no
//! files, and disks that are full or may not be written. The program ends, names what it could not read, and every
//! file of the user is whole.
#![cfg(unix)]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods,
    clippy::print_stdout
)] // a test may fail loudly

#[path = "faults/reading.rs"]
mod reading;
#[path = "faults/surroundings.rs"]
mod surroundings;
#[path = "faults/writing.rs"]
mod writing;

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

const LINT: &str = env!("CARGO_BIN_EXE_xacro-lint");

/// A folder that is made again, that everybody may write to.
fn folder() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    // where other users may go too
    let name = format!("xacro-faults-{}-{number}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    mode(&folder, 0o777);
    folder
}

fn mode(path: &Path, mode: u32) {
    fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
}

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

const ROBOT: &str = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n\
    <xacro:include filename=\"part.xacro\"/>\n<link name=\"a\"/>\n</robot>\n";
const PART: &str = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<xacro:property name=\"p\" value=\"1\"/>\n</robot>\n";

/// What `fix` changes: the prefix is missing.
fn fixable(lines: usize) -> String {
    let lines: String = (0..lines)
        .map(|n| format!("  <!-- \"l{n}\" -->\n"))
        .collect();
    format!(
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n  <property name=\"p\" value=\"a\"/>\n\
         {lines}  <link name=\"${{p}}\"/>\n</robot>\n"
    )
}

fn fixed(lines: usize) -> String {
    fixable(lines).replace("<property", "<xacro:property")
}

fn run(mut command: Command, folder: &Path) -> (i32, String) {
    let command = command
        .current_dir(folder)
        .stdin(Stdio::null())
        .env("AMENT_PREFIX_PATH", folder.join("none"));
    told(command.output().unwrap())
}

fn told(output: Output) -> (i32, String) {
    let text = format!(
        "{}{}",
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
    let code = output
        .status
        .code()
        .unwrap_or_else(|| panic!("ended by a signal: {text}"));
    assert!(!text.contains("panicked"), "{text}");
    assert!((0..=2).contains(&code), "exit {code}: {text}");
    (code, text)
}

fn lint(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let mut command = Command::new(LINT);
    command.args(arguments);
    run(command, folder)
}

/// The same as a user whom permissions bind: the superuser may do everything. None where there is no such user.
fn lint_bound(folder: &Path, arguments: &[&str]) -> Option<(i32, String)> {
    if fs::metadata(folder).unwrap().uid() != 0 {
        return Some(lint(folder, arguments));
    }
    let program = folder.with_extension("program");
    fs::copy(LINT, &program).unwrap();
    mode(&program, 0o755);
    let nobody = ["--reuid=65534", "--regid=65534", "--clear-groups"];
    let mut command = Command::new("setpriv");
    let works = command
        .args(nobody)
        .arg("true")
        .output()
        .is_ok_and(|done| done.status.success());
    let result = works.then(|| {
        // a program that another thread inherits open for writing is busy for a moment
        let ready = || {
            Command::new(&program)
                .arg("--version")
                .output()
                .is_ok_and(|done| done.status.success())
        };
        while !ready() {
            std::thread::sleep(Duration::from_millis(10));
        }
        let mut command = Command::new("setpriv");
        command.args(nobody).arg(&program).args(arguments);
        run(command, folder)
    });
    fs::remove_file(program).unwrap();
    if result.is_none() {
        println!("skipped: the superuser runs this, and `setpriv` is missing");
    }
    result
}

/// All files of a folder with their texts.
fn texts(folder: &Path) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        found.insert(name, fs::read_to_string(&path).unwrap_or_default());
    }
    found
}

/// Do something again and again in another thread while `work` runs.
fn meanwhile<T>(disturb: impl Fn(usize) + Sync, work: impl FnOnce() -> T) -> T {
    let over = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut turn = 0;
            while !over.load(Ordering::Relaxed) {
                disturb(turn);
                turn += 1;
            }
        });
        let result = work();
        over.store(true, Ordering::Relaxed);
        result
    })
}
