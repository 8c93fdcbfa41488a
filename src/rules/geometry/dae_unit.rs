//! A Collada file that is not in meters.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::once_per_file::each_file;
use model::{Mesh, MeshFormat};

pub(super) static RULE: Rule = Rule {
    code: "GEO024",
    name: "dae-unit",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("dae-unit"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let has_unit =
        |mesh: &Mesh| mesh.format == MeshFormat::Dae && mesh.unit.is_some_and(|unit| unit != 1.0);
    for (mesh, others) in each_file(cx, has_unit) {
        let unit = mesh.mesh.and_then(|mesh| mesh.unit).unwrap_or(1.0);
        let message = format!("unit of `{}` is {unit} m instead of 1 m", mesh.name());
        let help = "export it in meters; not all programs apply the unit";
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
