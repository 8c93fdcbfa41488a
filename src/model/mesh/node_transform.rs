//! Triangles moved to where a scene has them.

use nalgebra::{Matrix4, Point3};

use super::soup::MeshPoint;

/// A place in a scene.
pub(super) struct NodeTransform {
    matrix: Matrix4<f64>,
    /// Whether left and right are swapped there: then corners are swapped too, so that outside stays outside.
    mirrored: bool,
}

impl NodeTransform {
    pub(super) fn new(matrix: Matrix4<f64>) -> Self {
        let mirrored = matrix.fixed_view::<3, 3>(0, 0).determinant() < 0.0;
        Self { matrix, mirrored }
    }

    /// A triangle there.
    pub(super) fn triangle(&self, corners: [MeshPoint; 3]) -> [MeshPoint; 3] {
        let [a, b, c] = corners.map(|corner| -> MeshPoint {
            let moved = self.matrix * Point3::from(corner).to_homogeneous();
            [moved.x, moved.y, moved.z]
        });
        if self.mirrored { [a, c, b] } else { [a, b, c] }
    }
}
