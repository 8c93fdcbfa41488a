//! A mesh by an absolute path.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::resources::MeshUse;
use super::shapes::is_replaceable;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO019",
    name: "absolute-mesh-path",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("absolute-mesh-path"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes().filter(is_absolute) {
        let message = format!(
            "mesh `{}` of link `{}` has an absolute path",
            mesh.name(),
            mesh.link.shown()
        );
        let report = out
            .report(mesh.file.origin, message)
            .help("write package://PACKAGE/PATH; an absolute path works on this computer only");
        match in_package(cx, &mesh).filter(|uri| is_replaceable(mesh.file, uri)) {
            Some(uri) => report
                .replace_with(Safety::Unsafe, format!("replace with `{uri}`"), uri)
                .done(),
            None => report.done(),
        }
    }
}

/// Whether a mesh is named by an absolute path that the source spells. `$(find package)` makes an absolute path
/// too, and the right one everywhere.
pub(super) fn is_absolute(mesh: &MeshUse<'_>) -> bool {
    let start = absolute_start(&mesh.file.value).filter(|_| mesh.file.is_known());
    start.is_some_and(|start| mesh.file.is_written(start..start + 1))
}

/// Where the first name of the path begins, when it is absolute.
fn absolute_start(value: &str) -> Option<usize> {
    let path = ["file://localhost", "file://", "file:"]
        .iter()
        .find_map(|scheme| value.strip_prefix(scheme));
    let path = path.unwrap_or(value);
    // `file:///$(find package)` makes four slashes
    let has_drive = path.get(1..3) == Some(":/");
    (path.starts_with('/') || has_drive).then(|| value.len() - path.trim_start_matches('/').len())
}

/// The file as a URI of the package that holds it.
fn in_package(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<String> {
    let path = mesh.target.file()?;
    cx.world.packages.containing(path)?.uri(path)
}
