//! What a session says after edits is what a fresh one says of the same texts.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // a test may fail loudly

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use xacro_lsp::analysis::AnalysisHost;
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::rules::Finding;
use xacro_lsp::vfs::Environment;

/// A session over a folder whose descriptions are all open.
struct Session {
    host: AnalysisHost,
    texts: BTreeMap<PathBuf, String>,
}

impl Session {
    fn over(folder: &Path, texts: &BTreeMap<PathBuf, String>) -> Self {
        let vars = BTreeMap::from([("AMENT_PREFIX_PATH".to_owned(), "/nowhere".to_owned())]);
        let env = Environment {
            vars,
            cwd: folder.to_owned(),
            ..Environment::default()
        };
        let mut host = AnalysisHost::new(env, vec![folder.to_owned()]);
        while host.scan(|| false).is_some() {}
        for (path, text) in texts {
            host.set_text(path, text.clone());
        }
        Self {
            host,
            texts: texts.clone(),
        }
    }

    fn edit(&mut self, path: &Path, start: usize, end: usize, new: &str) {
        self.host
            .edit(path, TextRange::new(start as u32, end as u32), new);
        self.texts
            .get_mut(path)
            .unwrap()
            .replace_range(start..end, new);
    }

    /// All findings of all open files.
    fn findings(&mut self) -> Vec<String> {
        let paths: Vec<PathBuf> = self.texts.keys().cloned().collect();
        let report = self.host.report(&paths, &CancelFlag::default()).unwrap();
        let mut shown: Vec<String> = report
            .findings
            .iter()
            .map(|finding| {
                format!(
                    "{} {}",
                    report.path(finding.span.file).display(),
                    line(finding)
                )
            })
            .collect();
        shown.sort();
        shown
    }
}

fn line(finding: &Finding) -> String {
    let span = finding.span.range;
    format!(
        "{}..{} {} {}",
        span.start, span.end, finding.rule.name, finding.message
    )
}

fn descriptions(folder: &Path, into: &mut BTreeMap<PathBuf, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            descriptions(&path, into);
        } else if path
            .extension()
            .is_some_and(|ending| ending == "xacro" || ending == "urdf")
        {
            into.insert(path.clone(), fs::read_to_string(&path).unwrap());
        }
    }
}

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        ((self.0 >> 33) % below.max(1) as u64) as usize
    }
}

/// Somewhere in a text, a few bytes long.
fn somewhere(dice: &mut Dice, text: &str) -> (usize, usize) {
    let boundary = |mut at: usize| {
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = boundary(dice.roll(text.len() + 1));
    (start, boundary((start + dice.roll(6)).min(text.len())))
}

#[test]
fn an_edited_session_says_what_a_fresh_one_says() {
    const NEW: [&str; 12] = [
        "",
        "x",
        "0",
        " ",
        "${",
        "}",
        "<link name=\"extra\"/>",
        "<",
        "\"",
        "-->",
        "<!-- words -->",
        "\n",
    ];
    for (seed, robot) in [
        "industrial_arm",
        "two_joint_gripper",
        "broken_cell",
        "measuring_cell",
    ]
    .iter()
    .enumerate()
    {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("docs/examples")
            .join(robot);
        let mut texts = BTreeMap::new();
        descriptions(&folder, &mut texts);
        let paths: Vec<PathBuf> = texts.keys().cloned().collect();
        assert!(!paths.is_empty(), "{robot}");
        let mut session = Session::over(&folder, &texts);
        session.findings();
        let mut dice = Dice(seed as u64 + 1);
        for round in 0..12 {
            // edits that are taken back now and then, so that texts do not rot
            let before = session.texts.clone();
            for _ in 0..1 + dice.roll(4) {
                let path = paths[dice.roll(paths.len())].clone();
                let (start, end) = somewhere(&mut dice, &session.texts[&path]);
                session.edit(&path, start, end, NEW[dice.roll(NEW.len())]);
            }
            let fresh = Session::over(&folder, &session.texts).findings();
            assert_eq!(session.findings(), fresh, "{robot}, round {round}");
            if round % 3 == 2 {
                for (path, text) in before {
                    session.host.set_text(&path, text.clone());
                    session.texts.insert(path, text);
                }
            }
        }
    }
}
