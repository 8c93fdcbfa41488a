//! The robots of workspaces and what they include: searched for once, for many changes that are tried one after the
//! other.
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use super::change::Change;
use super::check_task::CheckTask;
use super::includes::{self, IncludeTargets};
use super::lock::locked;
use super::options::CheckOptions;
use super::report::Report;
use super::run_cache::Runs;
use super::session::Session;
use base::FastMap;
use vfs::SourceFile;

/// What is known of the robots of workspaces. Texts may change while it is used; packages, folders and configuration
/// stay.
#[derive(Default)]
pub struct Candidates {
    /// The tasks of all files below folders.
    tasks: Mutex<FastMap<Vec<PathBuf>, Arc<Vec<CheckTask>>>>,
    /// What each file may include, by its path.
    reach: Mutex<FastMap<PathBuf, KnownIncludes>>,
    /// Robots expanded.
    pub(super) runs: Arc<Runs>,
}

/// What the text of a file includes, and that text.
type KnownIncludes = (Arc<SourceFile>, Arc<IncludeTargets>);

impl Candidates {
    /// The robots below folders that may read one of the changed files.
    pub(super) fn reading(
        &self,
        session: &Session,
        folders: Vec<PathBuf>,
        changed: Vec<PathBuf>,
    ) -> Vec<CheckTask> {
        let mut tasks = (*self.below(session, &folders)).clone();
        let options = CheckOptions {
            changed,
            ..CheckOptions::default()
        };
        let Some(change) = Change::of(session, &options) else {
            return tasks;
        };
        tasks.extend(change.further(&tasks, &options.args));
        change.reached(tasks, self)
    }

    /// The tasks of all files below folders.
    fn below(&self, session: &Session, folders: &[PathBuf]) -> Arc<Vec<CheckTask>> {
        let mut tasks = locked(&self.tasks);
        if let Some(known) = tasks.get(folders) {
            return known.clone();
        }
        let options = CheckOptions {
            paths: folders.to_vec(),
            ..CheckOptions::default()
        };
        let found = Arc::new(session.all_tasks(&options, &mut Report::default()));
        tasks.insert(folders.to_vec(), found.clone());
        found
    }

    /// What a file may include, as its text is now; none when it cannot be read.
    pub(super) fn reach(&self, session: &Session, file: &Path) -> Option<Arc<IncludeTargets>> {
        let source = session.vfs.document(file).ok()?;
        if let Some((of, reach)) = locked(&self.reach).get(file)
            && Arc::ptr_eq(of, &source)
        {
            return Some(reach.clone());
        }
        let reach = Arc::new(includes::reach(&source, &session.packages));
        locked(&self.reach).insert(file.to_owned(), (source, reach.clone()));
        Some(reach)
    }
}
