//! Each limit of `src/base/limits.rs` is reached here, or by the test that `TESTS` names, and says so: with the file,
//! the place, the limit, and how to raise it where it can be raised. `docs/limits.md` lists them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use xacro_lsp::analysis::{AffectedRobots, Effort, Session, Setup};
use xacro_lsp::base::limits::*;
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::cli::{self, Io};
use xacro_lsp::model::{Mesh, Meshes};
use xacro_lsp::vfs::{Environment, Vfs};
use xacro_lsp::workspace::config::Pattern;
use xacro_lsp::workspace::{Callers, PackageOptions, Packages, launch};
use xacro_lsp::xml::Document;
use xacro_lsp::{expr, server};

/// Tests outside of this file, and those that reach several limits.
const TESTS: &[(&str, &str)] = &[
    (
        "CONNECTIONS",
        "src/preview/browser/tests.rs::a_thousand_idle_connections_keep_nobody_out",
    ),
    ("ENTITY_FACTOR", "tests/limits.rs::entity_growth"),
    ("EVALUATIONS", "tests/limits.rs::expand_nodes"),
    ("FIX_ROUNDS", "tests/fixes.rs::fixes_of_the_pages"),
    ("GLOB_FOLDERS", "tests/limits.rs::many_folders"),
    ("KEY_PARTS", "tests/limits.rs::key_depth"),
    (
        "MESH_ELEMENTS",
        "src/model/mesh/tests.rs::data_that_is_read_again_and_again",
    ),
    (
        "MESH_VISITS",
        "src/model/mesh/tests.rs::what_is_wrong_with_gltf",
    ),
    ("NAMESAKE_FILES", "tests/limits.rs::many_folders"),
    (
        "PAGES",
        "src/preview/browser/tests.rs::who_waits_longest_makes_room",
    ),
    (
        "REQUEST_HEAD",
        "src/preview/browser/tests.rs::what_is_too_large_is_refused",
    ),
    ("SCAN_FILES", "tests/limits.rs::many_folders"),
    ("SCAN_FOLDERS", "tests/limits.rs::many_folders"),
    (
        "SOCKET_MESSAGE",
        "src/preview/browser/tests.rs::what_is_too_large_is_refused",
    ),
    (
        "UNAUTHENTICATED",
        "src/preview/browser/tests.rs::sockets_that_say_nothing_keep_nobody_out",
    ),
    ("XML_ERRORS_SEEN", "tests/limits.rs::xml_errors"),
];

/// Groups whose tests stand in `tests/lsp/limits.rs`.
const OF_THE_SERVER: [&str; 2] = ["Language server", "Preview in a browser"];

/// Where the test of a limit stands: file and function.
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
        "tests/limits.rs"
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
    for limit in ALL {
        let (file, function) = test_of(limit);
        let text = fs::read_to_string(repository().join(&file)).unwrap();
        assert!(
            text.contains(&format!("fn {function}(")),
            "{}: no `{function}` in {file}",
            limit.name
        );
        let uses = files.iter().filter(|text| {
            text.split(|c: char| !c.is_alphanumeric() && c != '_')
                .any(|word| word == limit.name)
        });
        assert!(uses.count() > 0, "{} is not used", limit.name);
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

/// A robot with a file that is included twice, and so many arguments, each of which has five other values to be tried.
fn included_twice(arguments: usize) -> PathBuf {
    let folder = folder();
    let declared = |number| format!("<xacro:arg name=\"kind_{number}\" default=\"fixed\"/>");
    let declared: String = (0..arguments).map(declared).collect();
    let include = "<xacro:include filename=\"p.xacro\"/>\n";
    write(
        &folder,
        "r.urdf.xacro",
        robot(&format!(
            "{declared}{include}{include}<link name=\"${{p}}\"/>"
        )),
    );
    write(
        &folder,
        "p.xacro",
        robot("<xacro:property name=\"p\" value=\"a\"/>"),
    );
    folder
}

#[test]
fn proof_expansions() {
    let fixed = |arguments| {
        run(
            &included_twice(arguments),
            &[
                "fix",
                ".",
                "--select",
                "duplicate-include",
                "--show",
                "info",
            ],
            &mut std::io::empty(),
        )
    };
    assert!(fixed(3).contains("fixed 1 finding"), "{}", fixed(3));
    let said = fixed(PROOF_EXPANSIONS / 5 + 1);
    assert!(
        said.contains("1 fixable with --fix --unsafe-fixes"),
        "{said}"
    );
}

#[test]
fn quick_proof_expansions() {
    for (arguments, expected) in [
        (QUICK_PROOF_EXPANSIONS / 5 - 1, true),
        (QUICK_PROOF_EXPANSIONS / 5 + 1, false),
    ] {
        let folder = included_twice(arguments);
        let env = Environment {
            vars: BTreeMap::new(),
            cwd: folder.clone(),
            ..Environment::default()
        };
        let session = Session::new(
            &env,
            Setup {
                about: folder.clone(),
                ..Setup::default()
            },
        )
        .unwrap();
        let path = folder.join("r.urdf.xacro");
        let text = fs::read_to_string(&path).unwrap();
        let include = "<xacro:include filename=\"p.xacro\"/>\n";
        let at = text.rfind(include).unwrap() as u32;
        let edits = vec![(TextRange::new(at, at + include.len() as u32), String::new())];
        let cancel = CancelFlag::default();
        let effort = Effort {
            expansions: QUICK_PROOF_EXPANSIONS,
            roots: AffectedRobots::Known(vec![path.clone()]),
            cancel,
        };
        assert_eq!(
            session.expansion_unchanged(&path, edits, &effort),
            expected,
            "{arguments} arguments"
        );
    }
}

const LINK: &str = "<link name=\"a\"/>";

#[test]
fn file_mb() {
    let folder = folder();
    write(&folder, "xacro-lint.toml", "[limits]\nfile-mb = 1\n");
    let large = robot(&" ".repeat(1_100_000));
    write(&folder, "large.xacro", &large);
    write(
        &folder,
        "r.urdf.xacro",
        robot("<xacro:include filename=\"large.xacro\"/>\n<link name=\"a\"/>"),
    );
    let said = run(&folder, &["check", "r.urdf.xacro"], &mut std::io::empty());
    assert!(
        said.contains("`large.xacro` cannot be read: it has more than 1 MB, the limit"),
        "{said}"
    );
    assert!(
        said.contains("r.urdf.xacro:2:") && said.contains("raise `file-mb` under `[limits]`"),
        "{said}"
    );
    let said = run(&folder, &["check", "large.xacro"], &mut std::io::empty());
    assert!(
        said.contains("large.xacro") && said.contains("it has more than 1 MB, the limit"),
        "{said}"
    );
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert!(
        said.contains("File too large") && said.contains("raise `file-mb`"),
        "{said}"
    );
    write(&folder, "xacro-lint.toml", "[limits]\nfile-mb = 2\n");
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert!(said.contains("[exit 0]"), "{said}");
}

#[test]
fn file_mb_most() {
    let said = check(LINK, &[("xacro-lint.toml", "[limits]\nfile-mb = 1001\n")]);
    assert!(
        said.contains("xacro-lint.toml") && said.contains("must be from 1 to 1000"),
        "{said}"
    );
    // a configuration is read before it can say how much is read
    let folder = folder();
    write(&folder, "r.urdf.xacro", robot(LINK));
    sparse(&folder, "xacro-lint.toml", "", 5_000_000_000);
    let said = run(&folder, &["check", "r.urdf.xacro"], &mut std::io::empty());
    assert!(said.contains("[exit"), "{said}");
}

#[test]
fn stdin_bytes() {
    for command in ["check", "format", "expand"] {
        let mut input = std::io::repeat(b' ').take(STDIN_BYTES + 1);
        let said = run(&folder(), &[command, "-"], &mut input);
        assert!(
            said.contains("input is larger than 20 MB; pass the file name instead"),
            "{command}: {said}"
        );
        assert!(said.contains("[exit 2]"), "{command}: {said}");
    }
}

fn vfs() -> Vfs {
    Vfs::with_cwd(1 << 20, folder())
}

#[test]
fn mesh_bytes() {
    let folder = folder();
    sparse(&folder, "a.stl", "", MESH_BYTES + 1);
    let mesh = Meshes::default().get(&vfs(), &folder.join("a.stl"));
    assert_eq!(
        mesh.defect.as_ref().unwrap().message,
        "it has more than 100 megabytes"
    );
}

#[test]
fn material_bytes() {
    let folder = folder();
    write(
        &folder,
        "a.obj",
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    let missing = |size| {
        sparse(&folder, "a.mtl", "newmtl m\nmap_Kd gone.png\n", size);
        let (meshes, vfs, path) = (Meshes::default(), vfs(), folder.join("a.obj"));
        let mesh = meshes.get(&vfs, &path);
        meshes.missing(&vfs, &path, &mesh, &|_| true).len()
    };
    assert_eq!((missing(25), missing(MATERIAL_BYTES + 1)), (1, 0));
}

#[test]
fn xml_bytes() {
    // no input gets there: the largest file, the largest message and standard input are smaller
    let largest = [FILE_MB_MOST * 1_000_000, MESSAGE_BYTES, STDIN_BYTES]
        .into_iter()
        .max();
    assert!(largest < Some(XML_BYTES as u64), "{largest:?}");
}

/// A document whose root has entities: `a` of 1000 bytes, the others made of those before.
fn entities(declarations: &str, body: &str) -> String {
    let a = "x".repeat(1000);
    format!(
        "<!DOCTYPE robot [<!ENTITY a \"{a}\">{declarations}]>\n<robot name=\"r\">\n{body}\n</robot>"
    )
}

fn first_error(text: &str) -> String {
    let errors = Document::parse(text).errors();
    errors
        .first()
        .map(|error| error.message.clone())
        .unwrap_or_default()
}

#[test]
fn entity_bytes() {
    let (one, nine) = ("&a;".repeat(1000), "&b;".repeat(9));
    let text = entities(
        &format!("<!ENTITY b \"{one}\"><!ENTITY c \"{nine}\">"),
        "<link name=\"&c;\"/>",
    );
    assert!(
        first_error(&text).contains("entity `c` exceeds a limit: 8 MB"),
        "{}",
        first_error(&text)
    );
    let folder = folder();
    write(&folder, "r.urdf", text);
    let said = run(&folder, &["check", "r.urdf"], &mut std::io::empty());
    assert!(
        said.contains("r.urdf:3:") && said.contains("8 MB for one entity"),
        "{said}"
    );
}

#[test]
fn entities_bytes() {
    let one = "&a;".repeat(7000);
    let declarations: String = (0..6)
        .map(|n| format!("<!ENTITY b{n} \"{one}\">"))
        .collect();
    let uses: String = (0..6).map(|n| format!("&b{n};")).collect();
    // a long file, so that it is not the share of the entities that is too large
    let text = entities(
        &declarations,
        &format!("<!--{}-->{uses}", " ".repeat(600_000)),
    );
    assert!(
        first_error(&text).contains("32 MB for all"),
        "{}",
        first_error(&text)
    );
}

#[test]
fn entity_depth() {
    // the deepest one is asked for first
    let declarations = |count: u32| -> String {
        let nested = (1..count)
            .rev()
            .map(|n| format!("<!ENTITY d{n} \"&d{};\">", n - 1));
        nested.collect::<String>() + "<!ENTITY d0 \"x\">"
    };
    let text = entities(&declarations(5000), "&d4999;");
    assert!(
        first_error(&text).contains("256 levels"),
        "{}",
        first_error(&text)
    );
    assert_eq!(first_error(&entities(&declarations(200), "&d199;")), "");
}

#[test]
fn entity_growth() {
    let thousand = "&a;".repeat(1000);
    let text = entities(&format!("<!ENTITY b \"{thousand}\">"), &"&b;".repeat(9));
    assert!(
        first_error(&text).contains("more than 100 times the size of the file"),
        "{}",
        first_error(&text)
    );
}

#[test]
fn value_bytes() {
    let thousand = "&a;".repeat(1000);
    let uses = "&b;".repeat(20);
    let text = entities(
        &format!("<!ENTITY b \"{thousand}\">"),
        &format!("<link name=\"{uses}\"/>"),
    );
    let document = Document::parse(&text);
    let (_, item) = document.items().next().unwrap();
    let value = item
        .element()
        .unwrap()
        .attr("name")
        .unwrap()
        .value(document.entities())
        .len();
    assert!(
        value > VALUE_BYTES && value <= VALUE_BYTES + 1_000_000,
        "{value}"
    );
}

#[test]
fn item_errors() {
    let text = format!("<robot>\n<a>{}</a>\n</robot>", "&;".repeat(300));
    assert_eq!(Document::parse(&text).errors().len(), ITEM_ERRORS);
}

#[test]
fn xml_errors() {
    let item = format!("<a>{}</a>\n", "&;".repeat(300));
    let text = format!(
        "<robot>\n{}</robot>",
        item.repeat(XML_ERRORS_SEEN / ITEM_ERRORS + 10)
    );
    assert_eq!(Document::parse(&text).errors().len(), XML_ERRORS);
}

#[test]
fn expression_depth() {
    let deep = format!("<link name=\"${{{}True}}\"/>", "not ".repeat(300));
    reached(
        &deep,
        &[],
        &[
            "r.urdf.xacro:2:",
            "expression is nested more than 240 levels deep",
        ],
    );
}

#[test]
fn brackets() {
    let deep = format!(
        "<link name=\"${{{}1{}}}\"/>",
        "(".repeat(201),
        ")".repeat(201)
    );
    reached(
        &deep,
        &[],
        &["brackets are nested more than 200 levels deep"],
    );
}

#[test]
fn expression_errors() {
    let texts = [
        "f(a b), ",
        "[1 2], ",
        "'a' 'b' c, ",
        "__a + ",
        "a.__b + ",
        "(1 +), ",
        "f'{a b}' + ",
        "lambda, ",
    ];
    let counts = texts.map(|text| expr::parse(&text.repeat(100)).errors.len());
    // those of f-strings are found in their own small expressions
    let plain: Vec<usize> = counts.into_iter().filter(|&count| count != 100).collect();
    assert_eq!(
        plain.into_iter().max(),
        Some(EXPRESSION_ERRORS),
        "{counts:?}"
    );
}

#[test]
fn eval_steps() {
    let endless = "<link name=\"${len([i for i in python.range(10**6)])}\"/>";
    let config = [("xacro-lint.toml", "[limits]\neval-steps = 1000\n")];
    reached(
        endless,
        &config,
        &[
            "more than the limit of 1000 steps",
            "raise `eval-steps` under `[limits]`",
        ],
    );
    reached(endless, &[], &["more than the limit of 1000000 steps"]);
}

#[test]
fn eval_depth() {
    reached(
        "<link name=\"${(lambda f: f(f))(lambda f: f(f))}\"/>",
        &[],
        &["maximum recursion depth exceeded"],
    );
}

#[test]
fn eval_value_bytes() {
    reached(
        "<link name=\"${'a' * 10**9}\"/>",
        &[],
        &["the limit is 64 MB"],
    );
}

#[test]
fn integer_bits() {
    reached(
        "<link name=\"${10**10**8}\"/>",
        &[],
        &["the limit is 1048576 bits"],
    );
}

#[test]
fn integer_digits() {
    reached(
        "<link name=\"${int('9' * 5000)}\"/>",
        &[],
        &["Exceeds the limit (4300 digits)"],
    );
}

#[test]
fn key_depth() {
    let deep = "<link name=\"${[(t := ())] and [t := (t,) for _ in python.range(10**4)] and python.set([t])}\"/>";
    reached(
        deep,
        &[],
        &["maximum recursion depth exceeded while hashing a tuple"],
    );
    let wide = "<link name=\"${[(t := ())] and [t := (t, t) for _ in python.range(60)] and python.hash(t)}\"/>";
    reached(
        wide,
        &[],
        &["maximum recursion depth exceeded while hashing a tuple"],
    );
}

#[test]
fn shown_depth() {
    let deep =
        "<link name=\"${[(t := [])] and [t := [t] for _ in python.range(10**4)] and str(t)}\"/>";
    reached(
        deep,
        &[],
        &["maximum recursion depth exceeded while getting the repr"],
    );
}

/// A robot that loads `f.yaml`.
const LOADS: &str = "<xacro:property name=\"p\" value=\"${xacro.load_yaml('f.yaml')}\"/>\n<link name=\"${len(p)}\"/>";

#[test]
fn yaml_depth() {
    let deep = format!("a: {}{}\n", "[".repeat(300), "]".repeat(300));
    reached(
        LOADS,
        &[("f.yaml", &deep)],
        &["more than 200 levels of nesting"],
    );
}

#[test]
fn yaml_nodes() {
    let mut text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n".to_owned();
    for n in 1..7 {
        let uses = vec![format!("*a{}", n - 1); 10].join(", ");
        text.push_str(&format!("a{n}: &a{n} [{uses}]\n"));
    }
    reached(LOADS, &[("f.yaml", &text)], &["more than 500000 values"]);
}

#[test]
fn yaml_merges() {
    let text = format!("a: {}{{x: 1}}{}\n", "{<<: ".repeat(150), "}".repeat(150));
    reached(
        LOADS,
        &[("f.yaml", &text)],
        &["more than 100 merges into each other"],
    );
}

/// A macro that makes as many links as it is told, ten calls deep.
const MANY: &str = "<xacro:macro name=\"m\" params=\"n p\"><xacro:if value=\"${n > 0}\"><link name=\"${p}\"/>\
    <xacro:m n=\"${n - 1}\" p=\"${p}a\"/><xacro:m n=\"${n - 1}\" p=\"${p}b\"/></xacro:if></xacro:macro>\n\
    <xacro:m n=\"30\" p=\"l\"/>";

#[test]
fn expand_nodes() {
    let config = [("xacro-lint.toml", "[limits]\nexpand-nodes = 100\n")];
    reached(
        MANY,
        &config,
        &[
            "the expanded robot has more than 100 nodes",
            "raise `expand-nodes` under `[limits]`",
        ],
    );
    // each node is made by at most a few expressions: their values are bounded with the nodes
    assert!(EVALUATIONS as u64 >= EXPAND_NODES);
}

#[test]
fn compared_names() {
    let names = COMPARED_NAMES / 1000;
    let properties: String = (0..names)
        .map(|n| format!("<xacro:property name=\"param{n}\" value=\"1\"/>"))
        .collect();
    // a name that is like another, behind so many that were compared before
    let said = |others: usize| {
        let wrong: String = (0..others)
            .map(|n| format!("<link name=\"${{abc{n}}}\"/>"))
            .collect();
        let called = "<xacro:macro name=\"wheel\"><link name=\"a\"/></xacro:macro><xacro:wheeel/>";
        let patient = [("xacro-lint.toml", "[limits]\nexpand-ms = 60000\n")];
        check(&format!("{properties}{wrong}{called}"), &patient)
    };
    let suggested = "did you mean `wheel`?";
    assert!(said(0).contains(suggested));
    let said = said(1000);
    assert!(
        said.contains("macro `wheeel` is not defined") && !said.contains(suggested),
        "{said}"
    );
}

#[test]
fn expand_ms() {
    let config = [("xacro-lint.toml", "[limits]\nexpand-ms = 1\n")];
    reached(
        MANY,
        &config,
        &[
            "the expansion takes more than 1 ms",
            "raise `expand-ms` under `[limits]`",
        ],
    );
}

#[test]
fn output_bytes() {
    let uses = "<link name=\"${p}\"/>\n".repeat(40);
    let body = format!("<xacro:property name=\"p\" value=\"${{'a' * 2 * 10**6}}\"/>\n{uses}");
    reached(&body, &[], &["64 MB"]);
}

#[test]
fn macro_depth() {
    let endless = "<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n > 0}\"><xacro:m n=\"${n + 1}\"/></xacro:if>\
                   </xacro:macro>\n<xacro:m n=\"1\"/>";
    reached(
        endless,
        &[],
        &[
            "nested more than 1000 levels deep: `m`",
            "raise `macro-depth` under `[limits]`",
        ],
    );
    // a workspace may raise it, but not beyond what the stack holds
    let config = [(
        "xacro-lint.toml",
        "[limits]\nmacro-depth = 10000\nexpand-ms = 60000\n",
    )];
    reached(endless, &config, &["nested more than 10000 levels deep"]);
}

#[test]
fn include_depth() {
    let endless = "<xacro:include filename=\"${'r'}.urdf.xacro\"/>\n<link name=\"a\"/>";
    reached(
        endless,
        &[],
        &[
            "includes are nested more than 500 levels deep",
            "raise `include-depth` under `[limits]`",
        ],
    );
    let config = [(
        "xacro-lint.toml",
        "[limits]\ninclude-depth = 10000\nexpand-ms = 60000\n",
    )];
    reached(
        endless,
        &config,
        &["includes are nested more than 10000 levels deep"],
    );
}

#[test]
fn glob_files() {
    let names: Vec<String> = (0..=GLOB_FILES)
        .map(|n| format!("parts/p{n}.xacro"))
        .collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (&**name, "<robot/>")).collect();
    let body = format!("<xacro:include filename=\"parts/*.xacro\"/>\n{LINK}");
    reached(
        &body,
        &files,
        &[
            "r.urdf.xacro:2:",
            "matches more than 1000 files, the limit for one include",
        ],
    );
    let (_, fewer) = files.split_first().unwrap();
    let said = check(&body, fewer);
    assert!(!said.contains("error["), "{said}");
}

#[test]
fn glob_entries() {
    // each `*/..` multiplies
    let pattern = "*/../".repeat(20);
    let names: Vec<String> = (0..10).map(|n| format!("d{n}/x.txt")).collect();
    let files: Vec<(&str, &str)> = names.iter().map(|name| (&**name, "")).collect();
    let body = format!("<xacro:include filename=\"{pattern}*.xacro\"/>\n{LINK}");
    reached(&body, &files, &["r.urdf.xacro:2:", "is 200000"]);
    // patterns that are long and look at nothing
    for pattern in [
        "*/".repeat(1_000_000),
        format!("x{}", "[".repeat(1_000_000)),
        "*".repeat(1_000_000),
    ] {
        let body = format!("<xacro:include filename=\"gone/{pattern}\"/>\n{LINK}");
        assert!(
            check(&body, &files).contains("glob-include-no-match"),
            "{}",
            &pattern[..5]
        );
    }
}

#[test]
fn element_depth() {
    let count = ELEMENT_DEPTH as usize + 10;
    let deep = format!("{}{}", "<a>".repeat(count), "</a>".repeat(count));
    reached(
        &deep,
        &[],
        &["elements are nested more than 5000 levels deep"],
    );
}

#[test]
fn block_depth() {
    let endless = "<xacro:property name=\"b\"><xacro:insert_block name=\"b\"/></xacro:property>\n\
                   <xacro:insert_block name=\"b\"/>";
    reached(
        endless,
        &[],
        &["block `b` inserts itself (more than 500 levels)"],
    );
}

#[test]
fn lazy_depth() {
    let chain: String = (0..600)
        .map(|n| {
            format!(
                "<xacro:property name=\"p{n}\" value=\"${{p{} + 1}}\"/>\n",
                n + 1
            )
        })
        .collect();
    let body =
        format!("{chain}<xacro:property name=\"p600\" value=\"1\"/>\n<link name=\"${{p0}}\"/>");
    reached(&body, &[], &["more than 500 levels deep"]);
}

#[test]
fn config_chain() {
    let mut files = vec![(
        "xacro-lint.toml".to_owned(),
        "extend = 'c0.toml'\n".to_owned(),
    )];
    files.extend((0..20).map(|n| {
        (
            format!("c{n}.toml"),
            format!("extend = 'c{}.toml'\n", n + 1),
        )
    }));
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    let said = check(LINK, &files);
    assert!(
        said.contains("c14.toml:1:")
            && said.contains("more than 16 configuration files extend each other"),
        "{said}"
    );
}

#[test]
fn matrix_runs() {
    let digits = "[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]";
    let config = |axes: usize| {
        let args: Vec<String> = (0..axes).map(|n| format!("a{n} = {digits}")).collect();
        format!(
            "[[roots]]\nfile = 'robot.urdf'\nargs = {{ {} }}\n",
            args.join(", ")
        )
    };
    let said = check(LINK, &[("xacro-lint.toml", &config(9))]);
    assert!(
        said.contains("1000000000 combinations of arguments; only 1000 are used"),
        "{said}"
    );
    let said = check(LINK, &[("xacro-lint.toml", &config(3))]);
    assert!(!said.contains("combinations"), "{said}");
}

/// A robot of one link, generated from a source in the same folder under a given size of it.
fn generated(size: usize) -> String {
    format!(
        "<!-- autogenerated by xacro from arm.xacro | --><robot name='r'><link name='size_{size}'/></robot>"
    )
}

/// Whether a generated file is found to be out of date, of a source in each of these folders.
fn is_out_of_date(folders: usize, size: usize, config: &str) -> bool {
    let source = "<robot name='r' xmlns:xacro='x'><xacro:arg name='size' default='0'/>\
                  <link name='size_$(arg size)'/></robot>";
    let folder = folder();
    write(&folder, "package.xml", MANIFEST);
    write(&folder, "xacro-lint.toml", config);
    for n in 0..folders {
        // the last one alone gives what was generated
        let default = if n + 1 == folders {
            size.to_string()
        } else {
            "0".to_owned()
        };
        let source = if folders > 1 {
            source.replace("$(arg size)", &default)
        } else {
            source.to_owned()
        };
        write(&folder, &format!("{n}/arm.xacro"), source);
    }
    write(&folder, "made.urdf", generated(size));
    let check = [
        "check",
        "--format",
        "concise",
        "--show",
        "info",
        "made.urdf",
    ];
    run(&folder, &check, &mut std::io::empty()).contains("generated-urdf-out-of-date")
}

#[test]
fn drift_runs() {
    let config = |count: usize| {
        let sizes: Vec<String> = (1..=count).map(|size| size.to_string()).collect();
        format!(
            "[[roots]]\nfile = '0/arm.xacro'\nargs = {{ size = [{}] }}\n",
            sizes.join(", ")
        )
    };
    assert!(!is_out_of_date(1, DRIFT_RUNS, &config(DRIFT_RUNS)));
    assert!(is_out_of_date(1, DRIFT_RUNS + 1, &config(DRIFT_RUNS + 1)));
}

#[test]
fn call_runs() {
    let folder = folder();
    let robot = "<robot name='r' xmlns:xacro='x'><xacro:arg name='n' default='x'/><link name='a'/>\
                 <xacro:if value=\"${'$(arg n)' == 'LAST'}\"><link name='a'/></xacro:if></robot>";
    write(
        &folder,
        "r.xacro",
        robot.replace("LAST", &(CALL_RUNS - 1).to_string()),
    );
    let calls = (0..=CALL_RUNS).map(|n| format!("xacro r.xacro n:={n}\n"));
    write(&folder, "a.sh", calls.collect::<String>());
    let check = || {
        run(
            &folder,
            &["check", "--format", "concise"],
            &mut std::io::empty(),
        )
    };
    assert!(
        check().contains(&format!("[in 1 of {CALL_RUNS} calls]")),
        "{}",
        check()
    );
    write(
        &folder,
        "r.xacro",
        robot.replace("LAST", &CALL_RUNS.to_string()),
    );
    assert!(!check().contains("duplicate-link-name"), "{}", check());
}

#[test]
fn drift_sources() {
    assert!(!is_out_of_date(DRIFT_SOURCES, 7, ""));
    assert!(is_out_of_date(DRIFT_SOURCES + 1, 7, ""));
}

#[test]
fn glob_alternatives() {
    let names: Vec<String> = (0..70).map(|n| format!("a{n}")).collect();
    let pattern = Pattern::new(&format!("{{{}}}", names.join(",")), Path::new("/w"));
    let matches = |n: usize| pattern.matches(&Path::new("/w").join(format!("a{n}")));
    assert!(matches(0) && matches(GLOB_ALTERNATIVES - 1) && !matches(GLOB_ALTERNATIVES));
}

const MANIFEST: &str = "<package format=\"3\"><name>far</name><version>1.0.0</version><description>-</description>\
    <maintainer email=\"a@b.c\">a</maintainer><license>MIT</license></package>";

/// Whether the package `far` is found whose manifest lies so many folders down.
fn found_below(levels: usize) -> bool {
    let folder = folder();
    let deep: PathBuf = (0..levels).map(|_| "d").collect();
    // packages of the other tests lie in the same workspace
    let name = format!("far{levels}");
    write(
        &folder,
        &format!("{}/package.xml", deep.display()),
        MANIFEST.replace("far", &name),
    );
    write(&folder, "r.urdf", "<robot name=\"r\"/>");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let options = PackageOptions {
        explicit: vec![folder.clone()],
        ..PackageOptions::default()
    };
    Packages::new(
        Arc::new(Vfs::with_cwd(1 << 20, folder.clone())),
        &env,
        options,
    )
    .find(&name, &folder.join("r.urdf"))
    .is_ok()
}

#[test]
fn scan_depth() {
    assert_eq!(
        (found_below(SCAN_DEPTH - 4), found_below(SCAN_DEPTH + 4)),
        (true, false)
    );
}

/// Whether a file of the same name is suggested that lies so many folders down.
fn suggested_below(levels: usize) -> bool {
    let folder = folder();
    let deep: PathBuf = (0..levels).map(|_| "d").collect();
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    let name = format!("part{levels}.stl");
    write(&folder, &format!("{}/{name}", deep.display()), "");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let packages = Packages::new(
        Arc::new(Vfs::with_cwd(1 << 20, folder.clone())),
        &env,
        PackageOptions::default(),
    );
    packages
        .namesake(
            &folder.join("gone").join(name),
            Some(&folder),
            &folder.join("r.urdf"),
        )
        .is_some()
}

#[test]
fn namesake_depth() {
    assert_eq!(
        (
            suggested_below(NAMESAKE_DEPTH - 4),
            suggested_below(NAMESAKE_DEPTH + 4)
        ),
        (true, false)
    );
}

/// How many callers of a robot are found below `folder`.
fn callers_of(folder: &Path, robot: &str) -> usize {
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let options = PackageOptions {
        workspace_folders: vec![folder.to_owned()],
        search_upward: false,
        ..PackageOptions::default()
    };
    let packages = Packages::new(
        Arc::new(Vfs::with_cwd(1 << 24, folder.to_owned())),
        &env,
        options,
    );
    Callers::default().of(&folder.join(robot), &packages).len()
}

#[test]
fn caller_depth() {
    let found = |levels: usize| {
        let folder = folder();
        let deep: PathBuf = (0..levels).map(|_| "d").collect();
        write(
            &folder,
            &format!("{}/r.launch", deep.display()),
            "deep.urdf",
        );
        callers_of(&folder, "deep.urdf")
    };
    assert_eq!((found(CALLER_DEPTH - 4), found(CALLER_DEPTH + 4)), (1, 0));
}

#[test]
fn caller_bytes() {
    let found = |bytes: u64| {
        let folder = folder();
        write(
            &folder,
            "r.launch",
            format!("large.urdf{}", " ".repeat(bytes as usize)),
        );
        callers_of(&folder, "large.urdf")
    };
    assert_eq!((found(CALLER_BYTES / 2), found(CALLER_BYTES)), (1, 0));
}

#[test]
fn caller_folders() {
    let folder = folder();
    write(&folder, "a/r.launch", "far.urdf");
    assert_eq!(callers_of(&folder, "far.urdf"), 1);
    for n in 0..=CALLER_FOLDERS {
        fs::create_dir(folder.join(format!("f{n}"))).unwrap();
    }
    // those that are listed last are searched first
    assert_eq!(callers_of(&folder, "far.urdf"), 0);
    // a folder that a tool made counts as one, whatever is in it
    write(&folder, "b/CACHEDIR.TAG", "");
    write(&folder, "b/r.launch", "made.urdf");
    assert_eq!(callers_of(&folder.join("b"), "made.urdf"), 0);
    let _ = fs::remove_dir_all(folder);
}

#[test]
fn caller_files() {
    let folder = folder();
    for n in 0..3 {
        write(&folder, &format!("{n}/r.launch"), "many.urdf");
    }
    assert_eq!(callers_of(&folder, "many.urdf"), 3);
    for n in 0..=CALLER_FILES {
        write(&folder, &format!("0/{n}.md"), "");
    }
    // the folders are read one by one: how many came before the limit depends on the order
    assert!(callers_of(&folder, "many.urdf") < 3);
    let _ = fs::remove_dir_all(folder);
}

/// The calls of robots that a launch file makes, as text.
fn launched(name: &str, text: &str) -> Vec<String> {
    let file = launch::read(Path::new(name), text);
    let shown = |call: launch::LaunchCall| {
        let args = call
            .args
            .iter()
            .map(|arg| format!(" {}={}", arg.name, arg.value.shown()));
        format!("{}{}", call.file.shown(), args.collect::<String>())
    };
    file.iter().flat_map(launch::calls).map(shown).collect()
}

#[test]
fn launch_calls() {
    let text = |count: usize| {
        (0..count)
            .map(|n| format!("xacro r.xacro n:={n}\n"))
            .collect::<String>()
    };
    assert_eq!(launched("a.sh", &text(LAUNCH_CALLS)).len(), LAUNCH_CALLS);
    assert_eq!(
        launched("a.sh", &text(LAUNCH_CALLS + 1)).len(),
        LAUNCH_CALLS
    );
}

#[test]
fn caller_calls() {
    let folder = folder();
    let text: String = (0..LAUNCH_CALLS)
        .map(|n| format!("xacro r.xacro n:={n}\n"))
        .collect();
    for n in 0..=CALLER_CALLS / LAUNCH_CALLS {
        write(&folder, &format!("{n}.sh"), &text);
    }
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    let packages = Packages::new(vfs, &env, PackageOptions::default());
    assert_eq!(
        Callers::default().calls_below(&folder, &packages).len(),
        CALLER_CALLS
    );
}

#[test]
fn launch_includes() {
    let folder = folder();
    write(
        &folder,
        "0.launch",
        "<launch><arg name='a'/><param name='d' command='xacro r.xacro a:=$(arg a)'/></launch>",
    );
    let levels = LAUNCH_INCLUDES + 1;
    for n in 1..=levels {
        let give = if n == 1 {
            "1".to_owned()
        } else {
            "$(arg a)".to_owned()
        };
        let value = if n == levels { "deep" } else { &give };
        let below = n - 1;
        write(
            &folder,
            &format!("{n}.launch"),
            format!(
                "<launch><arg name='a'/><include file='$(dirname)/{below}.launch'><arg name='a' value='{value}'/></include></launch>"
            ),
        );
    }
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    let packages = Packages::new(vfs, &env, PackageOptions::default());
    let calls = Callers::default().calls_below(&folder, &packages);
    let most = calls.iter().map(|call| call.call.through.len()).max();
    assert!(most.is_some_and(|most| most <= LAUNCH_INCLUDES), "{most:?}");
}

#[test]
fn launch_steps() {
    let text = |lines: usize| {
        format!(
            "{}Command('xacro r.xacro')",
            "x = [1, 2, 3]\n".repeat(lines)
        )
    };
    assert_eq!(launched("a.py", &text(10)), ["r.xacro"]);
    assert_eq!(launched("a.py", &text(LAUNCH_STEPS / 4)), [""; 0]);
}

#[test]
fn launch_depth() {
    let text = |depth: usize| {
        let group = "<group>".repeat(depth);
        format!(
            "<launch>{group}<param command='xacro r.xacro'/>{}</launch>",
            "</group>".repeat(depth)
        )
    };
    assert_eq!(launched("a.launch", &text(LAUNCH_DEPTH)), ["r.xacro"]);
    assert_eq!(launched("a.launch", &text(LAUNCH_DEPTH + 1)), [""; 0]);
}

#[test]
fn launch_call_depth() {
    let text = |depth: usize| {
        let mut text = "def f0():\n    return 'r.xacro'\n".to_owned();
        for n in 1..depth {
            text.push_str(&format!("def f{n}():\n    return f{}()\n", n - 1));
        }
        format!("{text}Command(['xacro ', f{}()])\n", depth - 1)
    };
    assert_eq!(launched("a.py", &text(LAUNCH_CALL_DEPTH)), ["r.xacro"]);
    assert_eq!(launched("a.py", &text(LAUNCH_CALL_DEPTH + 1)), ["?"]);
}

#[test]
fn launch_pieces() {
    let text = |count: usize| {
        let pieces = "LaunchConfiguration('a'), ".repeat(count);
        format!(
            "DeclareLaunchArgument('a', default_value='b')\nCommand(['xacro r.xacro x:=', {pieces}])\n"
        )
    };
    assert_eq!(
        launched("a.py", &text(10)),
        [format!("r.xacro x={}", "b".repeat(10))]
    );
    assert_eq!(launched("a.py", &text(LAUNCH_PIECES)), [""; 0]);
}

#[test]
fn launch_text() {
    let text = |len: usize| {
        format!(
            "a = '{}'\nCommand(['xacro r.xacro x:=', a])\n",
            "b".repeat(len)
        )
    };
    assert_eq!(
        launched("a.py", &text(10)),
        [format!("r.xacro x={}", "b".repeat(10))]
    );
    assert_eq!(launched("a.py", &text(LAUNCH_TEXT)), [""; 0]);
    // what doubles with each line
    let doubles = format!(
        "a = 'xx'\n{}Command(['xacro r.xacro x:=', a])\n",
        "a = a + a\n".repeat(100)
    );
    assert_eq!(launched("a.py", &doubles), ["r.xacro x=?"]);
}

#[test]
fn manifest_nodes() {
    let found = |count: usize| {
        let folder = folder();
        let filler = "<a/>".repeat(count);
        write(
            &folder,
            "far/package.xml",
            MANIFEST.replace("</package>", &format!("{filler}</package>")),
        );
        let env = Environment {
            vars: BTreeMap::new(),
            cwd: folder.clone(),
            ..Environment::default()
        };
        let options = PackageOptions {
            explicit: vec![folder.clone()],
            ..PackageOptions::default()
        };
        let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
        Packages::new(vfs, &env, options)
            .find("far", &folder.join("r.urdf"))
            .is_ok()
    };
    // its name counts all the same
    assert_eq!((found(1000), found(MANIFEST_NODES as usize)), (true, true));
}

/// Whether a mesh is found where a `CMakeLists.txt` installs it that says something else before.
fn installed_behind(before: &str) -> bool {
    let folder = folder();
    let install = "install(DIRECTORY description/meshes DESTINATION share/near)";
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    write(
        &folder,
        "CMakeLists.txt",
        before.replace("INSTALL", install),
    );
    write(&folder, "description/meshes/a.stl", "");
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    Packages::new(vfs, &env, PackageOptions::default())
        .built(&folder.join("meshes/a.stl"))
        .is_some()
}

#[test]
fn build_bytes() {
    let behind =
        |count: usize| installed_behind(&format!("{} INSTALL", "set(a bbbbbbb)\n".repeat(count)));
    assert_eq!(
        (behind(100), behind(BUILD_BYTES as usize / 10)),
        (true, false)
    );
}

#[test]
fn build_depth() {
    let below = |levels: usize| {
        installed_behind(&format!(
            "{} INSTALL {}",
            "foreach(a b)\n".repeat(levels),
            "endforeach()\n".repeat(levels)
        ))
    };
    assert_eq!(
        (below(BUILD_DEPTH as usize), below(BUILD_DEPTH as usize + 1)),
        (true, false)
    );
    let nested = format!("share/near', {}", "[".repeat(1_000_000));
    let folder = folder();
    write(&folder, "package.xml", MANIFEST.replace("far", "near"));
    write(&folder, "setup.py", format!("x = ('{nested}"));
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 24, folder.clone()));
    assert!(
        Packages::new(vfs, &env, PackageOptions::default())
            .built(&folder.join("a.stl"))
            .is_none()
    );
}

/// Makes a hundred thousand folders and twenty thousand files: run it by `cargo test --test limits -- --ignored`.
#[test]
#[ignore = "makes 100,000 folders"]
fn many_folders() {
    let folder = folder();
    write(&folder, "r.urdf", robot(LINK));
    for n in 0..SCAN_FOLDERS + 5_000 {
        let group = folder.join((n / 1000).to_string());
        if n % 1000 == 0 {
            fs::create_dir(&group).unwrap();
        }
        let path = group.join(n.to_string());
        fs::create_dir(&path).unwrap();
        if n % 5 == 0 {
            fs::write(path.join("x.urdf"), "<robot name=\"x\"/>").unwrap();
        }
    }
    let env = Environment {
        vars: BTreeMap::new(),
        cwd: folder.clone(),
        ..Environment::default()
    };
    let options = PackageOptions {
        explicit: vec![folder.clone()],
        ..PackageOptions::default()
    };
    let vfs = Arc::new(Vfs::with_cwd(1 << 20, folder.clone()));
    let packages = Packages::new(vfs.clone(), &env, options);
    // packages of the other tests lie in the same workspace
    assert!(packages.find("nowhere", &folder.join("r.urdf")).is_err());
    assert!(
        packages
            .namesake(
                &folder.join("gone.stl"),
                Some(&folder),
                &folder.join("r.urdf")
            )
            .is_none()
    );
    let mut host = xacro_lsp::analysis::AnalysisHost::new(env, vec![folder.clone()]);
    while host.scan(|| false).is_some() {}
    assert!(
        host.known_files().len() <= SCAN_FILES + 1,
        "{}",
        host.known_files().len()
    );
    let _ = fs::remove_dir_all(folder);
}

fn mesh_defect(ending: &str, bytes: &[u8]) -> String {
    Mesh::read(ending, bytes, &|_| None)
        .defect
        .map(|defect| defect.message)
        .unwrap_or_default()
}

#[test]
fn mesh_triangles() {
    let text = format!(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n{}",
        "f 1 2 3\n".repeat(MESH_TRIANGLES + 1)
    );
    assert_eq!(
        mesh_defect("obj", text.as_bytes()),
        "line 2500004: it has more than 2500000 triangles"
    );
}

#[test]
fn mesh_nodes() {
    let text = format!("<COLLADA>{}</COLLADA>", "<a/>".repeat(MESH_NODES as usize));
    assert_eq!(
        mesh_defect("dae", text.as_bytes()),
        "it has more than 4000000 nodes"
    );
}

#[test]
fn mesh_files() {
    let libraries: String = (0..MESH_FILES + 500)
        .map(|n| format!("mtllib {n}.mtl\n"))
        .collect();
    let text = format!("{libraries}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(
        Mesh::read("obj", text.as_bytes(), &|_| None)
            .dependencies
            .len(),
        MESH_FILES
    );
}

#[test]
fn message_letters() {
    let name = "n".repeat(50_000);
    let said = check(
        &format!(
            "<joint name=\"{name}\" type=\"fixed\"><parent link=\"{name}p\"/><child link=\"{name}c\"/></joint>"
        ),
        &[],
    );
    let longest = said
        .lines()
        .filter(|line| line.starts_with("error["))
        .map(str::len)
        .max()
        .unwrap();
    assert!(
        (MESSAGE_LETTERS..MESSAGE_LETTERS + 100).contains(&longest),
        "{longest}"
    );
}

#[test]
fn drawn_line() {
    let said = check(&format!("{}<link/>", " ".repeat(DRAWN_LINE)), &[]);
    assert!(
        said.contains(&format!("r.urdf.xacro:2:{}", DRAWN_LINE + 1)),
        "{said}"
    );
    assert!(said.len() < DRAWN_LINE, "{}", said.len());
}

#[test]
fn findings_of_a_rule() {
    // one line, so that it is seen too that a long line is not taken apart for each of them
    let folder = folder();
    write(
        &folder,
        "r.urdf",
        format!(
            "<robot name=\"r\">{LINK}{}</robot>",
            "<a/>".repeat(FINDINGS_OF_A_RULE + 10)
        ),
    );
    let said = run(
        &folder,
        &["check", "--statistics", "r.urdf"],
        &mut std::io::empty(),
    );
    assert!(
        said.contains(&format!("{FINDINGS_OF_A_RULE}  hint")),
        "{said}"
    );
}

#[test]
fn drawn_of_a_rule() {
    let links: String = (0..150)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    let said = check(&links, &[]);
    assert_eq!(
        said.matches("[undefined-property]").count(),
        DRAWN_OF_A_RULE,
        "{said}"
    );
    assert!(said.contains("145 more not shown"), "{said}");
}

#[test]
fn drawn_in_all() {
    let folder = folder();
    for file in 0..4 {
        let link = |n: usize| format!("<link name=\"${{gone{file}_{n}}}\"/>\n");
        let links: String = (0..DRAWN_OF_A_RULE).map(link).collect();
        write(&folder, &format!("r{file}.urdf.xacro"), robot(&links));
    }
    let said = run(&folder, &["check", "."], &mut std::io::empty());
    assert_eq!(
        said.matches("[undefined-property]").count(),
        DRAWN_IN_ALL,
        "{said}"
    );
    let all = run(
        &folder,
        &["check", "--show", "all", "."],
        &mut std::io::empty(),
    );
    assert_eq!(
        all.matches("[undefined-property]").count(),
        4 * DRAWN_OF_A_RULE,
        "{all}"
    );
}

#[test]
fn drawn_problems() {
    let links: String = (0..150)
        .map(|n| format!("<link name=\"${{gone{n}}}\"/>\n"))
        .collect();
    let folder = folder();
    write(&folder, "r.urdf.xacro", robot(&links));
    let said = run(&folder, &["expand", "r.urdf.xacro"], &mut std::io::empty());
    assert_eq!(
        said.matches("error: name 'gone").count(),
        DRAWN_PROBLEMS,
        "{said}"
    );
}

const SMALL: &str = "Content-Length: 30\r\n\r\n{\"jsonrpc\":\"2.0\",\"method\":\"x\"}";

#[test]
fn message_bytes() {
    let said = |length: u64| {
        server::reframe(format!("Content-Length: {length}\r\n\r\n{SMALL}").as_bytes())
    };
    assert_eq!(
        said(MESSAGE_BYTES + 1),
        SMALL.as_bytes(),
        "a header that claims too much is none"
    );
    assert_eq!(
        said(MESSAGE_BYTES),
        b"",
        "the rest of the message is waited for"
    );
}

#[test]
fn header_bytes() {
    let line = "x".repeat(HEADER_BYTES as usize * 3);
    assert_eq!(
        server::reframe(format!("{line}\r\n{SMALL}").as_bytes()),
        SMALL.as_bytes()
    );
}

#[test]
fn files_beside() {
    let folder = folder();
    write(
        &folder,
        "package.xml",
        "<package><name>arm</name></package>",
    );
    write(
        &folder,
        "urdf/arm.urdf",
        "<robot name=\"arm\"><link name=\"base\"/></robot>",
    );
    let srdf = "<robot name=\"arm\"><group name=\"all\"><link name=\"base\"/><link name=\"hand\"/></group></robot>";
    for n in 0..FILES_BESIDE {
        write(&folder, &format!("config/arm_{n}.srdf"), srdf);
    }
    let reported = || {
        let arguments = ["check", "--no-group", "--format", "json", "."];
        let said = run(&folder, &arguments, &mut std::io::empty());
        said.matches("unknown link `hand`").count()
    };
    assert_eq!(reported(), FILES_BESIDE);
    write(&folder, "config/more.srdf", srdf);
    assert_eq!(reported(), 0);
    let _ = fs::remove_dir_all(folder);
}
