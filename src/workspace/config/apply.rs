//! From values to settings, with a warning for everything that does not fit.
//!
//! A file goes over those it extends: single values and `select` replace, tables merge, lists add up.

use std::path::PathBuf;

use super::choice::Choice;
use super::keys::ConfigKey;
use super::settings::ConfigTable;
use super::value::{ConfigEntry, ConfigValue, ValueKind};
use super::{Config, ConfigLocation, ConfigMention, ConfigMentionKind, ConfigWarning};
use base::{TextRange, count_line_ends, last_line_start};
use packages::nearest;

/// Applies the entries of one file.
pub(super) struct Applier {
    path: PathBuf,
    text: String,
    pub(super) folder: PathBuf,
    /// Whether unknown keys are somebody else's.
    pub(super) passes_unknown: bool,
    pub(super) warnings: Vec<ConfigWarning>,
    mentions: Vec<ConfigMention>,
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
            mentions: Vec::new(),
        }
    }

    pub(super) fn place(&self, range: TextRange) -> ConfigLocation {
        let before = self.text.get(..range.start as usize).unwrap_or("");
        let line_start = last_line_start(before).unwrap_or(0);
        let column = before.get(line_start..).unwrap_or("").chars().count();
        let column = u32::try_from(column).unwrap_or(u32::MAX - 1) + 1;
        ConfigLocation {
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
    pub(super) fn config(&mut self, config: &mut Config, entries: &[ConfigEntry]) {
        for entry in self.known(entries, Config::KEYS, "") {
            config.apply(entry, self);
        }
        config.mentions.append(&mut self.mentions);
    }

    /// A list of names, which are noted.
    pub(super) fn named(&mut self, entry: &ConfigEntry, kind: ConfigMentionKind) -> Vec<String> {
        let mut names = Vec::new();
        for value in self.values(entry) {
            if let ValueKind::Text(text) = &value.kind {
                self.mention(text, value.range, kind);
                names.push(text.clone());
            } else {
                self.wrong(&entry.key, value, "a list of strings");
            }
        }
        names
    }

    /// Note a name for whoever knows which exist.
    pub(super) fn mention(&mut self, text: &str, range: TextRange, kind: ConfigMentionKind) {
        let place = self.place(range);
        self.mentions.push(ConfigMention {
            kind,
            text: text.to_owned(),
            place,
        });
    }

    // Types.

    /// The entries with a known key; the others give a warning.
    pub(super) fn known<'e>(
        &mut self,
        entries: &'e [ConfigEntry],
        keys: &[ConfigKey],
        table: &str,
    ) -> Vec<&'e ConfigEntry> {
        let (known, unknown): (Vec<&ConfigEntry>, Vec<&ConfigEntry>) = entries
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

    pub(super) fn wrong(&mut self, key: &str, value: &ConfigValue, wanted: &str) {
        self.warn(
            value.range,
            format!("`{key}` must be {wanted}, not {}", value.what()),
            None,
        );
    }

    /// The text of a string.
    pub(super) fn text<'e>(&mut self, entry: &'e ConfigEntry) -> Option<&'e str> {
        if let ValueKind::Text(text) = &entry.value.kind {
            return Some(text);
        }
        self.wrong(&entry.key, &entry.value, "a string");
        None
    }

    pub(super) fn values<'e>(&mut self, entry: &'e ConfigEntry) -> &'e [ConfigValue] {
        if let ValueKind::List(items) = &entry.value.kind {
            return items;
        }
        self.wrong(&entry.key, &entry.value, "a list");
        &[]
    }

    pub(super) fn texts(&mut self, entry: &ConfigEntry) -> Vec<String> {
        let mut texts = Vec::new();
        for value in self.values(entry) {
            match &value.kind {
                ValueKind::Text(text) => texts.push(text.clone()),
                _ => self.wrong(&entry.key, value, "a list of strings"),
            }
        }
        texts
    }

    pub(super) fn flag(&mut self, entry: &ConfigEntry) -> Option<bool> {
        if let ValueKind::Bool(value) = entry.value.kind {
            return Some(value);
        }
        self.wrong(&entry.key, &entry.value, "a boolean");
        None
    }

    pub(super) fn table<'e>(&mut self, entry: &'e ConfigEntry) -> &'e [ConfigEntry] {
        if let ValueKind::Table(entries) = &entry.value.kind {
            return entries;
        }
        self.wrong(&entry.key, &entry.value, "a table");
        &[]
    }

    /// A whole number within the bounds of its key.
    pub(super) fn count(&mut self, entry: &ConfigEntry, key: &ConfigKey) -> Option<u64> {
        let ValueKind::Int(value) = entry.value.kind else {
            self.wrong(&entry.key, &entry.value, "an integer");
            return None;
        };
        let most = key.most();
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

    /// One of these words.
    pub(super) fn word(
        &mut self,
        key: &str,
        value: &ConfigValue,
        words: &[&'static str],
    ) -> Option<&'static str> {
        let ValueKind::Text(text) = &value.kind else {
            self.wrong(key, value, "a string");
            return None;
        };
        let found = words.iter().find(|word| *word == text).copied();
        if found.is_none() {
            let all: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
            let message = format!("invalid value `{text}` for `{key}`; use {}", all.join(", "));
            self.warn(value.range, message, nearest(text, words.iter().copied()));
        }
        found
    }

    /// What one of a few words stands for.
    pub(super) fn choice<T: Choice>(&mut self, key: &str, value: &ConfigValue) -> Option<T> {
        self.word(key, value, T::NAMES).and_then(T::named)
    }
}
