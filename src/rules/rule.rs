//! What a rule is.
use std::fmt;

use super::beside::BesideCx;
use super::context::{DocumentCx, FileCx, RobotCx};
use super::frames::ElementPose;
use super::sink::Sink;
use super::xml::{CheckedElement, Numeric};
pub use base::Severity;
use model::{Joint, Link};

/// A rule.
#[derive(Debug)]
pub struct Rule {
    /// Three letters and three digits; never given to another rule.
    pub code: &'static str,
    /// What configuration and suppressions call it.
    pub name: &'static str,
    /// The group it belongs to.
    pub category: Category,
    /// How bad a finding is, unless configured otherwise.
    pub severity: Severity,
    /// Whether it runs when nothing is configured.
    pub default: Activation,
    /// The first version that had it.
    pub since: &'static str,
    /// How safe its fixes are; none when it offers none.
    pub fix: Option<Safety>,
    /// Its page in `docs/rules/`.
    pub docs: &'static str,
    /// How findings are made, and from what.
    pub check: Check,
}

/// The groups of rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Category {
    /// Well-formedness and the schema.
    Xml,
    /// The xacro language.
    Xacro,
    /// The kinematic tree.
    Structure,
    /// Joints: axes, limits, mimic.
    Joint,
    /// Frames and orientations.
    Frames,
    /// Mass and inertia.
    Inertia,
    /// Geometry, meshes, materials.
    Geometry,
    /// Names.
    Conventions,
    /// Packages and files of the workspace.
    Package,
    /// ros2_control, transmissions, Gazebo.
    Control,
    /// What the programs that read URDF make of a robot.
    Consumers,
    /// Style.
    Style,
    /// Semantic descriptions beside the URDF.
    Srdf,
    /// Settings of MoveIt.
    Moveit,
    /// Suppressions and configuration of the linter itself.
    Linter,
}

/// Whether a rule runs when nothing is configured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Activation {
    /// It does.
    On,
    /// Only when it is selected.
    Off,
    /// Only with one of these profiles.
    Profiles(&'static [&'static str]),
}

/// How safe a fix is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Safety {
    /// The expansion stays equal, or becomes what was obviously meant.
    Safe,
    /// Names or numbers change.
    Unsafe,
}

/// What a rule looks at.
#[derive(Clone, Copy, Debug)]
pub enum Check {
    /// Nothing of its own: expansion reports it.
    Expander,
    /// Nothing of its own: known only when all findings are there.
    Analysis,
    /// One source file.
    File(fn(&FileCx<'_>, &mut Sink<'_>)),
    /// The expanded document of a root, robot or library.
    Document(fn(&DocumentCx<'_>, &mut Sink<'_>)),
    /// The expanded document of a root of which everything is there: the rule says that something is missing or unused.
    WholeDocument(fn(&DocumentCx<'_>, &mut Sink<'_>)),
    /// Each element of the expanded document that stands outside of the parts for other tools, its root first. Rules about single
    /// elements, and those of the next kinds, look at nothing else without [`DocumentCx::look_beyond`], so that they need not be
    /// asked again after an edit elsewhere.
    Element(fn(&DocumentCx<'_>, &CheckedElement, &mut Sink<'_>)),
    /// The same for a document of which everything is there: the rule says that something is missing.
    WholeElement(fn(&DocumentCx<'_>, &CheckedElement, &mut Sink<'_>)),
    /// Each attribute that holds numbers, of these elements, unless it is unknown.
    Number(fn(&DocumentCx<'_>, &Numeric, &mut Sink<'_>)),
    /// Each link.
    Link(fn(&DocumentCx<'_>, &Link, &mut Sink<'_>)),
    /// Each joint.
    Joint(fn(&DocumentCx<'_>, &Joint, &mut Sink<'_>)),
    /// Each origin of a joint, an inertia, a visual or a collision.
    Pose(fn(&DocumentCx<'_>, &ElementPose<'_>, &mut Sink<'_>)),
    /// An expanded robot.
    Robot(fn(&RobotCx<'_>, &mut Sink<'_>)),
    /// An expanded robot of which everything is there: the rule says that something is missing. Nothing is missing from
    /// a part of a robot.
    Whole(fn(&RobotCx<'_>, &mut Sink<'_>)),
    /// The same, also where names of links and joints could not be computed: the rule compares with what is known of them.
    Named(fn(&RobotCx<'_>, &mut Sink<'_>)),
    /// A file beside robots of which everything is there.
    Beside(fn(&BesideCx<'_>, &mut Sink<'_>)),
    /// A file beside robots that is compared with SRDFs only: the robots may be unknown.
    Semantic(fn(&BesideCx<'_>, &mut Sink<'_>)),
}

/// The page of a rule.
pub(super) use docs::rule as page;

impl PartialEq for Rule {
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

impl Eq for Rule {}

impl Rule {
    /// A rule that the expander finds.
    pub(super) const fn found(
        code: &'static str,
        name: &'static str,
        category: Category,
        severity: Severity,
        docs: &'static str,
    ) -> Self {
        let (default, check) = (Activation::On, Check::Expander);
        Self {
            code,
            name,
            category,
            severity,
            default,
            since: "0.1",
            fix: None,
            docs,
            check,
        }
    }

    /// A rule about files beside robots, without fixes.
    pub(super) const fn beside(
        code: &'static str,
        name: &'static str,
        category: Category,
        severity: Severity,
        docs: &'static str,
        check: fn(&BesideCx<'_>, &mut Sink<'_>),
    ) -> Self {
        let (default, check) = (Activation::On, Check::Beside(check));
        Self {
            code,
            name,
            category,
            severity,
            default,
            since: "0.1",
            fix: None,
            docs,
            check,
        }
    }

    /// A rule about files beside robots, without fixes, that looks at SRDFs only.
    pub(super) const fn semantic(
        code: &'static str,
        name: &'static str,
        category: Category,
        severity: Severity,
        docs: &'static str,
        check: fn(&BesideCx<'_>, &mut Sink<'_>),
    ) -> Self {
        Self {
            check: Check::Semantic(check),
            ..Self::beside(code, name, category, severity, docs, check)
        }
    }

    /// The same with fixes.
    pub(super) const fn fixed(mut self, safety: Safety) -> Self {
        self.fix = Some(safety);
        self
    }

    /// The first paragraph of the page: what the rule finds, in a sentence or two.
    pub fn summary(&self) -> &'static str {
        self.docs.split("\n\n").nth(2).unwrap_or("").trim()
    }

    /// The line below the title of the page.
    pub fn headline(&self) -> String {
        let fix = self.fix.map_or("no fix".to_owned(), |safety| {
            format!("{} fix", safety.name())
        });
        let Self {
            code,
            severity,
            default,
            since,
            ..
        } = self;
        format!("`{code}` · {severity} · {default} by default · {fix} · since {since}")
    }

    /// The address of its page, where the project has a home.
    pub fn url(&self) -> Option<String> {
        page_url(
            env!("CARGO_PKG_REPOSITORY"),
            env!("CARGO_PKG_VERSION"),
            self.name,
        )
    }

    /// Whether `selector` (a code, the beginning of a code, or a name) means this rule.
    pub fn is_named(&self, selector: &str) -> bool {
        let letters = selector.len() >= 3 && selector.starts_with(|c: char| c.is_ascii_uppercase());
        self.name == selector || (letters && self.code.starts_with(selector))
    }

    /// All that means this rule: `ALL` and what [`Rule::is_named`] accepts.
    pub fn selectors(&self) -> impl Iterator<Item = &'static str> + use<> {
        let (name, code) = (self.name, self.code);
        ["ALL", name]
            .into_iter()
            .chain((3..=code.len()).filter_map(move |end| code.get(..end)))
    }
}

fn page_url(repository: &str, version: &str, name: &str) -> Option<String> {
    let repository = repository.trim_end_matches('/');
    (!repository.is_empty()).then(|| format!("{repository}/blob/v{version}/docs/rules/{name}.md"))
}

impl Category {
    /// All of them, in the order of the catalogue.
    pub const ALL: [Category; 15] = [
        Category::Xml,
        Category::Xacro,
        Category::Structure,
        Category::Joint,
        Category::Frames,
        Category::Inertia,
        Category::Geometry,
        Category::Conventions,
        Category::Package,
        Category::Control,
        Category::Srdf,
        Category::Moveit,
        Category::Consumers,
        Category::Style,
        Category::Linter,
    ];

    /// Its name in lists.
    pub fn name(self) -> &'static str {
        match self {
            Category::Xml => "xml",
            Category::Xacro => "xacro",
            Category::Structure => "structure",
            Category::Joint => "joint",
            Category::Frames => "frames",
            Category::Inertia => "inertia",
            Category::Geometry => "geometry",
            Category::Conventions => "conventions",
            Category::Package => "package",
            Category::Control => "control",
            Category::Srdf => "srdf",
            Category::Moveit => "moveit",
            Category::Consumers => "consumers",
            Category::Style => "style",
            Category::Linter => "linter",
        }
    }

    /// What its rules are about.
    pub fn title(self) -> &'static str {
        match self {
            Category::Xml => "Well-formedness and the URDF schema",
            Category::Xacro => "The xacro language",
            Category::Structure => "The kinematic tree",
            Category::Joint => "Joints",
            Category::Frames => "Frames and orientations",
            Category::Inertia => "Mass and inertia",
            Category::Geometry => "Geometry, meshes and materials",
            Category::Conventions => "Names",
            Category::Package => "Packages and files",
            Category::Control => "ros2_control, transmissions and Gazebo",
            Category::Srdf => "SRDF",
            Category::Moveit => "Settings of MoveIt",
            Category::Consumers => "Programs that read URDF",
            Category::Style => "Style",
            Category::Linter => "The linter itself",
        }
    }
}

impl fmt::Display for Activation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Activation::On => f.write_str("on"),
            Activation::Off => f.write_str("off"),
            Activation::Profiles(profiles) => f.write_str(&profiles.join(", ")),
        }
    }
}

impl Safety {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Safety::Safe => "safe",
            Safety::Unsafe => "unsafe",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::page_url;

    #[test]
    fn pages_have_addresses_where_there_is_a_repository() {
        let expected = "https://example.org/x/blob/v0.1.0/docs/rules/no-links.md";
        assert_eq!(
            page_url("https://example.org/x/", "0.1.0", "no-links").as_deref(),
            Some(expected)
        );
        assert_eq!(page_url("", "0.1.0", "no-links"), None);
    }
}
