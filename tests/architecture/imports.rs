//! Which files of a crate use each other in a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::{REPOSITORY, rust_files};

/// Modules by their path without the crate, such as `xml::walk`; that of the crate itself is empty.
struct Modules {
    files: BTreeMap<String, String>,
    /// What a module hands on: the path of the name, and the path that it stands for.
    handed_on: BTreeMap<String, String>,
}

/// A path that a module names, and whether the module hands it on.
struct Import {
    path: String,
    is_public: bool,
}

/// Groups of files that use each other in a circle.
pub fn circles(crate_name: &str) -> Vec<BTreeSet<String>> {
    let folder = Path::new(REPOSITORY).join("src").join(crate_name);
    let mut paths = Vec::new();
    rust_files(&folder, &mut paths);
    let files = paths
        .into_iter()
        .filter(|path| !is_test(path))
        .map(|path| (module(&folder, &path), text(&path)))
        .collect();
    let mut modules = Modules {
        files,
        handed_on: BTreeMap::new(),
    };
    modules.note_what_is_handed_on();
    groups(&modules.uses())
}

fn is_test(path: &Path) -> bool {
    let name = path.file_stem().unwrap().to_string_lossy();
    name == "tests" || name.ends_with("_tests") || path.iter().any(|part| part == "tests")
}

fn module(folder: &Path, path: &Path) -> String {
    let inner = path.strip_prefix(folder).unwrap().with_extension("");
    let parts = inner.iter().map(|part| part.to_string_lossy());
    let parts: Vec<_> = parts
        .filter(|part| !matches!(&**part, "mod" | "lib"))
        .collect();
    parts.join("::")
}

/// The text of a file without comments and unit tests.
fn text(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap();
    let lines = code
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

impl Modules {
    fn note_what_is_handed_on(&mut self) {
        for (module, text) in &self.files {
            for import in imports(self, module, text) {
                if import.is_public {
                    let name = import.path.rsplit("::").next().unwrap();
                    self.handed_on
                        .insert(joined(module, name), import.path.clone());
                }
            }
        }
    }

    /// The modules that each one uses.
    fn uses(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let mut found = BTreeMap::new();
        for (module, text) in &self.files {
            let used = imports(self, module, text)
                .into_iter()
                .filter(|import| !import.is_public)
                .filter_map(|import| self.owner(&import.path, 0))
                .filter(|owner| owner != module)
                .collect::<BTreeSet<_>>();
            found.insert(module.as_str(), used);
        }
        found
    }

    /// The module that has what a path names.
    fn owner(&self, path: &str, depth: usize) -> Option<&str> {
        if let Some(meant) = self.handed_on.get(path).filter(|_| depth < 5) {
            return self.owner(meant, depth + 1);
        }
        let mut path = path;
        loop {
            if let Some((module, _)) = self.files.get_key_value(path) {
                return Some(module);
            }
            path = path.rsplit_once("::").map_or("", |(outer, _)| outer);
        }
    }

    /// A path without the crate, as seen from a module; `None` for what belongs to other crates.
    fn absolute(&self, module: &str, path: &str) -> Option<String> {
        let mut outer: Vec<&str> = module.split("::").filter(|part| !part.is_empty()).collect();
        let mut parts = path.split("::").peekable();
        match *parts.peek()? {
            "crate" => {
                parts.next();
                outer.clear();
            }
            "self" => {
                parts.next();
            }
            "super" => {
                while parts.next_if_eq(&"super").is_some() {
                    outer.pop();
                }
            }
            first if self.files.contains_key(&joined(module, first)) => {}
            _ => return None,
        }
        outer.extend(parts);
        Some(outer.join("::"))
    }
}

fn joined(module: &str, name: &str) -> String {
    if module.is_empty() {
        name.to_owned()
    } else {
        format!("{module}::{name}")
    }
}

/// The paths inside of the crate that a module names in `use` and elsewhere.
fn imports(modules: &Modules, module: &str, text: &str) -> Vec<Import> {
    let mut found = Vec::new();
    let mut rest = String::new();
    let mut statement: Option<String> = None;
    for line in text.lines() {
        let start = line.trim_start();
        let is_use = ["use ", "pub use ", "pub(super) use ", "pub(crate) use "]
            .iter()
            .any(|word| start.starts_with(word));
        if statement.is_none() && is_use {
            statement = Some(String::new());
        }
        let Some(open) = &mut statement else {
            rest.push_str(line);
            rest.push('\n');
            continue;
        };
        open.push_str(line);
        if line.contains(';') {
            let statement = statement.take().unwrap_or_default();
            let (head, tree) = statement.trim().split_once("use ").unwrap();
            let mut paths = Vec::new();
            flatten("", tree.trim_end_matches(';'), &mut paths);
            let paths = paths
                .iter()
                .filter_map(|path| modules.absolute(module, path));
            found.extend(paths.map(|path| Import {
                path,
                is_public: !head.is_empty(),
            }));
        }
    }
    let words = rest.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    let paths = words
        .map(|word| word.trim_matches(':'))
        .filter(|word| word.contains("::"))
        .filter_map(|path| modules.absolute(module, path));
    found.extend(paths.map(|path| Import {
        path,
        is_public: false,
    }));
    found
}

/// The paths of a tree such as `a::{b, c::{d}}`.
fn flatten(outer: &str, tree: &str, found: &mut Vec<String>) {
    let tree = tree.trim();
    let Some((head, inner)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap().trim();
        found.push(
            format!("{outer}{path}")
                .trim_end_matches("::self")
                .to_owned(),
        );
        return;
    };
    let outer = format!("{outer}{head}");
    let inner = inner.trim().strip_suffix('}').unwrap_or(inner);
    let (mut depth, mut start) = (0, 0);
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                flatten(&outer, &inner[start..at], found);
                start = at + 1;
            }
            _ => {}
        }
    }
    if !inner[start..].trim().is_empty() {
        flatten(&outer, &inner[start..], found);
    }
}

/// The groups of modules of which each leads to each other one.
fn groups(uses: &BTreeMap<&str, BTreeSet<&str>>) -> Vec<BTreeSet<String>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> = uses
        .keys()
        .map(|&module| (module, reached(uses, module)))
        .collect();
    let mut found: Vec<BTreeSet<String>> = Vec::new();
    for (module, others) in &reached {
        if !others.contains(module) || found.iter().any(|group| group.contains(*module)) {
            continue;
        }
        let back = others
            .iter()
            .filter(|other| reached[*other].contains(module));
        found.push(back.map(|&other| other.to_owned()).collect());
    }
    found
}

/// The modules that a module leads to.
fn reached<'a>(uses: &BTreeMap<&'a str, BTreeSet<&'a str>>, from: &str) -> BTreeSet<&'a str> {
    let mut found = BTreeSet::new();
    let mut open = vec![from];
    while let Some(module) = open.pop() {
        for &used in &uses[module] {
            if found.insert(used) {
                open.push(used);
            }
        }
    }
    found
}
