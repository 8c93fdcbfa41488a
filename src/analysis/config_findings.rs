//! What has no effect in the configurations that hold for a check.
use std::path::PathBuf;
use std::sync::Arc;

use ecow::EcoString;

use super::configs::Settings;
use super::options::CheckOptions;
use super::report::Report;
use super::root_result::RootResult;
use super::session::Session;
use base::FastSet;
use facts::{FactKind, MentionKind as Mentioned, facts_of};
use packages::nearest;
use rules::{Finding, invalid_config};
use vfs::SourceFile;
use workspace::config::{ConfigLocation, ConfigMentionKind, ConfigWarning, Root};

impl Session {
    /// What has no effect in the configurations that hold for what was checked. What is wrong in the settings of an
    /// editor has no place in a file.
    pub(super) fn config_findings(
        &self,
        options: &CheckOptions,
        report: &Report,
        results: &[RootResult],
    ) -> Vec<Finding> {
        let files = report.files.values().map(|file| self.settings(&file.path));
        let folders = options
            .paths
            .iter()
            .map(|path| self.folder_settings(&self.vfs.absolute(path)));
        let mut holding: FastSet<PathBuf> = FastSet::default();
        let mut warnings = self.config_warnings();
        for settings in files.chain(folders) {
            let before = holding.len();
            holding.extend(settings.config.files.iter().cloned());
            if holding.len() > before {
                warnings.extend(self.missing(&settings));
                warnings.extend(self.unknown_arguments(&settings, results));
            }
        }
        let mut seen: FastSet<(PathBuf, u32, String)> = FastSet::default();
        let in_files = warnings.iter().filter(|warning| {
            let ConfigLocation { path, range, .. } = &warning.place;
            holding.contains(path)
                && seen.insert((path.clone(), range.start, warning.message.clone()))
        });
        in_files
            .map(|w| invalid_config(self.vfs.file_id(&w.place.path), w))
            .collect()
    }

    /// Roots and folders that are not there.
    fn missing(&self, settings: &Arc<Settings>) -> Vec<ConfigWarning> {
        let config = &settings.config;
        let roots = config
            .roots
            .iter()
            .filter(|root| root.files(&self.vfs).is_empty());
        let roots = roots.map(|root| (&root.place, format!("no file matches `{}`", root.file)));
        let folders = config.mentions.iter().filter(|mention| {
            let folder = mention
                .place
                .path
                .parent()
                .map(|own| own.join(&mention.text));
            mention.kind == ConfigMentionKind::Folder
                && !folder.is_some_and(|folder| self.vfs.is_dir(&folder))
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
        &self,
        settings: &Arc<Settings>,
        results: &[RootResult],
    ) -> Vec<ConfigWarning> {
        let roots = settings
            .config
            .roots
            .iter()
            .filter(|root| !root.given.is_empty());
        roots
            .flat_map(|root| self.unknown_arguments_of(root, results))
            .collect()
    }

    fn unknown_arguments_of(&self, root: &Root, results: &[RootResult]) -> Vec<ConfigWarning> {
        let files = root.files(&self.vfs);
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
}

/// The arguments that a file declares or reads, as they are written.
pub(super) fn arguments(file: &SourceFile) -> Vec<EcoString> {
    let mut names = Vec::new();
    for (_, item) in file.document.parts() {
        let facts = facts_of(item);
        let declared = facts
            .named
            .iter()
            .filter(|fact| fact.kind == FactKind::Argument);
        names.extend(declared.map(|fact| fact.name.clone()));
        let read = facts
            .mentions()
            .filter(|mention| mention.kind == Mentioned::Argument);
        names.extend(read.map(|mention| mention.name.clone()));
    }
    names
}
