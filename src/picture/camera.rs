//! Where the robot is seen from, and what of it lies where in the picture.

use nalgebra::{Point3, Vector3};

use super::Viewport;
use model::Bounds;

/// Directions to look from; x points forward and z up, as REP-103 has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ViewDirection {
    /// From the front, the right and above.
    #[default]
    Iso,
    /// From the front: what is on the robot's left is on the right.
    Front,
    /// From its right: it looks to the right.
    Side,
    /// From above: it looks to the right.
    Top,
}

impl ViewDirection {
    /// The direction towards the camera, and what points up in the picture.
    fn directions(self) -> (Vector3<f64>, Vector3<f64>) {
        match self {
            ViewDirection::Iso => (Vector3::new(1.1, -1.3, 0.75), Vector3::z()),
            ViewDirection::Front => (Vector3::x(), Vector3::z()),
            ViewDirection::Side => (-Vector3::y(), Vector3::z()),
            ViewDirection::Top => (Vector3::z(), Vector3::y()),
        }
    }
}

/// Part of the picture that is left free on each side.
const MARGIN: f64 = 0.06;
/// What is left free for axes and names, pixels.
pub(super) const ROOM: f64 = 28.0;
/// Distance of the camera, in radii of the robot.
const DISTANCE: f64 = 4.5;
/// Half the diagonal of what is drawn at least, meters.
const SMALLEST: f64 = 0.01;

/// A camera: directions, and how what it sees is put into the picture.
#[derive(Clone, Debug)]
pub(super) struct Camera {
    /// To the right, up and towards the camera, each of length one.
    axes: [Vector3<f64>; 3],
    center: Point3<f64>,
    /// Distance from the center; none: lines that are parallel stay parallel.
    distance: Option<f64>,
    /// Pixels a meter at the center.
    pub scale: f64,
    /// Where the center is in the picture, pixels from the upper left corner.
    middle: [f64; 2],
}

impl Camera {
    /// A camera that has all points in the picture, with at least `room` pixels around them.
    pub fn around<'a>(
        points: impl Iterator<Item = &'a [f64; 3]> + Clone,
        shot: &Viewport,
        room: f64,
    ) -> Self {
        let bounds =
            Bounds::around(points.clone().copied()).unwrap_or_else(|| Bounds::centered([0.0; 3]));
        let center = Vector3::from(bounds.min) / 2.0 + Vector3::from(bounds.max) / 2.0;
        let (back, up) = shot.view.directions();
        let back = back.normalize();
        let right = up.cross(&back).normalize();
        let radius = (bounds.diagonal() / 2.0).max(SMALLEST);
        let distance = (shot.view == ViewDirection::Iso).then_some(radius * DISTANCE);
        let axes = [right, back.cross(&right), back];
        let mut camera = Self {
            axes,
            center: center.into(),
            distance,
            scale: 1.0,
            middle: [0.0; 2],
        };
        camera.fit(points, shot.size, room);
        camera
    }

    /// Choose scale and middle so that the points fill the picture.
    fn fit<'a>(&mut self, points: impl Iterator<Item = &'a [f64; 3]>, size: [u32; 2], room: f64) {
        let seen = points.map(|point| {
            let [x, y, _] = self.project(*point);
            [x, y, 0.0]
        });
        let seen = Bounds::around(seen).unwrap_or_else(|| Bounds::centered([0.0; 3]));
        let [width, height] = size.map(f64::from);
        let [wide, high, _] = seen.size();
        let free =
            [width, height].map(|side| (side - 2.0 * (side * MARGIN).max(room)).max(side / 2.0));
        let scale = (free[0] / wide.max(SMALLEST)).min(free[1] / high.max(SMALLEST));
        let ([x0, y0, _], [x1, y1, _]) = (seen.min, seen.max);
        self.middle = [
            width / 2.0 - scale * (x0 + x1) / 2.0,
            height / 2.0 - scale * (y0 + y1) / 2.0,
        ];
        self.scale = scale;
    }

    /// Where a point is in the picture, to the right and down in pixels; the third number is the greater the
    /// nearer the point is, and linear in the picture.
    pub fn project(&self, point: [f64; 3]) -> [f64; 3] {
        let from_center = Point3::from(point) - self.center;
        let [x, y, z] = self.axes.map(|axis| axis.dot(&from_center));
        let (nearer, key) = match self.distance {
            // nothing is farther from the center than the radius, so nothing reaches the camera
            Some(distance) => (distance / (distance - z), distance / (distance - z)),
            None => (1.0, z),
        };
        let [left, top] = self.middle;
        [
            left + x * nearer * self.scale,
            top - y * nearer * self.scale,
            key,
        ]
    }

    /// A direction as the camera sees it: to the right, up, towards it.
    pub fn turned(&self, direction: Vector3<f64>) -> Vector3<f64> {
        let [right, up, back] = self.axes.map(|axis| axis.dot(&direction));
        Vector3::new(right, up, back)
    }
}
