//! Links whose mass and inertia have little or no effect: fixed to another link, fixed to the world, or without a shape
//! of their own.

use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent_of};
use super::super::vocabulary::is_surroundings;
use model::{Bounds, Joint, JointType, Link};

/// A geometry whose box has half a diagonal up to this length in metres is a marker: it does not show the shape.
pub(super) const MARKER: f64 = 0.01;
/// Nothing depends on the inertia of links up to this mass, kg.
pub(super) const LIGHT: f64 = 0.01;

/// Whether a link is fixed to another one: simulators join both to one body.
pub(super) fn is_joined(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let above = joints_above(cx, link.shown());
    !above.is_empty() && above.iter().all(|joint| joint.is(&[JointType::Fixed]))
}

/// Whether a link is fixed to a body of which it is a small part: up to a twentieth of the mass of one that carries it.
pub(super) fn is_small_part(cx: &DocumentCx<'_>, link: &Link, mass: f64) -> bool {
    const SMALL: f64 = 0.05;
    let mut name = link.shown();
    for _ in 0..=cx.joints().len() {
        let &[joint] = joints_above(cx, name) else { return false };
        let Some(parent) = joint.parent.as_ref().filter(|_| joint.is(&[JointType::Fixed])) else {
            return false;
        };
        name = parent.value.as_str();
        let mut carried = cx.links_named(name).iter().filter_map(|carrier| carrier.inertial.as_ref()?.mass());
        if carried.any(|carried| mass <= SMALL * carried) {
            return true;
        }
    }
    false
}

/// Whether a link never moves: a chain of fixed joints leads up to the world.
pub(super) fn is_in_world(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let mut name = link.shown();
    for _ in 0..=cx.joints().len() {
        if is_surroundings(name) {
            return true;
        }
        let &[joint] = joints_above(cx, name) else { return false };
        let Some(parent) = joint.parent.as_ref().filter(|_| joint.is(&[JointType::Fixed])) else {
            return false;
        };
        name = parent.value.as_str();
    }
    false
}

/// The box of visuals and collisions together; none when there are none, or a part of it is not known.
pub(super) fn known_box(cx: &DocumentCx<'_>, link: &Link) -> Option<Bounds> {
    let parts = [extent_of(cx, &link.collisions), extent_of(cx, &link.visuals)];
    if parts.contains(&Extent::Unknown) {
        return None;
    }
    parts.into_iter().filter_map(Extent::bounds).reduce(|a, b| a.with(b))
}

/// The same, when it is more than a marker.
pub(super) fn shape(cx: &DocumentCx<'_>, link: &Link) -> Option<Bounds> {
    known_box(cx, link).filter(|bounds| bounds.diagonal() / 2.0 > MARKER)
}

/// The joints whose child is a link. In a macro that nothing calls, a part of the names is not known; what is known tells
/// them apart.
fn joints_above<'a>(cx: &'a DocumentCx<'_>, link: &str) -> &'a [&'a Joint] {
    if matches!(link, "" | "?") { &[] } else { cx.joints_above(link) }
}
