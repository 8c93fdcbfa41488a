//! Links that joints name and nobody defines.

use ecow::EcoString;
use indexmap::IndexMap;

use super::super::context::{RobotCx, elements};
use base::FastSet;
use expand::Origin;
use workspace::nearest;
use xml::Node;

/// A link that does not exist.
pub(super) struct Missing {
    /// Its name.
    pub(super) name: EcoString,
    /// The joints that name it.
    pub(super) uses: Uses,
    /// The link that was perhaps meant.
    pub(super) nearest: Option<EcoString>,
}

/// The joints that name a link, in document order.
pub(super) struct Uses {
    /// The first.
    pub(super) first: Use,
    /// The others.
    pub(super) others: Vec<Use>,
}

/// A joint that names a link.
pub(super) struct Use {
    /// The joint's name.
    pub(super) joint: String,
    /// Whether as parent or as child.
    pub(super) end: &'static str,
    /// The name in the source.
    pub(super) at: Origin,
    /// Whether the source holds the name itself, not an expression.
    pub(super) literal: bool,
}

/// All links that joints name and nobody defines, in the order of their first use.
pub(super) fn missing_links(cx: &RobotCx<'_>) -> Vec<Missing> {
    let mut missing: IndexMap<EcoString, Uses> = IndexMap::new();
    for joint in &cx.robot.joints {
        for (end, text) in [("parent", &joint.parent), ("child", &joint.child)] {
            let Some(text) = text else { continue };
            let Some(name) = text.name().filter(|name| cx.kinematics.link(name).is_none()) else { continue };
            let used =
                Use { joint: joint.shown().to_owned(), end, at: text.origin, literal: text.is_literal() };
            match missing.get_mut(name) {
                Some(uses) => uses.others.push(used),
                None => {
                    missing.insert(name.clone(), Uses { first: used, others: Vec::new() });
                }
            }
        }
    }
    // looking for near names takes time; nobody reads that many suggestions
    let near = |i: usize, name: &EcoString| if i < 50 { near_link(cx, name) } else { None };
    let missing = missing.into_iter().enumerate();
    missing.map(|(i, (name, uses))| Missing { nearest: near(i, &name), name, uses }).collect()
}

/// Links that a misspelt joint lost: what is wrong with them is said at the joint.
pub(super) fn lost_links(cx: &RobotCx<'_>) -> FastSet<EcoString> {
    missing_links(cx).into_iter().filter_map(|missing| missing.nearest).collect()
}

/// The link that was perhaps meant: a near name, or the only one that differs by a prefix.
fn near_link(cx: &RobotCx<'_>, name: &str) -> Option<EcoString> {
    let names = || cx.robot.links.iter().filter_map(|link| Some(link.name.as_ref()?.name()?.as_str()));
    if let Some(near) = nearest(name, names()) {
        return Some(near.into());
    }
    let extends =
        |long: &str, short: &str| long.strip_suffix(short).is_some_and(|prefix| prefix.ends_with('_'));
    let mut prefixed = names().filter(|other| extends(other, name) || extends(name, other));
    match (prefixed.next(), prefixed.next()) {
        (Some(only), None) => Some(only.into()),
        _ => None,
    }
}

/// Whether a joint somewhere in the files, with other arguments, has a link as one of these ends: `parent`, `child`.
pub(super) fn is_joined_elsewhere(cx: &RobotCx<'_>, link: &str, ends: &[&str]) -> bool {
    let names = |node: Node<'_>| {
        ends.contains(&node.name()) && node.attr("link").is_some_and(|name| name.raw() == link)
    };
    cx.expansion.files.iter().any(|file| elements(&file.source.document).any(|(_, node)| names(node)))
}
