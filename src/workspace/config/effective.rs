//! The settings that hold, with the files that set them.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::Config;
use super::keys::{ConfigKey, KeyType};
use super::settings::ConfigTable;
use super::value::{ConfigEntry, ValueKind};

/// One key of the configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectiveSetting {
    /// The key; of a key in a table, both with a dot between.
    pub key: String,
    /// Its value; null: not set, and without a default.
    pub value: Value,
    /// The files that set it, the nearest last; none for a default.
    pub origins: Vec<PathBuf>,
}

impl Config {
    /// All keys in the order of the documentation, without those of the thresholds that are not set.
    pub fn settings(&self) -> Vec<EffectiveSetting> {
        let mut settings = Vec::new();
        for (key, value) in self.values() {
            match key.of {
                KeyType::Keys(keys) => settings.extend(keys.iter().map(|inner| {
                    let name = format!("{}.{}", key.name, inner.name);
                    self.setting(name, value.get(inner.name).cloned().unwrap_or_default())
                })),
                _ => settings.push(self.setting(key.name.to_owned(), value)),
            }
        }
        settings
    }

    fn setting(&self, key: String, value: Value) -> EffectiveSetting {
        let origins = self.origins.get(&key).cloned().unwrap_or_default();
        EffectiveSetting {
            key,
            value,
            origins,
        }
    }

    /// Remember that a file sets these keys.
    pub(super) fn note_origins(&mut self, entries: &[ConfigEntry], path: &Path) {
        for entry in entries {
            let is_table =
                |key: &ConfigKey| key.name == entry.key && matches!(key.of, KeyType::Keys(_));
            let inner = Self::KEYS.iter().any(is_table);
            match &entry.value.kind {
                ValueKind::Table(fields) if inner => {
                    for field in fields {
                        self.note_origin(format!("{}.{}", entry.key, field.key), path);
                    }
                }
                _ => self.note_origin(entry.key.clone(), path),
            }
        }
    }

    fn note_origin(&mut self, key: String, path: &Path) {
        let origins = self.origins.entry(key).or_default();
        if origins.last().is_none_or(|last| last != path) {
            origins.push(path.to_owned());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Config;
    use vfs::testing::Tree;

    #[test]
    fn values_and_where_they_come_from() {
        let tree = Tree::new();
        tree.write("base.toml", "ignore = ['STR']\nlimits.file-mb = 5\n");
        tree.write(
            "xacro-lint.toml",
            "extend = 'base.toml'\nignore = ['XAC']\ntarget = 'ros1'\n",
        );
        let loaded = Config::load(tree.vfs(), &tree.path("xacro-lint.toml")).unwrap();
        let settings = loaded.config.settings();
        let of = |key: &str| {
            let setting = settings.iter().find(|setting| setting.key == key).unwrap();
            let names = setting
                .origins
                .iter()
                .map(|path| path.file_name().unwrap().to_string_lossy());
            format!("{} {}", setting.value, names.collect::<Vec<_>>().join(" "))
        };
        assert_eq!(of("ignore"), "[\"STR\",\"XAC\"] base.toml xacro-lint.toml");
        assert_eq!(of("target"), "\"ros1\" xacro-lint.toml");
        assert_eq!(of("limits.file-mb"), "5 base.toml");
        assert_eq!(of("limits.macro-depth"), "1000 ");
        assert_eq!(of("select"), "null ");
        let may_be_unset = |key: &str| ["select", "oldest-reader"].contains(&key);
        assert!(
            settings
                .iter()
                .all(|setting| may_be_unset(&setting.key) || !setting.value.is_null())
        );
    }
}
