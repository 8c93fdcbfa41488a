//! Links whose mass and inertia have little or no effect: fixed to another link, fixed to the world, or without a shape
//! of their own.
use nalgebra::Isometry3;

use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent_of};
use super::super::vocabulary::is_surroundings;
use base::FastSet;
use expand::XId;
use model::{Bounds, Joint, JointType, Link, joined_inertia, transform};

/// A geometry whose box has half a diagonal up to this length in meters is a marker: it does not show the shape.
pub(super) const MARKER: f64 = 0.01;
/// Nothing depends on the inertia of links up to this mass, kg.
pub(super) const LIGHT: f64 = 0.01;

/// Whether a link is fixed to another one: simulators join both to one body.
pub(super) fn is_joined(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let mut above = joints_above(cx, link.shown()).peekable();
    above.peek().is_some() && above.all(|joint| joint.is(&[JointType::Fixed]))
}

/// Whether a link is fixed to a body of which it is a small part: up to a twentieth of the mass of one that carries it.
pub(super) fn is_small_part(cx: &DocumentCx<'_>, link: &Link, mass: f64) -> bool {
    const SMALL: f64 = 0.05;
    let mut name = link.shown();
    for _ in 0..=cx.joint_count() {
        let Some(joint) = joint_above(cx, name) else {
            return false;
        };
        let Some(parent) = joint
            .parent
            .as_ref()
            .filter(|_| joint.is(&[JointType::Fixed]))
        else {
            return false;
        };
        name = parent.value.as_str();
        let mut carried = cx
            .links_named(name)
            .filter_map(|carrier| carrier.inertial.as_ref()?.mass());
        if carried.any(|carried| mass <= SMALL * carried) {
            return true;
        }
    }
    false
}

/// Whether a link never moves: a chain of fixed joints leads up to the world.
pub(super) fn is_in_world(cx: &DocumentCx<'_>, link: &Link) -> bool {
    chain_to_world(cx, link).is_some()
}

/// Whether a link never moves, wherever its file is used: the fixed joints that lead up to the world stand beside it, in the same
/// file and macro.
pub(super) fn is_built_into_world(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let place = |element: XId| {
        let origin = cx.expansion.tree.get(element).origin;
        Some((cx.expansion.place(origin)?.file, origin.frame))
    };
    let own = place(link.element);
    chain_to_world(cx, link)
        .is_some_and(|chain| own.is_some() && chain.iter().all(|joint| place(joint.element) == own))
}

/// The fixed joints that lead from a link up to the world; none when it can move.
fn chain_to_world<'a>(cx: &'a DocumentCx<'_>, link: &'a Link) -> Option<Vec<&'a Joint>> {
    let mut name = link.shown();
    let mut chain = Vec::new();
    for _ in 0..=cx.joint_count() {
        if is_surroundings(name) {
            return Some(chain);
        }
        let joint = joint_above(cx, name)?;
        let parent = joint.parent.as_ref();
        name = parent
            .filter(|_| joint.is(&[JointType::Fixed]))?
            .value
            .as_str();
        chain.push(joint);
    }
    None
}

/// The box of visuals and collisions together; none when there are none, or a part of it is not known.
pub(super) fn known_box(cx: &DocumentCx<'_>, link: &Link) -> Option<Bounds> {
    let parts = [
        extent_of(cx, &link.collisions),
        extent_of(cx, &link.visuals),
    ];
    if parts.contains(&Extent::Unknown) {
        return None;
    }
    parts
        .into_iter()
        .filter_map(Extent::bounds)
        .reduce(|a, b| a.with(b))
}

/// The same, when it is more than a marker.
pub(super) fn shape(cx: &DocumentCx<'_>, link: &Link) -> Option<Bounds> {
    known_box(cx, link).filter(|bounds| bounds.diagonal() / 2.0 > MARKER)
}

/// The boxes of a link and of all that is fixed to it, in its frame: simulators join them to one body. Parts that are not
/// known are left out.
pub(super) fn body_boxes(cx: &DocumentCx<'_>, link: &Link) -> Vec<Bounds> {
    let mut found = Vec::new();
    for (part, place) in body_parts(cx, link) {
        found.extend(known_box(cx, part).map(|bounds| bounds.moved(&place)));
    }
    found
}

/// Mass and inertia of a link with all that is fixed to it, as of one body; none when they are not known, or when nothing is.
pub(super) fn body_inertia(cx: &DocumentCx<'_>, link: &Link) -> Option<(f64, [f64; 6])> {
    let parts = body_parts(cx, link);
    let inertials = parts
        .iter()
        .filter_map(|(part, place)| Some((part.inertial.as_ref()?, Some(*place))));
    (inertials.clone().count() > 1)
        .then(|| joined_inertia(inertials))
        .flatten()
}

/// A link and all that is fixed to it, with their places in its frame.
fn body_parts<'a>(cx: &DocumentCx<'a>, link: &Link) -> Vec<(&'a Link, Isometry3<f64>)> {
    const MOST: usize = 64;
    let mut seen: FastSet<&str> = FastSet::default();
    let mut open = vec![(link.shown(), Isometry3::identity())];
    let mut found = Vec::new();
    while let Some((name, place)) = open.pop().filter(|_| seen.len() < MOST) {
        if matches!(name, "" | "?") || !seen.insert(name) {
            continue;
        }
        found.extend(cx.links_named(name).map(|part| (part, place)));
        let fixed = |joint: &&Joint| joint.is(&[JointType::Fixed]);
        for joint in cx.joints_above(name).filter(fixed) {
            let to = transform(joint.origin.as_ref()).map(|to| place * to.inverse());
            let parent = joint.parent.as_ref().zip(to);
            open.extend(parent.map(|(parent, to)| (parent.value.as_str(), to)));
        }
        for joint in cx.joints_below(name).filter(fixed) {
            let to = transform(joint.origin.as_ref()).map(|to| place * to);
            let child = joint.child.as_ref().zip(to);
            open.extend(child.map(|(child, to)| (child.value.as_str(), to)));
        }
    }
    found
}

/// The joints whose child is a link. In a macro that nothing calls, a part of the names is not known; what is known tells
/// them apart.
fn joints_above<'a>(cx: &DocumentCx<'a>, link: &str) -> impl Iterator<Item = &'a Joint> + Clone {
    let is_known = !matches!(link, "" | "?");
    is_known
        .then(|| cx.joints_above(link))
        .into_iter()
        .flatten()
}

/// The only one of them.
fn joint_above<'a>(cx: &DocumentCx<'a>, link: &str) -> Option<&'a Joint> {
    let is_known = !matches!(link, "" | "?");
    cx.joint_above(link).filter(|_| is_known)
}
