//! A mesh that is mirrored by its scale.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(super) static RULE: Rule = Rule {
    code: "GEO017",
    name: "negative-mesh-scale",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("negative-mesh-scale"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let (Some(scale), Some(factors)) = (mesh.scale, mesh.factors()) else {
            continue;
        };
        let negative = factors.iter().filter(|&&factor| factor < 0.0).count();
        // two negative factors turn the mesh by half a circle
        if negative % 2 == 1 {
            let message = format!("mesh of link `{}` has a negative scale", mesh.link.shown());
            out.report(scale.origin, message)
                .help(
                    "use a mirrored mesh file; some programs render a negative scale inside out or reject it",
                )
                .done();
        }
    }
}
