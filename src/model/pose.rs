//! `<origin>`: where one frame stands in another.

use nalgebra::{Isometry3, Translation3, UnitQuaternion};

use super::text::Text;
use expand::{XId, XTree};

/// An `origin` element: metres and radians, fixed axes roll, pitch, yaw.
#[derive(Clone, Debug)]
pub struct Pose {
    /// Its element.
    pub element: XId,
    /// The translation `xyz`, metres.
    pub xyz: Option<Text>,
    /// The rotation `rpy`, radians.
    pub rpy: Option<Text>,
}

impl Pose {
    pub(super) fn of(tree: &XTree, element: XId) -> Self {
        let text = |name| Text::attr(tree, element, name);
        Self { element, xyz: text("xyz"), rpy: text("rpy") }
    }

    /// The translation in metres, zero where none is written; none when it is no known vector.
    pub fn translation(&self) -> Option<[f64; 3]> {
        self.xyz.as_ref().map_or(Some([0.0; 3]), Text::numbers)
    }

    /// Roll, pitch and yaw in radians, zero where none are written; none when they are no known vector.
    pub fn angles(&self) -> Option<[f64; 3]> {
        self.rpy.as_ref().map_or(Some([0.0; 3]), Text::numbers)
    }

    /// Both as a transform from the frame inside to the frame around it.
    pub fn transform(&self) -> Option<Isometry3<f64>> {
        let ([x, y, z], [roll, pitch, yaw]) = (self.translation()?, self.angles()?);
        let rotation = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        Some(Isometry3::from_parts(Translation3::new(x, y, z), rotation))
    }
}

/// The transform of an origin that may be absent; none when it is not known.
pub fn transform(origin: Option<&Pose>) -> Option<Isometry3<f64>> {
    origin.map_or(Some(Isometry3::identity()), Pose::transform)
}
