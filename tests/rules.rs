//! The pages of `docs/rules/` are the tests of the rules: each block is checked as it stands, and a bad one
//! yields exactly its rule at its markers.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

#[path = "rules/helps.rs"]
mod helps;
mod meshes;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::{self, CheckOptions, Overrides, Position, Report, Session, Setup};
use xacro_lsp::rules::{self, Category, Rule, Severity};
use xacro_lsp::vfs::Environment;

/// A fenced block of a page.
struct Block {
    /// `xacro` or `urdf`.
    kind: String,
    bad: bool,
    /// The severity of its findings, where it is not the rule's own: ```urdf,bad,info
    severity: Option<Severity>,
    /// Saved in Latin-1, not in UTF-8.
    latin_1: bool,
    /// Line of the page.
    line: usize,
    lines: Vec<String>,
}

/// A place: file, row, first and last column (exclusive).
type Place = (String, u32, u32, u32);

fn pages() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/rules")
}

fn blocks(rule: &Rule) -> Vec<Block> {
    let mut found: Vec<Block> = Vec::new();
    let mut inside = false;
    for (i, line) in rule.docs.lines().enumerate() {
        match line.strip_prefix("```") {
            Some("") => inside = false,
            Some(info) => {
                let (info, latin_1) = info
                    .split_once(",latin-1")
                    .map_or((info, false), |(info, _)| (info, true));
                let (kind, verdict) = info
                    .split_once(',')
                    .unwrap_or_else(|| panic!("{}: `{info}`", rule.name));
                let (verdict, severity) =
                    verdict
                        .split_once(',')
                        .map_or((verdict, None), |(verdict, name)| {
                            (
                                verdict,
                                Some(
                                    Severity::from_name(name)
                                        .unwrap_or_else(|| panic!("{}: `{info}`", rule.name)),
                                ),
                            )
                        });
                assert!(
                    ["bad", "good"].contains(&verdict),
                    "{}: `{info}`",
                    rule.name
                );
                let block = Block {
                    kind: kind.to_owned(),
                    bad: verdict == "bad",
                    severity,
                    latin_1,
                    line: i + 1,
                    lines: Vec::new(),
                };
                found.push(block);
                inside = true;
            }
            None if inside => found.last_mut().unwrap().lines.push(line.to_owned()),
            None => {}
        }
    }
    found
}

/// The files of a block, the one to check first, and the places its markers point at.
fn files(block: &Block) -> (Vec<(String, String)>, Vec<Place>) {
    let mut files: Vec<(String, Vec<&str>)> = vec![(format!("robot.{}", block.kind), Vec::new())];
    let mut places = Vec::new();
    for line in &block.lines {
        let (name, lines) = files.last_mut().unwrap();
        if let Some(next) = line.strip_prefix("//- ") {
            // the block begins with a name of its own
            if lines.is_empty() && files.len() == 1 {
                files.pop();
            }
            files.push((next.to_owned(), Vec::new()));
        } else if line.contains('^') && line.chars().all(|c| c == ' ' || c == '^') {
            let start = line.find('^').unwrap() as u32 + 1;
            let row = lines.len() as u32;
            places.push((name.clone(), row, start, line.chars().count() as u32 + 1));
        } else {
            lines.push(line);
        }
    }
    let text = |lines: Vec<&str>| lines.iter().map(|line| format!("{line}\n")).collect();
    (
        files
            .into_iter()
            .map(|(name, lines)| (name, text(lines)))
            .collect(),
        places,
    )
}

/// Write the files of a block into a folder of its own; the file to check, and the places of the markers.
fn write(rule: &Rule, number: usize, block: &Block, folder: &Path) -> (PathBuf, Vec<Place>) {
    let folder = folder.join(rule.name).join(number.to_string());
    let _ = fs::remove_dir_all(&folder);
    // a repository of its own: nothing is read of folders above
    fs::create_dir_all(folder.join(".git")).unwrap();
    let (files, places) = files(block);
    for (name, text) in &files {
        // `//- part.stl: box 0.1` is a binary mesh
        let (name, mesh) = name
            .split_once(": ")
            .map_or((name.as_str(), None), |(name, mesh)| (name, Some(mesh)));
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let latin_1 = || text.chars().map(|c| u8::try_from(c).unwrap()).collect();
        let text = || {
            if block.latin_1 {
                latin_1()
            } else {
                text.clone().into_bytes()
            }
        };
        fs::write(path, mesh.map_or_else(text, meshes::binary_stl)).unwrap();
    }
    (folder.join(&files[0].0), places)
}

/// A session in a folder, with one rule in addition to the default ones.
fn session(rule: &Rule, folder: &Path) -> Session {
    let vars = BTreeMap::from([(
        "AMENT_PREFIX_PATH".to_owned(),
        folder.join("none").display().to_string(),
    )]);
    let env = Environment {
        vars,
        cwd: folder.to_owned(),
        ..Environment::default()
    };
    let extend_select = Some(vec![rule.name.to_owned()]);
    let overrides = Overrides {
        extend_select,
        ..Overrides::default()
    };
    Session::new(
        &env,
        Setup {
            about: folder.to_owned(),
            overrides,
            ..Setup::default()
        },
    )
    .unwrap()
}

/// What is found in a file, with one rule in addition to the default ones.
fn report(rule: &Rule, folder: &Path, file: &Path) -> Report {
    let session = session(rule, folder);
    // launch files are checked with the folder that they are in
    let path = if folder.join("launch").is_dir() && rule.code.starts_with("PKG") {
        folder
    } else {
        file
    };
    let options = CheckOptions {
        paths: vec![path.to_owned()],
        ..CheckOptions::default()
    };
    let report = analysis::check(&session, &options);
    assert!(report.unreadable.is_empty());
    report
}

/// Check a block: findings by rule name with their places.
fn check(
    rule: &Rule,
    number: usize,
    block: &Block,
) -> (Vec<(&'static str, Severity, Place)>, Vec<Place>) {
    let pages = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rules");
    let (file, places) = write(rule, number, block, &pages);
    let folder = pages.join(rule.name).join(number.to_string());
    let report = report(rule, &folder, &file);
    let findings = report.findings.iter().map(|finding| {
        let Position { start, end } = report.position(finding.span);
        let path = report
            .path(finding.span.file)
            .strip_prefix(&folder)
            .unwrap()
            .display()
            .to_string();
        (
            finding.rule.name,
            finding.severity,
            (path, start.0, start.1, end.1.max(start.1 + 1)),
        )
    });
    (findings.collect(), places)
}

#[test]
fn every_block_says_what_it_should() {
    let mut wrong = Vec::new();
    for rule in rules::all() {
        let blocks = blocks(rule);
        assert!(
            blocks.iter().any(|b| b.bad) && blocks.iter().any(|b| !b.bad),
            "{} needs both kinds",
            rule.name
        );
        for (number, block) in blocks.iter().enumerate() {
            let (findings, expected) = check(rule, number, block);
            let place = format!("docs/rules/{}.md:{}", rule.name, block.line);
            assert_eq!(
                block.bad,
                !expected.is_empty(),
                "{place}: bad blocks have markers, good ones none"
            );
            let own: Vec<&Place> = findings
                .iter()
                .filter(|f| f.0 == rule.name)
                .map(|f| &f.2)
                .collect();
            if own != expected.iter().collect::<Vec<_>>() {
                wrong.push(format!("{place}: found {own:?}, expected {expected:?}"));
            }
            let expected = block.severity.unwrap_or(rule.severity);
            for (name, severity, at) in &findings {
                if *name == rule.name && *severity != expected {
                    wrong.push(format!(
                        "{place}: {severity} at {at:?}, expected {expected}"
                    ));
                }
                if *name != rule.name && *severity >= Severity::Warning {
                    wrong.push(format!("{place}: {name} at {at:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Put the fixes of a rule into the files; how many there are.
fn apply_fixes(rule: &Rule, report: &Report) -> usize {
    let own = report
        .findings
        .iter()
        .filter(|finding| finding.rule.name == rule.name);
    let fixes: Vec<_> = own.filter_map(|finding| finding.fix.as_ref()).collect();
    let mut edits: Vec<_> = fixes.iter().flat_map(|fix| &fix.edits).collect();
    edits.sort_by_key(|edit| (edit.span.file, edit.span.range.start, edit.span.range.end));
    edits.dedup();
    for edit in edits.into_iter().rev() {
        let path = report.path(edit.span.file);
        let mut text = fs::read_to_string(path).unwrap();
        text.replace_range(
            edit.span.range.start as usize..edit.span.range.end as usize,
            &edit.content,
        );
        fs::write(path, text).unwrap();
    }
    fixes.len()
}

/// Rules whose fix needs what no page can hold: the absolute path of a file that exists.
const WITHOUT_EXAMPLE: &[&str] = &["absolute-mesh-path"];

#[test]
fn fixes_fix_what_they_are_offered_for() {
    let mut wrong = Vec::new();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fixes");
    for rule in rules::all() {
        let blocks = blocks(rule);
        let mut shown = 0;
        for (number, block) in blocks
            .iter()
            .enumerate()
            .filter(|(_, block)| block.bad && !block.latin_1)
        {
            let (file, _) = write(rule, number, block, &folder);
            let folder = folder.join(rule.name).join(number.to_string());
            let fixed = apply_fixes(rule, &report(rule, &folder, &file));
            shown += fixed;
            let place = format!("docs/rules/{}.md:{}", rule.name, block.line);
            if fixed > 0 && rule.fix.is_none() {
                wrong.push(format!("{place}: a fix that the headline does not promise"));
            }
            let after = report(rule, &folder, &file);
            let left = after
                .findings
                .iter()
                .filter(|finding| finding.rule.name == rule.name);
            if fixed > 0 && left.filter(|finding| finding.fix.is_some()).count() > 0 {
                wrong.push(format!("{place}: still found after the fix"));
            }
        }
        if shown == 0 && rule.fix.is_some() && !WITHOUT_EXAMPLE.contains(&rule.name) {
            wrong.push(format!(
                "docs/rules/{}.md: no example for the fix",
                rule.name
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn pages_have_their_shape() {
    const HEADINGS: [&str; 6] = [
        "## Why",
        "## Reported",
        "## Not reported",
        "## How to fix it",
        "## When to allow it",
        "## Source",
    ];
    for rule in rules::all() {
        let mut lines = rule.docs.lines();
        assert_eq!(lines.next(), Some(format!("# {}", rule.name).as_str()));
        assert_eq!(
            lines.nth(1),
            Some(rule.headline().as_str()),
            "{}",
            rule.name
        );
        let headings: Vec<&str> = rule
            .docs
            .lines()
            .filter(|line| line.starts_with("## "))
            .collect();
        assert_eq!(headings, HEADINGS, "{}", rule.name);
        assert!(
            !rule.summary().is_empty() && rule.docs.ends_with('\n'),
            "{}",
            rule.name
        );
    }
}

#[test]
fn every_page_has_a_rule_and_codes_are_unique() {
    let codes: Vec<&str> = rules::all().map(|rule| rule.code).collect();
    let mut sorted = codes.clone();
    sorted.sort_unstable();
    sorted.dedup();
    assert_eq!(sorted.len(), codes.len());
    for entry in fs::read_dir(pages()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let Some(name) = name.strip_suffix(".md").filter(|name| *name != "README") else {
            continue;
        };
        assert!(
            rules::all().any(|rule| rule.name == name),
            "docs/rules/{name}.md has no rule"
        );
    }
}

/// The table of all rules.
fn index() -> String {
    let mut text = String::from(
        "# Rules\n\n<!-- written by UPDATE=1 cargo test --test rules -->\n\nA rule is named by its name (`orphan-link`), its code \
         (`STR008`) or the beginning of its code (`STR`).\n`xacro-lint explain NAME` prints its page.\n",
    );
    for category in Category::ALL {
        if !rules::all().any(|rule| rule.category == category) {
            continue;
        }
        text.push_str(&format!(
            "\n## {}\n\n| code | name | severity | default | fix |\n|---|---|---|---|---|\n",
            category.title()
        ));
        for rule in rules::all().filter(|rule| rule.category == category) {
            let fix = rule.fix.map_or("", |safety| safety.name());
            let Rule {
                code,
                name,
                severity,
                default,
                ..
            } = rule;
            text.push_str(&format!(
                "| {code} | [{name}]({name}.md) | {severity} | {default} | {fix} |\n"
            ));
        }
    }
    text
}

#[test]
fn index_and_catalogue_are_up_to_date() {
    for (name, text) in [("README.md", index()), ("rules.json", rules::catalogue())] {
        let path = pages().join(name);
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&path, &text).unwrap();
        }
        let stored = fs::read_to_string(&path).unwrap_or_default();
        assert_eq!(
            stored, text,
            "docs/rules/{name} is old: run `UPDATE=1 cargo test --test rules`"
        );
    }
}

/// The setting `xacro.diagnostics.rules` of the VS Code extension: an editor of settings offers the names in it.
fn setting() -> String {
    let values = serde_json::json!(["error", "warning", "info", "hint", "off"]);
    let mut text = String::from(
        r#""xacro.diagnostics.rules": {
            "type": "object",
            "scope": "resource",
            "default": {},
            "markdownDescription": "Severity of rules by name, code or code prefix, for example `{ \"unused-property\": \"off\", \"NAM\": \"hint\" }`.",
            "properties": {
"#,
    );
    let mut rules: Vec<&Rule> = rules::all().collect();
    rules.sort_by_key(|rule| rule.name);
    let rows: Vec<String> = rules
        .iter()
        .map(|rule| {
            let Rule {
                name,
                code,
                severity,
                default,
                ..
            } = rule;
            let description = match default.to_string().as_str() {
                "on" => format!("{code}, {severity} by default"),
                other => format!("{code}, {severity}, {other} by default"),
            };
            format!("              \"{name}\": {{ \"enum\": {values}, \"description\": \"{description}\" }}")
        })
        .collect();
    text.push_str(&rows.join(",\n"));
    text.push_str(&format!(
        r#"
            }},
            "additionalProperties": {{ "enum": {values} }},
            "order": 1
          }}"#
    ));
    text
}

#[test]
fn the_setting_of_vs_code_has_all_rules() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("editors/vscode/package.json");
    let stored = fs::read_to_string(&path).unwrap();
    let begin = stored.find("\"xacro.diagnostics.rules\": {").unwrap();
    let end = begin + stored[begin..].find("\n          }").unwrap() + "\n          }".len();
    let made = format!("{}{}{}", &stored[..begin], setting(), &stored[end..]);
    if std::env::var_os("UPDATE").is_some() {
        fs::write(&path, &made).unwrap();
    }
    let stored = fs::read_to_string(&path).unwrap();
    assert!(
        stored == made,
        "editors/vscode/package.json is old: run `UPDATE=1 cargo test --test rules`"
    );
    serde_json::from_str::<serde_json::Value>(&stored).unwrap();
}
