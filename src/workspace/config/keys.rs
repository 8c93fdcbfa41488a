//! The table of keys: what exists, of which type, and what it says.

use base::limits::FILE_MB_MOST;

/// The type of a value.
#[derive(Clone, Copy, Debug)]
pub(super) enum Type {
    /// A string.
    Text,
    /// One of these strings.
    Choice(&'static [&'static str]),
    /// A list of strings.
    Texts,
    /// A list of these strings.
    Choices(&'static [&'static str]),
    Bool,
    /// A whole number from 1 to this.
    Count(u64),
    /// A table of these keys.
    Keys(&'static [Key]),
    /// A list of tables of these keys.
    Tables(&'static [Key]),
    /// A table of free keys, each with a value of this type.
    Map(&'static Type),
    Number,
    /// A string, number or boolean: the value of an xacro argument.
    Argument,
}

/// A key of the configuration.
#[derive(Debug)]
pub(super) struct Key {
    pub(super) name: &'static str,
    pub(super) of: Type,
    pub(super) doc: &'static str,
}

const fn key(name: &'static str, of: Type, doc: &'static str) -> Key {
    Key { name, of, doc }
}

/// Values of `target`.
pub(super) const TARGETS: &[&str] = &["ros2", "ros1"];
/// Values of `profile`.
pub(super) const PROFILES: &[&str] = &["ros-industrial", "mobile", "gazebo", "pedantic"];
/// Values of `severity`.
pub(super) const LEVELS: &[&str] = &["error", "warning", "info", "hint", "off"];
/// Values of `format.attributes`.
pub(super) const LAYOUTS: &[&str] = &["keep", "auto"];

/// Keys of `[format]`.
pub(super) const FORMAT: &[Key] = &[
    key("line-width", Type::Count(10_000), "Characters per line that wrapping aims at; default 120."),
    key("attributes", Type::Choice(LAYOUTS), "Whether line breaks between attributes stay or are set anew."),
    key("self-close", Type::Bool, "Whether `<a></a>` becomes `<a/>`; default false."),
];

/// Keys of `[limits]`.
pub(super) const LIMITS: &[Key] = &[
    key("eval-steps", Type::Count(u64::MAX), "Steps of evaluating one expression; default 1000000."),
    key("expand-nodes", Type::Count(u64::MAX), "Nodes of an expanded document; default 500000."),
    key("expand-ms", Type::Count(u64::MAX), "Milliseconds for one expansion; default 5000."),
    key("file-mb", Type::Count(FILE_MB_MOST), "Megabytes of a file that is read; default 20."),
    key("macro-depth", Type::Count(10_000), "Macro calls inside each other; default 1000."),
    key("include-depth", Type::Count(10_000), "Files included from each other; default 500."),
];

const ARGS: Type = Type::Map(&Type::Argument);

/// Keys of `[[roots]]`.
pub(super) const ROOTS: &[Key] = &[
    key("file", Type::Text, "Path or glob of entry files, from the folder of this file."),
    key("args", ARGS, "Arguments of every run, by name."),
    key("presets", Type::Map(&ARGS), "Named sets of arguments; each is a run of its own."),
];

/// All keys.
pub(super) const KEYS: &[Key] = &[
    key("extend", Type::Text, "Another configuration file, merged below this one."),
    key("target", Type::Choice(TARGETS), "Dialect of xacro and package conventions; default `ros2`."),
    key("urdf-version", Type::Texts, "Admitted values of the version of a robot; default `1.0`."),
    key("profile", Type::Choices(PROFILES), "Profiles whose rules are switched on."),
    key("select", Type::Texts, "Codes, prefixes or names of the only rules to run."),
    key("extend-select", Type::Texts, "Codes, prefixes or names of rules to run in addition."),
    key("ignore", Type::Texts, "Codes, prefixes or names of rules not to run."),
    key("severity", Type::Map(&Type::Choice(LEVELS)), "Severity by rule."),
    key("per-file-ignores", Type::Map(&Type::Texts), "Rules not to run, by glob of the files."),
    key("exclude", Type::Texts, "Globs of files and folders that are never checked."),
    key("package-path", Type::Texts, "Folders searched for packages before everything else."),
    key(
        "use-environment",
        Type::Bool,
        "Whether AMENT_PREFIX_PATH, COLCON_PREFIX_PATH and ROS_PACKAGE_PATH are read; default true.",
    ),
    key("thresholds", Type::Map(&Type::Number), "Numbers of rules; the unit is in the name."),
    key("allow-elements", Type::Texts, "Elements that are part of the vocabulary in addition."),
    key("allow-attributes", Type::Texts, "Attributes that are part of the vocabulary in addition."),
    key("roots", Type::Tables(ROOTS), "Entry files and the arguments they are run with."),
    key("format", Type::Keys(FORMAT), "How files are formatted."),
    key("limits", Type::Keys(LIMITS), "Budgets of one expansion."),
];
