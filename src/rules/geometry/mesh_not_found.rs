//! A mesh that is not there.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::absolute_mesh_path::is_absolute;
use super::missing::MissingFiles;
use super::target::FileLookup;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO001",
    name: "mesh-not-found",
    category: Category::Geometry,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("mesh-not-found"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let mut missing = MissingFiles::default();
    for mesh in cx.meshes() {
        let link = mesh.link.shown();
        match mesh.target {
            // that it is absolute is said by another rule: on the machine it was written on, it may be there
            FileLookup::Missing(..) if is_absolute(&mesh) => {}
            FileLookup::Missing(path, package) => {
                let what = format!("mesh `{}` of link `{link}`", mesh.name());
                missing.add(mesh.file, what, path, package.as_deref());
            }
            FileLookup::NoFile(path) => {
                let message = format!(
                    "mesh of link `{link}`: `{}` is not a file",
                    vfs::slashed(path)
                );
                out.report(mesh.file.origin, message)
                    .help("write the path of the mesh file")
                    .done();
            }
            _ => {}
        }
    }
    missing.report(cx, out);
}
