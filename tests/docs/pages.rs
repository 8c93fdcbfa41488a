//! The pages, and the blocks of code on them.

use std::fs;
use std::path::{Path, PathBuf};

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A page: its path below the repository, and its text.
pub struct Page {
    pub path: String,
    pub text: String,
}

impl Page {
    pub fn read(path: &str) -> Page {
        let text =
            fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        Page {
            path: path.to_owned(),
            text,
        }
    }

    /// The page named by a path, as it is linked from this one.
    pub fn folder(&self) -> PathBuf {
        Path::new(&self.path).parent().unwrap().to_owned()
    }
}

/// Folders that builds and tests make.
const MADE: [&str; 4] = ["build", "dist", "node_modules", "target"];

fn markdown(folder: &Path, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            let is_made = path
                .file_name()
                .is_some_and(|name| MADE.iter().any(|made| name == *made));
            if !is_made {
                markdown(&path, found);
            }
        } else if path.extension().is_some_and(|ending| ending == "md") {
            let path = path.strip_prefix(root()).unwrap();
            found.push(path.to_str().unwrap().replace('\\', "/"));
        }
    }
}

/// Every page of the repository.
pub fn all() -> Vec<Page> {
    let mut paths = Vec::new();
    markdown(&root().join("docs"), &mut paths);
    markdown(&root().join("editors"), &mut paths);
    markdown(&root().join("tests"), &mut paths);
    for entry in fs::read_dir(root()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".md") {
            paths.push(name);
        }
    }
    paths.sort();
    paths.iter().map(|path| Page::read(path)).collect()
}

/// The pages whose blocks are run here; those of the rules are the tests of the rules (`tests/rules.rs`).
pub fn told() -> Vec<Page> {
    let mut pages = all();
    pages.retain(|page| !page.path.starts_with("docs/rules/"));
    pages
}

/// A fenced block of code.
#[derive(Clone)]
pub struct Block {
    /// `PAGE:LINE`.
    pub place: String,
    /// The heading of the section it stands in, and how many there were before.
    pub section: usize,
    /// The first word behind the fence.
    pub language: String,
    /// Why it is not run.
    pub not_run: Option<String>,
    /// What the line above it says: `in`, `file` or `run:`, and of what.
    pub remark: Option<(String, String)>,
    pub text: String,
}

impl Block {
    fn new(place: String, section: usize, info: &str, above: &str) -> Block {
        let (language, rest) = info.split_once(' ').unwrap_or((info, ""));
        assert!(
            rest.is_empty() || rest.starts_with("not-run: "),
            "{place}: `{rest}` behind the language"
        );
        let not_run = rest.strip_prefix("not-run: ").map(str::to_owned);
        let remark = above
            .strip_prefix("<!-- ")
            .and_then(|rest| rest.strip_suffix(" -->"));
        let remark = remark.and_then(|remark| remark.split_once(' '));
        let remark = remark.filter(|(word, _)| ["in", "run:"].contains(word));
        // a line that holds a name in backticks and a colon names the file
        let name = above
            .strip_prefix('`')
            .and_then(|rest| rest.strip_suffix("`:"));
        let remark = remark.or(name
            .filter(|name| !name.contains('`'))
            .map(|name| ("file", name)));
        let remark = remark.map(|(word, of)| (word.to_owned(), of.to_owned()));
        Block {
            place,
            section,
            language: language.to_owned(),
            not_run,
            remark,
            text: String::new(),
        }
    }

    pub fn remark(&self, word: &str) -> Option<&str> {
        self.remark
            .as_ref()
            .filter(|(first, _)| first == word)
            .map(|(_, of)| of.as_str())
    }
}

/// A line of a page with what it is part of.
pub enum Line<'a> {
    /// The first line of a block.
    Fence(Block),
    Inside(&'a str),
    /// The last line of a block.
    End,
    Prose,
}

/// The page line by line. A block of a list may be indented; it ends with as many backticks as it began with.
pub fn lines(page: &Page) -> Vec<(&str, Line<'_>)> {
    let mut found = Vec::new();
    let (mut fence, mut above, mut section) = (None, "", 0);
    for (number, line) in page.text.lines().enumerate() {
        let bare = line.trim_start();
        let ticks = &bare[..bare.len() - bare.trim_start_matches('`').len()];
        let kind = match fence {
            Some(open) if bare == open => {
                fence = None;
                Line::End
            }
            Some(_) => Line::Inside(line),
            None if ticks.len() >= 3 => {
                fence = Some(ticks);
                let place = format!("{}:{}", page.path, number + 1);
                Line::Fence(Block::new(
                    place,
                    section,
                    &bare[ticks.len()..],
                    above.trim(),
                ))
            }
            None => {
                section += usize::from(line.starts_with("## ") || line.starts_with("### "));
                Line::Prose
            }
        };
        if !bare.is_empty() {
            above = line;
        }
        found.push((line, kind));
    }
    assert!(
        fence.is_none(),
        "{}: a block of code does not end",
        page.path
    );
    found
}

pub fn blocks(page: &Page) -> Vec<Block> {
    let mut found: Vec<Block> = Vec::new();
    for (_, line) in lines(page) {
        match line {
            Line::Fence(block) => found.push(block),
            Line::Inside(text) => {
                let block = found.last_mut().unwrap();
                block.text.push_str(text);
                block.text.push('\n');
            }
            Line::End | Line::Prose => {}
        }
    }
    found
}

/// Compare a stored file with what it should hold, or write it.
pub fn up_to_date(path: &str, new: &str) {
    let whole = root().join(path);
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&whole, new).unwrap();
    }
    let stored = fs::read_to_string(&whole).unwrap_or_default();
    let line = stored
        .lines()
        .zip(new.lines())
        .position(|(a, b)| a != b)
        .unwrap_or(0);
    let (old, made) = (
        stored.lines().nth(line).unwrap_or(""),
        new.lines().nth(line).unwrap_or(""),
    );
    let place = format!("{path}:{}", line + 1);
    assert!(
        stored == new,
        "{place}: `{old}` is old for `{made}`: run `UPDATE=1 cargo test --test docs`"
    );
}
