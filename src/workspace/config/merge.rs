//! How the values of a key go over those of a file that is extended, and how they are printed.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value as Json, json};

use super::apply::Applier;
use super::choice::Choice;
use super::keys::ConfigKey;
use super::pattern::Pattern;
use super::roots::{Axes, Root, XacroArgs};
use super::value::{ConfigEntry, ValueKind};
use super::{ConfigMentionKind, RuleLevel};

/// What a key does with its setting, of type `T`.
pub(super) trait Merge<T> {
    /// Take the value of an entry over; what does not fit is a warning.
    fn merge(setting: &mut T, entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier);

    /// The setting as JSON; null: not set, and without a default.
    fn json(setting: &T) -> Json;
}

/// A value that is read as a whole.
pub(super) trait WholeValue: Sized {
    fn read(entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier) -> Option<Self>;

    fn json(&self) -> Json;
}

impl WholeValue for bool {
    fn read(entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) -> Option<Self> {
        applier.flag(entry)
    }

    fn json(&self) -> Json {
        json!(self)
    }
}

impl WholeValue for u64 {
    fn read(entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier) -> Option<Self> {
        applier.count(entry, key)
    }

    fn json(&self) -> Json {
        json!(self)
    }
}

impl WholeValue for u32 {
    fn read(entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier) -> Option<Self> {
        let count = applier.count(entry, key)?;
        Some(Self::try_from(count).unwrap_or(Self::MAX))
    }

    fn json(&self) -> Json {
        json!(self)
    }
}

impl WholeValue for Vec<String> {
    fn read(entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) -> Option<Self> {
        let texts = applier.texts(entry);
        matches!(entry.value.kind, ValueKind::List(_)).then_some(texts)
    }

    fn json(&self) -> Json {
        json!(self)
    }
}

impl<T: Choice> WholeValue for T {
    fn read(entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) -> Option<Self> {
        applier.choice(&entry.key, &entry.value)
    }

    fn json(&self) -> Json {
        json!(self.word())
    }
}

/// The value replaces the one before.
pub(super) struct Replace;

impl<T: WholeValue> Merge<T> for Replace {
    fn merge(setting: &mut T, entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier) {
        if let Some(value) = T::read(entry, key, applier) {
            *setting = value;
        }
    }

    fn json(setting: &T) -> Json {
        setting.json()
    }
}

/// A version of urdfdom, which replaces the one before.
pub(super) struct ReaderVersion;

impl Merge<Option<String>> for ReaderVersion {
    fn merge(
        setting: &mut Option<String>,
        entry: &ConfigEntry,
        key: &ConfigKey,
        applier: &mut Applier,
    ) {
        let text = applier.text(entry);
        *setting = text.filter(|text| is_version(text)).map(str::to_owned);
        if let Some(text) = text.filter(|text| !is_version(text)) {
            let name = key.name;
            let message = format!(
                "invalid value `{text}` for `{name}`; use a version of urdfdom, such as `4.0`"
            );
            applier.warn(entry.value.range, message, None);
        }
    }

    fn json(setting: &Option<String>) -> Json {
        json!(setting)
    }
}

fn is_version(text: &str) -> bool {
    text.split('.').all(|part| part.parse::<u32>().is_ok())
}

/// Strings that are added to those before.
pub(super) struct Add;

impl Merge<Vec<String>> for Add {
    fn merge(setting: &mut Vec<String>, entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) {
        setting.extend(applier.texts(entry));
    }

    fn json(setting: &Vec<String>) -> Json {
        json!(setting)
    }
}

/// Words that are added to those before, each once.
pub(super) struct AddWords;

impl Merge<Vec<String>> for AddWords {
    fn merge(
        setting: &mut Vec<String>,
        entry: &ConfigEntry,
        key: &ConfigKey,
        applier: &mut Applier,
    ) {
        for value in applier.values(entry) {
            let word = applier.word(&entry.key, value, key.words());
            let word = word.map(str::to_owned);
            setting.extend(word.filter(|word| !setting.contains(word)));
        }
    }

    fn json(setting: &Vec<String>) -> Json {
        json!(setting)
    }
}

impl<T: Choice> Merge<Vec<T>> for AddWords {
    fn merge(setting: &mut Vec<T>, entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) {
        for value in applier.values(entry) {
            let choice = applier.choice(&entry.key, value);
            setting.extend(choice.filter(|choice| !setting.contains(choice)));
        }
    }

    fn json(setting: &Vec<T>) -> Json {
        setting.iter().map(|choice| json!(choice.word())).collect()
    }
}

/// Names of rules that replace those before.
pub(super) struct ReplaceRules;

impl Merge<Option<Vec<String>>> for ReplaceRules {
    fn merge(
        setting: &mut Option<Vec<String>>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        *setting = Some(applier.named(entry, ConfigMentionKind::Rule));
    }

    fn json(setting: &Option<Vec<String>>) -> Json {
        json!(setting)
    }
}

/// Names of rules that are added to those before.
pub(super) struct AddRules;

impl Merge<Vec<String>> for AddRules {
    fn merge(setting: &mut Vec<String>, entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) {
        setting.extend(applier.named(entry, ConfigMentionKind::Rule));
    }

    fn json(setting: &Vec<String>) -> Json {
        json!(setting)
    }
}

/// Severities by rule; the entry of a rule replaces the one before.
pub(super) struct BySeverity;

impl Merge<BTreeMap<String, RuleLevel>> for BySeverity {
    fn merge(
        setting: &mut BTreeMap<String, RuleLevel>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        for field in applier.table(entry) {
            applier.mention(&field.key, field.key_range, ConfigMentionKind::Rule);
            if let Some(level) = applier.choice(&field.key, &field.value) {
                setting.insert(field.key.clone(), level);
            }
        }
    }

    fn json(setting: &BTreeMap<String, RuleLevel>) -> Json {
        let levels = setting.iter();
        object(levels.map(|(rule, level)| (rule.clone(), json!(level.word()))))
    }
}

/// Rules by glob, added to those before.
pub(super) struct AddIgnores;

impl Merge<Vec<(Pattern, Vec<String>)>> for AddIgnores {
    fn merge(
        setting: &mut Vec<(Pattern, Vec<String>)>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        for field in applier.table(entry) {
            let rules = applier.named(field, ConfigMentionKind::Rule);
            setting.push((Pattern::new(&field.key, &applier.folder), rules));
        }
    }

    fn json(setting: &Vec<(Pattern, Vec<String>)>) -> Json {
        let ignores = setting.iter();
        object(ignores.map(|(glob, rules)| (glob.text().to_owned(), json!(rules))))
    }
}

/// Globs that are added to those before.
pub(super) struct AddGlobs;

impl Merge<Vec<Pattern>> for AddGlobs {
    fn merge(
        setting: &mut Vec<Pattern>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        let globs = applier.texts(entry);
        setting.extend(globs.iter().map(|text| Pattern::new(text, &applier.folder)));
    }

    fn json(setting: &Vec<Pattern>) -> Json {
        setting.iter().map(|glob| json!(glob.text())).collect()
    }
}

/// Folders that are searched before those of a file that is extended.
pub(super) struct PutFolders;

impl Merge<Vec<PathBuf>> for PutFolders {
    fn merge(
        setting: &mut Vec<PathBuf>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        let folders = applier.named(entry, ConfigMentionKind::Folder);
        let folders: Vec<PathBuf> = folders
            .into_iter()
            .map(|folder| applier.folder.join(folder))
            .collect();
        setting.splice(0..0, folders);
    }

    fn json(setting: &Vec<PathBuf>) -> Json {
        setting.iter().map(|path| shown(path)).collect()
    }
}

/// Numbers by name; the entry of a name replaces the one before.
pub(super) struct Thresholds;

impl Merge<BTreeMap<String, f64>> for Thresholds {
    fn merge(
        setting: &mut BTreeMap<String, f64>,
        entry: &ConfigEntry,
        _: &ConfigKey,
        applier: &mut Applier,
    ) {
        for field in applier.table(entry) {
            applier.mention(&field.key, field.key_range, ConfigMentionKind::Threshold);
            match field.value.kind {
                ValueKind::Int(Some(value)) => {
                    setting.insert(field.key.clone(), value as f64);
                }
                ValueKind::Float(value, _) if value.is_finite() => {
                    setting.insert(field.key.clone(), value);
                }
                _ => applier.wrong(&field.key, &field.value, "a number"),
            }
        }
    }

    fn json(setting: &BTreeMap<String, f64>) -> Json {
        let numbers = setting.iter();
        object(numbers.map(|(name, value)| (name.clone(), json!(value))))
    }
}

/// Entries of `[[roots]]`, in front of those of a file that is extended.
pub(super) struct PutRoots;

impl Merge<Vec<Root>> for PutRoots {
    fn merge(setting: &mut Vec<Root>, entry: &ConfigEntry, _: &ConfigKey, applier: &mut Applier) {
        let roots = applier.roots(entry);
        setting.splice(0..0, roots);
    }

    fn json(setting: &Vec<Root>) -> Json {
        setting.iter().map(root).collect()
    }
}

fn object(fields: impl Iterator<Item = (String, Json)>) -> Json {
    Json::Object(fields.collect::<Map<_, _>>())
}

fn shown(path: &Path) -> Json {
    json!(vfs::slashed(path))
}

fn root(root: &Root) -> Json {
    let args = |args: &XacroArgs| {
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
    Json::Object(fields)
}

/// Arguments with their values; one value by itself.
fn axes(axes: &Axes) -> Json {
    object(axes.iter().map(|(name, values)| match values.as_slice() {
        [value] => (name.clone(), json!(value)),
        values => (name.clone(), json!(values)),
    }))
}
