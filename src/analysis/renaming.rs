//! Proof that a rename leaves every robot as it is, but for the name.
//!
//! All robots that read a changed file are expanded before and after: as their arguments say, with their presets, with each switch turned over, and with each condition of a changed file taken and not, one at a time.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ecow::EcoString;

use super::check_task::CheckTask;
use super::plan::apply;
use super::proof::{
    AffectedRobots, CONDITIONS, Changed, Effort, Trial, enclosing, turned_over, with_arguments,
};
use super::root_analysis::task_of;
use super::root_config::RootConfig;
use super::run_cache::{RunResult, RunSetting};
use super::session::Session;
use base::{CancelFlag, TextRange};
use expand::Forced;
use model::{other_difference, same_robot};
use xml::{Document, Node, NodeKind};

/// Decisions of conditions that change something, tried for one rename.
const MOST_FORCED: usize = 200;
/// Arguments of one robot that are switches and are turned over.
const MOST_SWITCHES: usize = 8;

/// Texts of files replaced, each file once.
pub type Replaced = Vec<(PathBuf, Vec<(TextRange, String)>)>;

/// What gets another name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NewName<'a> {
    /// A name of xacro: robots stay what they are.
    Xacro,
    /// An argument: who gives it gives it under the new name.
    Argument {
        /// Its name as it is.
        old: &'a str,
        /// Its name as it would be.
        new: &'a str,
    },
    /// A part of the names of links, joints and materials: these change, and nothing else.
    Robot {
        /// The part as it is.
        old: &'a str,
        /// The part as it would be.
        new: &'a str,
    },
}

/// A robot that would be another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Obstacle {
    /// Its file.
    pub robot: PathBuf,
    /// The condition under which it is: file, line, and whether it is taken; none: as the arguments say.
    pub condition: Option<(PathBuf, u32, bool)>,
    /// What would be different beside names, where that is known.
    pub difference: Option<String>,
}

/// The first of these robots that would be another one, or refused for other reasons, with texts replaced.
pub fn changed_robot(
    session: &Session,
    replaced: Replaced,
    roots: &[RootConfig],
    name: NewName<'_>,
    cancel: &CancelFlag,
) -> Option<Obstacle> {
    let changed = replaced.into_iter().filter_map(|(path, mut edits)| {
        edits.sort_by_key(|(range, _)| range.start);
        let source = session.vfs.document(&path).ok()?;
        let old = source.document.text();
        let new = apply(&old, &edits);
        Some(Changed {
            path: source.path.clone(),
            old,
            new,
            edits,
        })
    });
    let changed: Vec<Changed> = changed.collect();
    let effort = Effort {
        expansions: 0,
        roots: AffectedRobots::Known(Vec::new()),
        cancel: cancel.clone(),
    };
    let trial = Trial::new(session, changed.iter().collect(), &effort)?;
    let mut left = MOST_FORCED;
    roots
        .iter()
        .map(task_of)
        .find_map(|task| obstacle(&trial, &task, name, &mut left))
}

/// Whether a robot would be another one, and under which condition.
fn obstacle(
    trial: &Trial<'_>,
    task: &CheckTask,
    name: NewName<'_>,
    left: &mut usize,
) -> Option<Obstacle> {
    let plain = RunSetting {
        args: task.args.clone(),
        forced: Vec::new(),
    };
    let before = trial.run(task, &trial.session.vfs, &plain);
    if let Err(difference) = is_same(
        trial,
        &before,
        &renamed_run(trial, task, &plain, name),
        name,
    ) {
        return found(trial, task, None, difference);
    }
    for (path, at, forced) in conditions(trial, &before) {
        if *left == 0 || trial.effort.cancel.is_cancelled() {
            break;
        }
        let taken = forced.last().is_some_and(|forced| forced.taken);
        let setting = RunSetting {
            args: task.args.clone(),
            forced,
        };
        let forced = trial.run(task, &trial.session.vfs, &setting);
        // what changes nothing is what was proved
        if forced.text == before.text && forced.failures == before.failures {
            continue;
        }
        *left -= 1;
        if let Err(difference) = is_same(
            trial,
            &forced,
            &renamed_run(trial, task, &setting, name),
            name,
        ) {
            return found(trial, task, Some((path, at, taken)), difference);
        }
    }
    for setting in switched(task, &before) {
        let before = trial.run(task, &trial.session.vfs, &setting);
        if let Err(difference) = is_same(
            trial,
            &before,
            &renamed_run(trial, task, &setting, name),
            name,
        ) {
            return found(trial, task, None, difference);
        }
    }
    None
}

/// The obstacle that a robot is; none when the search was given up, which may be all that differs.
fn found(
    trial: &Trial<'_>,
    task: &CheckTask,
    condition: Option<(PathBuf, u32, bool)>,
    difference: Option<String>,
) -> Option<Obstacle> {
    let obstacle = Obstacle {
        robot: task.file.clone(),
        condition,
        difference,
    };
    (!trial.effort.cancel.is_cancelled()).then_some(obstacle)
}

/// What a setting gives afterwards.
fn renamed_run(
    trial: &Trial<'_>,
    task: &CheckTask,
    setting: &RunSetting,
    name: NewName<'_>,
) -> Arc<RunResult> {
    let moved = |forced: &Forced| Forced {
        at: trial.moved(forced),
        ..forced.clone()
    };
    let args = setting.args.iter().map(|(given, value)| match name {
        NewName::Argument { old, new } if given == old => (new.to_owned(), value.clone()),
        _ => (given.clone(), value.clone()),
    });
    let setting = RunSetting {
        args: args.collect(),
        forced: setting.forced.iter().map(moved).collect(),
    };
    trial.run(task, &trial.after, &setting)
}

/// That a robot is the same before and after, or is refused for the same reasons; else what is different, if that is known.
fn is_same(
    trial: &Trial<'_>,
    before: &RunResult,
    after: &RunResult,
    name: NewName<'_>,
) -> Result<(), Option<String>> {
    if before.refused || after.refused {
        let moved = before.failures.iter().map(|(code, path, at)| {
            let changed = trial.changed.iter().find(|changed| *changed.path == **path);
            (
                *code,
                path.clone(),
                changed.map_or(*at, |changed| changed.moved(*at)),
            )
        });
        let is_same = before.refused && after.refused && moved.eq(after.failures.iter().cloned());
        return is_same.then_some(()).ok_or(None);
    }
    if before.text == after.text {
        return Ok(());
    }
    match name {
        NewName::Robot { old, new } => {
            match other_difference(&before.text, &after.text, old, new) {
                Some(difference) => Err(Some(difference)),
                None => Ok(()),
            }
        }
        _ => match same_robot(&before.text, &after.text) {
            Some(true) => Ok(()),
            _ => Err(None),
        },
    }
}

/// The conditions that may matter, each taken and not, those around it taken: file, line, what is decided. They are
/// those of the changed files, and where such a file takes no part, those around includes.
fn conditions(trial: &Trial<'_>, before: &RunResult) -> Vec<(PathBuf, u32, Vec<Forced>)> {
    let is_missing = trial
        .changed
        .iter()
        .any(|changed| !before.reads(&changed.path));
    let changed = trial
        .changed
        .iter()
        .map(|changed| changed.path.to_path_buf());
    let mut paths: Vec<PathBuf> = changed.collect();
    paths.extend(
        before
            .files()
            .iter()
            .filter(|path| is_missing && !is_changed(trial, path))
            .cloned(),
    );
    let mut found = Vec::new();
    for path in paths {
        let Ok(source) = trial.session.vfs.document(&path) else {
            continue;
        };
        for range in conditions_of(&source.document, !is_changed(trial, &path)) {
            let line = source
                .document
                .line_col(range.start, base::Encoding::Utf8)
                .line
                + 1;
            let around = enclosing(&source.document, range, &CONDITIONS);
            let outer: Vec<Forced> = around
                .iter()
                .map(|range| forced(&path, range.start, true))
                .collect();
            for taken in [true, false] {
                let own = outer
                    .iter()
                    .cloned()
                    .chain([forced(&path, range.start, taken)])
                    .collect();
                found.push((path.clone(), line, own));
            }
        }
    }
    found
}

fn is_changed(trial: &Trial<'_>, path: &Path) -> bool {
    trial.changed.iter().any(|changed| *changed.path == *path)
}

/// A robot with each of its switches turned over.
fn switched(task: &CheckTask, before: &RunResult) -> Vec<RunSetting> {
    let turned =
        before
            .arguments
            .iter()
            .filter_map(|(name, value)| match turned_over(value).as_slice() {
                [other] => Some((name, *other)),
                _ => None,
            });
    let with = |(name, value): (&EcoString, &str)| {
        with_arguments(task, [(name.to_string(), value.to_owned())])
    };
    turned.take(MOST_SWITCHES).map(with).collect()
}

/// The conditions of a document; only those around includes, when nothing else matters.
fn conditions_of(document: &Document, around_includes: bool) -> Vec<TextRange> {
    let mut found = Vec::new();
    for (base, item) in document.parts() {
        let elements = item
            .all_nodes()
            .filter(|node| node.kind() == NodeKind::Element);
        for node in elements.filter(|node| CONDITIONS.contains(&node.name())) {
            let range = node.range();
            let include = |inner: Node<'_>| {
                inner.name() == "xacro:include" && range.contains_range(inner.range())
            };
            if !around_includes || item.all_nodes().any(include) {
                found.push(range.shift(base));
            }
        }
    }
    found
}

fn forced(file: &Path, at: u32, taken: bool) -> Forced {
    Forced {
        file: file.to_owned(),
        at,
        taken,
    }
}
