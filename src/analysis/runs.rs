//! Expansions that proofs compare, kept while the files that they read stay the same.
use std::path::PathBuf;
use std::sync::Arc;

use super::check_task::CheckTask;
use super::lock::locked;
use super::run_cache::{RunResult, RunSetting, Runs};
use super::run_task;
use super::session::Session;
use base::{CancelFlag, TextRange};
use expand::{
    Expansion, FileUse, FrameKind, Problem, ProblemKind, Read, Request, Severity, Sources, expand,
    write,
};
use vfs::Vfs;

/// A robot expanded from the files that `vfs` shows. It is made again only when one of them has another text: packages
/// and folders are taken to stay as they are.
pub(super) fn run_once(
    runs: &Runs,
    session: &Session,
    vfs: &Vfs,
    cancel: &CancelFlag,
    task: &CheckTask,
    setting: &RunSetting,
) -> Arc<RunResult> {
    let key = (task.file.clone(), setting.clone());
    let known = locked(&runs.0).by_key.get(&key).cloned();
    let known: Vec<_> = known.unwrap_or_default();
    if let Some(run) = known.into_iter().find(|run| run.is_current(vfs)) {
        return run;
    }
    let run = Arc::new(run(session, vfs, cancel, task, setting));
    if !cancel.is_cancelled() {
        locked(&runs.0).add(key, run.clone());
    }
    run
}

/// Expand a robot from the files that `vfs` shows.
fn run(
    session: &Session,
    vfs: &Vfs,
    cancel: &CancelFlag,
    task: &CheckTask,
    setting: &RunSetting,
) -> RunResult {
    let Sources { packages, env, .. } = run_task::sources(session);
    let RunSetting { args, forced } = setting.clone();
    let request = Request {
        probe: false,
        args,
        forced,
        ..run_task::request(session, cancel, task)
    };
    let expansion = expand(Sources { vfs, packages, env }, &request);
    let is_broken = |file: &FileUse| !file.source.document.errors().is_empty();
    let texts = expansion.record.iter().filter_map(|read| match read {
        Read::File(path, hash) => Some((path.clone(), *hash)),
        _ => None,
    });
    RunResult {
        refused: expansion.has_errors()
            || expansion.root_error.is_some()
            || expansion.files.iter().any(is_broken),
        failures: failures(&expansion),
        called: called(&expansion),
        files: expansion
            .files
            .iter()
            .map(|file| file.source.path.to_path_buf())
            .collect(),
        texts: texts.collect(),
        text: write(&expansion.tree, "").text,
        arguments: expansion.arguments,
    }
}

/// The errors of an expansion: code, file and place.
fn failures(expansion: &Expansion) -> Vec<(ProblemKind, PathBuf, u32)> {
    let errors = expansion
        .problems
        .iter()
        .filter(|problem| problem.severity == Severity::Error);
    let place = |problem: &Problem| {
        let file = expansion.files.get(problem.place.file)?;
        Some((
            problem.kind,
            file.source.path.to_path_buf(),
            problem.place.range.start,
        ))
    };
    errors.filter_map(place).collect()
}

/// Where the macros stand that were called.
fn called(expansion: &Expansion) -> Vec<(PathBuf, TextRange)> {
    let calls = expansion
        .frames
        .iter()
        .filter(|frame| frame.kind == FrameKind::Macro);
    let places = calls.filter_map(|frame| expansion.place(frame.definition?));
    let mut found: Vec<_> = places.map(|place| (place.file, place.range)).collect();
    found.sort_unstable_by_key(|(file, range)| (*file, range.start));
    found.dedup();
    found
        .into_iter()
        .filter_map(|(file, range)| {
            let file = expansion.files.get(file)?;
            Some((file.source.path.to_path_buf(), range))
        })
        .collect()
}
