//! From values to settings, with a warning for everything that does not fit.
//!
//! A file goes over those it extends: single values and `select` replace, tables merge, lists add up.

use std::path::PathBuf;

use super::keys::{CONSUMERS, FORMAT, KEYS, Key, LAYOUTS, LEVELS, LIMITS, PROFILES, TARGETS, Type};
use super::pattern::Pattern;
use super::value::{Entry, Value, ValueKind};
use super::{
    AttributeLayout, Config, ConfigWarning, Format, Level, Limits, Mention, MentionKind, Place,
    Profile,
};
use crate::{Target, nearest};
use base::{TextRange, count_line_ends, last_line_start};

/// Applies the entries of one file.
pub(super) struct Applier {
    path: PathBuf,
    text: String,
    pub(super) folder: PathBuf,
    /// Whether unknown keys are somebody else's.
    pub(super) passes_unknown: bool,
    pub(super) warnings: Vec<ConfigWarning>,
}

impl Applier {
    /// For the file `path` with text `text`, whose relative paths start at `folder`.
    pub(super) fn new(path: PathBuf, text: String, folder: PathBuf) -> Self {
        Self {
            path,
            text,
            folder,
            passes_unknown: false,
            warnings: Vec::new(),
        }
    }

    pub(super) fn place(&self, range: TextRange) -> Place {
        let before = self.text.get(..range.start as usize).unwrap_or("");
        let line_start = last_line_start(before).unwrap_or(0);
        let column = before.get(line_start..).unwrap_or("").chars().count();
        let column = u32::try_from(column).unwrap_or(u32::MAX - 1) + 1;
        Place {
            path: self.path.clone(),
            range,
            line: count_line_ends(before) + 1,
            column,
        }
    }

    pub(super) fn warn(&mut self, range: TextRange, message: String, nearest: Option<&str>) {
        let (place, nearest) = (self.place(range), nearest.map(str::to_owned));
        // keys may have line ends in them
        let message = message.replace(['\n', '\r'], " ");
        self.warnings.push(ConfigWarning {
            place,
            message,
            nearest,
        });
    }

    /// Apply all entries to `config`.
    pub(super) fn config(&mut self, config: &mut Config, entries: &[Entry]) {
        for entry in self.known(entries, KEYS, "") {
            match entry.key.as_str() {
                "target" => {
                    let targets = [Target::Ros2, Target::Ros1];
                    self.set(&mut config.target, entry, TARGETS, &targets);
                }
                "urdf-version" => config.urdf_version = self.texts(entry),
                "consumers" => {
                    for value in self.values(entry) {
                        let name = self
                            .choice(&entry.key, value, CONSUMERS, CONSUMERS)
                            .map(str::to_owned);
                        config
                            .consumers
                            .extend(name.filter(|name| !config.consumers.contains(name)));
                    }
                }
                "oldest-reader" => {
                    let is_version =
                        |text: &&str| text.split('.').all(|part| part.parse::<u32>().is_ok());
                    let version = self.text(entry);
                    config.oldest_reader = version.filter(is_version).map(str::to_owned);
                    if let Some(text) = version.filter(|text| !is_version(text)) {
                        let key = &entry.key;
                        let message = format!(
                            "invalid value `{text}` for `{key}`; use a version of urdfdom, such as `4.0`"
                        );
                        self.warn(entry.value.range, message, None);
                    }
                }
                "profile" => {
                    let all = [
                        Profile::RosIndustrial,
                        Profile::Mobile,
                        Profile::Gazebo,
                        Profile::Pedantic,
                    ];
                    for value in self.values(entry) {
                        let profile = self.choice(&entry.key, value, PROFILES, &all);
                        config
                            .profiles
                            .extend(profile.filter(|profile| !config.profiles.contains(profile)));
                    }
                }
                "severity" => self.severity(config, entry),
                "per-file-ignores" => self.per_file_ignores(config, entry),
                "exclude" => {
                    let patterns = self.texts(entry);
                    config
                        .exclude
                        .extend(patterns.iter().map(|text| Pattern::new(text, &self.folder)));
                }
                "package-path" => {
                    let folders = self.named(config, entry, MentionKind::Folder);
                    let folders = folders.into_iter().map(|folder| self.folder.join(folder));
                    config
                        .package_path
                        .splice(0..0, folders.collect::<Vec<_>>());
                }
                "use-environment" => {
                    config.use_environment = self.flag(entry).unwrap_or(config.use_environment)
                }
                "thresholds" => self.thresholds(config, entry),
                "allow-elements" => config.allow_elements.extend(self.texts(entry)),
                "allow-attributes" => config.allow_attributes.extend(self.texts(entry)),
                "roots" => {
                    let roots = self.roots(entry);
                    config.roots.splice(0..0, roots);
                }
                "format" => self.format(&mut config.format, entry),
                "limits" => self.limits(&mut config.limits, entry),
                _ => self.selection(config, entry),
            }
        }
    }

    fn selection(&mut self, config: &mut Config, entry: &Entry) {
        let rules = match entry.key.as_str() {
            "select" | "extend-select" | "ignore" => self.named(config, entry, MentionKind::Rule),
            _ => return,
        };
        match entry.key.as_str() {
            "select" => config.select = Some(rules),
            "ignore" => config.ignore.extend(rules),
            _ => config.extend_select.extend(rules),
        }
    }

    /// A list of names, which are noted.
    fn named(&mut self, config: &mut Config, entry: &Entry, kind: MentionKind) -> Vec<String> {
        let mut names = Vec::new();
        for value in self.values(entry) {
            if let ValueKind::Text(text) = &value.kind {
                self.mention(config, text, value.range, kind);
                names.push(text.clone());
            } else {
                self.wrong(&entry.key, value, "a list of strings");
            }
        }
        names
    }

    fn mention(&self, config: &mut Config, text: &str, range: TextRange, kind: MentionKind) {
        let place = self.place(range);
        config.mentions.push(Mention {
            kind,
            text: text.to_owned(),
            place,
        });
    }

    fn severity(&mut self, config: &mut Config, entry: &Entry) {
        let levels = [
            Level::Error,
            Level::Warning,
            Level::Info,
            Level::Hint,
            Level::Off,
        ];
        for field in self.table(entry) {
            self.mention(config, &field.key, field.key_range, MentionKind::Rule);
            if let Some(level) = self.choice(&field.key, &field.value, LEVELS, &levels) {
                config.severity.insert(field.key.clone(), level);
            }
        }
    }

    fn per_file_ignores(&mut self, config: &mut Config, entry: &Entry) {
        for field in self.table(entry) {
            let rules = self.named(config, field, MentionKind::Rule);
            config
                .per_file_ignores
                .push((Pattern::new(&field.key, &self.folder), rules));
        }
    }

    fn thresholds(&mut self, config: &mut Config, entry: &Entry) {
        for field in self.table(entry) {
            self.mention(config, &field.key, field.key_range, MentionKind::Threshold);
            match field.value.kind {
                ValueKind::Int(Some(value)) => {
                    config.thresholds.insert(field.key.clone(), value as f64);
                }
                ValueKind::Float(value, _) if value.is_finite() => {
                    config.thresholds.insert(field.key.clone(), value);
                }
                _ => self.wrong(&field.key, &field.value, "a number"),
            }
        }
    }

    fn format(&mut self, format: &mut Format, entry: &Entry) {
        let fields = self.table(entry);
        for field in self.known(fields, FORMAT, "format") {
            match field.key.as_str() {
                "line-width" => {
                    let width = self
                        .count(field, FORMAT)
                        .and_then(|width| u32::try_from(width).ok());
                    format.line_width = width.unwrap_or(format.line_width);
                }
                "self-close" => format.self_close = self.flag(field).unwrap_or(format.self_close),
                _ => {
                    let layouts = [AttributeLayout::Keep, AttributeLayout::Auto];
                    self.set(&mut format.attributes, field, LAYOUTS, &layouts);
                }
            }
        }
    }

    fn limits(&mut self, limits: &mut Limits, entry: &Entry) {
        let fields = self.table(entry);
        for field in self.known(fields, LIMITS, "limits") {
            let Some(value) = self.count(field, LIMITS) else {
                continue;
            };
            let depth = u32::try_from(value).unwrap_or(u32::MAX);
            match field.key.as_str() {
                "eval-steps" => limits.eval_steps = value,
                "expand-nodes" => limits.expand_nodes = value,
                "expand-ms" => limits.expand_ms = value,
                "file-mb" => limits.file_mb = value,
                "macro-depth" => limits.macro_depth = depth,
                _ => limits.include_depth = depth,
            }
        }
    }

    // Types.

    /// The entries with a known key; the others give a warning.
    pub(super) fn known<'e>(
        &mut self,
        entries: &'e [Entry],
        keys: &[Key],
        table: &str,
    ) -> Vec<&'e Entry> {
        let (known, unknown): (Vec<&Entry>, Vec<&Entry>) = entries
            .iter()
            .partition(|entry| keys.iter().any(|key| key.name == entry.key));
        let unknown = if self.passes_unknown {
            Vec::new()
        } else {
            unknown
        };
        for entry in unknown {
            let near = nearest(&entry.key, keys.iter().map(|key| key.name));
            let place = if table.is_empty() {
                String::new()
            } else {
                format!(" in `{table}`")
            };
            self.warn(
                entry.key_range,
                format!("unknown key `{}`{place}", entry.key),
                near,
            );
        }
        known
    }

    pub(super) fn wrong(&mut self, key: &str, value: &Value, wanted: &str) {
        self.warn(
            value.range,
            format!("`{key}` must be {wanted}, not {}", value.what()),
            None,
        );
    }

    /// The text of a string.
    pub(super) fn text<'e>(&mut self, entry: &'e Entry) -> Option<&'e str> {
        if let ValueKind::Text(text) = &entry.value.kind {
            return Some(text);
        }
        self.wrong(&entry.key, &entry.value, "a string");
        None
    }

    pub(super) fn values<'e>(&mut self, entry: &'e Entry) -> &'e [Value] {
        if let ValueKind::List(items) = &entry.value.kind {
            return items;
        }
        self.wrong(&entry.key, &entry.value, "a list");
        &[]
    }

    pub(super) fn texts(&mut self, entry: &Entry) -> Vec<String> {
        let mut texts = Vec::new();
        for value in self.values(entry) {
            match &value.kind {
                ValueKind::Text(text) => texts.push(text.clone()),
                _ => self.wrong(&entry.key, value, "a list of strings"),
            }
        }
        texts
    }

    fn flag(&mut self, entry: &Entry) -> Option<bool> {
        if let ValueKind::Bool(value) = entry.value.kind {
            return Some(value);
        }
        self.wrong(&entry.key, &entry.value, "a boolean");
        None
    }

    pub(super) fn table<'e>(&mut self, entry: &'e Entry) -> &'e [Entry] {
        if let ValueKind::Table(entries) = &entry.value.kind {
            return entries;
        }
        self.wrong(&entry.key, &entry.value, "a table");
        &[]
    }

    /// A whole number within the bounds of its key.
    fn count(&mut self, entry: &Entry, keys: &[Key]) -> Option<u64> {
        let most = keys.iter().find_map(|key| match key.of {
            Type::Count(most) if key.name == entry.key => Some(most),
            _ => None,
        });
        let ValueKind::Int(value) = entry.value.kind else {
            self.wrong(&entry.key, &entry.value, "an integer");
            return None;
        };
        let most = most.unwrap_or(u64::MAX);
        let value = value.and_then(|value| u64::try_from(value).ok());
        let fits = value.filter(|value| (1..=most).contains(value));
        if fits.is_none() {
            let bounds = if most == u64::MAX {
                "at least 1".to_owned()
            } else {
                format!("from 1 to {most}")
            };
            self.warn(
                entry.value.range,
                format!("`{}` must be {bounds}", entry.key),
                None,
            );
        }
        fits
    }

    pub(super) fn choice<T: Copy>(
        &mut self,
        key: &str,
        value: &Value,
        names: &[&str],
        values: &[T],
    ) -> Option<T> {
        let ValueKind::Text(text) = &value.kind else {
            self.wrong(key, value, "a string");
            return None;
        };
        let found = names
            .iter()
            .position(|name| name == text)
            .and_then(|at| values.get(at).copied());
        if found.is_none() {
            let all: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            let message = format!("invalid value `{text}` for `{key}`; use {}", all.join(", "));
            self.warn(value.range, message, nearest(text, names.iter().copied()));
        }
        found
    }

    /// Set `slot` if the entry has one of the values.
    fn set<T: Copy>(&mut self, slot: &mut T, entry: &Entry, names: &[&str], values: &[T]) {
        *slot = self
            .choice(&entry.key, &entry.value, names, values)
            .unwrap_or(*slot);
    }
}
