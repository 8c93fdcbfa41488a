//! What an item may hold, seen at a glance: where it does not, nobody need look at its elements.
use std::sync::LazyLock;

use memchr::memmem::Finder;

use xml::{Item, NodeKind};

/// What an item may hold. What is said not to be there is not there; what is said to be there may be something else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// A comment for the linter.
    pub lint: bool,
    /// A name of a package, in `package://` or `$(find)`.
    pub package: bool,
    /// A condition of xacro.
    pub condition: bool,
    /// An element that has neither the prefix of xacro nor one of the names in [`ORDINARY_TAGS`].
    pub other_tag: bool,
}

/// The elements that most descriptions of robots consist of.
pub const ORDINARY_TAGS: [&str; 24] = [
    "robot",
    "link",
    "joint",
    "origin",
    "parent",
    "child",
    "axis",
    "limit",
    "visual",
    "collision",
    "geometry",
    "mesh",
    "inertial",
    "mass",
    "inertia",
    "material",
    "color",
    "box",
    "cylinder",
    "sphere",
    "dynamics",
    "mimic",
    "texture",
    "safety_controller",
];

impl Marks {
    /// How many different ones there are.
    pub(super) const COUNT: usize = 16;

    pub(super) fn of(item: &Item) -> Self {
        static LINT: LazyLock<[Finder<'_>; 3]> =
            LazyLock::new(|| ["lint", "Lint", "LINT"].map(Finder::new));
        static PACKAGE: LazyLock<[Finder<'_>; 2]> =
            LazyLock::new(|| ["package://", "$(find "].map(Finder::new));
        let holds = |text: &str, words: &[Finder<'_>]| {
            words
                .iter()
                .any(|word| word.find(text.as_bytes()).is_some())
        };
        let mut marks = Self {
            package: holds(item.text(), &*PACKAGE),
            ..Self::default()
        };
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => match node.name().strip_prefix("xacro:") {
                    Some("if" | "unless") => marks.condition = true,
                    Some(_) => {}
                    None => marks.other_tag |= !ORDINARY_TAGS.contains(&node.name()),
                },
                NodeKind::Comment => marks.lint = marks.lint || holds(node.raw(), &*LINT),
                _ => {}
            }
        }
        marks
    }

    /// Its place among all that there are.
    pub(super) fn number(self) -> usize {
        let flags = [self.lint, self.package, self.condition, self.other_tag];
        flags
            .into_iter()
            .fold(0, |number, flag| 2 * number + usize::from(flag))
    }
}
