//! Semantic descriptions (SRDF): groups, poses and collision pairs of a robot, which MoveIt reads beside the URDF.
use std::path::Path;

use super::rule::{Category, Check, Rule};
use expand::Expansion;
use xml::{Document, Node, NodeKind};

/// Elements that only SRDF knows.
const ELEMENTS: [&str; 10] = [
    "disable_collisions",
    "disable_default_collisions",
    "enable_collisions",
    "end_effector",
    "group",
    "group_state",
    "joint_property",
    "link_sphere_approximation",
    "passive_joint",
    "virtual_joint",
];

/// Whether the root file of an expansion is SRDF: its name ends so, it is in a folder `srdf`, or it holds elements of
/// SRDF. With a link at the top it is URDF, whatever the folder or the other elements.
pub fn is_semantic(expansion: &Expansion) -> bool {
    expansion
        .files
        .first()
        .is_some_and(|file| is_semantic_file(&file.source.path, &file.source.document))
}

/// The same of a file that nobody expands by itself.
pub fn is_semantic_file(path: &Path, document: &Document) -> bool {
    if is_semantic_name(path) {
        return true;
    }
    let Holds { link, srdf } = Holds::of(document);
    let folder = path.parent().and_then(Path::file_name);
    !link && (srdf || folder.is_some_and(|name| name.eq_ignore_ascii_case("srdf")))
}

/// Whether the name of a file says that it is SRDF, or gives one.
pub fn is_semantic_name(path: &Path) -> bool {
    let name = path
        .file_name()
        .map(|name| name.to_string_lossy().to_lowercase())
        .unwrap_or_default();
    name.ends_with(".srdf") || name.ends_with(".srdf.xacro")
}

/// What a file holds at its top, in its macros and in its conditions.
#[derive(Default)]
struct Holds {
    link: bool,
    srdf: bool,
}

impl Holds {
    fn of(document: &Document) -> Self {
        let mut found = Self::default();
        for (_, item) in document.parts().skip(1) {
            // an item holds one child of the root
            found.note(
                item.all_nodes()
                    .find(|node| node.kind() == NodeKind::Element),
            );
            if found.link {
                break;
            }
        }
        found
    }

    fn note(&mut self, element: Option<Node<'_>>) {
        // not by recursion: a file may nest conditions as deep as it likes
        let mut open: Vec<Node<'_>> = element.into_iter().collect();
        while let Some(node) = open.pop() {
            match node.name() {
                "link" => self.link = true,
                "xacro:macro" | "xacro:if" | "xacro:unless" => open.extend(node.child_elements()),
                name => self.srdf |= ELEMENTS.contains(&name),
            }
        }
    }
}

/// Whether a rule holds for SRDF as well: those of XML, of xacro, of packages and of the linter itself, and none that
/// reads the elements of URDF.
pub fn holds_for_semantic(rule: &Rule) -> bool {
    match rule.category {
        Category::Xml => matches!(rule.check, Check::File(_) | Check::Expander),
        Category::Xacro | Category::Package | Category::Style | Category::Linter => true,
        _ => false,
    }
}
