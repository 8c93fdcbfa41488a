//! A collision mesh of many triangles.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::super::thresholds::{MAX_COLLISION_TRIANGLES, WARN_COLLISION_TRIANGLES};

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO011",
    name: "collision-mesh-too-detailed",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("collision-mesh-too-detailed"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes().filter(|mesh| mesh.is_collision) {
        let Some(surface) = mesh.mesh.and_then(|mesh| mesh.surface) else {
            continue;
        };
        if is_too_detailed(cx, surface.triangles) {
            let (name, link, count) = (mesh.name(), mesh.link.shown(), surface.triangles);
            let message = format!(
                "collision mesh `{name}` of link `{link}` is too detailed: {count} triangles"
            );
            let many = surface.triangles as f64 > WARN_COLLISION_TRIANGLES.value(cx.world.config);
            out.report(mesh.file.origin, message)
                .severity(if many {
                    Severity::Warning
                } else {
                    Severity::Info
                })
                .group(mesh.folder_group())
                .help("use the convex hull, or a few boxes and cylinders")
                .done();
        }
    }
}

/// Whether a collision mesh has too many triangles.
pub(super) fn is_too_detailed(cx: &DocumentCx<'_>, triangles: usize) -> bool {
    triangles as f64 > MAX_COLLISION_TRIANGLES.value(cx.world.config)
}
