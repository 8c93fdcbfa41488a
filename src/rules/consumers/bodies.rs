//! Rigid bodies: links with all that is fixed to them, which simulators take for one.
use nalgebra::{Isometry3, Matrix3, Vector3};

use model::{Inertial, JointType, Kinematics, Link, Robot, transform};

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
    let moves = |link: usize| match kinematics
        .up(link)
        .first()
        .and_then(|&joint| robot.joints.get(joint))
    {
        Some(joint) => !joint.is(&[JointType::Fixed]),
        None => true,
    };
    (0..robot.links.len())
        .filter(|&link| moves(link))
        .map(|top| body(robot, kinematics, top))
        .collect()
}

fn body(robot: &Robot, kinematics: &Kinematics, top: usize) -> RigidBody {
    let mut placed = vec![(top, Some(Isometry3::identity()))];
    let mut next = 0;
    while let Some(&(link, place)) = placed.get(next).filter(|_| next < robot.links.len()) {
        next += 1;
        for &index in kinematics.down(link) {
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
                    .filter(|&child| kinematics.up(child).first() == Some(&index))
                    .map(|child| (child, place.zip(step).map(|(place, step)| place * step))),
            );
        }
    }
    placed.truncate(robot.links.len());
    let links: Vec<usize> = placed.iter().map(|&(link, _)| link).collect();
    let parts = || {
        placed
            .iter()
            .filter_map(|&(link, place)| Some((robot.links.get(link)?, place)))
    };
    RigidBody {
        is_root: kinematics.up(top).is_empty(),
        has_mass: parts().any(|(link, _)| has_mass(link)),
        sum: sum(parts()),
        links,
    }
}

fn sum<'a>(
    parts: impl Iterator<Item = (&'a Link, Option<Isometry3<f64>>)>,
) -> Option<(f64, [f64; 6])> {
    let (mut mass, mut moment, mut inertia) = (0.0, Vector3::zeros(), Matrix3::zeros());
    for (link, place) in parts {
        let Some(inertial) = &link.inertial else {
            continue;
        };
        let (own_mass, center, own) = at(inertial, &place?)?;
        mass += own_mass;
        moment += center * own_mass;
        inertia += own + shift(center) * own_mass;
    }
    if mass != 0.0 {
        inertia -= shift(moment / mass) * mass;
    }
    let entry = |row: usize, column: usize| inertia.get((row, column)).copied().unwrap_or_default();
    Some((
        mass,
        [
            entry(0, 0),
            entry(0, 1),
            entry(0, 2),
            entry(1, 1),
            entry(1, 2),
            entry(2, 2),
        ],
    ))
}

/// Mass, center of mass and inertia about it, in the axes of the body.
fn at(inertial: &Inertial, place: &Isometry3<f64>) -> Option<(f64, Vector3<f64>, Matrix3<f64>)> {
    let [xx, xy, xz, yy, yz, zz] = inertial.entries()?;
    let place = place * transform(inertial.origin.as_ref())?;
    let turn = place.rotation.to_rotation_matrix();
    let own = turn * Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) * turn.transpose();
    Some((inertial.mass()?, place.translation.vector, own))
}

/// What a mass of 1 kg at a place adds to the inertia about the origin.
fn shift(place: Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * place.norm_squared() - place * place.transpose()
}

/// Whether a link has a mass, or one that is not known.
pub(super) fn has_mass(link: &Link) -> bool {
    let mass = link
        .inertial
        .as_ref()
        .and_then(|inertial| inertial.mass.as_ref());
    mass.is_some_and(|mass| !mass.is_known() || mass.number().is_none_or(|mass| mass != 0.0))
}
