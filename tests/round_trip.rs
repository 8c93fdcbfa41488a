//! The way from the expanded text to its source and back: what a place came from made that place.
//!
//! The descriptions of this repository are gone through. `ROUND_TRIP` names others: a folder, whose descriptions are
//! all gone through, or a list with a robot a line: its file and `name:=value`, with tabs between. Packages are looked
//! for in the folder, or in that of the list, and in `ROS_PACKAGE_PATH`.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods,
    clippy::print_stdout
)] // a test may fail loudly, and says what it went through

use std::collections::{BTreeMap, HashMap};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use xacro_lsp::base::{Encoding, TextRange};
use xacro_lsp::expand::{
    Expansion, FileIdx, MapEntry, Request, Sources, Written, expand, write_mapped,
};
use xacro_lsp::ide;
use xacro_lsp::packages::{PackageOptions, Packages};
use xacro_lsp::vfs::{Environment, Vfs};

/// Failures that are printed of one robot.
const SHOWN: usize = 5;

/// A robot to go through.
struct Robot {
    file: PathBuf,
    args: Vec<(String, String)>,
}

/// All descriptions below a folder.
fn descriptions(folder: &Path, found: &mut Vec<Robot>) {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            descriptions(&path, found);
        } else if path
            .extension()
            .is_some_and(|ending| ending == "xacro" || ending == "urdf" || ending == "srdf")
        {
            found.push(Robot {
                file: path,
                args: Vec::new(),
            });
        }
    }
}

/// The robots of a list.
fn listed(list: &Path) -> Vec<Robot> {
    let text = fs::read_to_string(list).unwrap();
    let robot = |line: &str| {
        let mut words = line.split('\t');
        let file = list.with_file_name(words.next().unwrap());
        let args = words.filter_map(|word| word.split_once(":="));
        Robot {
            file,
            args: args
                .map(|(name, value)| (name.to_owned(), value.to_owned()))
                .collect(),
        }
    };
    text.lines()
        .filter(|line| !line.trim().is_empty())
        .map(robot)
        .collect()
}

/// One robot, and the way back from each source place, made once.
struct Ways<'a> {
    expansion: &'a Expansion,
    written: &'a Written,
    known: HashMap<(FileIdx, u32), Vec<TextRange>>,
}

impl Ways<'_> {
    /// What is wrong with the way from an entry to its source and back.
    fn check(&mut self, entry: &MapEntry) -> Result<(), String> {
        let Self {
            expansion, written, ..
        } = *self;
        let at = entry.out.start;
        let text: String = entry.out.slice(&written.text).chars().take(60).collect();
        // what is innermost there is what a client would be told
        let inner =
            ide::entry_at(written, at).ok_or_else(|| format!("nothing is known about `{text}`"))?;
        let place = expansion.place(ide::origin_of(expansion, inner));
        let place = place.ok_or_else(|| format!("`{text}` has no source"))?;
        let (file, start) = (place.file, place.range.start);
        let back = self.known.entry((file, start)).or_insert_with(|| {
            ide::instances(expansion, written, file, start)
                .into_iter()
                .map(|(out, _)| out)
                .collect()
        });
        if back.iter().any(|out| out.start <= at && at < out.end) {
            return Ok(());
        }
        let source = &expansion.files.get(file).unwrap().source;
        let position = source.document.line_col(start, Encoding::Utf8);
        let name = source
            .path
            .file_name()
            .unwrap()
            .to_string_lossy()
            .into_owned();
        let (line, column) = (position.line + 1, position.col + 1);
        Err(format!(
            "{:?} `{text}` comes from {name}:{line}:{column}, which does not lead back",
            entry.kind
        ))
    }
}

/// Go through robots whose packages lie in `folder`; the number of places.
fn round_trip(folder: &Path, robots: &[Robot]) -> usize {
    let vfs = Arc::new(Vfs::with_cwd(u64::MAX, folder.to_path_buf()));
    let vars = BTreeMap::from([
        ("HOME", "/home/user"),
        ("USER", "user"),
        ("ROS_VERSION", "2"),
    ]);
    let mut vars: BTreeMap<String, String> = vars
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value.to_owned()))
        .collect();
    if let Ok(path) = std::env::var("ROS_PACKAGE_PATH") {
        vars.insert("ROS_PACKAGE_PATH".to_owned(), path);
    }
    let env = Environment {
        vars,
        cwd: folder.to_path_buf(),
        ..Environment::default()
    };
    let options = PackageOptions {
        workspace_folders: vec![folder.to_path_buf()],
        ..PackageOptions::default()
    };
    let packages = Packages::new(vfs.clone(), &env, options);
    let (mut places, mut wrong) = (0, Vec::new());
    for Robot { file, args } in robots {
        let file = file.to_string_lossy().into_owned();
        let request = Request {
            file: file.clone(),
            args: args.clone(),
            ..Request::default()
        };
        let expansion = expand(
            Sources {
                vfs: &vfs,
                packages: &packages,
                env: &env,
            },
            &request,
        );
        let written = write_mapped(&expansion.tree, "");
        let mut ways = Ways {
            expansion: &expansion,
            written: &written,
            known: HashMap::new(),
        };
        let bad: Vec<String> = written
            .map
            .iter()
            .filter_map(|entry| ways.check(entry).err())
            .collect();
        places += written.map.len();
        if !bad.is_empty() {
            let shown: Vec<String> = bad
                .iter()
                .take(SHOWN)
                .map(|line| format!("\n  {line}"))
                .collect();
            wrong.push(format!(
                "{file} {args:?}: {} of {}{}",
                bad.len(),
                written.map.len(),
                shown.concat()
            ));
        }
    }
    println!(
        "{places} places of {} robots, {} robots with wrong ways",
        robots.len(),
        wrong.len()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    places
}

#[test]
fn what_a_place_came_from_made_that_place() {
    let mut robots = Vec::new();
    let Some(path) = std::env::var_os("ROUND_TRIP") else {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        for part in [
            "docs/examples",
            "tests/conformance",
            "tests/cli",
            "tests/preview/rig",
        ] {
            descriptions(&folder.join(part), &mut robots);
        }
        assert!(round_trip(folder, &robots) > 1000);
        return;
    };
    let path = fs::canonicalize(path).unwrap();
    if path.is_dir() {
        descriptions(&path, &mut robots);
        round_trip(&path, &robots);
    } else {
        round_trip(path.parent().unwrap(), &listed(&path));
    }
}
