//! Each limit of `src/base/limits.rs` is reached in a file of `tests/limits`, or by the test that `TESTS` names, and says
//! so: with the file, the place, the limit, and how to raise it where it can be raised. `docs/limits.md` lists them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

#[path = "limits/callers.rs"]
mod callers;
#[path = "limits/configuration.rs"]
mod configuration;
#[path = "limits/expansion.rs"]
mod expansion;
#[path = "limits/expressions.rs"]
mod expressions;
#[path = "limits/inputs.rs"]
mod inputs;
#[path = "limits/launch.rs"]
mod launch;
#[path = "limits/meshes.rs"]
mod meshes;
#[path = "limits/reports.rs"]
mod reports;
#[path = "limits/runs.rs"]
mod runs;
#[path = "limits/search.rs"]
mod search;
#[path = "limits/xml.rs"]
mod xml;
#[path = "limits/yaml.rs"]
mod yaml;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use xacro_lsp::base::limits::*;
use xacro_lsp::cli::{self, Io};
use xacro_lsp::vfs::Environment;

/// Tests outside of `tests/limits`, and those that reach several limits.
const TESTS: &[(&str, &str)] = &[
    (
        "CONNECTIONS",
        "src/preview/browser/tests.rs::a_thousand_idle_connections_keep_nobody_out",
    ),
    ("ENTITY_FACTOR", "tests/limits/xml.rs::entity_growth"),
    ("EVALUATIONS", "tests/limits/expansion.rs::expand_nodes"),
    ("FIX_ROUNDS", "tests/fixes.rs::fixes_of_the_pages"),
    ("GLOB_FOLDERS", "tests/limits/search.rs::many_folders"),
    ("KEY_PARTS", "tests/limits/expressions.rs::key_depth"),
    (
        "MESH_ELEMENTS",
        "src/model/mesh/tests.rs::data_that_is_read_again_and_again",
    ),
    (
        "MESH_VISITS",
        "src/model/mesh/tests.rs::what_is_wrong_with_gltf",
    ),
    ("NAMESAKE_FILES", "tests/limits/search.rs::many_folders"),
    (
        "PAGES",
        "src/preview/browser/tests.rs::who_waits_longest_makes_room",
    ),
    (
        "REQUEST_HEAD",
        "src/preview/browser/tests.rs::what_is_too_large_is_refused",
    ),
    ("SCAN_FILES", "tests/limits/search.rs::many_folders"),
    ("SCAN_FOLDERS", "tests/limits/search.rs::many_folders"),
    (
        "SOCKET_MESSAGE",
        "src/preview/browser/tests.rs::what_is_too_large_is_refused",
    ),
    (
        "UNAUTHENTICATED",
        "src/preview/browser/tests.rs::sockets_that_say_nothing_keep_nobody_out",
    ),
    ("XML_ERRORS_SEEN", "tests/limits/xml.rs::xml_errors"),
];

/// Groups whose tests stand in `tests/lsp/limits.rs`.
const OF_THE_SERVER: [&str; 2] = ["Language server", "Preview in a browser"];

/// Where the test of a limit stands: file, or folder of files, and function.
fn test_of(limit: &DocumentedLimit) -> (String, String) {
    if let Some((_, place)) = TESTS.iter().find(|(name, _)| *name == limit.name) {
        let (file, function) = place.split_once("::").unwrap();
        return (file.to_owned(), function.to_owned());
    }
    let own = ["MESSAGE_BYTES", "HEADER_BYTES"].contains(&limit.name);
    let of_the_server =
        OF_THE_SERVER.contains(&limit.group) && !own || limit.name == "REWRITTEN_MESH_BYTES";
    let file = if of_the_server {
        "tests/lsp/limits.rs"
    } else {
        "tests/limits"
    };
    (file.to_owned(), limit.name.to_lowercase())
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn every_limit_has_a_test_and_is_used() {
    let mut files = Vec::new();
    sources(&repository().join("src"), &mut files);
    let words: BTreeSet<&str> = files
        .iter()
        .flat_map(|text| text.split(|c: char| !c.is_alphanumeric() && c != '_'))
        .collect();
    for limit in ALL {
        let (file, function) = test_of(limit);
        let path = repository().join(&file);
        let mut texts = Vec::new();
        if path.is_dir() {
            sources(&path, &mut texts);
        } else {
            texts.push(fs::read_to_string(path).unwrap());
        }
        let head = format!("fn {function}(");
        assert!(
            texts.iter().any(|text| text.contains(&head)),
            "{}: no `{function}` in {file}",
            limit.name
        );
        assert!(words.contains(limit.name), "{} is not used", limit.name);
    }
}

/// The texts of all source files but that of the limits.
fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs")
            && !path.ends_with("base/limits.rs")
        {
            found.push(fs::read_to_string(path).unwrap());
        }
    }
}

/// A number with the groups of its digits apart, or as a power of two where it is one.
fn shown(value: u64) -> String {
    for (bits, unit) in [(30, "GiB"), (20, "MiB"), (10, "KiB")] {
        if value >= 1 << bits && value.is_multiple_of(1 << bits) {
            return format!("{} {unit}", value >> bits);
        }
    }
    let digits = value.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|group| std::str::from_utf8(group).unwrap())
        .collect();
    groups.join(",")
}

#[test]
fn the_page_lists_them() {
    let path = repository().join("docs/limits.md");
    let page = fs::read_to_string(&path).unwrap();
    let (begin, end) = (
        "<!-- limits: made by `UPDATE=1 cargo test --test limits` -->\n",
        "<!-- end of limits -->\n",
    );
    let (head, rest) = page.split_once(begin).unwrap();
    let (_, tail) = rest.split_once(end).unwrap();
    let mut table = String::new();
    let mut group = "";
    for limit in ALL {
        if limit.group != group {
            group = limit.group;
            table.push_str(&format!(
                "\n### {group}\n\n| what | limit | when it is reached | key | test |\n|---|---|---|---|---|\n"
            ));
        }
        let key = limit.key.map(|key| format!("`{key}`")).unwrap_or_default();
        let (what, (_, test)) = (limit.what.trim().trim_end_matches('.'), test_of(limit));
        table.push_str(&format!(
            "| {what} | {} | {} | {key} | `{test}` |\n",
            shown(limit.value),
            limit.then
        ));
    }
    let new = format!("{head}{begin}{table}\n{end}{tail}");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, &new).unwrap();
    }
    assert!(
        new == fs::read_to_string(&path).unwrap(),
        "docs/limits.md is old: run `UPDATE=1 cargo test --test limits`"
    );
}

/// A folder that is made again.
fn folder() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("limits")
        .join(number.to_string());
    let _ = fs::remove_dir_all(&folder);
    // a repository of its own: nothing is read of folders above
    fs::create_dir_all(folder.join(".git")).unwrap();
    folder
}

fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// A file of so many bytes that takes no room.
fn sparse(folder: &Path, name: &str, head: &str, size: u64) {
    write(folder, name, head);
    fs::File::options()
        .write(true)
        .open(folder.join(name))
        .unwrap()
        .set_len(size)
        .unwrap();
}

/// What a command prints in a folder.
fn run(folder: &Path, arguments: &[&str], input: &mut dyn Read) -> String {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let arguments: Vec<String> = arguments.iter().map(|&word| word.to_owned()).collect();
    let code = cli::run(&arguments, &env, &mut Io::plain(&mut out, &mut err, input));
    out.extend(err);
    format!("{}\n[exit {code}]", String::from_utf8(out).unwrap())
}

fn robot(body: &str) -> String {
    format!("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{body}\n</robot>\n")
}

/// What `check` says of a robot with this body, beside further files.
fn check(body: &str, files: &[(&str, &str)]) -> String {
    let folder = folder();
    write(&folder, "r.urdf.xacro", robot(body));
    for (name, text) in files {
        write(&folder, name, text);
    }
    run(&folder, &["check", "."], &mut std::io::empty())
}

/// An error with its file, its line and each of these words; and `expand` ends too.
#[track_caller]
fn reached(body: &str, files: &[(&str, &str)], words: &[&str]) {
    let said = check(body, files);
    assert!(
        said.contains("error[") && said.contains("r.urdf.xacro:"),
        "{said}"
    );
    for word in words {
        assert!(said.contains(word), "no `{word}` in {said}");
    }
}

const LINK: &str = "<link name=\"a\"/>";

const MANIFEST: &str = "<package format=\"3\"><name>far</name><version>1.0.0</version><description>-</description>\
    <maintainer email=\"a@b.c\">a</maintainer><license>MIT</license></package>";
