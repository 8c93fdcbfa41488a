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

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

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

#[test]
fn what_may_not_be_read_is_named() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", ROBOT);
    write(&folder, "part.xacro", PART);
    write(&folder, "closed/x.urdf", "<robot name=\"x\"/>");
    mode(&folder.join("part.xacro"), 0o000);
    mode(&folder.join("closed"), 0o000);
    if let Some((code, text)) = lint_bound(&folder, &["check", "r.urdf.xacro"]) {
        assert_eq!(code, 1, "{text}");
        assert!(
            text.contains("`part.xacro` cannot be read: Permission denied"),
            "{text}"
        );
        assert!(text.contains("r.urdf.xacro:2:"), "{text}");
        let (code, text) = lint_bound(&folder, &["check", "part.xacro"]).unwrap();
        assert!(
            code > 0 && text.contains("part.xacro") && text.contains("Permission denied"),
            "{text}"
        );
        let (_, text) = lint_bound(&folder, &["check", "."]).unwrap();
        assert!(text.contains("`part.xacro` cannot be read"), "{text}");
    }
    mode(&folder.join("closed"), 0o755);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_workspace_that_may_only_be_read_is_checked_and_left_alone() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    mode(&folder, 0o555);
    if let Some((code, text)) = lint_bound(&folder, &["fix", "."]) {
        assert_eq!(code, 2, "{text}");
        assert!(
            text.contains("cannot write r.urdf.xacro: Permission denied"),
            "{text}"
        );
    }
    mode(&folder, 0o777);
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(3))])
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_file_that_is_protected_is_not_replaced() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    mode(&folder.join("r.urdf.xacro"), 0o444);
    if let Some((code, text)) = lint_bound(&folder, &["fix", "."]) {
        assert_eq!(code, 2, "{text}");
        assert!(
            text.contains("cannot write r.urdf.xacro: Permission denied"),
            "{text}"
        );
    }
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(3))])
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn permissions_and_owner_stay() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(3));
    let path = folder.join("r.urdf.xacro");
    mode(&path, 0o640);
    if fs::metadata(&path).unwrap().uid() == 0 {
        std::os::unix::fs::chown(&path, Some(65534), Some(65534)).unwrap();
    }
    let before = fs::metadata(&path).unwrap();
    let (code, text) = lint(&folder, &["fix", "."]);
    assert_eq!(
        (code, fs::read_to_string(&path).unwrap()),
        (0, fixed(3)),
        "{text}"
    );
    let after = fs::metadata(&path).unwrap();
    assert_eq!(
        (after.mode(), after.uid(), after.gid()),
        (before.mode(), before.uid(), before.gid())
    );
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn links_are_followed_inside_the_workspace_and_refused_outside() {
    let (folder, other) = (folder(), folder());
    write(&folder, "robots/r.urdf.xacro", &fixable(1));
    write(&other, "foreign.urdf.xacro", &fixable(1));
    symlink("robots/r.urdf.xacro", folder.join("link.urdf.xacro")).unwrap();
    symlink(
        other.join("foreign.urdf.xacro"),
        folder.join("away.urdf.xacro"),
    )
    .unwrap();
    lint(&folder, &["fix", "."]);
    assert!(
        folder
            .join("link.urdf.xacro")
            .symlink_metadata()
            .unwrap()
            .is_symlink()
    );
    assert_eq!(
        fs::read_to_string(folder.join("robots/r.urdf.xacro")).unwrap(),
        fixed(1)
    );
    assert_eq!(
        fs::read_to_string(other.join("foreign.urdf.xacro")).unwrap(),
        fixable(1)
    );
    fs::remove_dir_all(folder).unwrap();
    fs::remove_dir_all(other).unwrap();
}

#[test]
fn what_is_no_file_is_named_and_not_waited_for() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", ROBOT);
    let part = folder.join("part.xacro");
    let named = |what: &str| {
        let begin = Instant::now();
        let (code, text) = lint(&folder, &["check", "."]);
        assert!(
            code == 1 && text.contains("part.xacro") && text.contains("r.urdf.xacro:2:"),
            "{what}: {text}"
        );
        assert!(
            begin.elapsed() < Duration::from_secs(20),
            "{what}: {:?}",
            begin.elapsed()
        );
        let (code, text) = lint(&folder, &["fix", "r.urdf.xacro"]);
        assert_eq!(code, 1, "{what}: {text}");
    };
    fs::create_dir(&part).unwrap();
    named("a folder");
    fs::remove_dir(&part).unwrap();
    assert!(
        Command::new("mkfifo")
            .arg(&part)
            .status()
            .unwrap()
            .success()
    );
    named("a pipe");
    fs::remove_file(&part).unwrap();
    for device in ["/dev/zero", "/dev/tty", "/dev/stdin"] {
        symlink(device, &part).unwrap();
        named(device);
        fs::remove_file(&part).unwrap();
    }
    symlink("other.xacro", &part).unwrap();
    symlink("part.xacro", folder.join("other.xacro")).unwrap();
    symlink(".", folder.join("again")).unwrap();
    symlink("..", folder.join("up")).unwrap();
    named("links in a circle");
    fs::remove_dir_all(folder).unwrap();
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

#[test]
fn files_that_change_vanish_and_shrink_while_they_are_read() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", ROBOT);
    let large = PART.replace(
        "</robot>",
        &format!("{}</robot>", "<link name=\"b\"/>\n".repeat(20_000)),
    );
    let part = folder.join("part.xacro");
    fs::write(&part, &large).unwrap();
    let disturb = |turn: usize| {
        match turn % 6 {
            0 => drop(fs::remove_file(&part)),
            1 => drop(fs::write(&part, &large)),
            2 => drop(
                fs::File::options()
                    .write(true)
                    .open(&part)
                    .and_then(|file| file.set_len(100)),
            ),
            3 => drop(fs::remove_file(&part).and_then(|()| fs::create_dir(&part))),
            4 => drop(fs::remove_dir(&part).and_then(|()| symlink("/dev/zero", &part))),
            _ => drop(fs::remove_file(&part).and_then(|()| fs::write(&part, &large))),
        };
    };
    meanwhile(disturb, || {
        for _ in 0..15 {
            let (_, text) = lint(&folder, &["check", "."]);
            assert!(!text.contains("internal"), "{text}");
        }
    });
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn names_that_are_not_utf_8() {
    use std::os::unix::ffi::OsStrExt;
    let folder = folder();
    write(
        &folder,
        "r.urdf",
        "<robot name=\"r\"><link name=\"a\"/><link name=\"a\"/></robot>",
    );
    let name = std::ffi::OsStr::from_bytes(b"\xff\xfe.urdf");
    if fs::write(
        folder.join(name),
        "<robot name=\"x\"><link name=\"b\"/><link name=\"b\"/></robot>",
    )
    .is_err()
    {
        println!("skipped: this file system knows no such names");
        return;
    }
    let (code, text) = lint(&folder, &["check", "."]);
    assert!(code == 1 && text.contains("r.urdf:1:"), "{text}");
    let mut command = Command::new(LINT);
    command.arg("check").arg(name);
    let (code, text) = run(command, &folder);
    assert!(code > 0 && text.contains(".urdf"), "{text}");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn names_in_other_letter_cases() {
    let folder = folder();
    write(
        &folder,
        "r.urdf.xacro",
        &ROBOT.replace("part.xacro", "Part.xacro"),
    );
    write(&folder, "part.xacro", PART);
    if folder.join("PART.XACRO").exists() {
        println!("skipped: this file system does not tell letter cases apart");
        return;
    }
    // here such an include is missing; a mesh is found by listing the folder, so that it is reported everywhere
    let (code, text) = lint(&folder, &["check", "."]);
    assert!(
        code == 1 && text.contains("`Part.xacro` not found"),
        "{text}"
    );
    write(&folder, "Part.xacro", PART);
    let (_, text) = lint(&folder, &["check", "r.urdf.xacro"]);
    assert!(!text.contains("Part.xacro` not found"), "{text}");
    fs::remove_dir_all(folder).unwrap();
}

/// Files may not grow beyond a kilobyte: writing fails as on a full disk.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(400));
    let mut command = Command::new("sh");
    command
        .arg("-c")
        .arg("trap '' XFSZ; ulimit -f 1; exec \"$0\" fix .")
        .arg(LINT);
    let (code, text) = run(command, &folder);
    assert_eq!(code, 2, "{text}");
    assert!(
        text.contains("cannot write r.urdf.xacro: File too large"),
        "{text}"
    );
    assert_eq!(
        texts(&folder),
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(400))])
    );
    fs::remove_dir_all(folder).unwrap();
}

/// The same on a file system without room, where the test may make one.
#[test]
fn a_small_file_system_leaves_the_old_file() {
    let folder = folder();
    let small = folder.join("small");
    fs::create_dir(&small).unwrap();
    let mounted = Command::new("mount")
        .args(["-t", "tmpfs", "-o", "size=64k", "none"])
        .arg(&small)
        .output();
    if !mounted.is_ok_and(|done| done.status.success()) {
        println!("skipped: a small file system can be made by the superuser only");
        return;
    }
    write(&small, "r.urdf.xacro", &fixable(2000));
    let (code, text) = lint(&small, &["fix", "."]);
    let left = texts(&small);
    Command::new("umount").arg(&small).status().unwrap();
    assert!(
        code == 2 && text.contains("cannot write r.urdf.xacro: No space left on device"),
        "{text}"
    );
    assert_eq!(
        left,
        BTreeMap::from([("r.urdf.xacro".to_owned(), fixable(2000))])
    );
    fs::remove_dir_all(folder).unwrap();
}

fn many(folder: &Path) {
    for n in 0..40 {
        write(folder, &format!("r{n}.urdf.xacro"), &fixable(200));
    }
}

#[test]
fn two_runs_of_fix_at_once() {
    let folder = folder();
    for round in 0..5 {
        many(&folder);
        let start = || {
            Command::new(LINT)
                .args(["fix", "."])
                .current_dir(&folder)
                .stdout(Stdio::piped())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let runs = [start(), start(), start()];
        for run in runs {
            let (code, text) = told(run.wait_with_output().unwrap());
            assert_eq!(code, 0, "round {round}: {text}");
        }
        let left = texts(&folder);
        assert_eq!(left.len(), 40, "{:?}", left.keys());
        assert!(
            left.values().all(|text| *text == fixed(200)),
            "round {round}"
        );
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn who_saves_a_file_while_it_is_fixed_finds_it_whole() {
    let folder = folder();
    write(&folder, "r.urdf.xacro", &fixable(10));
    let path = folder.join("r.urdf.xacro");
    // an editor that writes as editors do: a new file that takes the name
    let saved = std::sync::Mutex::new(String::new());
    let disturb = |turn: usize| {
        let text = fixable(10).replace("l3", &format!("saved{turn}"));
        let new = folder.join("editor~");
        fs::write(&new, &text).unwrap();
        fs::rename(&new, &path).unwrap();
        *saved.lock().unwrap() = format!("saved{turn}");
        std::thread::sleep(Duration::from_millis(20));
    };
    meanwhile(disturb, || {
        for _ in 0..8 {
            let (code, text) = lint(&folder, &["fix", "r.urdf.xacro"]);
            let fine = code == 0 || text.contains("it was changed by another program");
            assert!(fine, "{text}");
        }
    });
    // whole in every case: one of the texts that were saved, fixed or not
    let text = fs::read_to_string(&path)
        .unwrap()
        .replace("<xacro:property", "<property");
    let number = text
        .split("\"saved")
        .nth(1)
        .and_then(|rest| rest.split('"').next())
        .unwrap();
    assert_eq!(text, fixable(10).replace("l3", &format!("saved{number}")));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn ctrl_c_at_any_time_leaves_every_file_whole() {
    let folder = folder();
    let mut interrupted = 0;
    for round in 0..25 {
        many(&folder);
        let mut child = Command::new(LINT)
            .args(["fix", "."])
            .current_dir(&folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(round * 8));
        // a shell that started the tests in the background has told them to ignore the first one
        let signal = if round % 2 == 0 { "-INT" } else { "-TERM" };
        Command::new("kill")
            .args([signal, &child.id().to_string()])
            .stderr(Stdio::null())
            .status()
            .unwrap();
        interrupted += usize::from(child.wait().unwrap().code().is_none());
        for (name, text) in texts(&folder) {
            // a new file that did not get its name yet is no description and may be cut
            let is_new = name.starts_with('.') && name.ends_with(".tmp");
            assert!(
                is_new || text == fixable(200) || text == fixed(200),
                "round {round}: {name} is cut"
            );
        }
    }
    assert!(interrupted > 0, "no run was interrupted");
    // what was left over disturbs nobody
    let (code, text) = lint(&folder, &["fix", "."]);
    assert_eq!(code, 0, "{text}");
    fs::remove_dir_all(folder).unwrap();
}

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
    let folder = folder();
    for (open, close) in [
        ("<xacro:if value=\"1\">", "</xacro:if>"),
        ("<xacro:macro name=\"m\">", "</xacro:macro>"),
        ("<link name=\"a\">", "</link>"),
        ("<group>", "</group>"),
    ] {
        let nested = format!(
            "<robot name=\"r\">{}{}</robot>",
            open.repeat(100_000),
            close.repeat(100_000)
        );
        for name in ["r.urdf.xacro", "r.urdf", "r.srdf"] {
            write(&folder, name, &nested);
            for command in ["check", "expand", "tree", "format"] {
                let done = Command::new(LINT)
                    .arg(command)
                    .arg(name)
                    .current_dir(&folder)
                    .output()
                    .unwrap();
                assert!(
                    done.status.code().is_some(),
                    "{command} {name} with {open}: {done:?}"
                );
                fs::write(folder.join(name), &nested).unwrap();
            }
        }
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn preview_of_a_build_without_the_viewer_says_how_to_get_it() {
    if Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("editors/viewer/dist/viewer.js")
        .exists()
    {
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
