//! Which files a check is about, and how each is to be expanded.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::beside::{Sort, sort};
use super::candidates::Candidates;
use super::change::Change;
use super::check_task::{CheckReason, CheckTask};
use super::configs::Settings;
use super::lock::locked;
use super::options::CheckOptions;
use super::report::{Report, SkipReason, Skipped, Unreadable};
use super::roots::tasks_of;
use super::session::Session;
use super::walk;
use base::FastSet;

/// The files that [`check`](crate::check()) would look at, sorted; what they include comes on top.
pub fn files_to_check(session: &Session, options: &CheckOptions) -> Vec<PathBuf> {
    let tasks = tasks(session, options, &mut Report::default());
    let files: BTreeSet<PathBuf> = tasks.into_iter().map(|task| task.file).collect();
    files.into_iter().collect()
}

pub(super) fn tasks(
    session: &Session,
    options: &CheckOptions,
    report: &mut Report,
) -> Vec<CheckTask> {
    let mut tasks = all_tasks(session, options, report);
    if let Some(change) = Change::of(session, options) {
        tasks.extend(change.further(&tasks, &options.args));
        tasks = change.reached(tasks, &Candidates::default());
    }
    for task in tasks
        .iter()
        .filter(|task| task.reason != CheckReason::Walked)
    {
        if let Err(error) = session.vfs.document(&task.file) {
            report.unreadable.push(Unreadable {
                path: task.file.clone(),
                error,
            });
        }
    }
    tasks.retain(|task| {
        !report
            .unreadable
            .iter()
            .any(|unreadable| unreadable.path == task.file)
    });
    tasks
}

/// The tasks for what is named, whatever changed.
pub(super) fn all_tasks(
    session: &Session,
    options: &CheckOptions,
    report: &mut Report,
) -> Vec<CheckTask> {
    let args = &options.args;
    let entries = options
        .entries
        .iter()
        .map(|path| CheckTask::new(session.vfs.absolute(path), CheckReason::Root, args.clone()));
    let mut tasks: Vec<CheckTask> = entries.collect();
    let (named, walked) = named_and_walked(session, options, report);
    tasks.extend(configured(session, options, &named, &walked));
    let mut known: FastSet<PathBuf> = tasks.iter().map(|task| task.file.clone()).collect();
    let is_alone = options.paths.len() == 1 && options.changed.is_empty();
    let reason = if is_alone {
        CheckReason::Alone
    } else {
        CheckReason::Named
    };
    let named = named
        .into_iter()
        .map(|path| CheckTask::new(path, reason, args.clone()));
    let walked = walked
        .into_iter()
        .map(|path| CheckTask::new(path, CheckReason::Walked, args.clone()));
    tasks.extend(
        named
            .chain(walked)
            .filter(|task| known.insert(task.file.clone())),
    );
    tasks
}

/// The files that are named, and the descriptions below the folders that are.
pub(super) fn named_and_walked(
    session: &Session,
    options: &CheckOptions,
    report: &mut Report,
) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let (mut named, mut walked) = (Vec::new(), Vec::new());
    for path in options.paths.iter().map(|path| session.vfs.absolute(path)) {
        if session.vfs.is_dir(&path) {
            let (files, skipped) = walk::descriptions(&path, session);
            walked.extend(files);
            skipped
                .into_iter()
                .for_each(|skipped| report.skip(skipped, &path));
        } else if session.settings(&path).excludes(&path) {
            report.skipped.push(Skipped {
                path,
                reason: SkipReason::Excluded,
            });
        } else if sort(&path) != Some(Sort::Yaml) {
            // settings of a robot are no description
            named.push(path);
        }
    }
    (named, walked)
}

/// The tasks of `[[roots]]` that are among the files to be checked, or below a folder to be checked.
fn configured(
    session: &Session,
    options: &CheckOptions,
    named: &[PathBuf],
    walked: &[PathBuf],
) -> Vec<CheckTask> {
    let mut tasks = Vec::new();
    for (settings, number, files) in configured_files(session, options, named, walked) {
        let Some(root) = settings.config.roots.get(number) else {
            continue;
        };
        tasks.extend(
            files
                .iter()
                .flat_map(|file| tasks_of(&session.callers, root, file, &options.args)),
        );
    }
    tasks
}

/// The entries of `[[roots]]` by number, each with its files that are to be checked.
pub(super) fn configured_files(
    session: &Session,
    options: &CheckOptions,
    named: &[PathBuf],
    walked: &[PathBuf],
) -> Vec<(Arc<Settings>, usize, Vec<PathBuf>)> {
    let folders: Vec<PathBuf> = options
        .paths
        .iter()
        .map(|path| session.vfs.absolute(path))
        .collect();
    let mut seen: FastSet<Vec<PathBuf>> = FastSet::default();
    let mut found = Vec::new();
    let own = folders
        .iter()
        .filter(|path| session.vfs.is_dir(path))
        .map(|folder| session.folder_settings(folder));
    let settings = own.chain(
        named
            .iter()
            .chain(walked)
            .map(|file| session.settings(file)),
    );
    for settings in settings {
        if !seen.insert(settings.config.files.clone()) {
            continue;
        }
        for (number, root) in settings.config.roots.iter().enumerate() {
            let mut files = root.files(&session.vfs);
            files.retain(|file| folders.iter().any(|folder| file.starts_with(folder)));
            found.push((settings.clone(), number, files));
        }
    }
    found
}

/// The folders whose files are the user's own: in files elsewhere, only errors are reported.
pub(super) fn homes(session: &Session, options: &CheckOptions) -> Vec<PathBuf> {
    let paths = options
        .paths
        .iter()
        .chain(&options.entries)
        .chain(&options.changed);
    let paths = paths.map(|path| session.vfs.absolute(path));
    let homes = paths.flat_map(|path| {
        let is_dir = session.vfs.is_dir(&path);
        let folder = if is_dir {
            Some(path.clone())
        } else {
            path.parent().map(Path::to_owned)
        };
        let package = session
            .packages
            .containing(&path.join("_"))
            .map(|package| package.folder);
        let workspace = folder
            .as_ref()
            .and_then(|folder| session.packages.workspace(folder));
        [folder, package, workspace]
    });
    homes.flatten().collect()
}

/// The robots below folders that may read one of the changed files.
pub(super) fn tasks_reading(
    known: &Candidates,
    session: &Session,
    folders: Vec<PathBuf>,
    changed: Vec<PathBuf>,
) -> Vec<CheckTask> {
    let mut tasks = (*tasks_below(known, session, &folders)).clone();
    let options = CheckOptions {
        changed,
        ..CheckOptions::default()
    };
    let Some(change) = Change::of(session, &options) else {
        return tasks;
    };
    tasks.extend(change.further(&tasks, &options.args));
    change.reached(tasks, known)
}

/// The tasks of all files below folders.
fn tasks_below(
    candidates: &Candidates,
    session: &Session,
    folders: &[PathBuf],
) -> Arc<Vec<CheckTask>> {
    let mut tasks = locked(&candidates.tasks);
    if let Some(known) = tasks.get(folders) {
        return known.clone();
    }
    let options = CheckOptions {
        paths: folders.to_vec(),
        ..CheckOptions::default()
    };
    let found = Arc::new(all_tasks(session, &options, &mut Report::default()));
    tasks.insert(folders.to_vec(), found.clone());
    found
}
