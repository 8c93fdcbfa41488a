//! Links that joints name and nobody defines.
use std::cell::OnceCell;

use ecow::EcoString;
use indexmap::IndexMap;

use super::super::context::{RobotCx, elements};
use base::FastSet;
use expand::Origin;
use model::{AttrValue, Joint, Robot};
use packages::{Suggestions, nearest};

/// A link that does not exist.
pub(super) struct MissingLink {
    /// Its name.
    pub(super) name: EcoString,
    /// The joints that name it.
    pub(super) uses: LinkUses,
    /// The link that was perhaps meant.
    pub(super) nearest: Option<EcoString>,
}

/// The joints that name a link, in document order.
pub(super) struct LinkUses {
    /// The first.
    pub(super) first: LinkUse,
    /// The others.
    pub(super) others: Vec<LinkUse>,
}

/// A joint that names a link.
pub(super) struct LinkUse {
    /// The joint's name.
    pub(super) joint: String,
    /// Whether as parent or as child.
    pub(super) end: &'static str,
    /// The name in the source.
    pub(super) at: Origin,
    /// Whether the source holds the name itself, not an expression.
    pub(super) literal: bool,
}

/// All links that joints name and nobody defines, in the order of their first use. A link whose name could not be computed
/// may be any that its known part fits.
pub(super) fn missing_links(cx: &RobotCx<'_>) -> Vec<MissingLink> {
    let mut missing: IndexMap<EcoString, LinkUses> = IndexMap::new();
    let almost = OnceCell::new();
    let doubtful = OnceCell::new();
    let joints = cx.robot.joints.iter().enumerate();
    let incomplete = joints.filter(|(number, _)| cx.kinematics.ends(*number).is_none());
    for (_, joint) in incomplete {
        for (end, text) in [("parent", &joint.parent), ("child", &joint.child)] {
            let Some(text) = text else { continue };
            let Some(name) = text
                .name()
                .filter(|name| cx.kinematics.link(name).is_none())
            else {
                continue;
            };
            if almost.get_or_init(|| almost_links(cx)).contains(name)
                || text.is_doubtful()
                || may_be_there(doubtful.get_or_init(|| doubtful_links(cx)), name)
            {
                continue;
            }
            let used = LinkUse {
                joint: joint.shown().to_owned(),
                end,
                at: text.origin,
                literal: text.is_literal(),
            };
            match missing.get_mut(name) {
                Some(uses) => uses.others.push(used),
                None => {
                    missing.insert(
                        name.clone(),
                        LinkUses {
                            first: used,
                            others: Vec::new(),
                        },
                    );
                }
            }
        }
    }
    let mut suggestions = Suggestions::default();
    missing
        .into_iter()
        .map(|(name, uses)| MissingLink {
            nearest: near_link(cx, &name, &mut suggestions),
            name,
            uses,
        })
        .collect()
}

/// The names of links that could not be computed.
fn doubtful_links<'a>(cx: &RobotCx<'a>) -> Vec<&'a AttrValue> {
    let names = cx.robot.links.iter().filter_map(|link| link.name.as_ref());
    names.filter(|text| text.is_doubtful()).collect()
}

/// Whether a link whose name could not be computed may have this name.
fn may_be_there(doubtful: &[&AttrValue], name: &str) -> bool {
    doubtful.iter().any(|text| text.may_be(name))
}

/// The names of links that are there but for something else that is reported: a tag that is misspelled, spaces in the name.
fn almost_links(cx: &RobotCx<'_>) -> FastSet<EcoString> {
    let tree = &cx.expansion.tree;
    let elements = tree
        .elements(cx.robot.element)
        .filter(|&id| is_misspelled_link(&tree.get(id).text));
    let named = elements.filter_map(|id| Some(AttrValue::attr(tree, id, "name")?.name()?.clone()));
    let trimmed = link_names(cx)
        .filter(|name| name.trim() != *name)
        .map(|name| name.trim().into());
    named.chain(trimmed).collect()
}

fn is_misspelled_link(tag: &str) -> bool {
    tag != "link" && nearest(tag, ["link"]).is_some()
}

/// The names of links that are known.
fn link_names<'a>(cx: &RobotCx<'a>) -> impl Iterator<Item = &'a str> {
    cx.robot
        .links
        .iter()
        .filter_map(|link| Some(link.name.as_ref()?.name()?.as_str()))
}

/// Links that a misspelled joint lost: what is wrong with them is said at the joint.
pub(super) fn lost_links(cx: &RobotCx<'_>) -> FastSet<EcoString> {
    missing_links(cx)
        .into_iter()
        .filter_map(|missing| missing.nearest)
        .collect()
}

/// How many parents and children of joints are missing: what is missing is reported at the joint.
pub(super) fn missing_ends(robot: &Robot) -> usize {
    let ends = |joint: &Joint| [&joint.parent, &joint.child].map(|end| usize::from(end.is_none()));
    robot.joints.iter().flat_map(ends).sum()
}

/// How many joints have no parent or no child.
pub(super) fn incomplete_joints(robot: &Robot) -> usize {
    let is_incomplete = |joint: &&Joint| joint.parent.is_none() || joint.child.is_none();
    robot.joints.iter().filter(is_incomplete).count()
}

/// The link that was perhaps meant: a near name, or the only one that differs by a prefix.
fn near_link(cx: &RobotCx<'_>, name: &str, suggestions: &mut Suggestions) -> Option<EcoString> {
    if !suggestions.is_open() {
        return None;
    }
    let is_loose = |name: &&str| {
        cx.kinematics.link(name).is_some_and(|link| {
            cx.kinematics.parent_joints(link).is_empty()
                && cx.kinematics.child_joints(link).is_empty()
        })
    };
    if let Some(near) = suggestions.nearest(name, link_names(cx).filter(is_loose)) {
        return Some(near.into());
    }
    if let Some(near) = suggestions.nearest(name, link_names(cx)) {
        return Some(near.into());
    }
    let mut prefixed =
        link_names(cx).filter(|other| is_prefixed(other, name) || is_prefixed(name, other));
    match (prefixed.next(), prefixed.next()) {
        (Some(only), None) => Some(only.into()),
        _ => None,
    }
}

/// Whether a name is another one with a prefix.
fn is_prefixed(long: &str, short: &str) -> bool {
    long.strip_suffix(short)
        .is_some_and(|prefix| prefix.ends_with('_'))
}

/// The links that joints somewhere in the files, with other arguments, have as one of these ends: `parent`, `child`.
pub(super) fn joined_elsewhere(cx: &RobotCx<'_>, ends: &[&str]) -> FastSet<EcoString> {
    let files = cx.expansion.files.iter();
    let nodes = files
        .flat_map(|file| elements(&file.source.document))
        .map(|(_, node)| node);
    let names = nodes
        .filter(|node| ends.contains(&node.name()))
        .filter_map(|node| node.attr("link"));
    names.map(|name| name.raw().into()).collect()
}
