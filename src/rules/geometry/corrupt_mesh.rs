//! A mesh that cannot be read.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::DefectKind;

pub(super) const RULE: Rule = Rule {
    code: "GEO006",
    name: "corrupt-mesh",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("corrupt-mesh"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let Some(defect) = mesh.mesh.and_then(|mesh| mesh.defect.as_ref()) else { continue };
        let (severity, help) = match defect.kind {
            DefectKind::Corrupt => (Severity::Error, "export or copy it again"),
            DefectKind::LfsPointer => (Severity::Error, "fetch the file itself with `git lfs pull`"),
            DefectKind::Untidy => (Severity::Warning, "export it again: strict readers refuse it"),
            DefectKind::Unescaped => (Severity::Info, "most readers take it; write `&lt;` for strict ones"),
            DefectKind::TooLarge => (Severity::Info, "it was not checked; a robot needs no such mesh"),
            DefectKind::Unread => continue,
        };
        let message = format!("mesh `{}` of link `{}`: {}", mesh.name(), mesh.link.shown(), defect.message);
        out.report(mesh.file.origin, message).group(mesh.group()).severity(severity).help(help).done();
    }
}
