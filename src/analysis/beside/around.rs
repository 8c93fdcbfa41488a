//! Which files beside robots a question is about: those of a check, those of one robot, and those for the same robots.
use std::path::{Path, PathBuf};

use super::super::options::CheckOptions;
use super::super::root_config::RootConfig;
use super::super::session::Session;
use super::files::kind_of;
use super::paired::Pairing;
use super::pairing::{paired_around, pairing_of};
use super::sort::{Sort, beside_around, beside_settings, sort};
use base::FastSet;
use base::limits::FILES_BESIDE;

/// The files beside robots that a check is about.
pub(in super::super) fn beside_files(session: &Session, options: &CheckOptions) -> Vec<PathBuf> {
    let paths = options
        .paths
        .iter()
        .chain(&options.entries)
        .map(|path| session.vfs.absolute(path));
    let below = |path: PathBuf| {
        if session.vfs.is_dir(&path) {
            let around = beside_around(session, &path.join("_"));
            around
                .iter()
                .filter(|file| file.starts_with(&path))
                .cloned()
                .collect()
        } else if sort(&path).is_some() {
            vec![path]
        } else {
            Vec::new()
        }
    };
    let mut found: Vec<PathBuf> = paths.flat_map(below).collect();
    found.sort();
    found.dedup();
    found
}

/// The files beside a robot.
pub(in super::super) fn beside_of(session: &Session, root: &Path) -> Vec<PathBuf> {
    paired_around(session, root)
        .iter()
        .filter(|file| {
            pairing_of(session, file)
                .roots
                .iter()
                .any(|own| own.file == root)
        })
        .cloned()
        .collect()
}

/// The files beside the same robots, this one too. None for very many, such as a generated SRDF for each combination of
/// tools: to compare each with all others would take the square of them.
pub(super) fn of_the_same(
    session: &Session,
    path: &Path,
    pairing: &Pairing,
) -> Option<Vec<PathBuf>> {
    let is_same = |other: &&PathBuf| {
        *other == path
            || pairing.srdf.as_ref() == Some(other)
            || is_for_one_of(session, other, &pairing.roots)
    };
    let around = paired_around(session, path);
    let same = around.iter().filter(is_same);
    let found: Vec<PathBuf> = same.take(FILES_BESIDE + 1).cloned().collect();
    (found.len() <= FILES_BESIDE).then_some(found)
}

/// Whether a file beside robots is for one of these.
fn is_for_one_of(session: &Session, file: &Path, roots: &[RootConfig]) -> bool {
    !roots.is_empty()
        && pairing_of(session, file)
            .roots
            .iter()
            .any(|root| roots.contains(root))
}

/// What has to be expanded to judge files beside robots: their robots, and the SRDFs beside these.
pub(in super::super) fn beside_roots(session: &Session, paths: &[PathBuf]) -> Vec<RootConfig> {
    let mut found: FastSet<RootConfig> = FastSet::default();
    for path in paths {
        let pairing = pairing_of(session, path);
        let Some(around) = of_the_same(session, path, &pairing) else {
            continue;
        };
        let srdfs = around.iter().filter(|file| sort(file) == Some(Sort::Srdf));
        found.extend(srdfs.map(|file| RootConfig::plain(file)));
        found.extend(pairing.roots.iter().cloned());
    }
    let mut found: Vec<RootConfig> = found.into_iter().collect();
    found.sort();
    found
}

/// The files beside a robot, each with a word for what it is for; without those that say nothing of it.
pub fn files_beside(session: &Session, root: &Path) -> Vec<(PathBuf, &'static str)> {
    let kind = |file: &Path| match sort(file)? {
        Sort::Srdf => Some("srdf"),
        Sort::Yaml => Some(kind_of(&*beside_settings(session, file)?)),
    };
    let files = beside_of(session, &session.vfs.absolute(root)).into_iter();
    files
        .filter_map(|file| kind(&file).map(|kind| (file, kind)))
        .collect()
}
