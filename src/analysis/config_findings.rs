//! What has no effect in the configurations that hold for a check.
use std::path::PathBuf;
use std::sync::Arc;

use ecow::EcoString;

use super::configs::Settings;
use super::declared::arguments;
use super::options::CheckOptions;
use super::report::Report;
use super::root_result::RootResult;
use super::session::Session;
use base::FastSet;
use packages::nearest;
use rules::{Finding, invalid_config};
use workspace::config::{ConfigLocation, ConfigMentionKind, ConfigWarning, Root};

/// What has no effect in the configurations that hold for what was checked. What is wrong in the settings of an
/// editor has no place in a file.
pub(super) fn config_findings(
    session: &Session,
    options: &CheckOptions,
    report: &Report,
    results: &[RootResult],
) -> Vec<Finding> {
    let files = report
        .files
        .values()
        .map(|file| session.settings(&file.path));
    let folders = options
        .paths
        .iter()
        .map(|path| session.folder_settings(&session.vfs.absolute(path)));
    let mut holding: FastSet<PathBuf> = FastSet::default();
    let mut warnings = session.config_warnings();
    for settings in files.chain(folders) {
        let before = holding.len();
        holding.extend(settings.config.files.iter().cloned());
        if holding.len() > before {
            warnings.extend(missing(session, &settings));
            warnings.extend(unknown_arguments(session, &settings, results));
        }
    }
    let mut seen: FastSet<(PathBuf, u32, String)> = FastSet::default();
    let in_files = warnings.iter().filter(|warning| {
        let ConfigLocation { path, range, .. } = &warning.place;
        holding.contains(path) && seen.insert((path.clone(), range.start, warning.message.clone()))
    });
    in_files
        .map(|w| invalid_config(session.vfs.file_id(&w.place.path), w))
        .collect()
}

/// Roots and folders that are not there.
fn missing(session: &Session, settings: &Arc<Settings>) -> Vec<ConfigWarning> {
    let config = &settings.config;
    let roots = config
        .roots
        .iter()
        .filter(|root| root.files(&session.vfs).is_empty());
    let roots = roots.map(|root| (&root.place, format!("no file matches `{}`", root.file)));
    let folders = config.mentions.iter().filter(|mention| {
        let folder = mention
            .place
            .path
            .parent()
            .map(|own| own.join(&mention.text));
        mention.kind == ConfigMentionKind::Folder
            && !folder.is_some_and(|folder| session.vfs.is_dir(&folder))
    });
    let folders = folders.map(|mention| {
        (
            &mention.place,
            format!("`{}` is not a folder", mention.text),
        )
    });
    let warning = |(place, message): (&ConfigLocation, String)| ConfigWarning {
        place: place.clone(),
        message,
        nearest: None,
    };
    roots.chain(folders).map(warning).collect()
}

/// Arguments of roots that none of their files declares or reads.
fn unknown_arguments(
    session: &Session,
    settings: &Arc<Settings>,
    results: &[RootResult],
) -> Vec<ConfigWarning> {
    let roots = settings
        .config
        .roots
        .iter()
        .filter(|root| !root.given.is_empty());
    roots
        .flat_map(|root| unknown_arguments_of(session, root, results))
        .collect()
}

fn unknown_arguments_of(
    session: &Session,
    root: &Root,
    results: &[RootResult],
) -> Vec<ConfigWarning> {
    let files = root.files(&session.vfs);
    let runs: Vec<&RootResult> = results
        .iter()
        .filter(|run| files.contains(&run.task.file))
        .collect();
    // what is not expanded, or not wholly, may declare them
    if files
        .iter()
        .any(|file| !runs.iter().any(|run| run.task.file == *file))
        || runs.iter().any(|run| !run.complete)
    {
        return Vec::new();
    }
    let mut known: FastSet<EcoString> = FastSet::default();
    for file in runs.iter().flat_map(|run| &run.files) {
        known.extend(arguments(file));
    }
    if known.iter().any(|name| name.contains('$')) {
        return Vec::new();
    }
    let unknown = root
        .given
        .iter()
        .filter(|(name, _)| !known.contains(name.as_str()));
    let warning = |(name, place): &(String, ConfigLocation)| ConfigWarning {
        place: place.clone(),
        message: format!("unknown argument `{name}` of `{}`", root.file),
        nearest: nearest(name, known.iter().map(EcoString::as_str)).map(str::to_owned),
    };
    unknown.map(warning).collect()
}
