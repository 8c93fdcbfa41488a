//! Checks of files that are only parts of robots: the robots that include them are checked, for what concerns these files.
use std::path::{Path, PathBuf};

use super::candidates::Candidates;
use super::options::CheckOptions;
use super::session::Session;
use super::task_list::tasks_reading;
use super::walk::is_description;

/// What to check instead of files whose `<robot>` has no name, with the robots of their packages that include them.
/// `None` where there is no such robot, or where anything else is to be checked, too.
pub fn robots_of_parts(
    session: &Session,
    options: &CheckOptions,
) -> Option<(CheckOptions, Vec<PathBuf>)> {
    if !options.changed.is_empty() || !options.entries.is_empty() || options.paths.is_empty() {
        return None;
    }
    let files: Vec<PathBuf> = options
        .paths
        .iter()
        .map(|path| session.vfs.absolute(path))
        .collect();
    let is_part = |file: &PathBuf| is_description(file) && has_name(session, file) == Some(false);
    if !files.iter().all(is_part) {
        return None;
    }
    let packages = files
        .iter()
        .filter_map(|file| Some(session.packages.containing(file)?.folder));
    let mut folders: Vec<PathBuf> = packages.collect();
    folders.sort();
    folders.dedup();
    let reading = tasks_reading(
        &Candidates::default(),
        session,
        folders.clone(),
        files.clone(),
    );
    let mut robots: Vec<PathBuf> = reading.into_iter().map(|task| task.file).collect();
    robots.dedup();
    robots.retain(|file| !files.contains(file) && has_name(session, file) == Some(true));
    let changed = CheckOptions {
        paths: folders,
        changed: files,
        ..options.clone()
    };
    (!robots.is_empty()).then_some((changed, robots))
}

/// Whether the root element of a description has a name; none when it is not a `<robot>`.
fn has_name(session: &Session, file: &Path) -> Option<bool> {
    let source = session.vfs.document(file).ok()?;
    let root = source
        .document
        .root()
        .filter(|root| root.name() == "robot")?;
    Some(root.attr("name").is_some_and(|name| !name.raw().is_empty()))
}
