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
    let around = Around::of(solid);
    let at = |own: usize, point: u32| -> Vector3<f64> {
        let Some(own) = faces.get(own) else {
            return Vector3::z();
        };
        let direction = own.try_normalize(0.0).unwrap_or_else(Vector3::z);
        let near = around.triangles(point);
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
    };
    let corners = solid.triangles.iter().enumerate();
    corners
        .map(|(own, corners)| corners.map(|point| at(own, point)))
        .collect()
}

/// The direction of a triangle; its length is twice the area.
fn face(solid: &Solid, corners: [u32; 3]) -> Vector3<f64> {
    let [a, b, c] = solid.corners(corners).map(Vector3::from);
    (b - a).cross(&(c - a))
}

/// The triangles around each point.
struct Around {
    /// Where the list of a point begins.
    starts: Vec<u32>,
    list: Vec<u32>,
}

impl Around {
    fn of(solid: &Solid) -> Self {
        let mut starts = vec![0u32; solid.points.len() + 1];
        let corners = || solid.triangles.iter().flatten();
        for &point in corners() {
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
        let at = |index: usize| self.starts.get(index).map_or(0, |&start| start as usize);
        self.list
            .get(at(point as usize)..at(point as usize + 1))
            .unwrap_or_default()
    }
}
