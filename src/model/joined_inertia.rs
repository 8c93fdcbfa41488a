//! Inertia of parts that are fixed to each other.
use nalgebra::{Isometry3, Matrix3, Vector3};

use crate::{Inertial, transform};

/// Mass, kg, and `ixx ixy ixz iyy iyz izz` about the center of mass, kg m^2, of parts with their places; none when a number or a
/// place is not known.
pub fn joined_inertia<'i>(
    parts: impl IntoIterator<Item = (&'i Inertial, Option<Isometry3<f64>>)>,
) -> Option<(f64, [f64; 6])> {
    let (mut mass, mut moment, mut inertia) = (0.0, Vector3::zeros(), Matrix3::zeros());
    for (inertial, place) in parts {
        let (own_mass, center, own) = at(inertial, &place?)?;
        mass += own_mass;
        moment += center * own_mass;
        inertia += own + shift(center) * own_mass;
    }
    if mass != 0.0 {
        inertia -= shift(moment / mass) * mass;
    }
    // by columns
    let [[xx, ..], [xy, yy, _], [xz, yz, zz]]: [[f64; 3]; 3] = inertia.into();
    Some((mass, [xx, xy, xz, yy, yz, zz]))
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
