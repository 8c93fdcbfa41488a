//! Which files a check is about, and how each is to be expanded.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::beside::{Sort, sort};
use super::candidates::Candidates;
use super::change::Change;
use super::check_task::{CheckReason, CheckTask};
use super::configs::Settings;
use super::options::CheckOptions;
use super::report::{Report, SkipReason, Skipped, Unreadable};
use super::session::Session;
use super::walk;
use base::FastSet;

impl Session {
    /// The files that [`check`](Self::check) would look at, sorted; what they include comes on top.
    pub fn files(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let tasks = self.tasks(options, &mut Report::default());
        let files: BTreeSet<PathBuf> = tasks.into_iter().map(|task| task.file).collect();
        files.into_iter().collect()
    }

    pub(super) fn tasks(&self, options: &CheckOptions, report: &mut Report) -> Vec<CheckTask> {
        let mut tasks = self.all_tasks(options, report);
        if let Some(change) = Change::of(self, options) {
            tasks.extend(change.further(&tasks, &options.args));
            tasks = change.reached(tasks, &Candidates::default());
        }
        for task in tasks
            .iter()
            .filter(|task| task.reason != CheckReason::Walked)
        {
            if let Err(error) = self.vfs.document(&task.file) {
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
    pub(super) fn all_tasks(&self, options: &CheckOptions, report: &mut Report) -> Vec<CheckTask> {
        let args = &options.args;
        let entries = options
            .entries
            .iter()
            .map(|path| CheckTask::new(self.vfs.absolute(path), CheckReason::Root, args.clone()));
        let mut tasks: Vec<CheckTask> = entries.collect();
        let (named, walked) = self.named_and_walked(options, report);
        tasks.extend(self.configured(options, &named, &walked));
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
        &self,
        options: &CheckOptions,
        report: &mut Report,
    ) -> (Vec<PathBuf>, Vec<PathBuf>) {
        let (mut named, mut walked) = (Vec::new(), Vec::new());
        for path in options.paths.iter().map(|path| self.vfs.absolute(path)) {
            if self.vfs.is_dir(&path) {
                let (files, skipped) = walk::descriptions(&path, self);
                walked.extend(files);
                skipped
                    .into_iter()
                    .for_each(|skipped| report.skip(skipped, &path));
            } else if self.settings(&path).excludes(&path) {
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
        &self,
        options: &CheckOptions,
        named: &[PathBuf],
        walked: &[PathBuf],
    ) -> Vec<CheckTask> {
        let mut tasks = Vec::new();
        for (settings, number, files) in self.configured_files(options, named, walked) {
            let Some(root) = settings.config.roots.get(number) else {
                continue;
            };
            tasks.extend(
                files
                    .iter()
                    .flat_map(|file| self.tasks_of(root, file, &options.args)),
            );
        }
        tasks
    }

    /// The entries of `[[roots]]` by number, each with its files that are to be checked.
    pub(super) fn configured_files(
        &self,
        options: &CheckOptions,
        named: &[PathBuf],
        walked: &[PathBuf],
    ) -> Vec<(Arc<Settings>, usize, Vec<PathBuf>)> {
        let folders: Vec<PathBuf> = options
            .paths
            .iter()
            .map(|path| self.vfs.absolute(path))
            .collect();
        let mut seen: FastSet<Vec<PathBuf>> = FastSet::default();
        let mut found = Vec::new();
        let own = folders
            .iter()
            .filter(|path| self.vfs.is_dir(path))
            .map(|folder| self.folder_settings(folder));
        let settings = own.chain(named.iter().chain(walked).map(|file| self.settings(file)));
        for settings in settings {
            if !seen.insert(settings.config.files.clone()) {
                continue;
            }
            for (number, root) in settings.config.roots.iter().enumerate() {
                let mut files = root.files(&self.vfs);
                files.retain(|file| folders.iter().any(|folder| file.starts_with(folder)));
                found.push((settings.clone(), number, files));
            }
        }
        found
    }

    /// The folders whose files are the user's own: in files elsewhere, only errors are reported.
    pub(super) fn homes(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let paths = options
            .paths
            .iter()
            .chain(&options.entries)
            .chain(&options.changed);
        let paths = paths.map(|path| self.vfs.absolute(path));
        let homes = paths.flat_map(|path| {
            let is_dir = self.vfs.is_dir(&path);
            let folder = if is_dir {
                Some(path.clone())
            } else {
                path.parent().map(Path::to_owned)
            };
            let package = self
                .packages
                .containing(&path.join("_"))
                .map(|package| package.folder);
            let workspace = folder
                .as_ref()
                .and_then(|folder| self.packages.workspace(folder));
            [folder, package, workspace]
        });
        homes.flatten().collect()
    }
}
