//! What beginners do: each mistake of `tests/beginner/mistakes.txt` is planted alone in one of three small robots. What is
//! found of it is written below it; so is the text to type, which a fix writes. The robots themselves are silent.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

mod meshes;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::{self, CheckOptions, FixOptions, Overrides, Report, Session, Setup};
use xacro_lsp::rules::{Safety, Severity};
use xacro_lsp::vfs::Environment;

/// A mistake: edits of the files of a robot, and what is found.
struct Mistake {
    name: String,
    edits: Vec<(PathBuf, Edit)>,
    /// `error RULE FILE:LINE`, in order.
    found: Vec<String>,
    /// Texts that fixes write.
    typed: Vec<String>,
    /// More of the robot is there after the fix, and it has errors of its own.
    reveals: bool,
}

enum Edit {
    /// Each of these texts, which is there once, becomes the other one.
    Replace(Vec<(String, String)>),
    /// Wherever the text is.
    ReplaceAll(String, String),
    Delete,
    Move(PathBuf),
}

fn home() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/beginner")
}

fn mistakes() -> Vec<Mistake> {
    let text = fs::read_to_string(home().join("mistakes.txt")).unwrap();
    text.split("\n## ").skip(1).map(mistake).collect()
}

fn mistake(section: &str) -> Mistake {
    let mut lines = section.lines();
    let name = lines.next().unwrap().to_owned();
    let mut read = Mistake {
        name,
        edits: Vec::new(),
        found: Vec::new(),
        typed: Vec::new(),
        reveals: false,
    };
    let mut file = PathBuf::new();
    while let Some(line) = lines.next() {
        if line == "```diff" {
            let hunk: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            read.edits.push((file.clone(), replacement(&hunk)));
        } else if line == "delete" {
            read.edits.push((file.clone(), Edit::Delete));
        } else if let Some(target) = line.strip_prefix("move ") {
            read.edits.push((file.clone(), Edit::Move(target.into())));
        } else if let Some(found) = line.strip_prefix("* ") {
            match found.strip_prefix("types ") {
                Some(typed) => read.typed.push(typed.to_owned()),
                None if found == "reveals" => read.reveals = true,
                None if found == "silent" => {}
                None => read.found.push(found.to_owned()),
            }
        } else if !line.is_empty() {
            file = line.into();
        }
    }
    read
}

/// Lines with `-` are there and those with `+` are to be; a `~` in front of both: everywhere.
fn replacement(hunk: &[&str]) -> Edit {
    if let [old, new] = hunk
        && let (Some(old), Some(new)) = (old.strip_prefix('~'), new.strip_prefix('~'))
    {
        return Edit::ReplaceAll(old.replace("\\n", "\n"), new.replace("\\n", "\n"));
    }
    assert!(
        hunk.iter().all(|line| line.starts_with(['-', '+'])),
        "{hunk:?}"
    );
    let mut pairs = Vec::new();
    let mut lines = hunk.iter().peekable();
    while lines.peek().is_some() {
        let mut block = |sign: char| {
            let mut block = Vec::new();
            while let Some(line) = lines.next_if(|line| line.starts_with(sign)) {
                block.push(&line[1..]);
            }
            block.join("\n")
        };
        pairs.push((block('-'), block('+')));
    }
    Edit::Replace(pairs)
}

/// A robot with the mistake, in a folder of its own.
fn plant(mistake: &Mistake, below: &str) -> PathBuf {
    let name: String = mistake.name.split(' ').next().unwrap().to_owned();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("beginner")
        .join(below)
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    let robot = mistake.edits[0]
        .0
        .components()
        .next()
        .unwrap()
        .as_os_str()
        .to_owned();
    copy(&home().join("robots").join(&robot), &folder.join(&robot));
    // the workspace ends here: the packages of the other mistakes have the same names
    fs::create_dir_all(folder.join(".git")).unwrap();
    for (file, edit) in &mistake.edits {
        make(mistake, &folder, file, edit);
    }
    write_meshes(&folder);
    folder.join(robot)
}

fn make(mistake: &Mistake, folder: &Path, file: &Path, edit: &Edit) {
    let path = folder.join(file);
    match edit {
        Edit::Delete => fs::remove_file(path).unwrap(),
        Edit::Move(target) => {
            fs::create_dir_all(folder.join(target).parent().unwrap()).unwrap();
            fs::rename(path, folder.join(target)).unwrap();
        }
        Edit::ReplaceAll(old, new) => {
            let text = fs::read_to_string(&path).unwrap();
            assert!(text.contains(old), "{}: no `{old}`", mistake.name);
            fs::write(path, text.replace(old, new)).unwrap();
        }
        Edit::Replace(pairs) => {
            let mut text = fs::read_to_string(&path).unwrap();
            for (old, new) in pairs {
                assert_eq!(text.matches(old).count(), 1, "{}: `{old}`", mistake.name);
                text = text.replace(old, new);
            }
            fs::write(path, text).unwrap();
        }
    }
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from)
        .unwrap()
        .map(|entry| entry.unwrap().path())
    {
        let target = to.join(entry.file_name().unwrap());
        if entry.is_dir() {
            copy(&entry, &target);
        } else {
            fs::copy(&entry, target).unwrap();
        }
    }
}

/// The meshes that the lists `meshes.txt` describe: a file and its recipe in each line.
fn write_meshes(folder: &Path) {
    for entry in fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
    {
        if entry.is_dir() {
            write_meshes(&entry);
        } else if entry.ends_with("meshes.txt") {
            for line in fs::read_to_string(&entry).unwrap().lines() {
                let (name, recipe) = line.split_once(": ").unwrap();
                let path = folder.join(name);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, meshes::binary_stl(recipe)).unwrap();
            }
            fs::remove_file(entry).unwrap();
        }
    }
}

fn session(folder: &Path) -> (Session, CheckOptions) {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let setup = Setup {
        about: folder.to_owned(),
        overrides: Overrides::default(),
        ..Setup::default()
    };
    let session = Session::new(&env, setup).unwrap();
    (
        session,
        CheckOptions {
            paths: vec![folder.to_owned()],
            ..CheckOptions::default()
        },
    )
}

fn check(folder: &Path) -> Report {
    let (session, options) = session(folder);
    analysis::grouped(analysis::check(&session, &options))
}

/// `error RULE FILE:LINE` for each finding of a severity, in order.
fn found(report: &Report, folder: &Path, least: Severity) -> Vec<String> {
    let wanted = report
        .findings
        .iter()
        .filter(|finding| finding.severity >= least);
    let found = wanted.map(|finding| {
        let path = report.path(finding.span.file);
        let path = path
            .strip_prefix(folder)
            .unwrap_or(path)
            .display()
            .to_string();
        let line = report.position(finding.span).start.0;
        format!("{} {} {path}:{line}", finding.severity, finding.rule.name)
    });
    found.collect()
}

#[test]
fn the_robots_are_silent() {
    for robot in ["arm", "planar", "cell"] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("beginner/clean")
            .join(robot);
        let _ = fs::remove_dir_all(&folder);
        copy(&home().join("robots").join(robot), &folder);
        write_meshes(&folder);
        assert_eq!(
            found(&check(&folder), &folder, Severity::Warning),
            Vec::<String>::new(),
            "{robot}"
        );
    }
}

/// Of a hundred mistakes, so many are reported at least, and so many by one error or warning.
const REPORTED: usize = 91;
const BY_ONE: usize = 85;

#[test]
fn each_mistake_is_found_as_written() {
    let (mut wrong, mut reported, mut by_one) = (Vec::new(), 0, 0);
    let mistakes = mistakes();
    for mistake in &mistakes {
        let folder = plant(mistake, "found");
        let report = check(&folder);
        let loud = found(&report, &folder, Severity::Warning);
        let all: BTreeSet<String> = found(&report, &folder, Severity::Hint)
            .into_iter()
            .collect();
        let is_loud = |line: &&String| line.starts_with("error") || line.starts_with("warning");
        let expected: Vec<&String> = mistake.found.iter().filter(is_loud).collect();
        if loud.iter().collect::<Vec<_>>() != expected {
            wrong.push(format!("{}: found {loud:#?}", mistake.name));
        }
        let missing = mistake.found.iter().filter(|line| !all.contains(*line));
        wrong.extend(missing.map(|line| format!("{}: no `{line}`", mistake.name)));
        wrong.extend(
            report
                .findings
                .iter()
                .filter(|finding| finding.help.is_none())
                .map(|finding| format!("{}: no help for `{}`", mistake.name, finding.message)),
        );
        reported += usize::from(!mistake.found.is_empty());
        by_one += usize::from(loud.len() == 1);
    }
    println!(
        "{} mistakes, {reported} reported, {by_one} by one error or warning",
        mistakes.len()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        reported * 100 >= mistakes.len() * REPORTED,
        "{reported} reported"
    );
    assert!(
        by_one * 100 >= mistakes.len() * BY_ONE,
        "{by_one} reported by one error or warning"
    );
}

/// The errors of a report, by rule and message.
fn errors(report: &Report) -> BTreeSet<String> {
    let errors = report
        .findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error);
    errors
        .map(|finding| format!("{}: {}", finding.rule.name, finding.message))
        .collect()
}

#[test]
fn fixes_write_what_is_said_and_bring_no_error() {
    let mut wrong = Vec::new();
    for mistake in mistakes() {
        for most in [Safety::Safe, Safety::Unsafe] {
            let folder = plant(&mistake, "fixed");
            let (session, options) = session(&folder);
            let fixed = analysis::fix(
                &session,
                &options,
                FixOptions {
                    most,
                    shown: Severity::Info,
                },
            );
            let new: Vec<String> = errors(fixed.left())
                .difference(&errors(&fixed.found))
                .cloned()
                .collect();
            if !new.is_empty() && !mistake.reveals {
                wrong.push(format!(
                    "{}: {} fixes bring {new:?}",
                    mistake.name,
                    most.name()
                ));
            }
            let parses = |text: &str| xacro_lsp::xml::Document::parse(text).errors().len();
            for file in &fixed.files {
                if parses(&file.after) > parses(&file.before) {
                    wrong.push(format!(
                        "{}: {} does not parse",
                        mistake.name,
                        file.path.display()
                    ));
                }
            }
            if most == Safety::Unsafe {
                let is_there =
                    |text: &&String| fixed.files.iter().any(|file| file.after.contains(*text));
                let missing = mistake.typed.iter().filter(|text| !is_there(text));
                wrong.extend(
                    missing.map(|text| format!("{}: no fix writes `{text}`", mistake.name)),
                );
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
