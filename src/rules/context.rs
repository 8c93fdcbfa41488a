//! What rules see.
use std::cell::{OnceCell, RefCell};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::consumers::Met;
use super::conventions::NamedBy;
use super::frames::Distances;
use super::geometry::{MeshReference, Resources};
use super::package::{Manifests, PackageMention};
use super::watch::Watch;
use super::xacro::MentionedWords;
use base::{FastMap, FastSet};
use expand::{Expansion, FileIdx, Problem, StepKey, XId};
use facts::{Marks, is_keyword, parts_where};
use model::{AttrValue, Joint, Kinematics, Link, Meshes, Robot, SharedList, Version};
use packages::Packages;
use vfs::{SourceFile, Vfs};
use workspace::config::Config;
use xml::{Attr, Document, Item, Node, NodeKind};

/// What an expanded file is taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootKind {
    /// A robot that stands on its own.
    Robot,
    /// Macros, properties or parts for other files.
    Library,
    /// SRDF: about a robot, and none itself.
    Semantic,
}

/// One source file.
pub struct FileCx<'a> {
    /// An expansion the file took part in.
    pub expansion: &'a Expansion,
    /// Its number there.
    pub file: FileIdx,
    /// The file.
    pub source: &'a SourceFile,
    /// The macros that the files of the expansion define or call, once a rule has asked.
    pub(super) macros: &'a OnceCell<FastSet<&'a str>>,
    /// What lies around it.
    pub world: RuleEnv<'a>,
    /// The packages that it names, once a rule has asked.
    pub(super) packages: OnceCell<Vec<PackageMention>>,
}

impl<'a> FileCx<'a> {
    /// Whether the file is taken for plain URDF, which parsers that know no xacro read: by its name, and because
    /// nothing includes it.
    pub fn is_plain_urdf(&self) -> bool {
        is_plain_urdf(&self.source.path) && self.file == FileIdx(0)
    }

    /// All elements but the root, each with the offset its ranges count from.
    pub fn elements(&self) -> impl Iterator<Item = (u32, Node<'_>)> {
        elements(&self.source.document)
    }

    /// The same of the items that hold others than [`facts::ORDINARY_TAGS`] and tags of xacro.
    pub(super) fn other_elements(&self) -> impl Iterator<Item = (u32, Node<'_>)> {
        other_elements(&self.source.document)
    }

    /// The macros that the files of the expansion define or call.
    pub(super) fn macros(&self) -> &'a FastSet<&'a str> {
        self.macros.get_or_init(|| named_macros(self.expansion))
    }

    /// The attributes of the root element; their ranges are absolute.
    pub fn root_attrs(&self) -> impl Iterator<Item = Attr<'_>> {
        self.source
            .document
            .root()
            .into_iter()
            .flat_map(|root| root.attrs())
    }
}

/// Whether the name of a file calls it plain URDF.
pub fn is_plain_urdf(path: &Path) -> bool {
    let name = path
        .file_name()
        .map(|name| name.to_string_lossy().to_lowercase())
        .unwrap_or_default();
    name.ends_with(".urdf") && !name.contains(".xacro")
}

/// The elements of a document but its root, with the offset their ranges count from.
pub(super) fn elements(document: &Document) -> impl Iterator<Item = (u32, Node<'_>)> {
    document.parts().skip(1).flat_map(elements_of)
}

/// The elements of the items that may hold something, with the offset their ranges count from.
pub(super) fn elements_where(
    document: &Document,
    may: impl Fn(Marks) -> bool + Copy,
) -> impl Iterator<Item = (u32, Node<'_>)> {
    let parts = parts_where(document, may);
    let below_root = parts.filter(|(_, item)| !Arc::ptr_eq(item, document.header()));
    below_root.flat_map(elements_of)
}

/// The elements of the items that hold others than [`facts::ORDINARY_TAGS`] and tags of xacro.
pub(super) fn other_elements(document: &Document) -> impl Iterator<Item = (u32, Node<'_>)> {
    elements_where(document, |marks| marks.other_tag)
}

fn elements_of<'a>((base, item): (u32, &'a Arc<Item>)) -> impl Iterator<Item = (u32, Node<'a>)> {
    let nodes = item.all_nodes().map(move |node| (base, node));
    nodes.filter(|(_, node)| node.kind() == NodeKind::Element)
}

/// The macros that the files of an expansion define somewhere, and those that they call: the file that defines them may
/// be missing.
pub(super) fn named_macros(expansion: &Expansion) -> FastSet<&str> {
    let items = expansion
        .files
        .iter()
        .flat_map(|file| file.source.document.parts());
    let tags = items.flat_map(|(_, item)| item.all_nodes());
    tags.filter_map(macro_name).collect()
}

/// The macro that a tag defines or calls.
fn macro_name(node: Node<'_>) -> Option<&str> {
    match node.name().strip_prefix("xacro:")? {
        "macro" => Some(node.attr("name")?.raw().trim_start_matches("xacro:")),
        tag => (!is_keyword(tag)).then_some(tag),
    }
}

/// Whether all elements of an expansion are there.
pub fn is_whole(expansion: &Expansion) -> bool {
    let loses = |problem: &Problem| !problem.probed && problem.kind.loses_content();
    expansion.whole && !expansion.problems.iter().any(loses)
}

/// The expanded document of a root.
pub struct DocumentCx<'a> {
    /// The expansion of the root.
    pub expansion: &'a Expansion,
    /// The element to look at: the root of the document, or what a macro gives that nothing calls.
    pub element: XId,
    /// What the root file is taken for.
    pub kind: RootKind,
    /// Whether the user named the root file.
    pub explicit: bool,
    /// The robot; none when the root element is not `robot`.
    pub robot: Option<&'a Robot>,
    /// What lies around it.
    pub world: RuleEnv<'a>,
    /// Whether all elements of the expansion are there.
    pub complete: bool,
    /// The meshes that the robot names, once a rule has asked.
    pub(super) resources: OnceCell<Resources>,
    /// Where it names them, once a rule has asked.
    pub(super) mesh_references: OnceCell<Vec<MeshReference<'a>>>,
    /// What the texts mention, once a rule has asked.
    pub(super) mentions: OnceCell<Option<Vec<MentionedWords>>>,
    /// The shapes that stand in bodies without a geometry, of the bodies that a rule has asked about.
    pub(super) bare_shapes: RefCell<FastMap<XId, Option<&'a str>>>,
    /// What consumers may reject or change, once a rule has asked.
    pub(super) constructs: OnceCell<Vec<Met>>,
    /// The attributes that name its links and joints, once a rule has asked.
    pub(super) named_by: OnceCell<NamedBy>,
    /// What elements for Gazebo set to true, and of which link or of the whole robot, once a rule has asked.
    set: OnceCell<FastSet<(Option<&'a str>, &'a str)>>,
    /// For each definition whether something uses it, once a rule has asked.
    pub(super) used: OnceCell<Vec<bool>>,
    /// The macros that the files define, once a rule has asked.
    pub(super) macros: OnceCell<FastSet<&'a str>>,
    all: AllElements,
    pub(super) watch: Watch,
}

/// What is known of all links and joints together, once a rule has asked.
#[derive(Default)]
pub(super) struct AllElements {
    /// How far apart the joints are.
    pub(super) distances: OnceCell<Distances>,
    /// The lengths of the axes of joints that move.
    pub(super) axis_lengths: OnceCell<Vec<f64>>,
    /// The limits of joints along a line, meters, as bits.
    pub(super) sliding_ranges: OnceCell<FastSet<[u64; 2]>>,
    /// How the drives of Gazebo move wheels.
    drives: OnceCell<Drives>,
}

/// How the plugins of Gazebo for drives move wheels.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Drives {
    /// The torque of the weakest one that is given one, newton meters.
    pub(super) torque: Option<f64>,
    /// Whether one sets the speed of its wheels, whatever torque that takes.
    pub(super) sets_speed: bool,
}

impl<'a> DocumentCx<'a> {
    /// What there is to know about an element of an expansion.
    pub(super) fn new(
        expansion: &'a Expansion,
        element: XId,
        (kind, explicit): (RootKind, bool),
        robot: Option<&'a Robot>,
        world: RuleEnv<'a>,
        complete: bool,
    ) -> Self {
        Self {
            expansion,
            element,
            kind,
            explicit,
            robot,
            world,
            complete,
            resources: OnceCell::new(),
            mesh_references: OnceCell::new(),
            mentions: OnceCell::new(),
            bare_shapes: RefCell::default(),
            constructs: OnceCell::new(),
            named_by: OnceCell::new(),
            set: OnceCell::new(),
            used: OnceCell::new(),
            macros: OnceCell::new(),
            all: AllElements::default(),
            watch: Watch::default(),
        }
    }

    /// The steps of the expansion, each with its first element and the node behind its last one. Macros that nothing calls have
    /// none.
    pub(super) fn steps(&self) -> impl Iterator<Item = (&StepKey, Range<XId>)> {
        let is_document = self.expansion.tree.root() == Some(self.element);
        let steps = is_document.then(|| self.expansion.steps());
        steps.into_iter().flatten()
    }

    /// Note that a rule looks at something else than the element that it is asked about. What is read off the tree around the
    /// element, off its root tag, and off the configuration needs no note.
    pub(super) fn look_beyond(&self) {
        self.watch.note_anything();
    }

    /// What is known of all links and joints together.
    pub(super) fn all(&self) -> &AllElements {
        self.look_beyond();
        &self.all
    }

    /// How many joints there are.
    pub(super) fn joint_count(&self) -> usize {
        self.named_robot().map_or(0, |robot| robot.joints.len())
    }

    /// The joints whose child is a link of this name, in document order.
    pub(super) fn joints_above(&self, link: &str) -> impl Iterator<Item = &'a Joint> + Clone {
        self.named_robot()
            .into_iter()
            .flat_map(move |robot| robot.joints_above(link))
            .inspect(|joint| self.watch.note_element(joint.element))
    }

    /// The only joint whose child is a link of this name; none where there are several.
    pub(super) fn joint_above(&self, link: &str) -> Option<&'a Joint> {
        let mut joints = self.joints_above(link);
        joints.next().filter(|_| joints.next().is_none())
    }

    /// The joints whose parent is a link of this name, in document order.
    pub(super) fn joints_below(&self, link: &str) -> impl Iterator<Item = &'a Joint> + Clone {
        self.named_robot()
            .into_iter()
            .flat_map(move |robot| robot.joints_below(link))
            .inspect(|joint| self.watch.note_element(joint.element))
    }

    /// The links of a name, in document order.
    pub(super) fn links_named(&self, name: &str) -> impl Iterator<Item = &'a Link> + Clone {
        self.named_robot()
            .into_iter()
            .flat_map(move |robot| robot.links_named(name))
            .inspect(|link| self.watch.note_element(link.element))
    }

    /// The robot, of which it is looked which links and joints have a name.
    fn named_robot(&self) -> Option<&'a Robot> {
        self.watch.note_names();
        self.robot
    }

    /// The links of the document.
    pub fn links(&self) -> &'a SharedList<Link> {
        static NONE: SharedList<Link> = SharedList::new();
        self.look_beyond();
        self.robot.map_or(&NONE, |robot| &robot.links)
    }

    /// Whether the document is a model that never moves, such as a hall, whose measures are not those of robots.
    pub fn is_static(&self) -> bool {
        self.is_set_for(None, "static")
    }

    /// Whether an element for Gazebo about a link, or about the whole robot, sets something to true.
    pub(super) fn is_set_for(&self, link: Option<&str>, setting: &str) -> bool {
        self.look_beyond();
        self.set
            .get_or_init(|| set_for_gazebo(self.expansion, self.robot))
            .contains(&(link, setting))
    }

    /// How the plugins of Gazebo for drives move wheels.
    pub(super) fn drives(&self) -> Drives {
        let drives = || Drives::of(self.expansion, self.robot);
        *self.all().drives.get_or_init(drives)
    }

    /// The joints of the document.
    pub fn joints(&self) -> &'a SharedList<Joint> {
        static NONE: SharedList<Joint> = SharedList::new();
        self.look_beyond();
        self.robot.map_or(&NONE, |robot| &robot.joints)
    }

    /// Whether the robot is written in an older version of URDF; false where another file says which.
    pub fn is_older_than(&self, version: Version) -> bool {
        // asked for each attribute: nearly all are as old as the format
        version > Version(1, 0)
            && self.kind == RootKind::Robot
            && Version::of(&self.expansion.tree).is_some_and(|own| own < version)
    }

    /// Whether every element of the document is there: nothing may be said about what is missing otherwise. In
    /// a macro that nothing calls, blocks and conditions are not known.
    pub fn whole(&self) -> bool {
        self.complete && self.expansion.tree.root() == Some(self.element)
    }
}

impl Drives {
    /// A plugin reads one of the names that the torque had in different releases: the greatest counts.
    fn of(expansion: &Expansion, robot: Option<&Robot>) -> Self {
        const TORQUES: [&str; 3] = ["torque", "wheelTorque", "max_wheel_torque"];
        let tree = &expansion.tree;
        let is = |id: XId, names: &[&str]| names.contains(&tree.get(id).text.as_str());
        let blocks = robot.into_iter().flat_map(|robot| &robot.gazebo);
        let plugins = blocks
            .flat_map(|block| tree.elements(block.element))
            .filter(|&child| is(child, &["plugin"]));
        let mut found = Self::default();
        for plugin in plugins {
            let library = tree
                .attr(plugin, "filename")
                .map(|file| file.value.as_str());
            found.sets_speed |= library.is_some_and(|library| library.contains("-drive-system"));
            let settings = tree.elements(plugin).filter(|&child| is(child, &TORQUES));
            let torque = settings
                .filter_map(|setting| AttrValue::content(tree, setting)?.number())
                .reduce(f64::max);
            found.torque = [found.torque, torque]
                .into_iter()
                .flatten()
                .reduce(f64::min);
        }
        found
    }
}

/// What elements for Gazebo set to true, each with the link that it is about.
fn set_for_gazebo<'a>(
    expansion: &'a Expansion,
    robot: Option<&'a Robot>,
) -> FastSet<(Option<&'a str>, &'a str)> {
    let tree = &expansion.tree;
    let blocks = robot.into_iter().flat_map(|robot| &robot.gazebo);
    let tags = blocks.flat_map(|block| {
        let link = block.reference.as_ref().map(|name| name.value.as_str());
        tree.elements(block.element).map(move |tag| (link, tag))
    });
    let is_true = |tag: XId| {
        AttrValue::content(tree, tag).is_some_and(|text| ["true", "1"].contains(&text.value.trim()))
    };
    tags.filter(|&(_, tag)| is_true(tag))
        .map(|(link, tag)| (link, tree.get(tag).text.as_str()))
        .collect()
}

/// What lies around a description: packages, files, settings.
#[derive(Clone, Copy)]
pub struct RuleEnv<'a> {
    /// Where packages are looked for.
    pub packages: &'a Packages,
    /// Whether any ROS is around: without one, that a package is not found says little.
    pub has_ros: bool,
    /// Files.
    pub vfs: &'a Vfs,
    /// Meshes, read once.
    pub meshes: &'a Meshes,
    /// Package manifests, read once.
    pub manifests: &'a Manifests,
    /// The configuration of the root file.
    pub config: &'a Config,
}

/// An expanded robot.
pub struct RobotCx<'a> {
    /// The expansion of the root.
    pub expansion: &'a Expansion,
    /// Its links and joints.
    pub robot: &'a Robot,
    /// How its links hang together.
    pub kinematics: &'a Kinematics,
    /// What lies around it.
    pub world: RuleEnv<'a>,
    /// Whether all links and joints are there, with all their names known. When an include, a macro or a
    /// condition could not be resolved, nothing may be said about what is missing.
    pub whole: bool,
}
