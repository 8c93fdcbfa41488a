//! What files beside robots are, by their names and texts, and where they are.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::super::session::Session;
use project::{YamlSettings, may_be_settings};
use rules::is_semantic_name;

/// What a file beside a robot is by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sort {
    /// SRDF, or a xacro file that gives one.
    Srdf,
    /// YAML.
    Yaml,
}

/// What a file beside a robot may be, by its name.
pub(crate) fn sort(path: &Path) -> Option<Sort> {
    let name = path.file_name()?.to_str()?;
    let ending = name
        .rsplit_once('.')
        .map_or("", |(_, ending)| ending)
        .to_ascii_lowercase();
    if is_semantic_name(path) {
        return Some(Sort::Srdf);
    }
    (["yaml", "yml"].contains(&ending.as_str()) || name == ".setup_assistant").then_some(Sort::Yaml)
}

/// Whether a file is YAML that may hold settings of a robot, by its name.
pub fn is_settings(path: &Path) -> bool {
    sort(path) == Some(Sort::Yaml)
}

/// Whether a file may say something about a robot: an SRDF, or YAML with words of settings.
pub(in super::super) fn is_about_robots(session: &Session, path: &Path) -> bool {
    match sort(path) {
        Some(Sort::Srdf) => true,
        Some(Sort::Yaml) => session
            .vfs
            .text(path)
            .is_ok_and(|text| may_be_settings(&text.text)),
        None => false,
    }
}

/// The settings in a YAML file; none when it has none, or is broken.
pub(in super::super) fn beside_settings(
    session: &Session,
    path: &Path,
) -> Option<Arc<YamlSettings>> {
    let text = session.vfs.text(path).ok()?;
    if !may_be_settings(&text.text) {
        return None;
    }
    let yaml = session.vfs.yaml(path, "").ok()?;
    Some(Arc::new(YamlSettings::read(
        &text.text,
        yaml.value.as_ref().ok()?,
    )?))
}

/// The files around a path that may say something about robots.
pub(in super::super) fn beside_around(session: &Session, path: &Path) -> Arc<Vec<PathBuf>> {
    let Some(top) = session.packages.sources_around(path) else {
        return Arc::default();
    };
    if let Some(found) = session.known_beside().get(&top) {
        return found.clone();
    }
    let mut found = session.callers.beside(path);
    found.retain(|file| is_about_robots(session, file) && !session.settings(file).excludes(file));
    session
        .known_beside()
        .entry(top)
        .or_insert(Arc::new(found))
        .clone()
}
