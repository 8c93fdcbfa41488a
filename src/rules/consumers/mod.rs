//! What the programs that read URDF make of a robot: a table of constructs and outcomes, and what finds them.

mod consumer;
mod control;
mod facts;
mod geometry;
mod inertia;
mod joints;
mod materials;
mod meshes;
mod mimic;
mod names;
mod numbers;
mod table;
mod tree;
mod verdict;

use super::context::{DocumentCx, RootKind, Surroundings, is_plain_urdf};
use super::registry::Rule;
use super::run::is_whole;
use expand::Expansion;
use model::{Robot, tag_start};
use xml::{SyntaxError, SyntaxErrorKind};

pub use consumer::{CONSUMERS, Consumer};
pub use facts::Met;
pub use table::{CONSTRUCTS, Construct, Outcome};

use facts::{Facts, Found};

/// The rules.
pub(super) static RULES: &[Rule] = &[verdict::REJECTS, verdict::CHANGES];

/// The constructs of a robot that the table knows, by detector and in document order.
pub fn constructs(expansion: &Expansion, robot: Option<&Robot>, world: Surroundings<'_>) -> Vec<Met> {
    let Some(root) = expansion.tree.root() else { return Vec::new() };
    let mut found = Found::default();
    if robot.is_none() {
        found.add("root-element", tag_start(expansion, root), "the file");
        return found.met;
    }
    if has_undeclared_prefix(expansion) {
        found.add("prefix-undeclared", tag_start(expansion, root), "the robot");
    }
    let kind = (RootKind::Robot, true);
    let cx = DocumentCx::new(expansion, root, kind, robot, world, is_readable(expansion));
    found.met.extend(met(&cx));
    found.met
}

/// Whether an expansion gives a document that consumers can be given. Many read plain URDF with prefixes that are not
/// declared, which xacro rejects.
pub fn is_readable(expansion: &Expansion) -> bool {
    !expansion.has_errors() && is_whole(expansion) || has_undeclared_prefix(expansion)
}

/// Whether prefixes that are not declared are all that is wrong with a file of plain URDF.
fn has_undeclared_prefix(expansion: &Expansion) -> bool {
    let [file] = expansion.files.as_slice() else { return false };
    let errors = file.source.document.errors();
    let is_prefix = |error: &SyntaxError| error.kind == SyntaxErrorKind::UnboundPrefix;
    is_plain_urdf(&file.source.path) && !errors.is_empty() && errors.iter().all(is_prefix)
}

fn met(cx: &DocumentCx<'_>) -> Vec<Met> {
    let Some(robot) = cx.robot.filter(|_| cx.kind == RootKind::Robot && cx.whole()) else {
        return Vec::new();
    };
    let facts = Facts::of(cx, robot);
    let mut found = Found::default();
    let detectors = [
        control::find,
        tree::find,
        names::find,
        joints::find,
        mimic::find,
        inertia::find,
        geometry::find,
        meshes::find,
        materials::find,
        numbers::find,
    ];
    for find in detectors {
        find(&facts, &mut found);
    }
    found.met
}
