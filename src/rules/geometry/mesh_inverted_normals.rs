//! A mesh that is inside out.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

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
                .help("flip the normals in a mesh editor; the triangles face inward")
                .done();
        }
    }
}
