//! What an item may hold, seen at a glance: where it does not, nobody need look at its elements.
use std::sync::LazyLock;

use memchr::memchr_iter;
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
    /// The definition of a macro.
    pub macro_tag: bool,
    /// An include, with the prefix of xacro or without it.
    pub include: bool,
    /// An element that names a file, or may have any name: `mesh`, `texture`, `xacro:element`.
    pub file_tag: bool,
    /// A brace without `$`, or `($`.
    pub bare_brace: bool,
    /// Something is compared with a truth value.
    pub truth: bool,
    /// A file of parameters, as plugins of Gazebo name it.
    pub parameters: bool,
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
    pub(super) const COUNT: usize = 1 << 10;

    pub(super) fn of(item: &Item) -> Self {
        static LINT: LazyLock<[Finder<'_>; 3]> =
            LazyLock::new(|| ["lint", "Lint", "LINT"].map(Finder::new));
        let mut marks = Self::of_text(item.text());
        for node in item.all_nodes() {
            match node.kind() {
                NodeKind::Element => marks.note(node.name()),
                NodeKind::Comment => marks.lint = marks.lint || holds(node.raw(), &*LINT),
                _ => {}
            }
        }
        marks
    }

    fn of_text(text: &str) -> Self {
        static PACKAGE: LazyLock<[Finder<'_>; 2]> =
            LazyLock::new(|| ["package://", "$(find "].map(Finder::new));
        static BOOLEAN: LazyLock<[Finder<'_>; 2]> =
            LazyLock::new(|| ["rue", "alse"].map(Finder::new));
        static COMPARISON: LazyLock<[Finder<'_>; 2]> =
            LazyLock::new(|| ["==", "!="].map(Finder::new));
        static PARAMETERS: LazyLock<[Finder<'_>; 1]> =
            LazyLock::new(|| ["<parameters>"].map(Finder::new));
        Self {
            package: holds(text, &*PACKAGE),
            bare_brace: has_bare_brace(text),
            truth: holds(text, &*COMPARISON) && holds(text, &*BOOLEAN),
            parameters: holds(text, &*PARAMETERS),
            ..Self::default()
        }
    }

    /// Note that an element is there.
    fn note(&mut self, tag: &str) {
        match tag.strip_prefix("xacro:") {
            Some("if" | "unless") => self.condition = true,
            Some("macro") => self.macro_tag = true,
            Some("include") => self.include = true,
            Some("element") => self.file_tag = true,
            Some(_) => {}
            None => {
                self.other_tag |= !ORDINARY_TAGS.contains(&tag);
                self.include |= tag == "include";
                self.file_tag |= matches!(tag, "mesh" | "texture");
            }
        }
    }

    fn flags(self) -> [bool; 10] {
        let Self {
            lint,
            package,
            condition,
            other_tag,
            macro_tag,
            include,
            file_tag,
            bare_brace,
            truth,
            parameters,
        } = self;
        [
            lint, package, condition, other_tag, macro_tag, include, file_tag, bare_brace, truth,
            parameters,
        ]
    }

    /// What one of two may hold.
    pub(super) fn or(self, other: Self) -> Self {
        Self {
            lint: self.lint || other.lint,
            package: self.package || other.package,
            condition: self.condition || other.condition,
            other_tag: self.other_tag || other.other_tag,
            macro_tag: self.macro_tag || other.macro_tag,
            include: self.include || other.include,
            file_tag: self.file_tag || other.file_tag,
            bare_brace: self.bare_brace || other.bare_brace,
            truth: self.truth || other.truth,
            parameters: self.parameters || other.parameters,
        }
    }

    /// Its place among all that there are.
    pub(super) fn number(self) -> usize {
        self.flags()
            .into_iter()
            .fold(0, |number, flag| 2 * number + usize::from(flag))
    }
}

fn holds(text: &str, words: &[Finder<'_>]) -> bool {
    words
        .iter()
        .any(|word| word.find(text.as_bytes()).is_some())
}

/// Whether a text has a brace without `$`, or `($`.
fn has_bare_brace(text: &str) -> bool {
    let bytes = text.as_bytes();
    let before = |at: usize| at.checked_sub(1).and_then(|at| bytes.get(at));
    memchr_iter(b'{', bytes).any(|at| before(at) != Some(&b'$'))
        || memchr_iter(b'$', bytes).any(|at| before(at) == Some(&b'('))
}
