//! The style guide, as far as a program can check it: every message that the pages of the rules and the examples produce,
//! the text in the source, the pages and the editor plugins. `docs/contributing/style.md` gives the reasons.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::string_slice,
    clippy::disallowed_methods
)] // a test may fail loudly

#[path = "words/help.rs"]
mod help;
#[path = "words/lists.rs"]
mod lists;
mod meshes;
#[path = "words/printed.rs"]
mod printed;
#[path = "words/retired.rs"]
mod retired;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::{self, CheckOptions, Overrides, Session, Setup};
use xacro_lsp::rules::{self, Finding};
use xacro_lsp::vfs::Environment;

use lists::{prose, wrong_words};

/// Characters of a headline, without the names in backticks.
const HEADLINE: usize = 100;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Whether a text begins with a capital letter that is not part of an abbreviation or a name.
fn is_capitalized(text: &str) -> bool {
    const NAMES: &[&str] = &[
        "RViz",
        "Gazebo",
        "Drake",
        "Pinocchio",
        "Isaac",
        "SDFormat",
        "Python",
        "Linux",
        "ROS-Industrial",
    ];
    let word = text
        .split(|c: char| !c.is_alphanumeric() && c != '-')
        .next()
        .unwrap_or_default();
    let is_name = NAMES.contains(&word) || word.chars().skip(1).any(char::is_uppercase);
    word.chars().next().is_some_and(char::is_uppercase) && !is_name
}

/// What is wrong with a headline or a help.
fn wrong_line(text: &str) -> Vec<String> {
    let mut wrong = wrong_words(text);
    if is_capitalized(text) {
        wrong.push("begins with a capital letter".to_owned());
    }
    if text.ends_with('.') && !text.ends_with("...") {
        wrong.push("ends with a period".to_owned());
    }
    wrong
}

/// What is wrong with a finding.
fn wrong(finding: &Finding) -> Vec<String> {
    let mut wrong = wrong_line(&finding.message);
    if prose(&finding.message).chars().count() > HEADLINE {
        wrong.push(format!("has more than {HEADLINE} characters"));
    }
    if finding.message.contains("`?") || finding.message.contains("``") {
        wrong.push("shows a placeholder or an empty name".to_owned());
    }
    match &finding.help {
        Some(help) => wrong.extend(
            wrong_line(help)
                .into_iter()
                .map(|what| format!("help `{help}`: {what}")),
        ),
        None => wrong.push("has no help".to_owned()),
    }
    for related in &finding.related {
        let what = wrong_line(&related.message).into_iter();
        wrong.extend(what.map(|what| format!("note `{}`: {what}", related.message)));
    }
    if let Some(fix) = &finding.fix {
        wrong.extend(
            wrong_line(&fix.message)
                .into_iter()
                .map(|what| format!("fix `{}`: {what}", fix.message)),
        );
    }
    wrong
}

/// The examples of a rule's page, each a list of files with their content.
fn examples(page: &str) -> Vec<Vec<(String, Vec<u8>)>> {
    let mut found = Vec::new();
    for block in page.split("\n```").skip(1).step_by(2) {
        let (info, body) = block.split_once('\n').unwrap_or_default();
        let Some((kind, verdict)) = info.split_once(',') else {
            continue;
        };
        let mut files = vec![(format!("robot.{kind}"), String::new())];
        for line in body.lines() {
            let is_marker = line.contains('^') && line.chars().all(|c| c == ' ' || c == '^');
            match line.strip_prefix("//- ") {
                Some(name) => {
                    files.retain(|(_, text)| !text.is_empty());
                    files.push((name.to_owned(), String::new()));
                }
                None if is_marker => {}
                None => files.last_mut().unwrap().1.push_str(&format!("{line}\n")),
            }
        }
        let latin_1 = verdict.contains("latin-1");
        let content = |(name, text): (String, String)| match name.split_once(": ") {
            Some((name, mesh)) => (name.to_owned(), meshes::binary_stl(mesh)),
            None if latin_1 => (name, text.chars().map(|c| c as u8).collect()),
            None => (name, text.into_bytes()),
        };
        found.push(files.into_iter().map(content).collect());
    }
    found
}

/// The programs of `tests/conformance/cases`, each with its place and its files: they reach what the expander reports.
fn cases() -> Vec<(String, Vec<(String, String)>)> {
    let mut paths = Vec::new();
    files(
        &root().join("tests/conformance/cases"),
        ".cases",
        &mut paths,
    );
    let mut found = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        for case in text.split("\n== ").skip(1) {
            let (name, sections) = case.split_once('\n').unwrap();
            let of_file = |section: &str| {
                let (head, body) = section.strip_prefix("file ")?.split_once('\n')?;
                Some((head.split(' ').next()?.to_owned(), format!("{body}\n")))
            };
            let files = format!("\n{sections}")
                .split("\n-- ")
                .filter_map(of_file)
                .collect();
            found.push((format!("{}: {name}", path.display()), files));
        }
    }
    found
}

/// All findings in a file or folder, of every rule.
fn findings(folder: &Path, paths: Vec<PathBuf>) -> Vec<Finding> {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let extend_select = Some(vec!["ALL".to_owned()]);
    let overrides = Overrides {
        extend_select,
        ..Overrides::default()
    };
    let setup = Setup {
        about: folder.to_owned(),
        overrides,
        ..Setup::default()
    };
    let session = Session::new(&env, setup).unwrap();
    analysis::check(
        &session,
        &CheckOptions {
            paths,
            ..CheckOptions::default()
        },
    )
    .findings
}

#[test]
fn messages_follow_the_style_guide() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("words");
    let _ = fs::remove_dir_all(&folder);
    let mut complaints = BTreeSet::new();
    let mut count = 0;
    let mut judged = BTreeSet::new();
    let mut judge = |place: &str, found: Vec<Finding>| {
        for finding in found {
            count += 1;
            judged.insert(finding.rule.name);
            for what in wrong(&finding) {
                complaints.insert(format!(
                    "{place}: {}: `{}` {what}",
                    finding.rule.name, finding.message
                ));
            }
        }
    };
    for rule in rules::all() {
        for (number, files) in examples(rule.docs).into_iter().enumerate() {
            let folder = folder.join(rule.name).join(number.to_string());
            // a repository of its own: nothing is read of folders above
            fs::create_dir_all(folder.join(".git")).unwrap();
            for (name, content) in &files {
                let path = folder.join(name);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, content).unwrap();
            }
            // launch files are checked with the folder that they are in
            let is_launched = folder.join("launch").is_dir() && rule.code.starts_with("PKG");
            let path = if is_launched {
                folder.clone()
            } else {
                folder.join(&files[0].0)
            };
            judge(rule.name, findings(&folder, vec![path]));
        }
    }
    for (number, (place, files)) in cases().into_iter().enumerate() {
        let folder = folder.join("cases").join(number.to_string());
        fs::create_dir_all(folder.join(".git")).unwrap();
        for (name, content) in &files {
            let path = folder.join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, content).unwrap();
        }
        judge(&place, findings(&folder, vec![folder.join("input.xacro")]));
    }
    for examples in [
        "docs/examples",
        "tests/cli/beginner",
        "tests/cli/five",
        "tests/cli/guard",
        "tests/cli/walk",
    ] {
        judge(
            examples,
            findings(&root().join(examples), vec![root().join(examples)]),
        );
    }
    let silent: Vec<&str> = rules::all()
        .map(|rule| rule.name)
        .filter(|name| !judged.contains(name))
        .collect();
    assert!(silent.is_empty(), "no message of {silent:?}");
    assert!(count > 500, "only {count} messages");
    let complaints: Vec<String> = complaints.into_iter().collect();
    assert!(
        complaints.is_empty(),
        "{} complaints:\n{}",
        complaints.len(),
        complaints.join("\n")
    );
}

/// The string literals of a source file that read like sentences, with their lines; tests at its end are left out.
fn literals(source: &str) -> Vec<(usize, String)> {
    let source = source
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let mut found = Vec::new();
    for (number, line) in source.lines().enumerate() {
        let code = line.trim_start();
        if code.starts_with("//") {
            continue;
        }
        // parts between quotes that are not escaped
        let line = line.replace("\\\"", "\u{1}").replace("'\"'", "'\u{1}'");
        for text in line.split('"').skip(1).step_by(2) {
            let words = text
                .split(' ')
                .filter(|word| word.chars().all(char::is_alphabetic) && !word.is_empty());
            if words.count() > 2 {
                found.push((number + 1, text.replace('\u{1}', "\"")));
            }
        }
    }
    found
}

fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
    {
        let name = entry.file_name().unwrap().to_string_lossy().into_owned();
        if entry.is_dir() && !["node_modules", "testdata", "dist", "out"].contains(&name.as_str()) {
            files(&entry, ending, found);
        } else if name.ends_with(ending) && !name.contains("test") {
            found.push(entry);
        }
    }
}

fn complain(what: &str, complaints: &[String]) {
    assert!(
        complaints.is_empty(),
        "{what}: {} complaints:\n{}",
        complaints.len(),
        complaints.join("\n")
    );
}

#[test]
fn strings_in_the_source_follow_the_style_guide() {
    // these print the words of CPython, PyYAML and expat
    const THEIRS: &[&str] = &["src/expr/", "src/yaml/", "src/xml/error.rs"];
    let mut sources = Vec::new();
    files(&root().join("src"), ".rs", &mut sources);
    let mut complaints = Vec::new();
    for path in sources {
        let name = path
            .strip_prefix(root())
            .unwrap()
            .display()
            .to_string()
            .replace('\\', "/");
        if THEIRS.iter().any(|theirs| name.starts_with(theirs)) {
            continue;
        }
        for (line, text) in literals(&fs::read_to_string(&path).unwrap()) {
            complaints.extend(
                wrong_words(&text)
                    .into_iter()
                    .map(|what| format!("{name}:{line}: {what}")),
            );
        }
    }
    complain("strings", &complaints);
}

/// A page without its blocks of code and its comments.
fn text_of_page(page: &str) -> String {
    let mut kept = String::new();
    let mut inside = false;
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            inside = !inside;
        } else if !inside && !line.starts_with("<!--") {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

#[test]
fn pages_follow_the_style_guide() {
    // these pages are for contributors, or quote what is retired
    const LEFT_OUT: &[&str] = &[
        "docs/architecture.md",
        "docs/contributing/style.md",
        "docs/SUMMARY.md",
        "docs/precision.md",
    ];
    let mut pages: Vec<PathBuf> = [
        "README.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "SECURITY.md",
    ]
    .map(|name| root().join(name))
    .into();
    files(&root().join("editors"), ".md", &mut pages);
    files(&root().join("docs"), ".md", &mut pages);
    let mut complaints = Vec::new();
    for path in pages {
        let name = path
            .strip_prefix(root())
            .unwrap()
            .display()
            .to_string()
            .replace('\\', "/");
        if LEFT_OUT.contains(&name.as_str()) {
            continue;
        }
        let text = text_of_page(&fs::read_to_string(&path).unwrap());
        complaints.extend(
            wrong_words(&text)
                .into_iter()
                .map(|what| format!("{name}: {what}")),
        );
    }
    complain("pages", &complaints);
}

#[test]
fn editors_follow_the_style_guide() {
    let mut paths = vec![
        root().join("editors/vscode/package.json"),
        root().join("editors/nvim/doc/xacro.txt"),
    ];
    files(&root().join("editors/nvim/lua"), ".lua", &mut paths);
    files(&root().join("editors/vscode/src"), ".ts", &mut paths);
    files(&root().join("editors/viewer/src"), ".ts", &mut paths);
    let mut complaints = Vec::new();
    for path in paths {
        let name = path
            .strip_prefix(root())
            .unwrap()
            .display()
            .to_string()
            .replace('\\', "/");
        let source = fs::read_to_string(&path).unwrap();
        let texts = match path.extension().and_then(|ending| ending.to_str()) {
            Some("lua") => literals(&source.replace('\'', "\"")),
            Some("ts" | "json") => literals(&source),
            _ => vec![(1, source)],
        };
        for (line, text) in texts {
            complaints.extend(
                wrong_words(&text)
                    .into_iter()
                    .map(|what| format!("{name}:{line}: {what}")),
            );
        }
    }
    complain("editors", &complaints);
}
