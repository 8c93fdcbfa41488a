//! Keys of the configuration: their names, types and help, and those of `[[roots]]`.

/// The type of a value.
#[derive(Clone, Copy, Debug)]
pub(super) enum KeyType {
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
    Keys(&'static [ConfigKey]),
    /// A list of tables of these keys.
    Tables(&'static [ConfigKey]),
    /// A table of free keys, each with a value of this type.
    Map(&'static KeyType),
    Number,
    /// A string, number or boolean: the value of an xacro argument.
    Argument,
    /// The same, or a list of such values.
    Arguments,
    /// A list of values of this type.
    List(&'static KeyType),
    /// A whole number.
    Whole,
}

/// A key of the configuration.
#[derive(Debug)]
pub(super) struct ConfigKey {
    pub(super) name: &'static str,
    pub(super) of: KeyType,
    pub(super) doc: &'static str,
}

/// A key of this name, with values of this type, and what it does.
pub(super) const fn key(name: &'static str, of: KeyType, doc: &'static str) -> ConfigKey {
    ConfigKey { name, of, doc }
}

impl ConfigKey {
    /// The words that its values may be; none where any may.
    pub(super) fn words(&self) -> &'static [&'static str] {
        match self.of {
            KeyType::Choice(words) | KeyType::Choices(words) => words,
            _ => &[],
        }
    }

    /// The greatest number that it admits.
    pub(super) fn most(&self) -> u64 {
        match self.of {
            KeyType::Count(most) => most,
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

const ARGS: KeyType = KeyType::Map(&KeyType::Argument);
const AXES: KeyType = KeyType::Map(&KeyType::Arguments);

/// Values of `roots.choices`.
pub(super) const CHOICES: &[&str] = &["launch"];

/// Keys of `[[roots]]`.
pub(super) const ROOTS: &[ConfigKey] = &[
    key(
        "file",
        KeyType::Text,
        "Path or glob of root files, relative to this file.",
    ),
    key(
        "args",
        AXES,
        "Arguments by name, passed in every check; each combination of lists is checked separately.",
    ),
    key(
        "exclude",
        KeyType::List(&AXES),
        "Combinations of arguments that are left out.",
    ),
    key(
        "choices",
        KeyType::Choice(CHOICES),
        "Further values of arguments: `launch` takes those that launch files declare as `choices`.",
    ),
    key(
        "presets",
        KeyType::Map(&ARGS),
        "Named sets of arguments; each set is checked separately.",
    ),
    key(
        "expect",
        KeyType::Tables(EXPECT),
        "What `xacro-lint test` expects of the robots.",
    ),
];

/// Keys of `[[roots.expect]]`. In names and paths, `$(arg NAME)` is the value of an argument.
pub(super) const EXPECT: &[ConfigKey] = &[
    key("name", KeyType::Text, "Name in the output."),
    key(
        "when",
        AXES,
        "Values of arguments; the expectation applies only to these robots.",
    ),
    key("root", KeyType::Text, "Name of the root link."),
    key("links", KeyType::Texts, "Links that exist."),
    key("no-links", KeyType::Texts, "Links that do not exist."),
    key("joints", KeyType::Texts, "Joints that exist."),
    key("no-joints", KeyType::Texts, "Joints that do not exist."),
    key("link-count", KeyType::Whole, "Number of links."),
    key("joint-count", KeyType::Whole, "Number of joints."),
    key(
        "moving-joint-count",
        KeyType::Whole,
        "Number of joints that are not fixed.",
    ),
    key(
        "chains",
        KeyType::List(&KeyType::Texts),
        "Lists of links from top to bottom; each link is below the previous one.",
    ),
    key("mass", KeyType::Number, "Total mass in kg."),
    key(
        "mass-tolerance",
        KeyType::Number,
        "Tolerance of `mass` in kg; default 0.001.",
    ),
    key(
        "joint",
        KeyType::Map(&KeyType::Keys(JOINT)),
        "Properties of joints by name.",
    ),
    key(
        "command-interfaces",
        KeyType::Map(&KeyType::Texts),
        "All command interfaces of joints in `ros2_control`, by joint.",
    ),
    key(
        "state-interfaces",
        KeyType::Map(&KeyType::Texts),
        "All state interfaces of joints in `ros2_control`, by joint.",
    ),
    key(
        "expands-to",
        KeyType::Text,
        "URDF file that describes the same robot, relative to this file; `test --update` writes it.",
    ),
];

/// Keys of one joint in `expect.joint`.
pub(super) const JOINT: &[ConfigKey] = &[
    key("type", KeyType::Text, "Type of the joint."),
    key("parent", KeyType::Text, "Parent link."),
    key("child", KeyType::Text, "Child link."),
    key("mimic", KeyType::Text, "Joint that it mimics."),
    key(
        "lower",
        KeyType::Number,
        "Lower limit in radians or meters.",
    ),
    key(
        "upper",
        KeyType::Number,
        "Upper limit in radians or meters.",
    ),
    key("effort", KeyType::Number, "Effort limit in N m or N."),
    key(
        "velocity",
        KeyType::Number,
        "Velocity limit in rad/s or m/s.",
    ),
    key(
        "tolerance",
        KeyType::Number,
        "Tolerance of the limits; default 0.001.",
    ),
];
