//! The robots of workspaces and what they include: searched for once, for many changes that are tried one after the
//! other.
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use super::check_task::CheckTask;
use super::includes::{self, IncludeTargets};
use super::lock::locked;
use super::run_cache::Runs;
use super::session::Session;
use base::FastMap;
use vfs::SourceFile;

/// What is known of the robots of workspaces. Texts may change while it is used; packages, folders and configuration
/// stay.
#[derive(Default)]
pub struct Candidates {
    /// The tasks of all files below folders.
    pub(super) tasks: Mutex<FastMap<Vec<PathBuf>, Arc<Vec<CheckTask>>>>,
    /// What each file may include, by its path.
    reach: Mutex<FastMap<PathBuf, KnownIncludes>>,
    /// Robots expanded.
    pub(super) runs: Arc<Runs>,
}

/// What the text of a file includes, and that text.
type KnownIncludes = (Arc<SourceFile>, Arc<IncludeTargets>);

impl Candidates {
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
