//! Which files of the workspace include a file, whatever the condition around the include.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use super::includes::Included;
use super::session::Session;
use super::walk;
use base::FastSet;

/// What the descriptions of the workspace around a file include.
pub(super) fn included_around(session: &Session, file: &Path) -> Option<Arc<Included>> {
    let top = session.packages.sources_around(file)?;
    Some(session.included_below(&top, || {
        let files = walk::all_descriptions(&top, &session.vfs, &session.env);
        let sources = files
            .par_iter()
            .filter_map(|file| session.vfs.document(file).ok());
        Arc::new(Included::of_files(sources.collect(), &session.packages))
    }))
}

/// The files of the workspace that include this one.
pub(super) fn includers(session: &Session, file: &Path) -> Vec<PathBuf> {
    let all = included_around(session, file);
    let mut found: Vec<PathBuf> = all
        .iter()
        .flat_map(|all| all.includers(file))
        .map(Path::to_owned)
        .collect();
    found.sort();
    found
}

/// Whether a file of the workspace includes this one, whatever the condition around the include.
pub(super) fn is_included(session: &Session, file: &Path) -> bool {
    included_around(session, file).is_some_and(|included| included.has(file))
}

/// Whether something holds for a file, and for all that include it.
pub(super) fn holds_above(session: &Session, file: &Path, holds: impl Fn(&Path) -> bool) -> bool {
    let mut open = vec![file.to_owned()];
    let mut seen: FastSet<PathBuf> = FastSet::default();
    while let Some(file) = open.pop() {
        if seen.contains(&file) {
            continue;
        }
        if !holds(&file) {
            return false;
        }
        open.extend(includers(session, &file));
        seen.insert(file);
    }
    true
}

/// Whether a description is there for the tests of its package and nothing else.
pub(super) fn is_for_tests(session: &Session, file: &Path) -> bool {
    let includers = |file: &Path| includers(session, file);
    session.callers.is_for_tests(file, includers)
}

/// Whether a file was copied with a repository of others, and nothing else in the workspace leads to it.
pub(super) fn is_unused_copy(session: &Session, file: &Path) -> bool {
    session
        .callers
        .is_unused_copy(file, |file| includers(session, file))
}
