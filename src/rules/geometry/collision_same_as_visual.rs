//! A visual mesh used for collision.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::collision_mesh_too_detailed::is_too_detailed;
use super::resources::MeshUse;

pub(super) static RULE: Rule = Rule {
    code: "GEO012",
    name: "collision-same-as-visual",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("collision-same-as-visual"),
    check: Check::Document(check),
};

/// Meshes of at most this many triangles may serve for both.
const FEW: usize = 1000;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let meshes: Vec<_> = cx.meshes().collect();
    for collision in meshes.iter().filter(|mesh| mesh.is_collision) {
        let Some(surface) = collision.mesh.and_then(|mesh| mesh.surface) else {
            continue;
        };
        if surface.triangles <= FEW || is_too_detailed(cx, surface.triangles) {
            continue;
        }
        let is_same = |visual: &&MeshUse<'_>| {
            !visual.is_collision
                && visual.link.element == collision.link.element
                && visual.target == collision.target
        };
        if let Some(visual) = meshes.iter().find(is_same) {
            let (name, link, count) = (collision.name(), collision.link.shown(), surface.triangles);
            let message = format!(
                "link `{link}` uses its visual mesh `{name}` ({count} triangles) for collision"
            );
            out.report(collision.file.origin, message)
                .group(collision.group())
                .also(visual.file.origin, "visual")
                .help("use the convex hull, or a few boxes and cylinders")
                .done();
        }
    }
}
