//! A mesh that is inside out.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::resources::MeshUse;

pub(super) static RULE: Rule = Rule {
    code: "GEO008",
    name: "mesh-inverted-normals",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mesh-inverted-normals"),
    check: Check::Document(check),
};

/// A volume that flat meshes have by rounding alone, as part of the cube around them.
const NOISE: f64 = 1e-9;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let surface = mesh.mesh.and_then(|mesh| mesh.surface);
        let (Some(surface), Some(factors)) = (surface, mesh.factors()) else {
            continue;
        };
        // a scale that mirrors is meant so, and has a rule of its own
        let mirrored = factors.into_iter().product::<f64>() < 0.0;
        let (edges, noise) = (surface.edges, surface.bounds.extent().powi(3) * NOISE);
        if edges.closed && edges.same_direction == 0 && !mirrored && surface.volume < -noise {
            let message = format!(
                "mesh `{}` of link `{}` has inverted normals",
                mesh.name(),
                mesh.link.shown()
            );
            out.report(mesh.file.origin, message)
                .group(mesh.folder_group())
                .severity(severity(cx, &mesh))
                .help("flip the normals in a mesh editor; the triangles face inward")
                .done();
        }
    }
}

/// How bad it is: planners do not ask which side of a triangle is outside, and a robot without any mass is for them.
fn severity(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Severity {
    let is_shown = |other: MeshUse<'_>| !other.is_collision && other.file.value == mesh.file.value;
    let is_simulated = cx.links().iter().any(|link| link.inertial.is_some());
    if is_simulated || !mesh.is_collision || cx.meshes().any(is_shown) {
        RULE.severity
    } else {
        Severity::Info
    }
}
