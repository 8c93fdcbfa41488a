//! The wheels of a drive as the robot has them, beside what a plugin or controller is told.
use super::super::numbers::short;
use nalgebra::{Point3, Vector3};

use model::{Body, Bounds, Joint, JointType, Kinematics, Link, Robot, ShapeKind, transform};

/// By which factor two lengths differ at least, so that none of them is a rounded or tuned value of the other.
const MISMATCH: f64 = 1.3;
/// The same of a separation that is too large, which some measure between the outer sides of the wheels.
const TOO_FAR: f64 = 1.2;
/// The same of one that is too small: wheels that slip make it larger.
const TOO_CLOSE: f64 = 1.15;
/// By which factor the wheels of one size differ at most.
const SAME_SIZE: f64 = 1.1;

/// By which part of its diameter a wheel differs at most along the two axes that it does not turn about, and its middle from the axis.
const ROUND: f64 = 0.05;
/// How many diameters a wheel is wide at most.
const WIDEST: f64 = 1.2;

/// What gives the box around a link in its frame, in meters, where meshes can be read.
pub(super) type LinkBounds<'f> = dyn Fn(&Link) -> Option<Bounds> + 'f;

/// A pair of driven wheels.
pub(super) struct WheelPair<'a> {
    left: Wheel<'a>,
    right: Wheel<'a>,
    /// Whether the robot has further wheels of the size: it skids, and drives as if its wheels were farther apart.
    is_skidding: bool,
}

struct Wheel<'a> {
    link: &'a Link,
    /// In meters.
    radius: f64,
    /// Its center in the frame of the root link, with all joints at zero, in meters.
    center: Point3<f64>,
    /// The axis that it turns about, in the same frame, of length one.
    axle: Vector3<f64>,
}

/// A length that a drive is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DriveLength {
    Radius,
    Diameter,
    Separation,
}

/// The parameters of drives that hold lengths of wheels.
/// Source: the plugins of gazebo_ros_pkgs, the system diff-drive of gz-sim, and diff_drive_controller.
const PARAMETERS: [(&str, DriveLength); 5] = [
    ("wheel_radius", DriveLength::Radius),
    ("wheel_diameter", DriveLength::Diameter),
    ("wheelDiameter", DriveLength::Diameter),
    ("wheel_separation", DriveLength::Separation),
    ("wheelSeparation", DriveLength::Separation),
];

impl DriveLength {
    /// The length that a parameter holds.
    pub fn of(parameter: &str) -> Option<Self> {
        let mut all = PARAMETERS.iter();
        all.find(|(name, _)| *name == parameter)
            .map(|&(_, length)| length)
    }
}

impl<'a> WheelPair<'a> {
    /// The wheels that two joints turn; none where a shape or place is not known, or a wheel is neither a cylinder or sphere nor a mesh as
    /// round as one.
    pub fn of(
        robot: &'a Robot,
        kinematics: &Kinematics,
        [left, right]: [&str; 2],
        bounds: &LinkBounds<'_>,
    ) -> Option<Self> {
        let of = |name: &str| {
            let joint = robot
                .joints
                .iter()
                .position(|joint| joint.shown() == name)?;
            Wheel::of(robot, kinematics, joint, bounds)
        };
        let (left, right) = (of(left)?, of(right)?);
        let turns = |joint: &Joint| joint.is(&[JointType::Continuous]) && joint.mimic.is_none();
        let turning = (0..robot.joints.len()).filter(|&at| robot.joints.get(at).is_some_and(turns));
        let like_this = turning
            .filter_map(|joint| Wheel::of(robot, kinematics, joint, bounds))
            .filter(|wheel| factor(wheel.radius, left.radius) < SAME_SIZE);
        let is_skidding = like_this.count() > 2;
        Some(Self {
            left,
            right,
            is_skidding,
        })
    }

    /// What is wrong with a length that a parameter holds, in meters, and what it should be; none where it fits.
    pub fn mismatch(&self, parameter: &str, said: f64) -> Option<(String, f64)> {
        let (left, right) = (&self.left, &self.right);
        let radius = left.radius;
        let is_one_size = factor(radius, right.radius) < SAME_SIZE;
        let kind = DriveLength::of(parameter)?;
        let (real, what) = match kind {
            DriveLength::Separation => {
                // the first wheels of each side need not be a pair
                let distance = (left.center - right.center).dot(&left.axle).abs();
                let names = self.names();
                let apart = format!(
                    "wheels `{}` and `{}` are {} m apart",
                    names[0],
                    names[1],
                    length(distance)
                );
                (distance, apart)
            }
            _ if !is_one_size => return None,
            DriveLength::Radius => (radius, self.radius_of_left()),
            DriveLength::Diameter => (2.0 * radius, self.radius_of_left()),
        };
        let (least, most) = match kind {
            DriveLength::Separation if self.is_skidding => (TOO_CLOSE, f64::INFINITY),
            DriveLength::Separation => (TOO_CLOSE, TOO_FAR),
            _ => (MISMATCH, MISMATCH),
        };
        let differs = said > 0.0 && real > 0.0 && (said * least < real || said > real * most);
        let message = || format!("`{parameter}` is {} m, but {what}", length(said));
        differs.then(|| (message(), real))
    }

    /// What is wrong with the sides of the wheels, and what to do about it; none where they fit. With the axis of both pointing from the
    /// left wheel to the right one, a drive that is told to turn left turns right, wherever its front is.
    pub fn exchanged(&self) -> Option<(String, &'static str)> {
        let [one, other] = self.names();
        let what = if self.left.axle.y > 0.0 {
            "exchange the two joints"
        } else {
            "turn the axes of both joints around, or exchange the joints"
        };
        let points_to_right = self.axis_to_left().is_some_and(|apart| apart < 0.0);
        points_to_right.then(|| {
            let message = format!(
                "the robot turns the wrong way: the axis of the left wheel `{one}` points to the right wheel `{other}`"
            );
            (message, what)
        })
    }

    /// The names of the links of the wheels, the left one first.
    pub fn names(&self) -> [&'a str; 2] {
        [self.left.link.shown(), self.right.link.shown()]
    }

    /// Whether the left wheel is on the left, as the axes of both point.
    pub fn is_in_order(&self) -> bool {
        self.axis_to_left().is_some_and(|apart| apart > 0.0)
    }

    /// How far the left wheel is from the right one along the axis of both, in meters; none where they are no pair.
    fn axis_to_left(&self) -> Option<f64> {
        const LEVEL: f64 = 0.1;
        const PARALLEL: f64 = 0.9;
        const LEAST: f64 = 0.02;
        let (left, right) = (&self.left, &self.right);
        let is_pair = left.axle.z.abs() < LEVEL && left.axle.dot(&right.axle) > PARALLEL;
        let apart = (left.center - right.center).dot(&left.axle);
        (is_pair && apart.abs() > LEAST).then_some(apart)
    }

    fn radius_of_left(&self) -> String {
        let Wheel { link, radius, .. } = &self.left;
        format!(
            "wheel `{}` has a radius of {} m",
            link.shown(),
            length(*radius)
        )
    }
}

impl<'a> Wheel<'a> {
    fn of(
        robot: &'a Robot,
        kinematics: &Kinematics,
        at: usize,
        bounds: &LinkBounds<'_>,
    ) -> Option<Self> {
        let (_, child) = kinematics.ends(at)?;
        let (joint, link) = (robot.joints.get(at)?, robot.links.get(child)?);
        let mut bodies = link.collisions.iter().chain(&link.visuals);
        let shaped = bodies.find_map(|body| {
            let center = transform(body.origin.as_ref())?.translation.vector;
            Some((Point3::from(center), round(body)?))
        });
        let (middle, radius) = shaped.or_else(|| rolling(joint, bounds(link)?))?;
        let (mut center, axis) = (middle, Vector3::from(joint.axis()?));
        let mut axle = axis.try_normalize(f64::EPSILON)?;
        for above in kinematics.ancestor_joints(child) {
            let frame = transform(robot.joints.get(above)?.origin.as_ref())?;
            (center, axle) = (frame * center, frame * axle);
        }
        Some(Self {
            link,
            radius,
            center,
            axle,
        })
    }
}

/// Middle and radius of a box that is square around the axis of a joint along one of the coordinate axes, as that of a wheel is.
fn rolling(joint: &Joint, bounds: Bounds) -> Option<(Point3<f64>, f64)> {
    let axis = joint.axis.as_ref()?.xyz.as_ref()?.numbers::<3>()?;
    let about = axis.iter().position(|part| part.abs() > 0.99)?;
    let (size, center) = (bounds.size(), bounds.center());
    let across = |of: [f64; 3]| {
        let mut others = (0..3)
            .filter(|&at| at != about)
            .filter_map(|at| of.get(at).copied());
        Some([others.next()?, others.next()?])
    };
    let ([a, b], [x, y]) = (across(size)?, across(center)?);
    let width = *size.get(about)?;
    let is_round = (a - b).abs() < ROUND * a.max(b) && x.hypot(y) < ROUND * a;
    (is_round && width < WIDEST * a).then(|| (Point3::from(center), (a + b) / 4.0))
}

/// The radius of a cylinder or sphere.
fn round(body: &Body) -> Option<f64> {
    match &body.geometry.as_ref()?.shapes.first()?.kind {
        ShapeKind::Cylinder { radius, .. } | ShapeKind::Sphere { radius } => {
            radius.as_ref()?.number()
        }
        _ => None,
    }
}

/// By which factor two lengths differ, at least one.
fn factor(a: f64, b: f64) -> f64 {
    (a / b).max(b / a)
}

/// A length as people write it: to the tenth of a millimeter.
pub(super) fn length(meters: f64) -> String {
    short((meters * 1e4).round() / 1e4)
}
