//! A mesh that cannot be read.
use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::resources::MeshUse;
use model::DefectKind;

pub(super) static RULE: Rule = Rule {
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
        let Some(defect) = mesh.mesh.and_then(|mesh| mesh.defect.as_ref()) else {
            continue;
        };
        let (severity, help) = match defect.kind {
            DefectKind::Corrupt | DefectKind::Empty => {
                (Severity::Error, "export or copy the file again")
            }
            DefectKind::LfsPointer if is_in_git_lfs(cx, &mesh) => {
                (Severity::Info, "run `git lfs pull` to download the file")
            }
            DefectKind::LfsPointer => (Severity::Error, "run `git lfs pull` to download the file"),
            DefectKind::Untidy => (
                Severity::Warning,
                "export the file again; strict programs reject it",
            ),
            DefectKind::Unescaped => (
                Severity::Info,
                "write `&lt;` for `<`; strict programs reject the file",
            ),
            DefectKind::TooLarge => (Severity::Info, "simplify the mesh; it was not checked"),
            DefectKind::Unread => continue,
        };
        let message = format!(
            "mesh `{}` of link `{}`: {}",
            mesh.name(),
            mesh.link.shown(),
            defect.message
        );
        // a checkout without Git LFS has none of its files, and where a copy fails, or files are to come later, many are empty
        let group = match defect.kind {
            DefectKind::Empty => Group::Thing("empty files".into()),
            DefectKind::LfsPointer => Group::Thing("files of Git LFS".into()),
            _ => mesh.group(),
        };
        out.report(mesh.file.origin, message)
            .group(group)
            .severity(severity)
            .help(help)
            .done();
    }
}

/// Whether Git LFS has the file, as the repository says: this copy of it was made without.
fn is_in_git_lfs(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> bool {
    mesh.target
        .place()
        .is_some_and(|file| workspace::is_in_git_lfs(cx.world.packages, file))
}
