//! Finding and reading configuration files.

use std::path::{Path, PathBuf};

use super::apply::Applier;
use super::value::{ConfigEntry, ConfigValue, ValueKind, from_settings, from_toml};
use super::{Config, ConfigWarning};
use base::TextRange;
use base::limits::CONFIG_CHAIN;
use vfs::{LoadError, Vfs};

/// The names of a configuration file; the first wins in a folder that has both.
pub const CONFIG_NAMES: [&str; 2] = ["xacro-lint.toml", ".xacro-lint.toml"];

/// A configuration and what in it has no effect.
#[derive(Clone, Debug, Default)]
pub struct LoadedConfig {
    /// The settings.
    pub config: Config,
    /// What is wrong in the files.
    pub warnings: Vec<ConfigWarning>,
}

/// The configuration file for what lies in or below `folder`; it may be one that cannot be read.
pub fn find_config(vfs: &Vfs, folder: &Path) -> Option<PathBuf> {
    let mut folder = vfs.absolute(folder);
    if folder
        .components()
        .any(|part| part == std::path::Component::ParentDir)
    {
        // what lies above `a/../b` is not `a`
        folder = vfs.canonical(&folder);
    }
    folder.ancestors().find_map(|folder| {
        CONFIG_NAMES
            .iter()
            .map(|name| folder.join(name))
            .find(|path| vfs.is_present(path))
    })
}

impl Config {
    /// The configuration for `file`: the nearest one upward, else the defaults.
    pub fn for_file(vfs: &Vfs, file: &Path) -> LoadedConfig {
        let found = file.parent().and_then(|folder| find_config(vfs, folder));
        found
            .and_then(|path| Self::load(vfs, &path).ok())
            .unwrap_or_default()
    }

    /// Read a configuration file and those it extends.
    ///
    /// # Errors
    /// When the file itself cannot be read. One that it extends gives a warning only.
    pub fn load(vfs: &Vfs, path: &Path) -> Result<LoadedConfig, LoadError> {
        let mut loaded = LoadedConfig::default();
        let path = vfs.absolute(path);
        let home = vfs.canonical(path.parent().unwrap_or(Path::new("")));
        load_over(vfs, &path, &home, &mut Vec::new(), &mut loaded)?;
        loaded.config.files.reverse();
        Ok(loaded)
    }

    /// Lay the settings of an editor (what stands below `xacro.`) over this configuration. Relative paths
    /// start at `folder`. Keys that only an editor has are passed over.
    pub fn apply_settings(
        &mut self,
        settings: &serde_json::Value,
        folder: &Path,
    ) -> Vec<ConfigWarning> {
        let mut entries = from_settings(
            settings,
            &["roots", "severity", "per-file-ignores", "diagnostics"],
        );
        rename(&mut entries);
        let mut applier = Applier::new(PathBuf::new(), String::new(), folder.to_owned());
        applier.passes_unknown = true;
        applier.config(self, &entries);
        applier.warnings
    }
}

/// The places in the text of a configuration file that give the argument `name` a value, in entries of `roots` whose
/// `file` is admitted.
pub fn argument_places(text: &str, name: &str, admits: impl Fn(&str) -> bool) -> Vec<TextRange> {
    let (entries, _) = from_toml(text);
    let mut found = Vec::new();
    for root in tables(&entries, "roots") {
        let is_file = |entry: &&ConfigEntry| entry.key == "file";
        let file = root.iter().find(is_file).map(|entry| &entry.value.kind);
        if matches!(file, Some(ValueKind::Text(file)) if admits(file)) {
            let presets = root.iter().filter(|entry| entry.key == "presets");
            let presets = presets
                .flat_map(|presets| fields(&presets.value))
                .map(|preset| &preset.value);
            let args = root
                .iter()
                .filter(|entry| entry.key == "args")
                .map(|args| &args.value);
            let expected = tables(root, "expect")
                .into_iter()
                .flatten()
                .filter(|entry| entry.key == "when");
            let excluded = tables(root, "exclude").into_iter().flatten();
            let expected = expected
                .flat_map(|when| fields(&when.value))
                .chain(excluded);
            let given = args
                .chain(presets)
                .flat_map(fields)
                .chain(expected)
                .filter(|entry| entry.key == name);
            found.extend(given.map(|entry| bare(text, entry.key_range)));
        }
    }
    found
}

fn fields(value: &ConfigValue) -> &[ConfigEntry] {
    match &value.kind {
        ValueKind::Table(fields) => fields,
        _ => &[],
    }
}

/// The tables of a list.
fn tables<'a>(entries: &'a [ConfigEntry], key: &str) -> Vec<&'a [ConfigEntry]> {
    let listed = entries
        .iter()
        .filter(|entry| entry.key == key)
        .flat_map(|entry| match &entry.value.kind {
            ValueKind::List(items) => items.as_slice(),
            _ => &[],
        });
    listed.map(fields).collect()
}

/// A key without its quotes.
fn bare(text: &str, range: TextRange) -> TextRange {
    let quoted = range.len() > 1 && range.slice(text).starts_with(['"', '\'']);
    if quoted {
        TextRange::new(range.start + 1, range.end - 1)
    } else {
        range
    }
}

/// Settings that only editors have.
const EDITOR_ONLY: [&str; 7] = [
    "completion",
    "diagnostics",
    "inlay-hints",
    "preview",
    "server",
    "trace",
    "use-environment",
];

/// What nobody knows among the settings of an editor.
pub fn unknown_settings(settings: &serde_json::Value) -> Vec<String> {
    let mut entries = from_settings(
        settings,
        &["roots", "severity", "per-file-ignores", "diagnostics"],
    );
    rename(&mut entries);
    entries.retain(|entry| {
        let group = entry.key.split('.').next().unwrap_or("");
        !EDITOR_ONLY.contains(&group)
    });
    let mut applier = Applier::new(PathBuf::new(), String::new(), PathBuf::new());
    applier.config(&mut Config::default(), &entries);
    let unknown = applier
        .warnings
        .iter()
        .filter(|warning| warning.message.starts_with("unknown key"));
    unknown.map(ToString::to_string).collect()
}

/// The two keys that have another name in editors.
fn rename(entries: &mut Vec<ConfigEntry>) {
    let mut rules = Vec::new();
    for entry in entries.iter_mut() {
        if entry.key == "package-paths" {
            entry.key = "package-path".to_owned();
        }
        if let ("diagnostics", ValueKind::Table(fields)) = (entry.key.as_str(), &entry.value.kind) {
            rules.extend(fields.iter().filter(|field| field.key == "rules").cloned());
        }
    }
    for mut rule in rules {
        rule.key = "severity".to_owned();
        entries.push(rule);
    }
}

/// Apply the file `path` over what is loaded, the files it extends first. `home` is the folder of the first one.
fn load_over(
    vfs: &Vfs,
    path: &Path,
    home: &Path,
    chain: &mut Vec<PathBuf>,
    loaded: &mut LoadedConfig,
) -> Result<(), LoadError> {
    let file = vfs.text(path)?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let (entries, errors) = from_toml(&file.text);
    let mut applier = Applier::new(path.to_owned(), file.text.clone(), folder.clone());
    for (message, range) in errors {
        applier.warn(range, message, None);
    }
    chain.push(vfs.canonical(path));
    for entry in entries.iter().filter(|entry| entry.key == "extend") {
        let Some(base) = applier.text(entry) else {
            continue;
        };
        let base = folder.join(base);
        if chain.contains(&vfs.canonical(&base)) {
            applier.warn(entry.value.range, "circular `extend`".to_owned(), None);
        } else if chain.len() >= CONFIG_CHAIN {
            applier.warn(
                entry.value.range,
                format!("more than {CONFIG_CHAIN} configuration files extend each other"),
                None,
            );
        } else if let Err(error) = load_over(vfs, &base, home, chain, loaded) {
            let message = format!(
                "cannot read `{}`: {}",
                vfs::slashed(&error.path),
                error.reason()
            );
            applier.warn(entry.value.range, message, None);
        }
    }
    chain.pop();
    applier.config(&mut loaded.config, &entries);
    loaded.config.note_origins(&entries, path);
    loaded.config.files.push(path.to_owned());
    if !is_configuration(&vfs.canonical(path), home) {
        for warning in &mut applier.warnings {
            warning.message =
                "invalid setting; it is not shown, because the file is in another folder and does not \
                               have the name of a configuration file"
                    .to_owned();
            warning.nearest = None;
        }
    }
    applier
        .warnings
        .sort_by_key(|warning| warning.place.range.start);
    loaded.warnings.append(&mut applier.warnings);
    Ok(())
}

/// Whether the file at `path` is meant as a configuration. A link, or `extend`, can name any file, also a key.
fn is_configuration(path: &Path, home: &Path) -> bool {
    let is_named = |name: &str| path.file_name().is_some_and(|own| own == name);
    path.starts_with(home) || CONFIG_NAMES.into_iter().any(is_named)
}
