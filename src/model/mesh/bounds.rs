//! Boxes along the axes.

use nalgebra::{Isometry3, Point3};

/// A box along the axes, meters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the least coordinates.
    pub min: [f64; 3],
    /// The corner with the greatest.
    pub max: [f64; 3],
}

impl Bounds {
    /// The box around points; none when there are none.
    pub fn around(points: impl IntoIterator<Item = [f64; 3]>) -> Option<Self> {
        let mut points = points.into_iter();
        let mut bounds = Self::at(points.next()?);
        for point in points {
            bounds = bounds.with(Self::at(point));
        }
        Some(bounds)
    }

    /// The box that is one point.
    fn at(point: [f64; 3]) -> Self {
        Self {
            min: point,
            max: point,
        }
    }

    /// The box of full lengths `size` around the origin.
    pub fn centered(size: [f64; 3]) -> Self {
        Self {
            min: size.map(|length| -length.abs() / 2.0),
            max: size.map(|length| length.abs() / 2.0),
        }
    }

    /// The box around both.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            min: each(self.min, other.min, f64::min),
            max: each(self.max, other.max, f64::max),
        }
    }

    /// The box made larger along each axis; a negative factor mirrors it.
    #[must_use]
    pub fn scaled(self, [x, y, z]: [f64; 3]) -> Self {
        let [one, other] = [self.min, self.max].map(|[px, py, pz]| [px * x, py * y, pz * z]);
        Self::at(one).with(Self::at(other))
    }

    /// The box around this box moved.
    #[must_use]
    pub fn moved(self, by: &Isometry3<f64>) -> Self {
        let ([x, y, z], [u, v, w]) = (self.min, self.max);
        let corners = [
            [x, y, z],
            [u, y, z],
            [x, v, z],
            [u, v, z],
            [x, y, w],
            [u, y, w],
            [x, v, w],
            [u, v, w],
        ];
        let moved = corners.map(|corner| (by * Point3::from(corner)).coords.into());
        Self::around(moved).unwrap_or(self)
    }

    /// Full lengths along the axes.
    pub fn size(self) -> [f64; 3] {
        let ([x, y, z], [u, v, w]) = (self.min, self.max);
        [u - x, v - y, w - z]
    }

    /// The point in the middle.
    pub fn center(self) -> [f64; 3] {
        let ([x, y, z], [u, v, w]) = (self.min, self.max);
        [(x + u) / 2.0, (y + v) / 2.0, (z + w) / 2.0]
    }

    /// The greatest length along an axis.
    pub fn extent(self) -> f64 {
        self.size().into_iter().fold(0.0, f64::max)
    }

    /// From corner to opposite corner.
    pub fn diagonal(self) -> f64 {
        let [x, y, z] = self.size();
        x.hypot(y).hypot(z)
    }

    /// How far a point is outside along the axis where it is farthest; negative inside.
    pub fn outside(self, point: [f64; 3]) -> f64 {
        let sides = self.min.iter().zip(&self.max).zip(point);
        sides
            .map(|((min, max), at)| (min - at).max(at - max))
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

/// What `choose` takes from two points along each axis.
fn each([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3], choose: fn(f64, f64) -> f64) -> [f64; 3] {
    [choose(ax, bx), choose(ay, by), choose(az, bz)]
}
