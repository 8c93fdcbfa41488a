//! A mesh far away from the frame of its link.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::bodies::bounds;
use super::mesh_scale_suspicious::{is_suspicious, meters};
use super::resources::MeshUse;
use model::{Body, Bounds, JointType, Link, Robot};

pub(super) static RULE: Rule = Rule {
    code: "GEO034",
    name: "mesh-far-from-link",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mesh-far-from-link"),
    check: Check::Document(check),
};

/// From this distance on, meters.
const FAR: f64 = 1.0;
/// And so many times the size of the mesh.
const SIZES: f64 = 3.0;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    // an object without joints may be a building, whose parts are drawn in one frame
    if cx.robot.is_none_or(Robot::is_rigid) {
        return;
    }
    for mesh in cx.meshes().filter(|mesh| !is_suspicious(cx, mesh)) {
        let Some(bounds) = placed(cx, &mesh) else {
            continue;
        };
        let distance = distance(cx, mesh.link, bounds);
        if distance < FAR || distance < SIZES * bounds.diagonal() || is_among_others(cx, &mesh) {
            continue;
        }
        let message = format!(
            "mesh `{}` is {} away from link `{}`",
            mesh.name(),
            meters(distance),
            mesh.link.shown()
        );
        out.report(mesh.file.origin, message)
            .group(mesh.group())
            .help("export the mesh in the frame of its link, or correct the `origin`; meshes of an assembly have one frame for all parts")
            .done();
    }
}

/// The box of a mesh in the frame of its link.
fn placed(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<Bounds> {
    let mut bodies = mesh.link.visuals.iter().chain(&mesh.link.collisions);
    bounds(
        cx,
        bodies.find(|body| {
            body.shape()
                .is_some_and(|shape| shape.element == mesh.element)
        })?,
    )
}

/// Whether other shapes of the same use are where the link is: the far ones are parts of a large body.
fn is_among_others(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> bool {
    let is_of_mesh = |body: &Body| {
        body.shape()
            .is_some_and(|shape| shape.element == mesh.element)
    };
    let uses = [&mesh.link.visuals, &mesh.link.collisions];
    let bodies = uses
        .into_iter()
        .find(|bodies| bodies.iter().any(is_of_mesh))
        .into_iter()
        .flatten();
    bodies
        .filter_map(|body| bounds(cx, body))
        .any(|bounds| distance(cx, mesh.link, bounds) < FAR)
}

/// From the frame of a link to the nearest point of a box; from the axis of the joint above, where the link turns: where on it
/// the frame stands makes no difference.
fn distance(cx: &DocumentCx<'_>, link: &Link, bounds: Bounds) -> f64 {
    let above = cx.joints_above(link.shown()).next();
    // what slides moves alike, wherever its frame is
    if above.is_some_and(|joint| joint.is(&[JointType::Prismatic])) {
        return 0.0;
    }
    let turning = above.filter(|joint| joint.is(&[JointType::Revolute, JointType::Continuous]));
    let Some(joint) = turning else {
        return beyond(bounds);
    };
    let axis = joint.axis.as_ref().and_then(|axis| axis.xyz.as_ref());
    let Some([x, y, z]) = axis.map_or(Some([1.0, 0.0, 0.0]), |axis| axis.numbers::<3>()) else {
        return 0.0;
    };
    let length = x.hypot(y).hypot(z);
    let center = bounds.center();
    let along = center
        .iter()
        .zip([x, y, z])
        .map(|(at, part)| at * part)
        .sum::<f64>()
        / length;
    let square = center.iter().map(|at| at * at).sum::<f64>() - along * along;
    if length > 0.0 {
        square.max(0.0).sqrt() - bounds.diagonal() / 2.0
    } else {
        0.0
    }
}

/// From the frame to the nearest point of a box.
fn beyond(bounds: Bounds) -> f64 {
    let sides = bounds
        .min
        .iter()
        .zip(&bounds.max)
        .map(|(min, max)| min.max(-max).max(0.0));
    sides.map(|side| side * side).sum::<f64>().sqrt()
}
