//! Triangles as a reader finds them.

use super::defect::Defect;
use base::FastMap;
use base::limits::MESH_TRIANGLES;

/// A point, meters.
pub(super) type MeshPoint = [f64; 3];

/// Triangles over points that are stored once each.
#[derive(Debug, Default)]
pub(super) struct Soup {
    /// The points, each different from the others.
    pub(super) points: Vec<MeshPoint>,
    /// Corners as indices of points, counter-clockwise seen from outside.
    pub(super) triangles: Vec<[u32; 3]>,
    /// From which triangle on there is which color: red, green, blue, opacity.
    pub(super) tints: Vec<(usize, Option<[f64; 4]>)>,
    known: FastMap<[u64; 3], u32>,
}

impl Soup {
    /// Take a triangle.
    ///
    /// # Errors
    /// When a corner is no finite point, and when there are too many triangles.
    pub(super) fn push(&mut self, corners: [MeshPoint; 3]) -> Result<(), Defect> {
        if corners.iter().flatten().any(|number| !number.is_finite()) {
            let number = self.triangles.len() + 1;
            return Err(Defect::corrupt(format!(
                "a vertex of triangle {number} is not finite"
            )));
        }
        if self.triangles.len() >= MESH_TRIANGLES {
            return Err(Defect::too_large(format!(
                "it has more than {MESH_TRIANGLES} triangles"
            )));
        }
        let triangle = corners.map(|corner| self.point(corner));
        self.triangles.push(triangle);
        Ok(())
    }

    /// The triangles that come now have this color.
    pub(super) fn tint(&mut self, tint: Option<[f64; 4]>) {
        let next = self.triangles.len();
        match self.tints.last_mut() {
            Some((_, now)) if *now == tint => {}
            Some((start, now)) if *start == next => *now = tint,
            None if tint.is_none() => {}
            _ => self.tints.push((next, tint)),
        }
    }

    fn point(&mut self, point: MeshPoint) -> u32 {
        // adding zero makes minus zero zero
        let key = point.map(|number| (number + 0.0).to_bits());
        *self.known.entry(key).or_insert_with(|| {
            self.points.push(point);
            self.points.len() as u32 - 1
        })
    }

    /// All triangles are there: what only serves to find equal points is given back.
    pub(super) fn complete(mut self) -> Self {
        self.known = FastMap::default();
        self
    }

    /// The corners of a triangle.
    pub(super) fn corners(&self, triangle: [u32; 3]) -> [MeshPoint; 3] {
        triangle.map(|index| self.points.get(index as usize).copied().unwrap_or_default())
    }
}
