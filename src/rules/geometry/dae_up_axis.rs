//! A Collada file whose up axis is not z.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::once_per_file::each_file;
use model::{Mesh, MeshFormat, UpAxis};

pub(super) static RULE: Rule = Rule {
    code: "GEO023",
    name: "dae-up-axis",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("dae-up-axis"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let is_turned = |mesh: &Mesh| {
        mesh.format == MeshFormat::Dae && matches!(mesh.up_axis, Some(UpAxis::X | UpAxis::Y))
    };
    for (mesh, others) in each_file(cx, is_turned) {
        let axis = if mesh
            .mesh
            .is_some_and(|mesh| mesh.up_axis == Some(UpAxis::X))
        {
            "X_UP"
        } else {
            "Y_UP"
        };
        let message = format!("up axis of `{}` is `{axis}` instead of `Z_UP`", mesh.name());
        let help = "export it with Z_UP; not all programs apply the up axis";
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
