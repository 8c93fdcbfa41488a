//! Links with the inertia of a motor added on purpose.
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::super::context::DocumentCx;
use super::moments::{Impossible, judged};
use base::FastSet;
use expand::XId;
use model::{JointType, Link, Robot};

/// From this many links on, a moment that is too large about the own joint is that of the motor, added on purpose.
const ROTORS: usize = 3;

/// The links with the inertia of a motor; none where they are too few to be meant so.
pub(in super::super) fn rotors<'a>(cx: &'a DocumentCx<'_>) -> &'a Arc<FastSet<XId>> {
    cx.watch.note_rotors();
    cx.rotors.get_or_init(|| {
        let all = cx.robot.map(all).unwrap_or_default();
        Arc::new(if all.len() < ROTORS {
            FastSet::default()
        } else {
            all
        })
    })
}

fn all(robot: &Robot) -> FastSet<XId> {
    let links = robot.links.iter().filter(|link| has_rotor(robot, link));
    links.map(|link| link.element).collect()
}

/// Whether the largest moment of a link is that of a motor about its own joint.
fn has_rotor(robot: &Robot, link: &Link) -> bool {
    let judged = link.inertial.as_ref().map(judged);
    let impossible = judged
        .as_ref()
        .and_then(|judged| judged.impossible.as_ref());
    impossible.is_some_and(
        |Impossible {
             moments, tensor, ..
         }| {
            tensor.is_some_and(|tensor| is_about_joint(robot, link, &tensor, moments[2]))
        },
    )
}

/// Whether the largest moment of a link is that about the axis of its own joint.
fn is_about_joint(robot: &Robot, link: &Link, tensor: &Matrix3<f64>, most: f64) -> bool {
    const TOLERANCE: f64 = 0.02;
    let mut joints = robot.joints_above(link.shown());
    let Some(joint) = joints.next().filter(|_| joints.next().is_none()) else {
        return false;
    };
    let axis = joint
        .axis()
        .map(Vector3::from)
        .and_then(|axis| axis.try_normalize(f64::EPSILON));
    let Some(axis) = axis.filter(|_| !joint.is(&[JointType::Fixed])) else {
        return false;
    };
    (tensor * axis - most * axis).norm() <= TOLERANCE * most
}
