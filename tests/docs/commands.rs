//! Command lines, run by a shell with the program that was built, on a copy of the examples.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::pages::{self, Block, Line, Page, root};

/// What readers see for the folder of the copy.
const HOME: &str = "/home/you";
/// How the README starts the program, before it is installed.
const FROM_SOURCE: &str = "cargo run --release -- ";

/// A folder like a checkout: the examples are where they are in the repository.
struct Copy {
    home: PathBuf,
    /// Where commands are run that no comment sends elsewhere.
    start: PathBuf,
}

fn copy_into(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let (path, name) = entry
            .map(|entry| (entry.path(), entry.file_name()))
            .unwrap();
        if path.is_dir() {
            copy_into(&path, &to.join(name));
        } else {
            fs::copy(&path, to.join(name)).unwrap();
        }
    }
}

impl Copy {
    fn new(page: &Page, test: &str) -> Copy {
        let home = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("docs")
            .join(test)
            .join(page.path.replace('/', "-"));
        let _ = fs::remove_dir_all(&home);
        let checkout = home.join("xacro-lsp");
        copy_into(
            &root().join("docs/examples"),
            &checkout.join("docs/examples"),
        );
        fs::create_dir_all(checkout.join(".git")).unwrap();
        // pages of the repository speak of its top folder, those of the book of the examples
        let inside = page.path.starts_with("docs/") && !page.path.starts_with("docs/examples/");
        let start = if inside {
            checkout.join("docs/examples")
        } else {
            checkout
        };
        Copy {
            home: home.canonicalize().unwrap(),
            start: start.canonicalize().unwrap(),
        }
    }

    /// The folder of a section with files of its own.
    fn section(&self, number: usize) -> PathBuf {
        self.home.join(format!("{number}/robot_ws"))
    }

    /// The folder for a block: one of the examples, that of the files of its section, or where the page starts.
    fn folder(&self, block: &Block) -> PathBuf {
        let section = self.section(block.section);
        match block.remark("in") {
            Some(name) => self.start.join(name),
            None if section.is_dir() => section,
            None => self.start.clone(),
        }
    }

    /// What a line of a shell prints, and its exit code.
    fn run(&self, line: &str, folder: &Path) -> (String, i32) {
        let programs = Path::new(env!("CARGO_BIN_EXE_xacro-lint"))
            .parent()
            .unwrap();
        let mut path = programs.as_os_str().to_owned();
        path.push(":");
        path.push(std::env::var_os("PATH").unwrap_or_default());
        let line = line.replace(FROM_SOURCE, "xacro-lint ");
        let mut shell = Command::new("sh");
        shell
            .args(["-c", &format!("exec 2>&1\n{line}")])
            .current_dir(folder);
        shell
            .env_clear()
            .env("PATH", path)
            .env("HOME", &self.home)
            .env("LC_ALL", "C.UTF-8");
        // no ROS of this machine
        shell.env("AMENT_PREFIX_PATH", self.home.join("ros"));
        let done = shell.output().unwrap();
        let code = done.status.code().unwrap_or(-1);
        (
            self.for_readers(&String::from_utf8(done.stdout).unwrap()),
            code,
        )
    }

    fn for_readers(&self, text: &str) -> String {
        let home = self.home.display().to_string();
        let mut text = text.replace(&format!("{home}/ros"), "/opt/ros/jazzy");
        for number in 0..100 {
            text = text.replace(
                &format!("{home}/{number}/robot_ws"),
                &format!("{HOME}/robot_ws"),
            );
        }
        text.replace(&home, HOME)
    }

    /// Write the files that the sections of a page show.
    fn write_files(&self, blocks: &[Block]) {
        for block in blocks {
            let Some(name) = block.remark("file") else {
                continue;
            };
            let path = self.section(block.section).join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, &block.text).unwrap();
        }
    }
}

/// Whether an answer is what a page shows, where a line `...` stands for any lines.
fn matches(shown: &[&str], got: &[&str]) -> bool {
    match shown.split_first() {
        None => got.is_empty(),
        Some((&"...", rest)) => (0..=got.len()).any(|skipped| matches(rest, &got[skipped..])),
        Some((first, rest)) => {
            got.first()
                .is_some_and(|line| same_everywhere(line) == same_everywhere(first))
                && matches(rest, &got[1..])
        }
    }
}

/// A line without the number of places that packages were looked for in: one more for each ROS of this machine.
fn same_everywhere(line: &str) -> String {
    match line.split_once(" (looked in ") {
        Some((before, after)) => {
            format!(
                "{before}{}",
                after.trim_start_matches(|c: char| c.is_ascii_digit())
            )
        }
        None => line.to_owned(),
    }
}

/// The page with all answers made again.
fn rerun(page: &Page) -> String {
    let blocks = pages::blocks(page);
    let copy = Copy::new(page, "transcripts");
    copy.write_files(&blocks);
    let mut blocks = blocks.into_iter();
    let mut new = String::new();
    let mut console = false;
    for (line, kind) in pages::lines(page) {
        match kind {
            Line::Fence(_) => {
                let block = blocks.next().unwrap();
                console = block.language == "console" && block.not_run.is_none();
                new.push_str(&format!("{line}\n"));
                if console {
                    new.push_str(&transcript(&copy, &block));
                }
            }
            Line::Inside(_) if console => {}
            _ => new.push_str(&format!("{line}\n")),
        }
    }
    new
}

fn transcript(copy: &Copy, block: &Block) -> String {
    let folder = copy.folder(block);
    let mut commands: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in block.text.lines() {
        match line.strip_prefix("$ ") {
            Some(command) => commands.push((command, Vec::new())),
            None => commands
                .last_mut()
                .unwrap_or_else(|| panic!("{}: no command", block.place))
                .1
                .push(line),
        }
    }
    let mut new = String::new();
    for (command, shown) in commands {
        let (mut text, code) = copy.run(command, &folder);
        assert!(code != 127, "{}: {text}", block.place);
        if !text.is_empty() && !text.ends_with('\n') {
            text.push('\n');
        }
        if code != 0 {
            text.push_str(&format!("[exit {code}]\n"));
        }
        let got: Vec<&str> = text.lines().collect();
        let kept = if matches(&shown, &got) { shown } else { got };
        new.push_str(&format!("$ {command}\n"));
        kept.iter()
            .for_each(|line| new.push_str(&format!("{line}\n")));
    }
    new
}

#[test]
fn transcripts_are_what_the_program_prints() {
    let mut pages = pages::told();
    pages.retain(|page| {
        pages::blocks(page)
            .iter()
            .any(|block| block.language == "console")
    });
    assert!(pages.len() > 5);
    for page in pages {
        pages::up_to_date(&page.path, &rerun(&page));
    }
}

/// Lines of a block of commands: comments left out, continued lines in one.
fn command_lines(text: &str) -> Vec<String> {
    let joined = text.replace("\\\n", " ");
    let lines = joined
        .lines()
        .map(|line| line.split(" # ").next().unwrap_or(line).trim().to_owned());
    lines
        .filter(|line| !line.is_empty() && !line.starts_with('#'))
        .collect()
}

#[test]
fn commands_work() {
    let mut wrong = Vec::new();
    for page in pages::told() {
        let mut blocks = pages::blocks(&page);
        blocks.retain(|block| block.not_run.is_none());
        if !blocks.iter().any(|block| block.language == "sh") {
            continue;
        }
        let copy = Copy::new(&page, "commands");
        copy.write_files(&blocks);
        for block in blocks.iter().filter(|block| block.language == "sh") {
            let folder = copy.folder(block);
            for line in command_lines(&block.text) {
                let (text, code) = copy.run(&line, &folder);
                // 1: there are findings
                if code != 0
                    && !(code == 1 && line.contains("xacro-lint") || line.contains(FROM_SOURCE))
                {
                    wrong.push(format!(
                        "{}: `{line}` ends with {code}\n{text}",
                        block.place
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Words in running text that look like a call of the program, by page.
fn inline_calls() -> BTreeMap<String, Vec<String>> {
    let mut calls: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for page in pages::all() {
        for (line, kind) in pages::lines(&page) {
            if !matches!(kind, Line::Prose) {
                continue;
            }
            let spans = line.split('`').skip(1).step_by(2);
            let spans = spans.filter(|span| {
                span.starts_with("xacro-lint ") && !span.starts_with("xacro-lint -")
            });
            calls
                .entry(page.path.clone())
                .or_default()
                .extend(spans.map(str::to_owned));
        }
    }
    calls
}

/// `xacro-lint COMMAND --option` in running text names what there is.
#[test]
fn commands_in_running_text_exist() {
    let reference = xacro_lsp::cli::reference();
    let mut wrong = Vec::new();
    for (page, calls) in inline_calls() {
        for call in calls {
            let mut words = call.split_whitespace().skip(1);
            let command = words.next().unwrap_or("");
            if !reference.contains(&format!("### `{command}`\n")) {
                wrong.push(format!("{page}: `{call}`: unknown command `{command}`"));
            }
            // `expand` has the options of xacro, which no table lists
            for option in words.filter(|word| word.starts_with("--") && command != "expand") {
                let option = option.split('=').next().unwrap_or("");
                if !reference.contains(&format!("`{option}")) {
                    wrong.push(format!("{page}: `{call}`: there is no option `{option}`"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
