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
    /// The same, or a list of such values.
    Arguments,
    /// A list of values of this type.
    List(&'static Type),
    /// A whole number.
    Whole,
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
/// Values of `consumers`: the programs that the table of consumers knows.
pub const CONSUMERS: &[&str] = &[
    "urdfdom",
    "urdfdom-3",
    "kdl",
    "moveit",
    "gazebo",
    "mujoco",
    "drake",
    "pinocchio",
    "pybullet",
    "yourdfpy",
    "urchin",
    "urdf_parser_py",
    "urdf-loader",
    "urdf-rs",
    "isaac",
];
/// Values of `severity`.
pub(super) const LEVELS: &[&str] = &["error", "warning", "info", "hint", "off"];
/// Values of `format.attributes`.
pub(super) const LAYOUTS: &[&str] = &["keep", "auto"];

/// Keys of `[format]`.
pub(super) const FORMAT: &[Key] = &[
    key(
        "line-width",
        Type::Count(10_000),
        "Maximum line length for wrapping; default 120.",
    ),
    key(
        "attributes",
        Type::Choice(LAYOUTS),
        "Keep (`keep`) or re-wrap (`auto`) line breaks between attributes.",
    ),
    key(
        "self-close",
        Type::Bool,
        "Write `<a></a>` as `<a/>`; default false.",
    ),
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
    key(
        "expand-ms",
        Type::Count(u64::MAX),
        "Maximum time for one expansion in milliseconds; default 5000.",
    ),
    key(
        "file-mb",
        Type::Count(FILE_MB_MOST),
        "Maximum file size in megabytes; default 20.",
    ),
    key(
        "macro-depth",
        Type::Count(10_000),
        "Maximum nesting depth of macro calls; default 1000.",
    ),
    key(
        "include-depth",
        Type::Count(10_000),
        "Maximum nesting depth of includes; default 500.",
    ),
];

const ARGS: Type = Type::Map(&Type::Argument);
const AXES: Type = Type::Map(&Type::Arguments);

/// Values of `roots.choices`.
pub(super) const CHOICES: &[&str] = &["launch"];

/// Keys of `[[roots]]`.
pub(super) const ROOTS: &[Key] = &[
    key(
        "file",
        Type::Text,
        "Path or glob of root files, relative to this file.",
    ),
    key(
        "args",
        AXES,
        "Arguments by name, passed in every check; each combination of lists is checked separately.",
    ),
    key(
        "exclude",
        Type::List(&AXES),
        "Combinations of arguments that are left out.",
    ),
    key(
        "choices",
        Type::Choice(CHOICES),
        "Further values of arguments: `launch` takes those that launch files declare as `choices`.",
    ),
    key(
        "presets",
        Type::Map(&ARGS),
        "Named sets of arguments; each set is checked separately.",
    ),
    key(
        "expect",
        Type::Tables(EXPECT),
        "What `xacro-lint test` expects of the robots.",
    ),
];

/// Keys of `[[roots.expect]]`. In names and paths, `$(arg NAME)` is the value of an argument.
pub(super) const EXPECT: &[Key] = &[
    key("name", Type::Text, "Name in the output."),
    key(
        "when",
        AXES,
        "Values of arguments; the expectation applies only to these robots.",
    ),
    key("root", Type::Text, "Name of the root link."),
    key("links", Type::Texts, "Links that exist."),
    key("no-links", Type::Texts, "Links that do not exist."),
    key("joints", Type::Texts, "Joints that exist."),
    key("no-joints", Type::Texts, "Joints that do not exist."),
    key("link-count", Type::Whole, "Number of links."),
    key("joint-count", Type::Whole, "Number of joints."),
    key(
        "moving-joint-count",
        Type::Whole,
        "Number of joints that are not fixed.",
    ),
    key(
        "chains",
        Type::List(&Type::Texts),
        "Lists of links from top to bottom; each link is below the previous one.",
    ),
    key("mass", Type::Number, "Total mass in kg."),
    key(
        "mass-tolerance",
        Type::Number,
        "Tolerance of `mass` in kg; default 0.001.",
    ),
    key(
        "joint",
        Type::Map(&Type::Keys(JOINT)),
        "Properties of joints by name.",
    ),
    key(
        "command-interfaces",
        Type::Map(&Type::Texts),
        "All command interfaces of joints in `ros2_control`, by joint.",
    ),
    key(
        "state-interfaces",
        Type::Map(&Type::Texts),
        "All state interfaces of joints in `ros2_control`, by joint.",
    ),
    key(
        "expands-to",
        Type::Text,
        "URDF file that describes the same robot, relative to this file; `test --update` writes it.",
    ),
];

/// Keys of one joint in `expect.joint`.
pub(super) const JOINT: &[Key] = &[
    key("type", Type::Text, "Type of the joint."),
    key("parent", Type::Text, "Parent link."),
    key("child", Type::Text, "Child link."),
    key("mimic", Type::Text, "Joint that it mimics."),
    key("lower", Type::Number, "Lower limit in radians or meters."),
    key("upper", Type::Number, "Upper limit in radians or meters."),
    key("effort", Type::Number, "Effort limit in N m or N."),
    key("velocity", Type::Number, "Velocity limit in rad/s or m/s."),
    key(
        "tolerance",
        Type::Number,
        "Tolerance of the limits; default 0.001.",
    ),
];

/// All keys.
pub(super) const KEYS: &[Key] = &[
    key(
        "extend",
        Type::Text,
        "Configuration file to extend; settings in this file take precedence.",
    ),
    key(
        "target",
        Type::Choice(TARGETS),
        "Dialect of xacro and package conventions; default `ros2`.",
    ),
    key(
        "urdf-version",
        Type::Texts,
        "Supported URDF versions; default `1.0`.",
    ),
    key(
        "consumers",
        Type::Choices(CONSUMERS),
        "Programs that have to load the robots.",
    ),
    key(
        "oldest-reader",
        Type::Text,
        "Oldest version of urdfdom that has to load the robots, such as `3.0`; default: the newest.",
    ),
    key(
        "profile",
        Type::Choices(PROFILES),
        "Profiles whose rules are enabled.",
    ),
    key(
        "select",
        Type::Texts,
        "Run only these rules (codes, code prefixes or names).",
    ),
    key(
        "extend-select",
        Type::Texts,
        "Run these rules in addition (codes, code prefixes or names).",
    ),
    key(
        "ignore",
        Type::Texts,
        "Do not run these rules (codes, code prefixes or names).",
    ),
    key(
        "severity",
        Type::Map(&Type::Choice(LEVELS)),
        "Severity per rule.",
    ),
    key(
        "per-file-ignores",
        Type::Map(&Type::Texts),
        "Rules not to run, per file glob.",
    ),
    key(
        "exclude",
        Type::Texts,
        "Globs of files and folders to exclude from checks.",
    ),
    key(
        "package-path",
        Type::Texts,
        "Folders to search for packages first.",
    ),
    key(
        "use-environment",
        Type::Bool,
        "Use AMENT_PREFIX_PATH, COLCON_PREFIX_PATH and ROS_PACKAGE_PATH; default true.",
    ),
    key(
        "thresholds",
        Type::Map(&Type::Number),
        "Thresholds of rules; the unit is in the name.",
    ),
    key("allow-elements", Type::Texts, "Additional known elements."),
    key(
        "allow-attributes",
        Type::Texts,
        "Additional known attributes.",
    ),
    key(
        "roots",
        Type::Tables(ROOTS),
        "Root files and their arguments.",
    ),
    key("format", Type::Keys(FORMAT), "Formatting."),
    key("limits", Type::Keys(LIMITS), "Limits for one expansion."),
];
