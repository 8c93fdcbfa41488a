//! What the command line promises to those who run it in scripts, tried with the program itself.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly
#![cfg(unix)]

use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

const PROGRAM: &str = env!("CARGO_BIN_EXE_xacro-lint");
const ROBOT: &str =
    "<?xml version=\"1.0\"?>\n<robot name=\"r\">\n  <link name=\"base_link\"/>\n</robot>\n";

/// An empty folder with these files.
fn folder(files: &[(&str, &str)]) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("contracts")
        .join(number.to_string());
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join(".git")).unwrap();
    for (name, text) in files {
        fs::create_dir_all(folder.join(name).parent().unwrap()).unwrap();
        fs::write(folder.join(name), text).unwrap();
    }
    folder
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null());
    command
        .env_remove("AMENT_PREFIX_PATH")
        .env_remove("ROS_PACKAGE_PATH");
    command
}

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = command(folder, arguments).output().unwrap();
    (
        status.code(),
        String::from_utf8(stdout).unwrap(),
        String::from_utf8(stderr).unwrap(),
    )
}

#[test]
fn a_full_disk_is_an_error() {
    if !Path::new("/dev/full").exists() {
        println!("skipped: no /dev/full here");
        return;
    }
    let folder = folder(&[
        ("r.urdf", ROBOT),
        ("package.xml", "<package><name>p</name></package>"),
    ]);
    for arguments in [
        vec!["expand", "r.urdf"],
        vec!["check", "--format", "sarif", "."],
        vec!["check", "--format", "json", "."],
        vec!["check", "."],
        vec!["tree", "r.urdf"],
        vec!["packages", "."],
        vec!["deps", "r.urdf"],
        vec!["rules"],
        vec!["explain", "no-links"],
        vec!["config", "."],
        vec!["completions", "bash"],
        vec!["--help"],
    ] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = command(&folder, &arguments).stdout(full).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(
            said.contains("cannot write to standard output: No space left"),
            "{arguments:?}: {said}"
        );
    }
}

#[test]
fn a_reader_that_goes_away_is_none() {
    let folder = folder(&[("r.urdf", ROBOT)]);
    for arguments in [
        vec!["expand", "r.urdf"],
        vec!["rules"],
        vec!["check", "--format", "json", "."],
    ] {
        let mut child = command(&folder, &arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(
            String::from_utf8(output.stderr).unwrap(),
            "",
            "{arguments:?}"
        );
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    }
}

#[test]
fn a_configuration_that_cannot_be_read_is_an_error() {
    type Make = fn(&Path);
    let makes: [(&str, Make); 4] = [
        ("a link that leads nowhere", |path| {
            symlink("gone", path).unwrap()
        }),
        ("a folder", |path| fs::create_dir(path).unwrap()),
        ("very large", |path| {
            fs::File::create(path).unwrap().set_len(25_000_000).unwrap()
        }),
        ("not for us", |path| {
            fs::write(path, "ignore = [\"ALL\"]").unwrap();
            fs::set_permissions(path, fs::Permissions::from_mode(0o000)).unwrap();
        }),
    ];
    for (kind, make) in makes {
        let folder = folder(&[("r.urdf", ROBOT)]);
        let path = folder.join("xacro-lint.toml");
        make(&path);
        if fs::read(&path).is_ok_and(|text| text.len() < 100) {
            println!("skipped, {kind}: this user may read everything");
            continue;
        }
        for arguments in [
            vec!["check", "."],
            vec!["fix", "."],
            vec!["config", "."],
            vec!["format", "--check", "."],
        ] {
            let (code, _, said) = run(&folder, &arguments);
            assert_eq!(code, Some(2), "{kind}, {arguments:?}: {said}");
            assert!(
                said.contains("error: xacro-lint.toml: "),
                "{kind}, {arguments:?}: {said}"
            );
        }
    }
}

#[test]
fn text_of_files_stays_in_its_line() {
    let name = "a&#10;::error file=x::said&#155;&#127;";
    let link = |name: &str| format!("<link name=\"{name}\"/>");
    let joint = "<joint name=\"j&#10;::error::\" type=\"fixed\"><parent link=\"base\"/><child link=\"a&#10;::error file=x::said&#155;&#127;\"/></joint>";
    let robot = format!(
        "<robot name=\"r&#10;::error::\">{}{}{joint}</robot>",
        link("base"),
        link(name)
    );
    let message = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><link name=\"a\"/>${xacro.message('m\\n::error::x')}</robot>";
    let manifest = "<package><name>p&#10;::error::</name></package>";
    let folder = folder(&[
        ("r.urdf", &robot),
        ("m.xacro", message),
        ("p/package.xml", manifest),
    ]);
    for arguments in [
        vec!["tree", "r.urdf"],
        vec!["tree", "--joints", "r.urdf"],
        vec!["tree", "--format", "dot", "r.urdf"],
        vec!["packages", "."],
        vec!["expand", "m.xacro", "-o", "out.urdf"],
        vec!["check", "--show", "all", "."],
        vec!["check", "--show", "all", "--format", "concise", "."],
    ] {
        let (_, out, err) = run(&folder, &arguments);
        for line in out.lines().chain(err.lines()) {
            let bad = |c: char| c.is_control() && c != '\t';
            assert!(
                !line.trim_start().starts_with("::error") && !line.contains(bad),
                "{arguments:?}: {line:?}"
            );
        }
    }
}

#[test]
fn a_file_that_cannot_be_fixed_does_not_keep_others_from_it() {
    let wrong = ROBOT.replace(
        "<robot name=\"r\">",
        "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><property name=\"a\" value=\"1\"/>",
    );
    let folder = folder(&[
        ("a.xacro", &wrong),
        ("b.xacro", &wrong),
        ("c.xacro", &wrong),
    ]);
    let latin = [wrong.as_bytes(), b"<!-- \xe9 -->"].concat();
    fs::write(folder.join("d.xacro"), latin).unwrap();
    fs::set_permissions(folder.join("b.xacro"), fs::Permissions::from_mode(0o444)).unwrap();
    let is_root = fs::File::options()
        .write(true)
        .open(folder.join("b.xacro"))
        .is_ok();
    let (code, _, said) = run(&folder, &["fix", "."]);
    for (name, fixed) in [
        ("a.xacro", true),
        ("b.xacro", is_root),
        ("c.xacro", true),
        ("d.xacro", false),
    ] {
        let text = fs::read(folder.join(name)).unwrap();
        let text = String::from_utf8_lossy(&text);
        assert_eq!(text.contains("<xacro:property"), fixed, "{name}: {said}");
    }
    if !is_root {
        assert_eq!(code, Some(2), "{said}");
        assert!(said.contains("error: b.xacro: cannot be written"), "{said}");
    }
    let (_, diff, _) = run(&folder, &["fix", "--diff", "."]);
    assert!(!diff.contains("d.xacro"), "{diff}");
}

#[test]
fn a_comment_at_an_include_hides_what_is_in_the_file() {
    let part = "<robot><joint name=\"j\" type=\"fixed\"><parent link=\"base_link\"/><child link=\"gone\"/></joint></robot>";
    let robot = |comment: &str| {
        format!(
            "<?xml version=\"1.0\"?>\n<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n<link name=\"base_link\"/>\n{comment}\n<xacro:include filename=\"inc.xacro\"/>\n</robot>\n"
        )
    };
    let comment = "<!-- xacro-lint: disable-next-line STR: mounted elsewhere -->";
    for (comment, expected) in [("", Some(1)), (comment, Some(0))] {
        let folder = folder(&[("r.urdf.xacro", &robot(comment)), ("inc.xacro", part)]);
        let only = ["check", "--select", "undefined-link,LNT", "r.urdf.xacro"];
        let (code, out, _) = run(&folder, &only);
        assert_eq!(code, expected, "{out}");
        assert!(!out.contains("unused-suppression"), "{out}");
    }
}

#[test]
fn bash_completes_below_the_first_word() {
    let script = run(Path::new("."), &["completions", "bash"]).1;
    let ask = |words: &[&str]| {
        let list = words
            .iter()
            .map(|word| format!("'{word}'"))
            .collect::<Vec<_>>()
            .join(" ");
        let last = words.len() - 1;
        let code = format!(
            "{script}\nCOMP_WORDS=({list}); COMP_CWORD={last}; _xacro__lint xacro-lint '{}' '{}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            words[last],
            words[last - 1]
        );
        Command::new("bash")
            .args(["--norc", "-c", &code])
            .output()
            .map(|output| String::from_utf8(output.stdout).unwrap())
    };
    let Ok(commands) = ask(&["xacro-lint", "ch"]) else {
        println!("skipped: no bash here");
        return;
    };
    assert_eq!(commands.trim(), "check");
    assert!(
        ask(&["xacro-lint", "check", "--fo"])
            .unwrap()
            .contains("--format")
    );
    assert!(
        ask(&["xacro-lint", "check", "--format", ""])
            .unwrap()
            .contains("sarif")
    );
    assert!(
        ask(&["xacro-lint", "fix", "--"])
            .unwrap()
            .contains("--unsafe-fixes")
    );
}

#[test]
fn places_of_a_sarif_result_differ() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples/broken_cell");
    let (_, out, _) = run(
        &folder,
        &["check", "--format", "sarif", "--show", "all", "."],
    );
    let report: serde_json::Value = serde_json::from_str(&out).unwrap();
    let mut seen = 0;
    for result in report["runs"][0]["results"].as_array().unwrap() {
        let places = result["relatedLocations"]
            .as_array()
            .cloned()
            .unwrap_or_default();
        for (number, place) in places.iter().enumerate() {
            let without_id = |place: &serde_json::Value| {
                (place["physicalLocation"].clone(), place["message"].clone())
            };
            assert!(
                places[..number]
                    .iter()
                    .all(|other| without_id(other) != without_id(place)),
                "{result}"
            );
        }
        seen += places.len();
    }
    assert!(seen > 3);
}

#[test]
fn a_file_that_is_excluded_does_not_look_checked() {
    let files = [
        ("xacro-lint.toml", "exclude = [\"sub\"]"),
        ("sub/b.urdf", "<robot name=\"b\"/>"),
        ("a.urdf", ROBOT),
    ];
    let folder = folder(&files);
    let (code, out, err) = run(&folder, &["check", "sub/b.urdf", "a.urdf"]);
    assert_eq!(code, Some(0), "{out}{err}");
    assert!(
        err.contains("warning: sub/b.urdf was not checked: it is excluded"),
        "{err}"
    );
    assert!(out.contains("1 file checked"), "{out}");
}

#[test]
fn a_baseline_speaks_of_the_files_that_are_checked() {
    let wrong = ROBOT.replace("/>", "/><link name=\"loose\"/>");
    let folder = folder(&[("a.urdf", &wrong), ("b.urdf", &wrong)]);
    assert_eq!(
        run(&folder, &["check", "--write-baseline", "k.json", "."]).0,
        Some(0)
    );
    let said = |arguments: &[&str]| {
        run(
            &folder,
            &[&["check", "--baseline", "k.json"], arguments].concat(),
        )
        .2
    };
    fs::write(folder.join("a.urdf"), ROBOT).unwrap();
    assert!(
        said(&["b.urdf"]).contains("not shown") && !said(&["b.urdf"]).contains("no longer found")
    );
    let one = said(&["a.urdf"]);
    assert!(one.contains("from the baseline no longer found\n"), "{one}");
    assert!(said(&["."]).contains("no longer found: update it with --write-baseline"));
    assert!(!said(&["--changed", "a.urdf"]).contains("no longer found"));
}

/// A file or folder that nobody may read; for the superuser, who may, the program runs as somebody else.
fn run_without_rights(folder: &Path, arguments: &[&str]) -> Option<(Option<i32>, String, String)> {
    let mut command = command(folder, arguments);
    if fs::read_dir(folder.join("closed")).is_ok() {
        command.uid(65534).gid(65534);
    }
    let Output {
        status,
        stdout,
        stderr,
    } = command.output().ok()?;
    Some((
        status.code(),
        String::from_utf8(stdout).unwrap(),
        String::from_utf8(stderr).unwrap(),
    ))
}

#[test]
fn folders_that_cannot_be_read_are_named() {
    let folder = folder(&[("a.urdf", ROBOT), ("closed/b.urdf", ROBOT)]);
    let mode = |mode| {
        fs::set_permissions(folder.join("closed"), fs::Permissions::from_mode(mode)).unwrap()
    };
    mode(0o000);
    let inside = run_without_rights(&folder, &["check", "."]);
    let named = run_without_rights(&folder, &["check", "closed"]);
    mode(0o755);
    let (Some((code, _, inside)), Some((failed, _, named))) = (inside, named) else {
        println!("skipped: the program cannot be run as another user here");
        return;
    };
    assert_eq!(code, Some(0), "{inside}");
    let said = "warning: closed was not checked: cannot read the folder: Permission denied";
    assert!(inside.contains(said), "{inside}");
    assert_eq!(failed, Some(2), "{named}");
    assert!(
        named.contains("error: closed: Permission denied"),
        "{named}"
    );
}

#[test]
fn names_that_are_no_text_are_said_to_be_skipped() {
    let folder = folder(&[("a.urdf", ROBOT)]);
    for name in [&b"caf\xe9.urdf"[..], b"dir\xff"] {
        let path = folder.join(OsStr::from_bytes(name));
        let path = if name.ends_with(b"urdf") {
            path
        } else {
            fs::create_dir(&path).map(|()| path.join("b.urdf")).unwrap()
        };
        fs::write(path, "<robot").unwrap();
    }
    let (code, out, err) = run(&folder, &["check", "."]);
    assert_eq!(code, Some(0), "{out}{err}");
    assert!(out.contains("1 file checked"), "{out}");
    assert_eq!(
        err.matches("was not checked: its name is not valid UTF-8")
            .count(),
        2,
        "{err}"
    );
}

#[test]
fn roots_folders_and_arguments_that_are_not_there() {
    let config = "package-path = [\"no/such\", \"src\"]\n[[roots]]\nfile = \"nope.urdf\"\n[[roots]]\n\
                  file = \"r.xacro\"\nargs = { side = \"left\" }\npresets.far = { distance = 2, dept = 1 }\n";
    let robot = "<robot name=\"r\" xmlns:xacro=\"http://ros.org/wiki/xacro\">\n<xacro:arg name=\"depth\" default=\"1\"/>\n\
                 <link name=\"$(arg side)_$(arg depth)\"/>\n</robot>\n";
    let folder = folder(&[
        ("xacro-lint.toml", config),
        ("r.xacro", robot),
        ("src/a.txt", ""),
    ]);
    let (code, out, _) = run(&folder, &["check", "--format", "concise", "."]);
    assert_eq!(code, Some(1), "{out}");
    for said in [
        "xacro-lint.toml:1:17: warning: `no/such` is not a folder",
        "xacro-lint.toml:3:8: warning: no file matches `nope.urdf`",
        "xacro-lint.toml:7:17: warning: unknown argument `distance` of `r.xacro`",
        "xacro-lint.toml:7:31: warning: unknown argument `dept` of `r.xacro`",
    ] {
        assert!(out.contains(said), "{said}\n{out}");
    }
    assert_eq!(out.matches("xacro-lint.toml").count(), 4, "{out}");
    // a root that is not expanded may declare what it is given
    let (_, out, _) = run(&folder, &["check", "--format", "concise", "src"]);
    assert!(!out.contains("unknown argument"), "{out}");
}

#[test]
fn watching_survives_a_robot_that_comes_and_goes() {
    let folder = folder(&[("r.urdf", ROBOT)]);
    let mut child = command(&folder, &["check", "--watch", "."])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
    let mut wait_for = |text: &str| {
        let found = lines.by_ref().any(|line| line.unwrap().contains(text));
        assert!(found, "{text}");
    };
    wait_for("watching");
    fs::rename(folder.join("r.urdf"), folder.join("away")).unwrap();
    wait_for("r.urdf changed");
    wait_for("watching");
    fs::rename(folder.join("away"), folder.join("r.urdf")).unwrap();
    wait_for("r.urdf changed");
    wait_for("watching");
    fs::write(folder.join("xacro-lint.toml"), "select = [\"STR\"]").unwrap();
    wait_for("xacro-lint.toml changed");
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn a_diff_has_the_bytes_of_the_file() {
    let wrong = "<robot name=\"r\">\r  <!-- \u{85} \u{9b} \u{7f} \u{202e} -->\n  <link name=\"a\" />\n  <!-- xacro-lint: disable-next-line STR: x -->\n  \
                 <link name=\"b\"/>\n  <joint name=\"j\" type=\"fixed\">\n    <parent link=\"a\"/>\n    <child link=\"b\"/>\n  </joint>\n</robot>\n";
    let folder = folder(&[("a file.urdf", wrong), ("z.urdf", wrong), ("b.urdf", wrong)]);
    let (_, diff, err) = run(&folder, &["check", "--diff", "."]);
    let names: Vec<&str> = diff
        .lines()
        .filter(|line| line.starts_with("--- "))
        .collect();
    assert_eq!(
        names,
        ["--- a/a file.urdf\t", "--- a/b.urdf", "--- a/z.urdf"],
        "{err}"
    );
    fs::write(folder.join("fix.patch"), &diff).unwrap();
    let fixed = wrong.replace("  <!-- xacro-lint: disable-next-line STR: x -->\n", "");
    for (program, arguments) in [
        ("git", vec!["apply", "fix.patch"]),
        ("patch", vec!["-p1", "--binary", "-i", "fix.patch"]),
    ] {
        let Ok(output) = Command::new(program)
            .args(arguments)
            .current_dir(&folder)
            .output()
        else {
            println!("skipped: no {program} here");
            continue;
        };
        assert!(output.status.success(), "{program}: {output:?}");
        for name in ["a file.urdf", "b.urdf", "z.urdf"] {
            assert_eq!(
                fs::read_to_string(folder.join(name)).unwrap(),
                fixed,
                "{program} {name}"
            );
            fs::write(folder.join(name), wrong).unwrap();
        }
    }
}

#[test]
fn an_empty_path_is_no_folder() {
    let folder = folder(&[("a.urdf", ROBOT)]);
    for arguments in [
        vec!["fix", ""],
        vec!["check", ""],
        vec!["check", "a.urdf", ""],
    ] {
        let (code, _, err) = run(&folder, &arguments);
        assert_eq!(
            (code, err.contains("empty path")),
            (Some(2), true),
            "{arguments:?}: {err}"
        );
    }
}

#[test]
fn a_backslash_is_a_letter_of_a_name() {
    let folder = folder(&[("back\\slash.urdf", "<robot name=\"r\"/>")]);
    let (_, out, _) = run(&folder, &["check", "--format", "concise", "."]);
    assert!(out.contains("back\\slash.urdf:1:"), "{out}");
}

#[test]
fn text_that_turns_around_is_made_visible() {
    let robot = "<robot name=\"r\"><link name=\"a\u{202e}b\u{2028}c\"/><link name=\"z\"/></robot>";
    let folder = folder(&[("r.urdf", robot)]);
    for format in ["text", "concise", "github"] {
        let (_, out, _) = run(&folder, &["check", "--format", format, "."]);
        assert!(out.contains("orphan") || out.contains("root"), "{out}");
        assert!(!out.contains(['\u{202e}', '\u{2028}']), "{format}: {out}");
    }
}
