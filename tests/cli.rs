//! The command line, as transcripts: `tests/cli/*.txt` hold commands with what they print.
//!
//! A transcript begins with the folder it is run in: `cd FOLDER`, or `copy FOLDER` when the commands change it.
//! `UPDATE=1` writes the answers anew.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cli")
}

/// Words of a command line; single quotes keep blanks.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (i, part) in line.split('\'').enumerate() {
        match i % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

/// What a command prints and its exit code, as it stands in a transcript.
fn answer(line: &str, cwd: &Path) -> String {
    let (line, input) = line.split_once(" < ").map_or((line, ""), |(line, input)| (line, input));
    let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), cwd.join("none").display().to_string())]);
    let env = Environment { vars, cwd: cwd.to_owned() };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let mut stdin = input.as_bytes();
    let mut io = Io::plain(&mut out, &mut err, &mut stdin);
    let code = cli::run(&words(line), &env, &mut io);
    let mut text = String::from_utf8(out).unwrap();
    for line in String::from_utf8(err).unwrap().lines() {
        text.push_str(&format!("[stderr] {line}\n"));
    }
    if code != 0 {
        text.push_str(&format!("[exit {code}]\n"));
    }
    text.replace(&cwd.display().to_string(), "[cwd]")
}

/// The transcript with all answers made anew.
fn rerun(transcript: &str) -> String {
    let (head, _) = transcript.split_once('\n').unwrap();
    let cwd = match head.split_once(' ').unwrap() {
        ("cd", name) => folder().join(name),
        (_, name) => copy(&folder().join(name)),
    };
    let mut new = format!("{head}\n");
    for line in transcript.lines().filter_map(|line| line.strip_prefix("$ ")) {
        let answer = match line.split_once(' ').unwrap() {
            ("cat", file) => fs::read_to_string(cwd.join(file)).unwrap(),
            ("xacro-lint", arguments) => answer(arguments, &cwd),
            (other, _) => panic!("no such command: {other}"),
        };
        new.push_str(&format!("\n$ {line}\n{answer}"));
    }
    new
}

/// A folder that commands may change.
fn copy(folder: &Path) -> PathBuf {
    let new = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(folder.file_name().unwrap());
    let _ = fs::remove_dir_all(&new);
    copy_into(folder, &new);
    new
}

fn copy_into(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name())).unwrap();
        if path.is_dir() {
            copy_into(&path, &to.join(name));
        } else {
            fs::copy(&path, to.join(name)).unwrap();
        }
    }
}

#[test]
fn transcripts() {
    let mut wrong = Vec::new();
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    paths.sort();
    assert!(!paths.is_empty());
    for path in paths {
        let stored = fs::read_to_string(&path).unwrap();
        let new = rerun(&stored);
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&path, &new).unwrap();
        } else if new != stored {
            let line = new.lines().zip(stored.lines()).position(|(a, b)| a != b).unwrap_or(0);
            let (got, want) = (new.lines().nth(line).unwrap_or(""), stored.lines().nth(line).unwrap_or(""));
            wrong.push(format!("{}:{}: got\n{got}\nwant\n{want}", path.display(), line + 1));
        }
    }
    assert!(wrong.is_empty(), "{}\n(UPDATE=1 writes the answers anew)", wrong.join("\n\n"));
}
