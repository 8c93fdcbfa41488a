//! The command line, as transcripts: `tests/cli/*.txt` hold commands with what they print. Those of the pages are run by
//! `tests/docs`.
//!
//! A transcript begins with the folder it is run in: `cd FOLDER`, or `copy FOLDER` when the commands change it.
//! `UPDATE=1` writes the answers again.
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
    let (line, input) = line
        .split_once(" < ")
        .map_or((line, ""), |(line, input)| (line, input));
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        cwd.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: cwd.to_owned(),
        ..Environment::default()
    };
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

/// The transcript with all answers made again.
fn rerun(transcript: &str) -> String {
    let (head, _) = transcript.split_once('\n').unwrap();
    let cwd = match head.split_once(' ').unwrap() {
        // a shell knows no `..` in the folder it is in
        ("cd", name) => folder().join(name).canonicalize().unwrap(),
        (_, name) => copy(&folder().join(name)),
    };
    let mut new = format!("{head}\n");
    for line in transcript
        .lines()
        .filter_map(|line| line.strip_prefix("$ "))
    {
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
    let new = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("cli")
        .join(folder.file_name().unwrap());
    let _ = fs::remove_dir_all(&new);
    copy_into(folder, &new);
    new
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

#[test]
fn transcripts() {
    let mut wrong = Vec::new();
    let mut paths: Vec<PathBuf> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "txt"));
    paths.sort();
    assert!(!paths.is_empty());
    for path in paths {
        let stored = fs::read_to_string(&path).unwrap();
        let new = rerun(&stored);
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&path, &new).unwrap();
        } else if new != stored {
            let line = new
                .lines()
                .zip(stored.lines())
                .position(|(a, b)| a != b)
                .unwrap_or(0);
            let (got, want) = (
                new.lines().nth(line).unwrap_or(""),
                stored.lines().nth(line).unwrap_or(""),
            );
            wrong.push(format!(
                "{}:{}: got\n{got}\nwant\n{want}",
                path.display(),
                line + 1
            ));
        }
    }
    assert!(
        wrong.is_empty(),
        "{}\n(UPDATE=1 writes the answers anew)",
        wrong.join("\n\n")
    );
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Compare a stored file with what it should hold, or write it.
fn up_to_date(path: &Path, new: &str) {
    if std::env::var_os("UPDATE").is_some() {
        fs::write(path, new).unwrap();
    }
    let stored = fs::read_to_string(path).unwrap_or_default();
    assert!(
        stored == new,
        "{} is old: run `UPDATE=1 cargo test --test cli`",
        path.display()
    );
}

/// A page with the part between the comments of `name` made again.
fn with_part(page: &str, name: &str, part: &str) -> String {
    let begin = page.find(&format!("<!-- {name}: ")).unwrap();
    let begin = begin + page[begin..].find('\n').unwrap() + 1;
    let end = page.find(&format!("<!-- end of {name} -->")).unwrap();
    format!("{}{part}{}", &page[..begin], &page[end..])
}

/// Rows for the keys of a schema; those of tables have the name of the table in front.
fn key_rows(schema: &serde_json::Value, prefix: &str) -> String {
    let mut rows = String::new();
    for (name, of) in schema["properties"].as_object().unwrap() {
        let name = format!("{prefix}{name}");
        rows.push_str(&format!(
            "| `{name}` | {} | {} |\n",
            kind(of),
            of["description"].as_str().unwrap()
        ));
        let inner = if of["properties"].is_object() {
            of
        } else {
            &of["items"]
        };
        if inner["properties"].is_object() {
            rows.push_str(&key_rows(inner, &format!("{name}.")));
        }
    }
    rows
}

fn kind(of: &serde_json::Value) -> String {
    if let Some(values) = of["enum"].as_array() {
        return values
            .iter()
            .map(|value| format!("`{value}`"))
            .collect::<Vec<_>>()
            .join(", ");
    }
    match of["type"].as_str() {
        Some("array") if of["items"]["properties"].is_object() => "list of tables".to_owned(),
        Some("array") => format!("list of {}", several(&kind(&of["items"]))),
        Some("object") if of["additionalProperties"].is_object() => {
            format!("table of {}", several(&kind(&of["additionalProperties"])))
        }
        Some("object") => "table".to_owned(),
        Some(name) => name.to_owned(),
        None => "string, number or boolean".to_owned(),
    }
}

/// `strings`, but also `lists of strings`.
fn several(kind: &str) -> String {
    match kind.split_once(' ') {
        Some((first @ ("list" | "table"), rest)) => format!("{first}s {rest}"),
        Some(_) => kind.to_owned(),
        None if kind.starts_with('`') => kind.to_owned(),
        None => format!("{kind}s"),
    }
}

#[test]
fn pages_are_up_to_date() {
    let schema = xacro_lsp::workspace::config::schema();
    up_to_date(
        &repository().join("docs/xacro-lint.schema.json"),
        &format!("{schema:#}\n"),
    );
    let page = |name: &str| {
        let path = repository().join("docs").join(name);
        (fs::read_to_string(&path).unwrap(), path)
    };
    let (text, path) = page("configuration.md");
    let keys = format!(
        "\n| key | type | meaning |\n|---|---|---|\n{}\n",
        key_rows(&schema, "")
    );
    up_to_date(&path, &with_part(&text, "keys", &keys));
    let (text, path) = page("cli.md");
    up_to_date(
        &path,
        &with_part(&text, "commands", &format!("{}\n", cli::reference())),
    );
}

#[test]
fn the_settings_that_are_printed_are_a_configuration() {
    let cwd = folder().join("presets");
    let printed = answer("config", &cwd)
        .lines()
        .filter(|line| !line.starts_with("["))
        .collect::<Vec<_>>()
        .join("\n");
    let copied = copy(&folder().join("library"));
    fs::write(copied.join("xacro-lint.toml"), &printed).unwrap();
    let again = answer("config --format json", &copied);
    let values = |text: &str| -> Vec<serde_json::Value> {
        let json = text
            .lines()
            .take_while(|line| !line.starts_with("[stderr]"))
            .collect::<String>();
        let parsed: serde_json::Value = serde_json::from_str(&json).unwrap();
        parsed["settings"]
            .as_object()
            .unwrap()
            .values()
            .map(|setting| setting["value"].clone())
            .collect()
    };
    assert_eq!(
        values(&again),
        values(&answer("config --format json", &cwd))
    );
}
