//! The house rules that a machine can check: who may import whom, and who may touch the disk.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

#[path = "architecture/imports.rs"]
mod imports;
#[path = "architecture/rule_names.rs"]
mod rule_names;

const REPOSITORY: &str = env!("CARGO_MANIFEST_DIR");

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(REPOSITORY).join(path)).unwrap()
}

/// The crates below `src`, as `Cargo.toml` lists them.
fn crates() -> Vec<String> {
    let manifest = read("Cargo.toml");
    let members = manifest
        .split("members = [")
        .nth(1)
        .and_then(|rest| rest.split(']').next())
        .unwrap();
    let names = members
        .lines()
        .filter_map(|line| line.trim().strip_prefix("\"src/")?.strip_suffix("\","));
    names.map(str::to_owned).collect()
}

/// The crates of this repository that a crate uses.
fn used(name: &str) -> Vec<String> {
    let manifest = read(&format!("src/{name}/Cargo.toml"));
    let dependencies = manifest
        .split("[dependencies]")
        .nth(1)
        .unwrap_or("")
        .split("\n[")
        .next()
        .unwrap();
    let names = dependencies
        .lines()
        .filter_map(|line| line.split(['.', ' ']).next());
    let known = crates();
    names
        .filter(|name| known.iter().any(|crate_name| crate_name == name))
        .map(str::to_owned)
        .collect()
}

/// The rows of the table in `docs/architecture.md`: crates that do not use each other.
fn rows() -> Vec<Vec<String>> {
    let page = read("docs/architecture.md");
    let table = page
        .split("| crate | what it is |")
        .nth(1)
        .unwrap()
        .split("\n\n")
        .next()
        .unwrap()
        .to_owned();
    let cells = table
        .lines()
        .skip(2)
        .filter_map(|line| line.split('|').nth(1));
    cells
        .map(|cell| {
            cell.split('`')
                .skip(1)
                .step_by(2)
                .map(str::to_owned)
                .collect()
        })
        .collect()
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

/// Whether a file of `src` holds tests only.
fn is_test(path: &Path) -> bool {
    path.iter()
        .map(|part| part.to_string_lossy())
        .any(|part| part == "testing.rs" || part.ends_with("tests.rs") || part.ends_with("tests"))
}

/// Every source file with its crate and its text without `//` comments.
fn sources() -> Vec<(PathBuf, String, String)> {
    let src = Path::new(REPOSITORY).join("src");
    let mut files = Vec::new();
    rust_files(&src, &mut files);
    files.sort();
    files
        .into_iter()
        .map(|path| {
            let inside = path.strip_prefix(&src).unwrap().to_path_buf();
            let crate_name = inside.iter().next().unwrap().to_string_lossy().into_owned();
            let text = fs::read_to_string(&path).unwrap();
            let code: Vec<&str> = text
                .lines()
                .map(|l| l.split("//").next().unwrap_or(""))
                .collect();
            (inside, crate_name, code.join("\n"))
        })
        .collect()
}

#[test]
fn each_crate_uses_only_those_in_front_of_it() {
    let order = crates();
    assert!(order.len() > 10, "{order:?}");
    let place = |name: &String| order.iter().position(|known| known == name).unwrap();
    for name in &order {
        for other in used(name) {
            assert!(
                place(&other) < place(name),
                "`{name}` uses `{other}`, which Cargo.toml lists behind it"
            );
        }
    }
}

#[test]
fn the_page_shows_the_order_of_crates() {
    let rows = rows();
    assert_eq!(rows.concat(), crates(), "docs/architecture.md");
    for row in &rows {
        for name in row {
            assert!(
                used(name).iter().all(|other| !row.contains(other)),
                "`{name}` uses another one of its row"
            );
        }
    }
}

/// The crates of others that the programs use.
fn dependencies() -> BTreeSet<String> {
    let own = crates();
    let of_crate = |name: &String| {
        let manifest = read(&format!("src/{name}/Cargo.toml"));
        let tables = manifest
            .split("\n[")
            .filter_map(|table| table.split_once("dependencies]\n"));
        let lines: Vec<String> = tables
            .filter(|(kind, _)| *kind != "dev-")
            .flat_map(|(_, table)| table.lines())
            .filter_map(|line| line.split(['.', ' ']).next())
            .map(str::to_owned)
            .collect();
        lines
    };
    own.iter()
        .flat_map(of_crate)
        .filter(|name| !name.is_empty() && !name.starts_with('#') && !own.contains(name))
        .collect()
}

#[test]
fn the_page_says_what_each_dependency_is_for() {
    let page = read("docs/architecture.md");
    let (_, table) = page.split_once("| crate | for | why this one |").unwrap();
    let first_cells = table
        .lines()
        .skip(2)
        .map_while(|line| line.strip_prefix("| ")?.split(" | ").next());
    let explained: BTreeSet<&str> = first_cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect();
    // they are built from folders of this repository, and are in the table of crates
    let built = ["docs", "viewer"];
    let used = dependencies();
    let missing: Vec<&String> = used
        .iter()
        .filter(|name| !explained.contains(name.as_str()) && !built.contains(&name.as_str()))
        .collect();
    assert!(missing.is_empty(), "without a row: {missing:?}");
    let gone: Vec<&&str> = explained
        .iter()
        .filter(|name| !used.contains(**name))
        .collect();
    assert!(gone.is_empty(), "rows of what nothing uses: {gone:?}");
}

/// Programs in Rust take the library with all that it brings along: little, and as much as its page says.
#[test]
fn the_library_brings_few_crates_along() {
    const MOST: usize = 25;
    let tree = Command::new(env!("CARGO"))
        .args("tree -p xacro-expand -e normal,build --prefix none --no-dedupe".split(' '))
        .args(["--locked", "--offline"])
        .current_dir(REPOSITORY)
        .output()
        .unwrap();
    let text = String::from_utf8(tree.stdout).unwrap();
    let names: BTreeSet<&str> = text
        .lines()
        .filter_map(|line| line.split(' ').next())
        .collect();
    let (own, others): (Vec<&str>, Vec<&str>) =
        names.iter().partition(|name| name.starts_with("xacro-"));
    assert!(!own.is_empty() && names.len() <= MOST, "{names:?}");
    let said = format!(
        "{} crates: {} in this repository and {} from crates.io",
        names.len(),
        own.len(),
        others.len()
    );
    assert!(read("docs/library.md").contains(&said), "{said}");
}

#[test]
fn only_vfs_touches_the_disk_and_only_the_server_speaks_the_protocol() {
    let rules: [(&str, &[&str]); 6] = [
        ("std::fs", &["vfs"]),
        // the program that starts the server, which lies beside it
        ("Command::new", &["bin"]),
        ("std::env::var", &["vfs"]),
        ("tower_lsp", &["server"]),
        ("lsp_types", &["server"]),
        ("std::net", &["preview", "server"]),
    ];
    let mut wrong = Vec::new();
    for (path, crate_name, code) in sources() {
        let product = code.split("#[cfg(test)]").next().unwrap_or("");
        for (name, allowed) in rules {
            if product.contains(name) && !allowed.contains(&crate_name.as_str()) && !is_test(&path)
            {
                wrong.push(format!(
                    "{}: `{name}` is not for `{crate_name}`",
                    path.display()
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The methods of a type stand in the file of the type: who reads the one finds the others. What is asked of the state of
/// a program, such as the session in `analysis`, is a function that takes it, in the module of the question.
#[test]
fn methods_stand_beside_their_type() {
    for (crate_name, most) in [("server", 0), ("analysis", 0)] {
        let away = methods_away_from_their_type(crate_name);
        assert!(
            away.len() <= most,
            "{crate_name}: methods away from their types in {} places, of at most {most}:\n{}",
            away.len(),
            away.join("\n")
        );
    }
}

fn methods_away_from_their_type(crate_name: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (path, own_crate, code) in sources() {
        if own_crate != crate_name {
            continue;
        }
        for line in code
            .lines()
            .filter(|line| line.starts_with("impl") && !line.contains(" for "))
        {
            let head = line.split('{').next().unwrap().trim();
            let name = head.rsplit(' ').next().unwrap().split('<').next().unwrap();
            let is_declared = ["struct", "enum", "trait"]
                .iter()
                .any(|kind| code.contains(&format!("{kind} {name}")));
            if !is_declared {
                found.push(format!("{}: `{head}`", path.display()));
            }
        }
    }
    found
}

#[test]
fn files_are_short() {
    const MOST_LINES: usize = 600;
    let mut files = Vec::new();
    for folder in ["src", "tests"] {
        rust_files(&Path::new(REPOSITORY).join(folder), &mut files);
    }
    let long: Vec<String> = files
        .into_iter()
        .map(|path| {
            let lines = fs::read_to_string(&path).unwrap().lines().count();
            (path, lines)
        })
        .filter(|(_, lines)| *lines > MOST_LINES)
        .map(|(path, lines)| format!("{}: {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "{}", long.join("\n"));
}

/// Who reads a file should not have to read all others first: files that use each other in a circle are few.
#[test]
fn files_use_each_other_in_one_direction() {
    for (crate_name, most) in [("rules", 16), ("expand", 5), ("analysis", 0), ("server", 3)] {
        let circles = imports::circles(crate_name);
        let count: usize = circles.iter().map(|circle| circle.len()).sum();
        assert!(
            count <= most,
            "{crate_name}: {count} files, of at most {most}, use each other in circles: {circles:?}"
        );
    }
}

/// A struct with many fields is several: the parts have names.
#[test]
fn structs_have_few_fields() {
    const MOST: usize = 16;
    for (path, crate_name, code) in sources() {
        if !["server", "analysis", "expand"].contains(&&*crate_name) {
            continue;
        }
        let mut name = None;
        let mut fields = 0;
        for line in code.lines() {
            let start = line.trim_start();
            if let Some((_, rest)) = start.split_once("struct ").filter(|_| start.ends_with('{')) {
                (name, fields) = (Some(rest.trim_end_matches(" {").to_owned()), 0);
            } else if line == "}" {
                name = None;
            }
            let is_field = line.starts_with("    ")
                && !line.starts_with("     ")
                && start
                    .trim_start_matches("pub ")
                    .trim_start_matches("pub(super) ")
                    .trim_start_matches("pub(crate) ")
                    .split_once(": ")
                    .is_some_and(|(field, _)| {
                        field.chars().all(|c| c.is_alphanumeric() || c == '_')
                    });
            if let Some(name) = &name {
                fields += usize::from(is_field);
                assert!(
                    fields <= MOST,
                    "{}: {name} has more than {MOST} fields",
                    path.display()
                );
            }
        }
    }
}
