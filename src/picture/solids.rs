//! Shapes as triangles.

use std::f64::consts::{PI, TAU};

use nalgebra::{Isometry3, Point3};

use super::color::Rgba;
use model::Triangles;

/// Sides of a round shape.
const SIDES: u32 = 64;
/// Rings of a sphere.
const RINGS: u32 = 32;

/// A shape as triangles over points that are stored once each.
#[derive(Clone, Debug, Default)]
pub(super) struct Solid {
    pub points: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// From which triangle on there is which color of its own.
    pub tints: Vec<(usize, Option<Rgba>)>,
}

impl From<Triangles> for Solid {
    fn from(
        Triangles {
            points,
            corners,
            tints,
        }: Triangles,
    ) -> Self {
        Self {
            points,
            triangles: corners,
            tints,
        }
    }
}

impl Solid {
    /// The corners of a triangle.
    pub fn corners(&self, triangle: [u32; 3]) -> [[f64; 3]; 3] {
        triangle.map(|index| self.points.get(index as usize).copied().unwrap_or_default())
    }

    fn of(points: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        Self {
            points,
            triangles,
            tints: Vec::new(),
        }
    }

    /// A box of full lengths `size` around the origin.
    pub fn cuboid([x, y, z]: [f64; 3]) -> Self {
        let corner = |i: u32| {
            [(0, x), (1, y), (2, z)].map(|(bit, length)| {
                if i >> bit & 1 == 0 {
                    -length / 2.0
                } else {
                    length / 2.0
                }
            })
        };
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        Self::of(
            (0..8).map(corner).collect(),
            sides.into_iter().flat_map(quad).collect(),
        )
    }

    /// A cylinder along z around the origin.
    pub fn cylinder(radius: f64, length: f64) -> Self {
        let half = length / 2.0;
        let mut points = vec![[0.0, 0.0, -half], [0.0, 0.0, half]];
        let mut triangles = Vec::new();
        for i in 0..SIDES {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(SIDES));
            points.extend([
                [radius * cos, radius * sin, -half],
                [radius * cos, radius * sin, half],
            ]);
            let (here, next) = (2 + 2 * i, 2 + 2 * ((i + 1) % SIDES));
            triangles.extend(quad([here, next, next + 1, here + 1]));
            triangles.extend([[0, next, here], [1, here + 1, next + 1]]);
        }
        Self::of(points, triangles)
    }

    /// A sphere around the origin.
    pub fn sphere(radius: f64) -> Self {
        Self::round(radius, 0.0, (1..RINGS).collect())
    }

    /// A cylinder along z around the origin, with half spheres at its ends.
    pub fn capsule(radius: f64, length: f64) -> Self {
        // the cylinder stands between the two rings of the equator
        Self::round(
            radius,
            length / 2.0,
            (1..=RINGS / 2).chain(RINGS / 2..RINGS).collect(),
        )
    }

    /// The rings of a sphere, those of the upper half moved up, the others down.
    fn round(radius: f64, half: f64, rings: Vec<u32>) -> Self {
        let mut points = vec![[0.0, 0.0, radius + half], [0.0, 0.0, -radius - half]];
        let mut triangles = Vec::new();
        let count = rings.len() as u32;
        for (number, ring) in (1..).zip(rings) {
            let (out, up) = libm::sincos(PI * f64::from(ring) / f64::from(RINGS));
            let z = radius * up + if number <= RINGS / 2 { half } else { -half };
            for i in 0..SIDES {
                let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(SIDES));
                points.push([radius * out * cos, radius * out * sin, z]);
                let next = (i + 1) % SIDES;
                if number == 1 {
                    triangles.push([0, ring_point(1, i), ring_point(1, next)]);
                } else {
                    triangles.extend(quad([
                        ring_point(number - 1, i),
                        ring_point(number, i),
                        ring_point(number, next),
                        ring_point(number - 1, next),
                    ]));
                }
                if number == count {
                    triangles.push([1, ring_point(number, next), ring_point(number, i)]);
                }
            }
        }
        Self::of(points, triangles)
    }

    /// A box from the origin of a frame to a point in it, as thick as a line.
    pub fn beam(to: [f64; 3], thickness: f64) -> Self {
        let [x, y, z] = to;
        let length = x.hypot(y).hypot(z);
        let mut beam = Self::cuboid([thickness, thickness, length]);
        let along = nalgebra::Vector3::from(to);
        let turn = nalgebra::UnitQuaternion::rotation_between(&nalgebra::Vector3::z(), &along);
        let turn = turn.unwrap_or_else(|| {
            nalgebra::UnitQuaternion::from_axis_angle(&nalgebra::Vector3::x_axis(), PI)
        });
        beam.place([1.0; 3], &Isometry3::from_parts((along / 2.0).into(), turn));
        beam
    }

    /// Scale it and put it somewhere.
    pub fn place(&mut self, [sx, sy, sz]: [f64; 3], at: &Isometry3<f64>) {
        for point in &mut self.points {
            let [x, y, z] = *point;
            *point = (at * Point3::new(x * sx, y * sy, z * sz)).coords.into();
        }
    }
}

/// The number of a corner of a round shape, counted from 1 by rings from the upper one on.
fn ring_point(ring: u32, i: u32) -> u32 {
    2 + (ring - 1) * SIDES + i
}

fn quad([a, b, c, d]: [u32; 4]) -> [[u32; 3]; 2] {
    [[a, b, c], [a, c, d]]
}
