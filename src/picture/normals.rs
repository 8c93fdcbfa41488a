//! The directions in which surfaces face, for light.

use nalgebra::Vector3;

use super::solids::Solid;

/// Cosine of the angle between two triangles below which the edge between them is rounded.
const ROUND: f64 = 0.8;
/// Triangles around a point that are looked at; where more meet, each has its own direction.
const MOST_AROUND: usize = 48;

/// For each triangle the directions at its corners, each of length one: edges stay sharp, round surfaces look round.
pub(super) fn normals(solid: &Solid) -> Vec<[Vector3<f64>; 3]> {
    let faces: Vec<Vector3<f64>> = solid
        .triangles
        .iter()
        .map(|corners| face(solid, *corners))
        .collect();
    let around = VertexTriangles::of(solid);
    let corners = solid.triangles.iter().zip(&faces);
    corners
        .map(|(corners, own)| corners.map(|point| normal(own, around.triangles(point), &faces)))
        .collect()
}

/// The direction at a corner of a triangle, from its own and those of the triangles that are near.
fn normal(own: &Vector3<f64>, near: &[u32], faces: &[Vector3<f64>]) -> Vector3<f64> {
    let direction = own.try_normalize(0.0).unwrap_or_else(Vector3::z);
    if near.len() > MOST_AROUND {
        return direction;
    }
    let others = near.iter().filter_map(|&other| faces.get(other as usize));
    // a triangle counts by its area
    let smooth = others.filter(|other| other.dot(&direction) >= ROUND * other.norm());
    smooth
        .sum::<Vector3<f64>>()
        .try_normalize(0.0)
        .unwrap_or(direction)
}

/// The direction of a triangle; its length is twice the area.
fn face(solid: &Solid, corners: [u32; 3]) -> Vector3<f64> {
    let [a, b, c] = solid.corners(corners).map(Vector3::from);
    (b - a).cross(&(c - a))
}

/// The triangles around each point.
struct VertexTriangles {
    /// Where the list of a point begins.
    starts: Vec<u32>,
    list: Vec<u32>,
}

impl VertexTriangles {
    fn of(solid: &Solid) -> Self {
        let mut starts = vec![0u32; solid.points.len() + 1];
        for &point in solid.triangles.iter().flatten() {
            starts
                .get_mut(point as usize + 1)
                .into_iter()
                .for_each(|count| *count += 1);
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut next = starts.clone();
        let mut list = vec![0u32; solid.triangles.len() * 3];
        for (number, triangle) in (0u32..).zip(&solid.triangles) {
            for &point in triangle {
                let Some(slot) = next.get_mut(point as usize) else {
                    continue;
                };
                list.get_mut(*slot as usize)
                    .into_iter()
                    .for_each(|entry| *entry = number);
                *slot += 1;
            }
        }
        Self { starts, list }
    }

    fn triangles(&self, point: u32) -> &[u32] {
        let point = point as usize;
        let [start, end] = [point, point + 1]
            .map(|index| self.starts.get(index).map_or(0, |&start| start as usize));
        self.list.get(start..end).unwrap_or_default()
    }
}
