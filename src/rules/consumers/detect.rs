//! Finding the constructs of a robot that the table knows.
use std::collections::BTreeMap;

use super::super::context::{DocumentCx, RootKind, RuleEnv, is_plain_urdf, is_whole};
use super::facts::{ConstructCollector, RobotFacts};
use super::met::Met;
use super::table::Outcome;
use super::{control, geometry, inertia, joints, materials, meshes, mimic, names, numbers, tree};
use expand::Expansion;
use model::{Robot, tag_start};
use xml::{SyntaxError, SyntaxErrorKind};

/// The constructs of a robot that the table knows, by detector and in document order.
pub fn constructs(expansion: &Expansion, robot: Option<&Robot>, world: RuleEnv<'_>) -> Vec<Met> {
    let Some(root) = expansion.tree.root() else {
        return Vec::new();
    };
    let mut found = ConstructCollector::default();
    if robot.is_none() {
        found.add("root-element", tag_start(expansion, root), "the file");
        return found.met;
    }
    for row in tolerated(expansion).into_iter().flatten() {
        found.add(row, tag_start(expansion, root), "the robot");
    }
    let kind = (RootKind::Robot, true);
    let cx = DocumentCx::new(expansion, root, kind, robot, world, is_readable(expansion));
    found.met.extend(find(&cx));
    found.met
}

/// What some consumer rejects or changes of a robot, by the name of the construct, with the worst that one does.
pub type Tally = BTreeMap<&'static str, Outcome>;

/// The constructs of a robot that some consumer rejects or changes; none when consumers are not given it.
pub(in super::super) fn tally(cx: &DocumentCx<'_>) -> Tally {
    if !is_readable(cx.expansion) {
        return Tally::new();
    }
    let outcomes = met(cx)
        .iter()
        .map(|met| (met.construct.name.as_str(), met.construct.worst()));
    outcomes
        .filter(|(_, worst)| *worst > Outcome::Accepts)
        .collect()
}

/// Whether an expansion gives a document that consumers can be given. Many read plain URDF with prefixes that are not
/// declared, which xacro rejects.
pub fn is_readable(expansion: &Expansion) -> bool {
    !expansion.has_errors() && is_whole(expansion) || tolerated(expansion).is_some()
}

/// The rows of what is wrong with a file of plain URDF, when many consumers read it in spite of that.
fn tolerated(expansion: &Expansion) -> Option<Vec<&'static str>> {
    let [file] = expansion.files.as_slice() else {
        return None;
    };
    let document = &file.source.document;
    let is_first = document.text().starts_with("<?xml");
    let row = |error: &SyntaxError| match error.kind {
        SyntaxErrorKind::UnboundPrefix => Some("prefix-undeclared"),
        SyntaxErrorKind::BadReference => Some("reference-malformed"),
        SyntaxErrorKind::UndefinedEntity => Some("entity-undefined"),
        SyntaxErrorKind::LtInValue => Some("less-than-in-value"),
        SyntaxErrorKind::BadCharacterReference => Some("character-reference"),
        SyntaxErrorKind::DuplicateAttribute => Some("attribute-twice"),
        SyntaxErrorKind::BadComment => Some("comment-with-dashes"),
        SyntaxErrorKind::CDataEndInText => Some("cdata-end"),
        SyntaxErrorKind::BadDeclaration if is_first => Some("declaration-malformed"),
        _ => None,
    };
    let rows: Option<Vec<_>> = document.errors().iter().map(row).collect();
    rows.filter(|rows| !rows.is_empty() && is_plain_urdf(&file.source.path))
}

/// The constructs of a document, found once.
pub(super) fn met<'c>(cx: &'c DocumentCx<'_>) -> &'c [Met] {
    cx.constructs.get_or_init(|| find(cx))
}

fn find(cx: &DocumentCx<'_>) -> Vec<Met> {
    let Some(robot) = cx
        .robot
        .filter(|_| cx.kind == RootKind::Robot && cx.whole())
    else {
        return Vec::new();
    };
    let facts = RobotFacts::of(cx, robot);
    let mut found = ConstructCollector::default();
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
