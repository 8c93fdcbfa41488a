//! Rigid bodies: links with all that is fixed to them, which simulators take for one.
use nalgebra::Isometry3;

use model::{JointType, Kinematics, Link, Robot, joined_inertia, transform};

/// A link that is the root or moves, with the links that are fixed below it.
#[derive(Debug)]
pub(super) struct RigidBody {
    /// Indices of its links, the one that moves first.
    pub(super) links: Vec<usize>,
    /// Whether the root is one of them.
    pub(super) is_root: bool,
    /// Whether one of its links has a mass, or one that is not known.
    pub(super) has_mass: bool,
    /// Its mass, kg, and `ixx ixy ixz iyy iyz izz` about its center of mass, kg m^2; none when a part is not known.
    pub(super) sum: Option<(f64, [f64; 6])>,
}

/// The bodies of a robot.
pub(super) fn bodies(robot: &Robot, kinematics: &Kinematics) -> Vec<RigidBody> {
    (0..robot.links.len())
        .filter(|&link| {
            let joint = kinematics.parent_joints(link).first();
            let joint = joint.and_then(|&joint| robot.joints.get(joint));
            joint.is_none_or(|joint| !joint.is(&[JointType::Fixed]))
        })
        .map(|top| body(robot, kinematics, top))
        .collect()
}

fn body(robot: &Robot, kinematics: &Kinematics, top: usize) -> RigidBody {
    let mut placed = vec![(top, Some(Isometry3::identity()))];
    let mut next = 0;
    while let Some(&(link, place)) = placed.get(next).filter(|_| next < robot.links.len()) {
        next += 1;
        for &index in kinematics.child_joints(link) {
            let Some(joint) = robot
                .joints
                .get(index)
                .filter(|joint| joint.is(&[JointType::Fixed]))
            else {
                continue;
            };
            let below = kinematics.ends(index).map(|(_, child)| child);
            let step = transform(joint.origin.as_ref());
            // a link with two joints above it belongs to the first of them
            placed.extend(
                below
                    .filter(|&child| kinematics.parent_joints(child).first() == Some(&index))
                    .map(|child| (child, place.zip(step).map(|(place, step)| place * step))),
            );
        }
    }
    placed.truncate(robot.links.len());
    let links: Vec<usize> = placed.iter().map(|&(link, _)| link).collect();
    RigidBody {
        is_root: kinematics.parent_joints(top).is_empty(),
        has_mass: links
            .iter()
            .any(|&link| robot.links.get(link).is_some_and(has_mass)),
        sum: sum(robot, &placed),
        links,
    }
}

fn sum(robot: &Robot, placed: &[(usize, Option<Isometry3<f64>>)]) -> Option<(f64, [f64; 6])> {
    let parts = placed.iter().filter_map(|&(link, place)| {
        let inertial = robot.links.get(link)?.inertial.as_ref()?;
        Some((inertial, place))
    });
    joined_inertia(parts)
}

/// Whether a link has a mass, or one that is not known.
pub(super) fn has_mass(link: &Link) -> bool {
    let mass = link
        .inertial
        .as_ref()
        .and_then(|inertial| inertial.mass.as_ref());
    mass.is_some_and(|mass| !mass.is_known() || mass.number().is_none_or(|mass| mass != 0.0))
}
