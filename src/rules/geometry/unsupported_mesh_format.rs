//! A mesh of a format that few programs read.

use super::super::context::DocumentCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::resources::Target;
use crate::workspace::edit_distance;

pub(super) const RULE: Rule = Rule {
    code: "GEO003",
    name: "unsupported-mesh-format",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("unsupported-mesh-format"),
    check: Check::Document(check),
};

/// The endings that at least one of the usual programs reads.
const READ: [&str; 12] =
    ["stl", "dae", "obj", "ply", "gltf", "glb", "mesh", "msh", "usd", "usda", "usdc", "usdz"];

/// Those of which another ending may be a misspelling.
const USUAL: [&str; 3] = ["stl", "dae", "obj"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    for mesh in cx.meshes() {
        let name = mesh.name();
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
        let known = READ.contains(&ending.to_lowercase().as_str());
        if known || name.is_empty() || !mesh.file.is_known() || matches!(mesh.target, Target::NoFile(_)) {
            continue;
        }
        let link = mesh.link.shown();
        let message = match ending {
            "" => format!("mesh `{name}` of link `{link}` has no ending that tells its format"),
            _ => format!("mesh of link `{link}`: format `.{ending}` is read by few programs"),
        };
        let near = USUAL.iter().find(|known| edit_distance(known, &ending.to_lowercase()) == 1);
        let help = near.map_or_else(
            || "convert it to STL, OBJ, DAE or GLB".to_owned(),
            |near| format!("did you mean `.{near}`? Otherwise convert the mesh to STL, OBJ, DAE or GLB"),
        );
        out.report(mesh.file.origin, message).group(mesh.group()).help(help).done();
    }
}
