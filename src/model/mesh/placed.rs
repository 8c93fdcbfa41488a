//! Triangles moved to where a scene has them.

use nalgebra::{Matrix4, Point3};

use super::soup::Point;

/// A place in a scene.
pub(super) struct Placed {
    matrix: Matrix4<f64>,
    /// Whether left and right are swapped there: then corners are swapped too, so that outside stays outside.
    mirrored: bool,
}

impl Placed {
    pub(super) fn new(matrix: Matrix4<f64>) -> Self {
        let mirrored = matrix.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        Self { matrix, mirrored }
    }

    /// A triangle there.
    pub(super) fn triangle(&self, corners: [Point; 3]) -> [Point; 3] {
        let [a, b, c] = corners.map(|corner| -> Point {
            let moved = self.matrix * Point3::from(corner).to_homogeneous();
            [moved.x, moved.y, moved.z]
        });
        if self.mirrored { [a, c, b] } else { [a, b, c] }
    }
}
