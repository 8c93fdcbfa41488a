//! The house rules that a machine can check: who may import whom, and who may touch the disk.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::disallowed_methods)] // a test may fail loudly

use std::fs;
use std::path::{Path, PathBuf};

/// Modules in import order: each may use only those in front of it. Those on one level may not use each other.
const LEVELS: &[&[&str]] = &[
    &["base"],
    &["xml", "expr", "yaml"],
    &["vfs"],
    &["workspace"],
    &["facts"],
    &["expand"],
    &["model"],
    &["rules"],
    &["ide"],
    &["analysis"],
    &["preview"],
    &["picture"],
    &["server", "cli"],
];

fn level(module: &str) -> Option<usize> {
    LEVELS.iter().position(|names| names.contains(&module))
}

fn rust_files(dir: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(dir).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Every source file of the library with its top-level module and its text without `//` comments.
fn sources() -> Vec<(PathBuf, String, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    files.sort();
    files
        .into_iter()
        .map(|path| {
            let inside = path.strip_prefix(&src).unwrap().to_path_buf();
            let module = inside.iter().next().unwrap().to_string_lossy().trim_end_matches(".rs").to_owned();
            let text = fs::read_to_string(&path).unwrap();
            let code: Vec<&str> = text.lines().map(|l| l.split("//").next().unwrap_or("")).collect();
            (inside, module, code.join("\n"))
        })
        .collect()
}

/// Top-level modules named in `crate::...` paths, those in braces included.
fn crate_paths(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (i, _) in code.match_indices("crate::") {
        let rest = &code[i + "crate::".len()..];
        let names: Vec<&str> = match rest.strip_prefix('{') {
            Some(list) => list.split('}').next().unwrap_or("").split(',').collect(),
            None => vec![rest],
        };
        for name in names {
            let word = name.trim().split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
            found.push(word.to_owned());
        }
    }
    found
}

#[test]
fn imports_go_upward_only() {
    let mut wrong = Vec::new();
    for (path, module, code) in sources() {
        let Some(own) = level(&module) else { continue };
        for used in crate_paths(&code) {
            let Some(other) = level(&used) else { continue };
            if used != module && other >= own {
                wrong.push(format!("{}: `{module}` may not use `{used}`", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "imports against the order of docs/architecture.md:\n{}", wrong.join("\n"));
}

#[test]
fn every_module_has_a_level() {
    for (path, module, _) in sources() {
        let known = level(&module).is_some() || ["lib", "bin"].contains(&module.as_str());
        assert!(known, "{} belongs to no level of the import order", path.display());
    }
}

#[test]
fn only_vfs_touches_the_disk_and_only_the_server_speaks_the_protocol() {
    let rules: [(&str, &[&str]); 6] = [
        ("std::fs", &["vfs"]),
        ("std::process::Command", &[]),
        ("std::env::var", &["vfs"]),
        ("tower_lsp", &["server"]),
        ("lsp_types", &["server"]),
        ("std::net", &["preview", "server"]),
    ];
    let mut wrong = Vec::new();
    for (path, module, code) in sources() {
        let parts: Vec<String> = path.iter().map(|part| part.to_string_lossy().into_owned()).collect();
        let is_test = parts
            .iter()
            .any(|part| part == "testing.rs" || part.ends_with("tests.rs") || part.ends_with("tests"));
        let product = code.split("#[cfg(test)]").next().unwrap_or("");
        for (name, allowed) in rules {
            if product.contains(name) && !allowed.contains(&module.as_str()) && !is_test {
                wrong.push(format!("{}: `{name}` is not for `{module}`", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
