//! Words that the code does not use any more.

use std::fs;
use std::path::{Path, PathBuf};

/// A name that is retired: its parts, and what to write.
struct Retired {
    words: Vec<String>,
    instead: String,
}

fn list() -> Vec<Retired> {
    let text =
        fs::read_to_string(super::root().join("docs/contributing/retired-words.txt")).unwrap();
    let lines = text
        .lines()
        .filter(|line| !line.starts_with('#') && !line.is_empty());
    let pair = |line: &str| {
        let (words, instead) = line
            .split_once(" -> ")
            .unwrap_or_else(|| panic!("`{line}` has no ` -> `"));
        Retired {
            words: words.split(' ').map(str::to_owned).collect(),
            instead: instead.to_owned(),
        }
    };
    lines.map(pair).collect()
}

/// The source files of programs, editors and tests.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    const LEFT_OUT: [&str; 5] = ["node_modules", "target", "dist", "out", "fixtures"];
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let ending = path
            .extension()
            .map(|ending| ending.to_string_lossy().into_owned());
        if path.is_dir() && !LEFT_OUT.contains(&name.as_str()) && !name.starts_with('.') {
            sources(&path, found);
        } else if ending
            .is_some_and(|ending| ["rs", "ts", "lua", "py", "mjs"].contains(&ending.as_str()))
        {
            found.push(path);
        }
    }
}

/// The words of a line, in lower case: names are taken apart. What is in quotes or backticks is text of others.
fn words(line: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut quote = None;
    let mut was_lower = false;
    let mut is_open = false;
    for c in line.chars() {
        match quote {
            Some(open) if open == c => quote = None,
            Some(_) => {}
            None if c == '"' || c == '`' => quote = Some(c),
            None if c.is_alphabetic() => {
                let begins = !is_open || (c.is_uppercase() && was_lower);
                if begins {
                    found.push(String::new());
                }
                found.last_mut().unwrap().extend(c.to_lowercase());
                was_lower = c.is_lowercase();
                is_open = true;
                continue;
            }
            None => {}
        }
        is_open = false;
    }
    found
}

#[test]
fn retired_words_are_not_used() {
    let retired = list();
    let mut files = Vec::new();
    for folder in ["src", "editors", "tests"] {
        sources(&super::root().join(folder), &mut files);
    }
    assert!(files.len() > 500, "only {} source files found", files.len());
    let mut wrong = Vec::new();
    for path in files {
        let shown = path
            .strip_prefix(super::root())
            .unwrap()
            .to_string_lossy()
            .into_owned();
        let text = fs::read_to_string(&path).unwrap();
        let lines = text.lines().map(words).zip(1..);
        for (words, line) in std::iter::once((words(&shown), 0)).chain(lines) {
            for Retired {
                words: old,
                instead,
            } in &retired
            {
                if words.windows(old.len()).any(|window| window == old) {
                    wrong.push(format!(
                        "{shown}:{line}: `{}`; write `{instead}`",
                        old.join(" ")
                    ));
                }
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} retired words:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}
