//! Which settings hold for a file: those of the configuration nearest to it, under those of the command line.
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use super::lock::locked;
use base::FastMap;
use packages::nearest;
use rules::{
    Finding, Rule, RuleSelection, SelectionOptions, Severity, THRESHOLDS, find, nearest_selector,
};
use vfs::{LoadError, Vfs};
use workspace::config::{
    Config, ConfigMention, ConfigMentionKind, ConfigWarning, LoadedConfig, Profile, find_config,
};

/// What the command line says over every configuration file.
#[derive(Clone, Debug, Default)]
pub struct Overrides {
    /// `--config`
    pub config: Option<PathBuf>,
    /// `--select`
    pub select: Option<Vec<String>>,
    /// `--extend-select`
    pub extend_select: Option<Vec<String>>,
    /// `--ignore`
    pub ignore: Option<Vec<String>>,
    /// `--profile`
    pub profiles: Option<Vec<String>>,
    /// `--for`
    pub consumers: Option<Vec<String>>,
    /// The settings of an editor (what stands below `xacro.`), and the folder they hold for, where their relative
    /// paths start; outside of all of these folders the first ones hold.
    pub editor: Vec<(serde_json::Value, PathBuf)>,
}

impl Overrides {
    /// The number of the editor's settings that hold for a folder.
    fn editor_of(&self, folder: &Path) -> Option<usize> {
        let around = self
            .editor
            .iter()
            .enumerate()
            .filter(|(_, (_, own))| folder.starts_with(own));
        let nearest = around.max_by_key(|(_, (_, own))| own.components().count());
        nearest
            .map(|(number, _)| number)
            .or((!self.editor.is_empty()).then_some(0))
    }
}

/// The settings that hold for a file.
#[derive(Debug)]
pub struct Settings {
    /// The configuration.
    pub config: Config,
    selection: RuleSelection,
}

/// Configurations by the folder they hold for.
pub(super) struct Configs {
    overrides: Overrides,
    state: Mutex<ConfigCache>,
}

/// What settings are made of: a configuration file, and settings of the editor by their number.
type SettingsKey = (Option<PathBuf>, Option<usize>);

#[derive(Default)]
struct ConfigCache {
    /// By folder: the settings that hold there.
    folders: FastMap<PathBuf, Arc<Settings>>,
    /// By configuration file (none: no file at all) and by the number of the editor's settings.
    files: FastMap<SettingsKey, Arc<Settings>>,
    warnings: Vec<ConfigWarning>,
    /// Those that cannot be read.
    unreadable: Vec<LoadError>,
}

impl Settings {
    fn new(mut config: Config, overrides: &Overrides) -> Self {
        // some rules ask for the profiles themselves
        if let Some(names) = &overrides.profiles {
            config.profiles = names
                .iter()
                .filter_map(|name| Profile::named(name))
                .collect();
        }
        if let Some(names) = &overrides.consumers {
            config.consumers.clone_from(names);
        }
        let profiles: Vec<String> = config
            .profiles
            .iter()
            .map(|&profile| profile.name().to_owned())
            .collect();
        let severity = config
            .severity
            .iter()
            .map(|(rule, level)| (rule.clone(), level.severity()));
        let selection = RuleSelection::new(&SelectionOptions {
            select: overrides.select.clone().or_else(|| config.select.clone()),
            extend_select: given_or(overrides.extend_select.as_ref(), &config.extend_select),
            ignore: given_or(overrides.ignore.as_ref(), &config.ignore),
            commanded: overrides
                .select
                .iter()
                .chain(&overrides.extend_select)
                .flatten()
                .cloned()
                .collect(),
            ignore_is_commanded: overrides.ignore.is_some(),
            profiles,
            severity: severity.collect(),
        });
        Self { config, selection }
    }

    /// The severity of a finding in `path`; none when it is not wanted there.
    pub(super) fn severity(&self, finding: &Finding, path: &Path) -> Option<Severity> {
        if self.passes(finding.rule, path) {
            self.selection.severity(finding)
        } else {
            None
        }
    }

    /// Whether a rule runs for any file.
    pub(super) fn selects(&self, rule: &Rule) -> bool {
        self.selection.runs(rule)
    }

    /// Whether a rule was selected by name, by code or with `ALL`.
    pub(super) fn names(&self, rule: &Rule) -> bool {
        self.selection.names(rule)
    }

    /// Whether a rule runs for `path`.
    pub fn runs(&self, rule: &Rule, path: &Path) -> bool {
        self.selection.runs(rule) && self.passes(rule, path)
    }

    /// Whether neither the file nor the rule for it is left out.
    fn passes(&self, rule: &Rule, path: &Path) -> bool {
        let mut ignores = self
            .config
            .per_file_ignores
            .iter()
            .filter(|(pattern, _)| pattern.matches(path));
        let ignored = ignores.any(|(_, rules)| {
            rules
                .iter()
                .any(|name| name == "ALL" || rule.is_named(name))
        });
        !self.excludes(path) && !ignored
    }

    /// Whether the configuration excludes a file.
    pub fn excludes(&self, path: &Path) -> bool {
        self.config
            .exclude
            .iter()
            .any(|pattern| pattern.matches(path))
    }
}

impl Configs {
    /// Configurations under `overrides`.
    ///
    /// # Errors
    /// When `--config` names a file that cannot be read.
    pub(super) fn new(vfs: &Vfs, overrides: Overrides) -> Result<Self, LoadError> {
        let configs = Self {
            overrides,
            state: Mutex::default(),
        };
        if let Some(path) = &configs.overrides.config {
            let loaded = Config::load(vfs, path)?;
            configs.lock().add((None, None), loaded, &configs.overrides);
        }
        Ok(configs)
    }

    /// Configurations under overrides that name no file.
    pub(super) fn without_file(overrides: Overrides) -> Self {
        Self {
            overrides,
            state: Mutex::default(),
        }
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, ConfigCache> {
        locked(&self.state)
    }

    /// The settings for files in `folder`.
    pub(super) fn of_folder(&self, vfs: &Vfs, folder: &Path) -> Arc<Settings> {
        let mut state = self.lock();
        if let Some(settings) = state.folders.get(folder) {
            return settings.clone();
        }
        let path = match self.overrides.config {
            Some(_) => None,
            None => find_config(vfs, folder),
        };
        let origin = (path, self.overrides.editor_of(folder));
        let settings = match state.files.get(&origin) {
            Some(settings) => settings.clone(),
            None => {
                let path = origin.0.as_ref();
                let loaded = path.map_or_else(
                    || Ok(LoadedConfig::default()),
                    |path| Config::load(vfs, path),
                );
                let loaded = loaded.unwrap_or_else(|error| {
                    state.unreadable.push(error);
                    LoadedConfig::default()
                });
                state.add(origin, loaded, &self.overrides)
            }
        };
        state.folders.insert(folder.to_owned(), settings.clone());
        settings
    }

    /// The configuration files read so far.
    pub(super) fn files(&self) -> Vec<PathBuf> {
        self.lock()
            .files
            .values()
            .flat_map(|settings| &settings.config.files)
            .cloned()
            .collect()
    }

    /// Whether the settings of the editor that hold for a folder give this very rule a severity: they take precedence over the file.
    pub(super) fn editor_sets_severity(&self, folder: &Path, rule: &Rule) -> bool {
        let number = self.overrides.editor_of(folder);
        let own = number.and_then(|number| self.overrides.editor.get(number));
        let severities = own.and_then(|(settings, _)| settings.get("severity")?.as_object());
        severities
            .is_some_and(|given| given.contains_key(rule.name) || given.contains_key(rule.code))
    }

    /// The configurations that could not be read so far.
    pub(super) fn unreadable(&self) -> Vec<LoadError> {
        self.lock().unreadable.clone()
    }

    /// What in the configurations read so far has no effect.
    pub(super) fn warnings(&self) -> Vec<ConfigWarning> {
        self.lock().warnings.clone()
    }
}

impl ConfigCache {
    fn add(
        &mut self,
        origin: SettingsKey,
        loaded: LoadedConfig,
        overrides: &Overrides,
    ) -> Arc<Settings> {
        let LoadedConfig {
            mut config,
            mut warnings,
        } = loaded;
        if let Some((settings, folder)) = origin.1.and_then(|number| overrides.editor.get(number)) {
            // what is wrong in them is said once, when they come in
            config.apply_settings(settings, folder);
        }
        warnings.extend(unknown_names(&config));
        for warning in warnings {
            // several files may extend the same one
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
        let settings = Arc::new(Settings::new(config, overrides));
        self.files.insert(origin, settings.clone());
        settings
    }
}

/// Names in a configuration that mean no rule.
fn unknown_names(config: &Config) -> Vec<ConfigWarning> {
    let warning = |mention: &ConfigMention| {
        let name = mention.text.as_str();
        let (kind, near) = match mention.kind {
            ConfigMentionKind::Threshold
                if THRESHOLDS.iter().all(|threshold| threshold.name != name) =>
            {
                (
                    "threshold of a rule",
                    nearest(name, THRESHOLDS.iter().map(|t| t.name)),
                )
            }
            ConfigMentionKind::Rule if name != "ALL" && find(name).next().is_none() => {
                ("rule", nearest_selector(name))
            }
            _ => return None,
        };
        let message = format!("unknown {kind} `{name}`");
        Some(ConfigWarning {
            place: mention.place.clone(),
            message,
            nearest: near.map(str::to_owned),
        })
    };
    config.mentions.iter().filter_map(warning).collect()
}

/// The names that an option gives, or else those of the configuration.
fn given_or(given: Option<&Vec<String>>, configured: &[String]) -> Vec<String> {
    given.map_or(configured, Vec::as_slice).to_vec()
}
