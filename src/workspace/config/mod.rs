//! The configuration file: `xacro-lint.toml`, or `.xacro-lint.toml`.
//!
//! What is wrong in it is a warning with a place; the rest holds. Editor settings are the same keys in
//! camelCase and are read by the same code.

mod apply;
mod apply_roots;
mod effective;
mod expect;
#[cfg(test)]
mod files_tests;
mod keys;
mod load;
mod pattern;
mod place;
mod roots;
mod schema;
#[cfg(test)]
mod tests;
mod value;
mod wanted;

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

pub use effective::Setting;
pub use expect::{Expectation, ExpectedJoint};
pub use keys::CONSUMERS;
pub use load::{CONFIG_NAMES, Loaded, argument_places, find_config, unknown_settings};
pub use pattern::Pattern;
pub use place::{ConfigPlace, PlaceKind, is_bare, place_at};
pub use roots::{Args, Axes, Root, Variant, files_named};
pub use schema::schema;
pub use wanted::{Wanted, doc, wanted};

use super::packages::Target;
use base::{TextRange, limits};

/// All settings, with their defaults filled in.
#[derive(Clone, Debug)]
pub struct Config {
    /// The files it was read from, the nearest first; none when all are defaults.
    pub files: Vec<PathBuf>,
    /// Dialect of xacro and conventions for packages.
    pub target: Target,
    /// Admitted values of `robot/@version`.
    pub urdf_version: Vec<String>,
    /// The programs that have to load the robots.
    pub consumers: Vec<String>,
    /// The oldest urdfdom that has to load the robots.
    pub oldest_reader: Option<String>,
    /// Profiles that are switched on.
    pub profiles: Vec<Profile>,
    /// Codes, prefixes or names of the only rules to run; `None` for the default set.
    pub select: Option<Vec<String>>,
    /// The same for rules to run in addition.
    pub extend_select: Vec<String>,
    /// The same for rules not to run.
    pub ignore: Vec<String>,
    /// Severity by rule.
    pub severity: BTreeMap<String, Level>,
    /// Rules not to run on files that match.
    pub per_file_ignores: Vec<(Pattern, Vec<String>)>,
    /// Files and folders never checked.
    pub exclude: Vec<Pattern>,
    /// Folders searched for packages before all others.
    pub package_path: Vec<PathBuf>,
    /// Whether the variables that list package folders are read.
    pub use_environment: bool,
    /// Numbers of rules by name; the unit is in the name.
    pub thresholds: BTreeMap<String, f64>,
    /// Elements that are part of the vocabulary in addition.
    pub allow_elements: Vec<String>,
    /// Attributes that are part of the vocabulary in addition.
    pub allow_attributes: Vec<String>,
    /// Entry files and their arguments.
    pub roots: Vec<Root>,
    /// How files are formatted.
    pub format: Format,
    /// Budgets.
    pub limits: Limits,
    /// The names of rules and thresholds in the file, for whoever knows which exist.
    pub mentions: Vec<Mention>,
    /// By key: the files that set it, the nearest last.
    pub origins: BTreeMap<String, Vec<PathBuf>>,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            files: Vec::new(),
            target: Target::Ros2,
            urdf_version: vec!["1.0".to_owned()],
            consumers: Vec::new(),
            oldest_reader: None,
            profiles: Vec::new(),
            select: None,
            extend_select: Vec::new(),
            ignore: Vec::new(),
            severity: BTreeMap::new(),
            per_file_ignores: Vec::new(),
            exclude: Vec::new(),
            package_path: Vec::new(),
            use_environment: true,
            thresholds: BTreeMap::new(),
            allow_elements: Vec::new(),
            allow_attributes: Vec::new(),
            roots: Vec::new(),
            format: Format::default(),
            limits: Limits::default(),
            mentions: Vec::new(),
            origins: BTreeMap::new(),
        }
    }
}

/// Groups of rules for a kind of user.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Profile {
    RosIndustrial,
    Mobile,
    Gazebo,
    Pedantic,
}

/// The severity a rule is set to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Level {
    Off,
    Hint,
    Info,
    Warning,
    Error,
}

/// How files are formatted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Format {
    /// Characters per line that wrapping aims at.
    pub line_width: u32,
    /// What happens to line breaks between attributes.
    pub attributes: AttributeLayout,
    /// Whether `<a></a>` becomes `<a/>`.
    pub self_close: bool,
}

impl Default for Format {
    fn default() -> Self {
        Self {
            line_width: 120,
            attributes: AttributeLayout::Keep,
            self_close: false,
        }
    }
}

/// Line breaks between attributes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AttributeLayout {
    /// They stay, aligned.
    Keep,
    /// They are set where the line is full.
    Auto,
}

/// Budgets of one expansion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Steps of evaluating one expression.
    pub eval_steps: u64,
    /// Nodes of the result.
    pub expand_nodes: u64,
    /// Time, in milliseconds.
    pub expand_ms: u64,
    /// Size of a file that is read, in megabytes (10^6 bytes).
    pub file_mb: u64,
    /// Macro calls inside each other.
    pub macro_depth: u32,
    /// Files included from each other.
    pub include_depth: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            eval_steps: limits::EVAL_STEPS,
            expand_nodes: limits::EXPAND_NODES,
            expand_ms: limits::EXPAND_MS,
            file_mb: limits::FILE_MB,
            macro_depth: limits::MACRO_DEPTH,
            include_depth: limits::INCLUDE_DEPTH,
        }
    }
}

impl Limits {
    /// The size limit of files in bytes.
    pub fn file_bytes(&self) -> u64 {
        self.file_mb.saturating_mul(1_000_000)
    }
}

/// A place in a configuration file, or in the settings of an editor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file; empty for editor settings.
    pub path: PathBuf,
    /// Bytes of the file.
    pub range: TextRange,
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
}

/// A name whose meaning is outside of the configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mention {
    /// What it names.
    pub kind: MentionKind,
    /// The name, as it is written.
    pub text: String,
    /// Where it stands.
    pub place: Place,
}

/// What a name in a configuration names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MentionKind {
    /// Rules, by code, prefix or name.
    Rule,
    /// A threshold of a rule.
    Threshold,
    /// A folder of packages.
    Folder,
}

/// Something in the configuration that has no effect.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigWarning {
    /// Where it stands.
    pub place: Place,
    /// What is wrong.
    pub message: String,
    /// What may have been meant.
    pub nearest: Option<String>,
}

impl fmt::Display for ConfigWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place {
            path, line, column, ..
        } = &self.place;
        if !path.as_os_str().is_empty() {
            write!(f, "{}:{line}:{column}: ", vfs::slashed(path))?;
        }
        f.write_str(&self.message)?;
        match &self.nearest {
            Some(nearest) => write!(f, "; did you mean `{nearest}`?"),
            None => Ok(()),
        }
    }
}
