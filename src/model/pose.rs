//! `<origin>`: where one frame stands in another.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

use super::attr_value::AttrValue;
use super::version::Version;
use expand::{XId, XTree};

/// An `origin` element: meters and radians, fixed axes roll, pitch, yaw, or a quaternion.
#[derive(Clone, Debug)]
pub struct Pose {
    /// Its element.
    pub element: XId,
    /// The translation `xyz`, meters.
    pub xyz: Option<AttrValue>,
    /// The rotation `rpy`, radians.
    pub rpy: Option<AttrValue>,
    /// The rotation `quat_xyzw`, of any length but zero; none in a robot of URDF 1.0, where nobody reads it. Boxed: few
    /// have one.
    pub quaternion: Option<Box<AttrValue>>,
}

impl Pose {
    /// What an element `origin` says.
    pub fn of(tree: &XTree, element: XId) -> Self {
        let quaternion = AttrValue::attr(tree, element, "quat_xyzw")
            .filter(|_| Version::V1_1.is_in(tree))
            .map(Box::new);
        Self {
            element,
            xyz: AttrValue::attr(tree, element, "xyz"),
            rpy: AttrValue::attr(tree, element, "rpy"),
            quaternion,
        }
    }

    /// The translation in meters, zero where none is written; none when it is no known vector.
    pub fn translation(&self) -> Option<[f64; 3]> {
        self.xyz.as_ref().map_or(Some([0.0; 3]), AttrValue::numbers)
    }

    /// Roll, pitch and yaw in radians, zero where no rotation is written; none when it is no known vector.
    pub fn angles(&self) -> Option<[f64; 3]> {
        if self.quaternion.is_some() {
            let (roll, pitch, yaw) = self.rotation()?.euler_angles();
            return Some([roll, pitch, yaw]);
        }
        self.rpy.as_ref().map_or(Some([0.0; 3]), AttrValue::numbers)
    }

    /// The rotation; none when it is not known, or written in both ways.
    fn rotation(&self) -> Option<UnitQuaternion<f64>> {
        let Some(text) = &self.quaternion else {
            let [roll, pitch, yaw] = self.angles()?;
            return Some(UnitQuaternion::from_euler_angles(roll, pitch, yaw));
        };
        let [x, y, z, w] = text.numbers().filter(|_| self.rpy.is_none())?;
        // urdfdom takes one of length zero for no rotation
        Some(UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-12).unwrap_or_default())
    }

    /// Both as a transform from the frame inside to the frame around it.
    pub fn transform(&self) -> Option<Isometry3<f64>> {
        let [x, y, z] = self.translation()?;
        Some(Isometry3::from_parts(
            Translation3::new(x, y, z),
            self.rotation()?,
        ))
    }
}

/// The transform of an origin that may be absent; none when it is not known.
pub fn transform(origin: Option<&Pose>) -> Option<Isometry3<f64>> {
    origin.map_or(Some(Isometry3::identity()), Pose::transform)
}
