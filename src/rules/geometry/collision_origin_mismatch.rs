//! A visual and a collision of the same shape that stand at different places in their link.
use nalgebra::{Isometry3, Point3, Vector3};

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::bodies::shape_bounds;
use super::resources::factors;
use model::{AttrValue, Body, Bounds, Link, Pose, Shape, ShapeKind, tag_start, transform};

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO038",
    name: "collision-origin-mismatch",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("collision-origin-mismatch"),
    check: Check::Link(check),
};

/// Smaller shapes stand for something else, meters.
const MARKER: f64 = 0.02;
/// How far apart they may be, of the diagonal of the shape.
const CLOSE: f64 = 0.05;
/// What hardly matters to a contact, meters.
const LITTLE: f64 = 0.02;

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(found) = mismatch(cx, link) else {
        return;
    };
    let place = |body: &Body| {
        let origin = body.origin.as_ref().map(|origin| origin.element);
        tag_start(cx.expansion, origin.unwrap_or(body.element))
    };
    let (shape, link) = (found.shape, link.shown());
    let message = format!(
        "visual and collision of link `{link}` are the same {shape}, but {}",
        found.difference()
    );
    let severity = if found.farthest < LITTLE {
        Severity::Info
    } else {
        Severity::Warning
    };
    out.report(place(found.collision), message)
        .severity(severity)
        .also(place(found.visual), "visual")
        .help("give both the same `origin`: what is shown is not where the robot collides")
        .done();
}

/// A visual and a collision of the same shape at different places.
pub(super) struct Mismatch<'a> {
    visual: &'a Body,
    collision: &'a Body,
    /// The element of the shape.
    shape: &'static str,
    /// From center to center, meters; zero when they are close, and it is the turn that counts.
    distance: f64,
    /// Between their directions, radians.
    angle: f64,
    /// How far the one stands out of the other, meters.
    farthest: f64,
}

impl Mismatch<'_> {
    /// How the places differ.
    fn difference(&self) -> String {
        let turned = format!("turned by {:.0}°", self.angle.to_degrees());
        let is_turned = self.angle > CLOSE;
        match (self.distance > 0.0, is_turned) {
            (true, false) => format!("{} apart", meters(self.distance)),
            (true, true) => format!("{} apart and {turned}", meters(self.distance)),
            (false, _) => turned,
        }
    }
}

/// A length in meters with two digits that count.
fn meters(length: f64) -> String {
    let digits = (1.0 - length.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{length:.digits$} m")
}

/// How the one collision of a link differs from its one visual, when both are the same shape.
pub(super) fn mismatch<'a>(cx: &DocumentCx<'_>, link: &'a Link) -> Option<Mismatch<'a>> {
    let ([visual], [collision]) = (&*link.visuals, &*link.collisions) else {
        return None;
    };
    if is_same_place(visual.origin.as_ref(), collision.origin.as_ref()) {
        return None;
    }
    let shape = visual.shape()?;
    let own = measures(shape)?;
    if own != measures(collision.shape()?)? {
        return None;
    }
    let bounds = shape_bounds(cx, shape)?;
    let (one, other) = (
        transform(visual.origin.as_ref())?,
        transform(collision.origin.as_ref())?,
    );
    let limit = CLOSE * bounds.diagonal();
    let farthest = farthest(shape, bounds, &one, &other);
    if bounds.diagonal() < MARKER || farthest <= limit {
        return None;
    }
    let center = Point3::from(bounds.center());
    let distance = (one * center - other * center).norm();
    if !distance.is_finite() {
        return None; // numbers that no robot has
    }
    let angle = angle(shape, &one, &other);
    let is_moved = distance > limit || angle <= CLOSE;
    Some(Mismatch {
        visual,
        collision,
        shape: own.0,
        distance: if is_moved { distance } else { 0.0 },
        angle,
        farthest,
    })
}

/// Whether two origins say the same in the same words; nearly all do.
fn is_same_place(one: Option<&Pose>, other: Option<&Pose>) -> bool {
    let text = |value: Option<&AttrValue>| value.map(|value| value.value.clone());
    let words = |pose: &Pose| {
        let quaternion = pose.quaternion.as_deref();
        [
            text(pose.xyz.as_ref()),
            text(pose.rpy.as_ref()),
            text(quaternion),
        ]
    };
    one.map(words) == other.map(words)
}

/// The element, the measures in meters or factors, and the file of a shape; none when one of them is not known.
fn measures(shape: &Shape) -> Option<(&'static str, Vec<f64>, &str)> {
    let number = |text: &Option<AttrValue>| text.as_ref()?.number();
    Some(match &shape.kind {
        ShapeKind::Box { size } => {
            let size = size.as_ref()?.numbers::<3>()?;
            ("box", size.to_vec(), "")
        }
        ShapeKind::Cylinder { radius, length } => {
            ("cylinder", vec![number(radius)?, number(length)?], "")
        }
        ShapeKind::Capsule { radius, length } => {
            ("capsule", vec![number(radius)?, number(length)?], "")
        }
        ShapeKind::Sphere { radius } => ("sphere", vec![number(radius)?], ""),
        ShapeKind::Mesh { filename, scale } => {
            let scale = factors(scale.as_ref())?;
            ("mesh", scale.to_vec(), filename.as_ref()?.value.as_str())
        }
        ShapeKind::Other => return None,
    })
}

/// How far the one shape stands out of the other, meters: from each of its marks to the nearest of the other's. Shapes that
/// look the same after a turn have the same marks after it.
fn farthest(shape: &Shape, bounds: Bounds, one: &Isometry3<f64>, other: &Isometry3<f64>) -> f64 {
    let marks = marks(shape, bounds);
    let moved: Vec<_> = marks.iter().map(|mark| other * mark).collect();
    let nearest = |mark: &Point3<f64>| {
        let at = one * mark;
        let distances = moved.iter().map(|other| (at - other).norm());
        distances.fold(f64::INFINITY, f64::min)
    };
    marks.iter().map(nearest).fold(0.0, f64::max)
}

/// The angle between the directions of a shape at two places, radians.
fn angle(shape: &Shape, one: &Isometry3<f64>, other: &Isometry3<f64>) -> f64 {
    match shape.kind {
        // which end is up does not show
        ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
            let [one, other] = [one, other].map(|place| place * Vector3::z());
            one.angle(&other).min(one.angle(&-other))
        }
        ShapeKind::Sphere { .. } => 0.0,
        _ => one.rotation.angle_to(&other.rotation),
    }
}

/// Points of a shape that tell where it stands: the corners of a box, the ends of an axis, a center.
fn marks(shape: &Shape, bounds: Bounds) -> Vec<Point3<f64>> {
    let [x, y, z] = bounds.size().map(|size| size / 2.0);
    match shape.kind {
        ShapeKind::Sphere { .. } => vec![Point3::origin()],
        // a disk that lies instead of standing is as far off as its edge
        ShapeKind::Cylinder { .. } | ShapeKind::Capsule { .. } => {
            let end = z.max(x);
            vec![Point3::new(0.0, 0.0, end), Point3::new(0.0, 0.0, -end)]
        }
        _ => {
            let center = Point3::from(bounds.center());
            let signs = [1.0, -1.0];
            let corners =
                signs.map(|u| signs.map(|v| signs.map(|w| Vector3::new(u * x, v * y, w * z))));
            let corners = corners.into_iter().flatten().flatten();
            corners.map(|corner| center + corner).collect()
        }
    }
}
