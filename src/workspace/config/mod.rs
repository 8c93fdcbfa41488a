//! The configuration file: `xacro-lint.toml`, or `.xacro-lint.toml`.
//!
//! What is wrong in it is a warning with a place; the rest holds. Editor settings are the same keys in
//! camelCase and are read by the same code.

mod apply;
mod apply_roots;
mod choice;
mod cursor;
mod effective;
mod expect;
#[cfg(test)]
mod files_tests;
mod keys;
mod load;
mod merge;
mod pattern;
mod roots;
mod schema;
mod settings;
#[cfg(test)]
mod tests;
mod value;
mod wanted;

use std::fmt;
use std::path::PathBuf;

pub use choice::{AttributeLayout, Profile, RuleLevel};
pub use cursor::{ConfigCursor, ConfigCursorKind, is_bare, place_at};
pub use effective::EffectiveSetting;
pub use expect::{Expectation, ExpectedJoint};
pub use keys::CONSUMERS;
pub use load::{CONFIG_NAMES, LoadedConfig, argument_places, find_config, unknown_settings};
pub use pattern::Pattern;
pub use roots::{Axes, Root, Variant, XacroArgs, files_named};
pub use schema::schema;
pub use settings::{Config, Format, Limits};
pub use wanted::{ExpectedValue, doc, wanted};

use base::TextRange;

/// A place in a configuration file, or in the settings of an editor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConfigLocation {
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
pub struct ConfigMention {
    /// What it names.
    pub kind: ConfigMentionKind,
    /// The name, as it is written.
    pub text: String,
    /// Where it stands.
    pub place: ConfigLocation,
}

/// What a name in a configuration names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConfigMentionKind {
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
    pub place: ConfigLocation,
    /// What is wrong.
    pub message: String,
    /// What may have been meant.
    pub nearest: Option<String>,
}

impl fmt::Display for ConfigWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ConfigLocation {
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
