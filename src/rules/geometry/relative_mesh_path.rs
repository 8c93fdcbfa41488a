//! A mesh by a relative path.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::shapes::is_replaceable;
use super::uri::defect;

pub(super) static RULE: Rule = Rule {
    code: "GEO020",
    name: "relative-mesh-path",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("relative-mesh-path"),
    check: Check::Document(check),
};

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let value = mesh.file.value.as_str();
        let is_path = mesh.file.is_known()
            && !value.is_empty()
            && !value.starts_with('/')
            && !value.contains(':');
        if !is_path || defect(value).is_some() {
            continue;
        }
        let place = cx.expansion.place(mesh.file.origin);
        let source = place.and_then(|place| cx.expansion.files.get(place.file));
        let Some(package) = source.and_then(|file| cx.world.packages.containing(&file.source.path))
        else {
            continue;
        };
        let message = format!(
            "mesh `{}` of link `{}` has a relative path",
            mesh.name(),
            mesh.link.shown()
        );
        let report = out
            .report(mesh.file.origin, message)
            .help("write package://PACKAGE/PATH; RViz cannot load relative paths");
        let uri = mesh.target.file().and_then(|path| package.uri(path));
        match uri.filter(|uri| is_replaceable(mesh.file, uri) && !uri.contains("..")) {
            Some(uri) => {
                report
                    .replace_with(Safety::Unsafe, format!("replace with `{uri}`"), uri)
                    .done();
            }
            None => report.done(),
        }
    }
}
