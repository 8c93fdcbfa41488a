//! The settings that hold, with the files that set them.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::keys::{FORMAT, KEYS, LAYOUTS, LEVELS, LIMITS, PROFILES, TARGETS, Type};
use super::roots::{Args, Axes};
use super::value::{Entry, ValueKind};
use super::{AttributeLayout, Config, Level, Pattern, Profile, Root};
use crate::Target;

/// One key of the configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The key; of a key in a table, both with a dot between.
    pub key: String,
    /// Its value; null: not set, and without a default.
    pub value: Value,
    /// The files that set it, the nearest last; none for a default.
    pub origins: Vec<PathBuf>,
}

impl Profile {
    const ALL: [Profile; 4] = [
        Profile::RosIndustrial,
        Profile::Mobile,
        Profile::Gazebo,
        Profile::Pedantic,
    ];

    /// The profile of that name.
    pub fn named(name: &str) -> Option<Profile> {
        Self::ALL.into_iter().find(|profile| profile.name() == name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        PROFILES.get(self as usize).copied().unwrap_or_default()
    }
}

impl Level {
    /// Its name.
    pub fn name(self) -> &'static str {
        // the names are listed from the worst on
        LEVELS
            .iter()
            .rev()
            .nth(self as usize)
            .copied()
            .unwrap_or_default()
    }
}

impl Config {
    /// All keys in the order of the documentation, without those of the thresholds that are not set.
    pub fn settings(&self) -> Vec<Setting> {
        let mut settings = Vec::new();
        for key in KEYS.iter().filter(|key| key.name != "extend") {
            match key.of {
                Type::Keys(keys) => {
                    settings.extend(
                        keys.iter()
                            .map(|inner| self.setting(&format!("{}.{}", key.name, inner.name))),
                    );
                }
                _ => settings.push(self.setting(key.name)),
            }
        }
        settings
    }

    fn setting(&self, key: &str) -> Setting {
        let origins = self.origins.get(key).cloned().unwrap_or_default();
        Setting {
            key: key.to_owned(),
            value: self.value_of(key),
            origins,
        }
    }

    fn value_of(&self, key: &str) -> Value {
        let texts =
            |patterns: &[Pattern]| patterns.iter().map(|p| json!(p.text())).collect::<Value>();
        match key {
            "target" => json!(TARGETS.get(usize::from(self.target == Target::Ros1))),
            "urdf-version" => json!(self.urdf_version),
            "consumers" => json!(self.consumers),
            "oldest-reader" => json!(self.oldest_reader),
            "profile" => self
                .profiles
                .iter()
                .map(|profile| json!(profile.name()))
                .collect(),
            "select" => json!(self.select),
            "extend-select" => json!(self.extend_select),
            "ignore" => json!(self.ignore),
            "severity" => object(
                self.severity
                    .iter()
                    .map(|(rule, level)| (rule.clone(), json!(level.name()))),
            ),
            "per-file-ignores" => object(
                self.per_file_ignores
                    .iter()
                    .map(|(p, rules)| (p.text().to_owned(), json!(rules))),
            ),
            "exclude" => texts(&self.exclude),
            "package-path" => self.package_path.iter().map(|path| shown(path)).collect(),
            "use-environment" => json!(self.use_environment),
            "thresholds" => object(
                self.thresholds
                    .iter()
                    .map(|(name, &value)| (name.clone(), json!(value))),
            ),
            "allow-elements" => json!(self.allow_elements),
            "allow-attributes" => json!(self.allow_attributes),
            "roots" => self.roots.iter().map(root).collect(),
            _ => self.value_in_table(key),
        }
    }

    fn value_in_table(&self, key: &str) -> Value {
        let (format, limits) = (&self.format, &self.limits);
        match key {
            "format.line-width" => json!(format.line_width),
            "format.attributes" => {
                json!(LAYOUTS.get(usize::from(format.attributes == AttributeLayout::Auto)))
            }
            "format.self-close" => json!(format.self_close),
            "limits.eval-steps" => json!(limits.eval_steps),
            "limits.expand-nodes" => json!(limits.expand_nodes),
            "limits.expand-ms" => json!(limits.expand_ms),
            "limits.file-mb" => json!(limits.file_mb),
            "limits.macro-depth" => json!(limits.macro_depth),
            "limits.include-depth" => json!(limits.include_depth),
            _ => Value::Null,
        }
    }

    /// Remember that a file sets these keys.
    pub(super) fn note_origins(&mut self, entries: &[Entry], path: &Path) {
        for entry in entries {
            let mut note = |key: String| {
                let origins = self.origins.entry(key).or_default();
                if origins.last().is_none_or(|last| last != path) {
                    origins.push(path.to_owned());
                }
            };
            let inner = [("format", FORMAT), ("limits", LIMITS)]
                .iter()
                .any(|(name, _)| *name == entry.key);
            match &entry.value.kind {
                ValueKind::Table(fields) if inner => {
                    fields
                        .iter()
                        .for_each(|field| note(format!("{}.{}", entry.key, field.key)));
                }
                _ => note(entry.key.clone()),
            }
        }
    }
}

fn object(fields: impl Iterator<Item = (String, Value)>) -> Value {
    Value::Object(fields.collect::<Map<_, _>>())
}

fn shown(path: &Path) -> Value {
    json!(vfs::slashed(path))
}

fn root(root: &Root) -> Value {
    let args = |args: &Args| {
        object(
            args.iter()
                .map(|(name, value)| (name.clone(), json!(value))),
        )
    };
    let mut fields = Map::new();
    fields.insert("file".to_owned(), json!(root.file));
    if !root.args.is_empty() {
        fields.insert("args".to_owned(), axes(&root.args));
    }
    if !root.exclude.is_empty() {
        fields.insert(
            "exclude".to_owned(),
            root.exclude.iter().map(axes).collect(),
        );
    }
    if root.launch_choices {
        fields.insert("choices".to_owned(), json!("launch"));
    }
    if !root.presets.is_empty() {
        let presets = root
            .presets
            .iter()
            .map(|(name, preset)| (name.clone(), args(preset)));
        fields.insert("presets".to_owned(), object(presets));
    }
    if !root.expect.is_empty() {
        fields.insert(
            "expect".to_owned(),
            root.expect
                .iter()
                .map(|expected| expected.written.clone())
                .collect(),
        );
    }
    Value::Object(fields)
}

/// Arguments with their values; one value by itself.
fn axes(axes: &Axes) -> Value {
    object(axes.iter().map(|(name, values)| match values.as_slice() {
        [value] => (name.clone(), json!(value)),
        values => (name.clone(), json!(values)),
    }))
}

#[cfg(test)]
mod tests {
    use super::super::{Config, Level, Profile};
    use vfs::testing::Tree;

    #[test]
    fn names() {
        let levels = [
            Level::Off,
            Level::Hint,
            Level::Info,
            Level::Warning,
            Level::Error,
        ];
        assert_eq!(
            levels.map(Level::name),
            ["off", "hint", "info", "warning", "error"]
        );
        assert_eq!(
            Profile::ALL.map(Profile::name),
            ["ros-industrial", "mobile", "gazebo", "pedantic"]
        );
    }

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
