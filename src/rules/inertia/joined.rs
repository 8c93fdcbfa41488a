//! Links whose mass and inertia have little or no effect: fixed to another link, fixed to the world, or without a shape
//! of their own.

use super::super::context::DocumentCx;
use super::super::geometry::{Extent, extent_of};
use super::super::vocabulary::is_surroundings;
use crate::model::{Bounds, Joint, JointType, Link};

/// A geometry whose box has half a diagonal up to this length in metres is a marker: it does not show the shape.
pub(super) const MARKER: f64 = 0.01;
/// Nothing depends on the inertia of links up to this mass, kg.
pub(super) const LIGHT: f64 = 0.01;

/// Whether a link is fixed to another one: simulators join both to one body.
pub(super) fn is_joined(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let above = link.name.as_ref().and_then(|name| name.name()).map(|name| joints_above(cx, name));
    above.is_some_and(|joints| !joints.is_empty() && joints.iter().all(|joint| joint.is(&[JointType::Fixed])))
}

/// Whether a link never moves: a chain of fixed joints leads up to the world.
pub(super) fn is_in_world(cx: &DocumentCx<'_>, link: &Link) -> bool {
    let mut name = link.name.as_ref().and_then(|name| name.name());
    for _ in 0..=cx.joints().len() {
        let Some(current) = name else { return false };
        if is_surroundings(current) {
            return true;
        }
        let [joint] = joints_above(cx, current)[..] else { return false };
        name = joint.ends().filter(|_| joint.is(&[JointType::Fixed])).map(|(above, _)| above);
    }
    false
}

/// The box of visuals and collisions together; none when a part of it is not known, or when it is only a marker.
pub(super) fn shape(cx: &DocumentCx<'_>, link: &Link) -> Option<Bounds> {
    let parts = [extent_of(cx, &link.collisions), extent_of(cx, &link.visuals)];
    if parts.contains(&Extent::Unknown) {
        return None;
    }
    let bounds = parts.into_iter().filter_map(Extent::bounds).reduce(|a, b| a.with(b))?;
    (bounds.diagonal() / 2.0 > MARKER).then_some(bounds)
}

fn joints_above<'a>(cx: &'a DocumentCx<'_>, link: &str) -> Vec<&'a Joint> {
    cx.joints().iter().filter(|joint| joint.ends().is_some_and(|(_, child)| child == link)).collect()
}
