//! All keys of the configuration: each is declared once, with its type, default, merging and help. The fields, the reader,
//! the output of `xacro-lint config`, the JSON schema and completion follow from it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Duration;

use serde_json::Value as Json;

use super::ConfigMention;
use super::apply::Applier;
use super::choice::{AttributeLayout, Choice, Profile, RuleLevel};
use super::keys::{CONSUMERS, ConfigKey, KeyType, ROOTS, key};
use super::merge::{
    Add, AddGlobs, AddIgnores, AddRules, AddWords, BySeverity, Merge, PutFolders, PutRoots,
    ReaderVersion, Replace, ReplaceRules, Thresholds,
};
use super::pattern::Pattern;
use super::roots::Root;
use super::value::ConfigEntry;
use base::ExpansionLimits;
use base::limits::{self, FILE_MB_MOST};
use packages::RosVersion;

/// A table of settings.
pub(super) trait ConfigTable: Sized {
    /// Its keys, in the order of the documentation.
    const KEYS: &'static [ConfigKey];

    /// Take the value of one entry over.
    fn apply(&mut self, entry: &ConfigEntry, applier: &mut Applier);

    /// The settings by key, in the same order.
    fn values(&self) -> Vec<(&'static ConfigKey, Json)>;
}

/// A table in the configuration: its entries replace those before, one by one.
pub(super) struct Inner;

impl<T: ConfigTable> Merge<T> for Inner {
    fn merge(setting: &mut T, entry: &ConfigEntry, key: &ConfigKey, applier: &mut Applier) {
        let fields = applier.table(entry);
        for field in applier.known(fields, T::KEYS, key.name) {
            setting.apply(field, applier);
        }
    }

    fn json(setting: &T) -> Json {
        let values = setting.values().into_iter();
        let fields = values.map(|(key, value)| (key.name.to_owned(), value));
        Json::Object(fields.collect())
    }
}

/// Declares a table of settings. For each key: its name, the type of its values, its field with default, what it does
/// with the setting of a file that is extended, and its help. `read elsewhere` are keys without a field, `besides` fields
/// without a key.
macro_rules! settings {
    (
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($key:literal: $of:expr => $field:ident: $type:ty = $default:expr, $how:ty, $help:literal;)*
        }
        read elsewhere { $($other:literal: $other_of:expr, $other_help:literal;)* }
        besides { $($(#[$plain_doc:meta])* $plain:ident: $plain_type:ty,)* }
    ) => {
        $(#[$meta])*
        pub struct $name {
            $(#[doc = $help] pub $field: $type,)*
            $($(#[$plain_doc])* pub $plain: $plain_type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self {
                    $($field: $default,)*
                    $($plain: Default::default(),)*
                }
            }
        }

        impl ConfigTable for $name {
            const KEYS: &'static [ConfigKey] = &[
                $(key($other, $other_of, $other_help),)*
                $(key($key, $of, $help),)*
            ];

            fn apply(&mut self, entry: &ConfigEntry, applier: &mut Applier) {
                let Some(key) = Self::KEYS.iter().find(|key| key.name == entry.key) else {
                    return;
                };
                match key.name {
                    $($key => <$how as Merge<$type>>::merge(&mut self.$field, entry, key, applier),)*
                    _ => {}
                }
            }

            fn values(&self) -> Vec<(&'static ConfigKey, Json)> {
                let values = [$(($key, <$how as Merge<$type>>::json(&self.$field))),*];
                let keyed = values.into_iter().filter_map(|(name, value)| {
                    Some((Self::KEYS.iter().find(|key| key.name == name)?, value))
                });
                keyed.collect()
            }
        }
    };
}

settings! {
    /// All settings, with their defaults filled in.
    #[derive(Clone, Debug)]
    pub struct Config {
        "target": KeyType::Choice(RosVersion::NAMES) => target: RosVersion = RosVersion::Ros2, Replace,
            "Dialect of xacro and package conventions; default `ros2`.";
        "urdf-version": KeyType::Texts => urdf_version: Vec<String> = vec!["1.0".to_owned()], Replace,
            "Supported URDF versions; default `1.0`.";
        "consumers": KeyType::Choices(CONSUMERS) => consumers: Vec<String> = Vec::new(), AddWords,
            "Programs that have to load the robots.";
        "oldest-reader": KeyType::Text => oldest_reader: Option<String> = None, ReaderVersion,
            "Oldest version of urdfdom that has to load the robots, such as `3.0`; default: the newest.";
        "profile": KeyType::Choices(Profile::NAMES) => profiles: Vec<Profile> = Vec::new(), AddWords,
            "Profiles whose rules are enabled.";
        "select": KeyType::Texts => select: Option<Vec<String>> = None, ReplaceRules,
            "Run only these rules (codes, code prefixes or names).";
        "extend-select": KeyType::Texts => extend_select: Vec<String> = Vec::new(), AddRules,
            "Run these rules in addition (codes, code prefixes or names).";
        "ignore": KeyType::Texts => ignore: Vec<String> = Vec::new(), AddRules,
            "Do not run these rules (codes, code prefixes or names).";
        "severity": KeyType::Map(&KeyType::Choice(RuleLevel::NAMES)) => severity: BTreeMap<String, RuleLevel> = BTreeMap::new(), BySeverity,
            "Severity per rule.";
        "per-file-ignores": KeyType::Map(&KeyType::Texts) => per_file_ignores: Vec<(Pattern, Vec<String>)> = Vec::new(), AddIgnores,
            "Rules not to run, per file glob.";
        "exclude": KeyType::Texts => exclude: Vec<Pattern> = Vec::new(), AddGlobs,
            "Globs of files and folders to exclude from checks.";
        "package-path": KeyType::Texts => package_path: Vec<PathBuf> = Vec::new(), PutFolders,
            "Folders to search for packages first.";
        "use-environment": KeyType::Bool => use_environment: bool = true, Replace,
            "Use AMENT_PREFIX_PATH, COLCON_PREFIX_PATH and ROS_PACKAGE_PATH; default true.";
        "thresholds": KeyType::Map(&KeyType::Number) => thresholds: BTreeMap<String, f64> = BTreeMap::new(), Thresholds,
            "Thresholds of rules; the unit is in the name.";
        "allow-elements": KeyType::Texts => allow_elements: Vec<String> = Vec::new(), Add,
            "Additional known elements.";
        "allow-attributes": KeyType::Texts => allow_attributes: Vec<String> = Vec::new(), Add,
            "Additional known attributes.";
        "roots": KeyType::Tables(ROOTS) => roots: Vec<Root> = Vec::new(), PutRoots,
            "Root files and their arguments.";
        "format": KeyType::Keys(Format::KEYS) => format: Format = Format::default(), Inner,
            "Formatting.";
        "limits": KeyType::Keys(Limits::KEYS) => limits: Limits = Limits::default(), Inner,
            "Limits for one expansion.";
    }
    read elsewhere {
        "extend": KeyType::Text, "Configuration file to extend; settings in this file take precedence.";
    }
    besides {
        /// The files it was read from, the nearest first; none when all are defaults.
        files: Vec<PathBuf>,
        /// The names of rules and thresholds in the file, for whoever knows which exist.
        mentions: Vec<ConfigMention>,
        /// By key: the files that set it, the nearest last.
        origins: BTreeMap<String, Vec<PathBuf>>,
    }
}

settings! {
    /// How files are formatted.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct Format {
        "line-width": KeyType::Count(10_000) => line_width: u32 = 120, Replace,
            "Maximum line length for wrapping; default 120.";
        "attributes": KeyType::Choice(AttributeLayout::NAMES) => attributes: AttributeLayout = AttributeLayout::Keep, Replace,
            "Keep (`keep`) or re-wrap (`auto`) line breaks between attributes.";
        "self-close": KeyType::Bool => self_close: bool = false, Replace,
            "Write `<a></a>` as `<a/>`; default false.";
    }
    read elsewhere {}
    besides {}
}

settings! {
    /// Budgets of one expansion.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct Limits {
        "eval-steps": KeyType::Count(u64::MAX) => eval_steps: u64 = limits::EVAL_STEPS, Replace,
            "Maximum number of steps to evaluate one expression; default 1000000.";
        "expand-nodes": KeyType::Count(u64::MAX) => expand_nodes: u64 = limits::EXPAND_NODES, Replace,
            "Maximum number of nodes of the expanded robot; default 500000.";
        "expand-ms": KeyType::Count(u64::MAX) => expand_ms: u64 = limits::EXPAND_MS, Replace,
            "Maximum time for one expansion in milliseconds; default 5000.";
        "file-mb": KeyType::Count(FILE_MB_MOST) => file_mb: u64 = limits::FILE_MB, Replace,
            "Maximum file size in megabytes; default 20.";
        "macro-depth": KeyType::Count(10_000) => macro_depth: u32 = limits::MACRO_DEPTH, Replace,
            "Maximum nesting depth of macro calls; default 1000.";
        "include-depth": KeyType::Count(10_000) => include_depth: u32 = limits::INCLUDE_DEPTH, Replace,
            "Maximum nesting depth of includes; default 500.";
    }
    read elsewhere {}
    besides {}
}

impl Limits {
    /// The budgets of one expansion.
    pub fn expansion(&self) -> ExpansionLimits {
        ExpansionLimits {
            eval_steps: self.eval_steps,
            expand_nodes: self.expand_nodes,
            expand_time: Duration::from_millis(self.expand_ms),
            macro_depth: self.macro_depth,
            include_depth: self.include_depth,
            ..ExpansionLimits::default()
        }
    }

    /// The size limit of files in bytes.
    pub fn file_bytes(&self) -> u64 {
        self.file_mb.saturating_mul(1_000_000)
    }
}
