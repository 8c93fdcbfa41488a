//! A mesh scaled to nothing.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule {
    code: "GEO018",
    name: "zero-mesh-scale",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("zero-mesh-scale"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let (Some(scale), Some(factors)) = (mesh.scale, mesh.factors()) else {
            continue;
        };
        if factors.contains(&0.0) {
            let message = format!("mesh of link `{}` has a scale of zero", mesh.link.shown());
            out.report(scale.origin, message)
                .help("write scale=\"1 1 1\", or scale=\"0.001 0.001 0.001\" for a mesh in millimeters")
                .done();
        }
    }
}
