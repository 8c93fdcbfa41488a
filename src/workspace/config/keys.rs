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
    key("line-width", Type::Count(10_000), "Maximum line length for wrapping; default 120."),
    key(
        "attributes",
        Type::Choice(LAYOUTS),
        "Keep (`keep`) or re-wrap (`auto`) line breaks between attributes.",
    ),
    key("self-close", Type::Bool, "Write `<a></a>` as `<a/>`; default false."),
];

/// Keys of `[limits]`.
pub(super) const LIMITS: &[Key] = &[
    key(
        "eval-steps",
        Type::Count(u64::MAX),
        "Maximum number of steps to evaluate one expression; default 1000000.",
    ),
    key(
        "expand-nodes",
        Type::Count(u64::MAX),
        "Maximum number of nodes of the expanded robot; default 500000.",
    ),
    key("expand-ms", Type::Count(u64::MAX), "Maximum time for one expansion in milliseconds; default 5000."),
    key("file-mb", Type::Count(FILE_MB_MOST), "Maximum file size in megabytes; default 20."),
    key("macro-depth", Type::Count(10_000), "Maximum nesting depth of macro calls; default 1000."),
    key("include-depth", Type::Count(10_000), "Maximum nesting depth of includes; default 500."),
];

const ARGS: Type = Type::Map(&Type::Argument);

/// Keys of `[[roots]]`.
pub(super) const ROOTS: &[Key] = &[
    key("file", Type::Text, "Path or glob of root files, relative to this file."),
    key("args", ARGS, "Arguments by name, passed in every check."),
    key("presets", Type::Map(&ARGS), "Named sets of arguments; each set is checked separately."),
];

/// All keys.
pub(super) const KEYS: &[Key] = &[
    key("extend", Type::Text, "Configuration file to extend; settings in this file take precedence."),
    key("target", Type::Choice(TARGETS), "Dialect of xacro and package conventions; default `ros2`."),
    key("urdf-version", Type::Texts, "Supported URDF versions; default `1.0`."),
    key("profile", Type::Choices(PROFILES), "Profiles whose rules are enabled."),
    key("select", Type::Texts, "Run only these rules (codes, code prefixes or names)."),
    key("extend-select", Type::Texts, "Run these rules in addition (codes, code prefixes or names)."),
    key("ignore", Type::Texts, "Do not run these rules (codes, code prefixes or names)."),
    key("severity", Type::Map(&Type::Choice(LEVELS)), "Severity per rule."),
    key("per-file-ignores", Type::Map(&Type::Texts), "Rules not to run, per file glob."),
    key("exclude", Type::Texts, "Globs of files and folders to exclude from checks."),
    key("package-path", Type::Texts, "Folders to search for packages first."),
    key(
        "use-environment",
        Type::Bool,
        "Use AMENT_PREFIX_PATH, COLCON_PREFIX_PATH and ROS_PACKAGE_PATH; default true.",
    ),
    key("thresholds", Type::Map(&Type::Number), "Thresholds of rules; the unit is in the name."),
    key("allow-elements", Type::Texts, "Additional known elements."),
    key("allow-attributes", Type::Texts, "Additional known attributes."),
    key("roots", Type::Tables(ROOTS), "Root files and their arguments."),
    key("format", Type::Keys(FORMAT), "Formatting."),
    key("limits", Type::Keys(LIMITS), "Limits for one expansion."),
];
