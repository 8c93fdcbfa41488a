//! A collision mesh with holes.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule {
    code: "GEO010",
    name: "mesh-not-watertight",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mesh-not-watertight"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes().filter(|mesh| mesh.is_collision) {
        let Some(edges) = mesh
            .mesh
            .and_then(|mesh| mesh.surface)
            .map(|surface| surface.edges)
        else {
            continue;
        };
        if edges.boundary > 0 {
            let (name, link, count) = (mesh.name(), mesh.link.shown(), edges.boundary);
            let message =
                format!("collision mesh `{name}` of link `{link}` has holes ({count} open edges)");
            out.report(mesh.file.origin, message)
                .group(mesh.folder_group())
                .help("close the holes, or use the convex hull")
                .done();
        }
    }
}
