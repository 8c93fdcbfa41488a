//! Keys of the configuration: their names, types and help, and those of `[[roots]]`.

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

/// A key of this name, with values of this type, and what it does.
pub(super) const fn key(name: &'static str, of: Type, doc: &'static str) -> Key {
    Key { name, of, doc }
}

impl Key {
    /// The words that its values may be; none where any may.
    pub(super) fn words(&self) -> &'static [&'static str] {
        match self.of {
            Type::Choice(words) | Type::Choices(words) => words,
            _ => &[],
        }
    }

    /// The greatest number that it admits.
    pub(super) fn most(&self) -> u64 {
        match self.of {
            Type::Count(most) => most,
            _ => u64::MAX,
        }
    }
}

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
