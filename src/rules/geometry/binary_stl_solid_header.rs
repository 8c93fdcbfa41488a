//! A binary STL that looks like text.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::once_per_file::each_file;
use model::{Mesh, MeshFormat};

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO005",
    name: "binary-stl-solid-header",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("binary-stl-solid-header"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let is_solid = |mesh: &Mesh| {
        mesh.format == MeshFormat::StlBinary { solid: true } && mesh.surface.is_some()
    };
    for (mesh, others) in each_file(cx, is_solid) {
        let message = format!("header of binary STL `{}` starts with `solid`", mesh.name());
        let help = "write another header; some programs mistake the file for ASCII STL";
        let report = out
            .report(mesh.file.origin, message)
            .group(mesh.group())
            .help(help);
        others
            .iter()
            .fold(report, |report, other| {
                report.also(other.file.origin, "also used here")
            })
            .done();
    }
}
