//! A mesh whose textures, materials or buffers are missing.
use std::cell::OnceCell;
use std::path::Path;

use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::MissingDependency;

pub(super) static RULE: Rule = Rule {
    code: "GEO022",
    name: "mesh-missing-dependency",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("mesh-missing-dependency"),
    check: Check::Document(check),
};

/// Missing files named in one message.
const MOST_NAMES: usize = 3;

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let roots = cx.expansion.files.first().map(|file| &*file.source.path);
    let around = OnceCell::new();
    let belongs = |path: &Path| {
        around
            .get_or_init(|| cx.world.packages.around(roots))
            .hold(path)
    };
    for mesh in cx.meshes() {
        let (Some(path), Some(content)) = (mesh.target.file(), mesh.mesh) else {
            continue;
        };
        let missing = cx
            .world
            .meshes
            .missing(cx.world.vfs, path, content, &belongs);
        if missing.is_empty() {
            continue;
        }
        let message = format!(
            "mesh `{}` of link `{}` refers to {}",
            mesh.name(),
            mesh.link.shown(),
            names(&missing)
        );
        let help = "add the missing file, or remove the reference from the mesh";
        out.report(mesh.file.origin, message)
            .group(mesh.group())
            .help(help)
            .done();
    }
}

fn names(missing: &[MissingDependency]) -> String {
    let name = |missing: &MissingDependency| match &missing.named_in {
        Some(library) => format!("`{}` (referenced in `{library}`)", missing.name),
        None => format!("`{}`", missing.name),
    };
    let listed: Vec<String> = missing.iter().take(MOST_NAMES).map(name).collect();
    let more = match missing.len().saturating_sub(MOST_NAMES) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let verb = if missing.len() == 1 { "is" } else { "are" };
    format!("{}{more}, which {verb} missing", listed.join(", "))
}
