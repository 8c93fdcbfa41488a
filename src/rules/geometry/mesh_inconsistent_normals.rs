//! A mesh of which some triangles face the wrong way.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO009",
    name: "mesh-inconsistent-normals",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mesh-inconsistent-normals"),
    check: Check::Document(check),
};

/// From this part of the edges on, contacts go wrong.
const MANY: f64 = 0.05;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let Some(edges) = mesh
            .mesh
            .and_then(|mesh| mesh.surface)
            .map(|surface| surface.edges)
        else {
            continue;
        };
        let wrong = edges.same_direction;
        let counts = if mesh.is_collision {
            wrong > 0
        } else {
            wrong * 100 > edges.total
        };
        if counts {
            let (name, link) = (mesh.name(), mesh.link.shown());
            let message =
                format!("mesh `{name}` of link `{link}` has inconsistent normals at {wrong} edges");
            // programs that draw take normals from the file or show both sides
            let matters = mesh.is_collision && wrong as f64 > MANY * edges.total as f64;
            let severity = if matters {
                Severity::Warning
            } else {
                Severity::Info
            };
            out.report(mesh.file.origin, message)
                .severity(severity)
                .group(mesh.folder_group())
                .help("make all normals consistent in a mesh editor")
                .done();
        }
    }
}
