//! STL as text.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::MeshFormat;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO004",
    name: "ascii-stl",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("ascii-stl"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        if mesh
            .mesh
            .is_some_and(|mesh| mesh.format == MeshFormat::StlAscii)
        {
            let message = format!(
                "mesh `{}` of link `{}` is an ASCII STL file",
                mesh.name(),
                mesh.link.shown()
            );
            out.report(mesh.file.origin, message)
                .group(mesh.group())
                .help("export it as binary STL, which every program reads and which is about a fifth of the size")
                .done();
        }
    }
}
