//! A mesh by a path that xacro makes absolute, without `file://` in front of it.

use super::super::context::DocumentCx;
use super::super::grouping::Group;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::absolute_mesh_path::is_absolute;
use super::resources::MeshUse;

pub(in super::super) static RULE: Rule = Rule {
    code: "GEO037",
    name: "mesh-path-without-scheme",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("mesh-path-without-scheme"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    // that a path is written so, and works on one computer only, is said by another rule
    let is_bare = |mesh: &MeshUse<'_>| mesh.file.is_known() && mesh.file.value.starts_with('/');
    for mesh in cx
        .meshes()
        .filter(|mesh| is_bare(mesh) && !is_absolute(mesh))
    {
        let message = format!(
            "mesh `{}` of link `{}` has a path without `file://`",
            mesh.name(),
            mesh.link.shown()
        );
        let report = out
            .report(mesh.file.origin, message)
            // who writes one path so writes all of them so
            .group(Group::Value("no scheme".into()))
            .help("write file://$(find PACKAGE)/PATH or package://PACKAGE/PATH; RViz and MoveIt load only URIs");
        match written(cx, &mesh) {
            Some(path) => {
                let uri = format!("file://{path}");
                report
                    .replace_with(Safety::Unsafe, format!("replace with `{uri}`"), uri)
                    .done();
            }
            None => report.done(),
        }
    }
}

/// The text of the source, when it begins with the package.
fn written(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<String> {
    let place = cx.expansion.place(mesh.file.origin)?;
    let file = cx.expansion.files.get(place.file)?;
    let text = file.source.document.slice(place.range);
    text.starts_with("$(find ").then_some(text)
}
