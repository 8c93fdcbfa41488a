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

/// Those of construction programs, which no program for robots reads.
const CONSTRUCTION: [&str; 10] =
    ["step", "stp", "iges", "igs", "sldprt", "sldasm", "ipt", "iam", "fcstd", "blend"];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let common = common_ending(cx);
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
        // all meshes in one format are a choice: some program reads it
        let is_chosen = near.is_none() && common.as_deref() == Some(&*ending.to_lowercase());
        let severity = if is_chosen { Severity::Info } else { Severity::Warning };
        out.report(mesh.file.origin, message).severity(severity).group(mesh.group()).help(help).done();
    }
}

/// The ending that several meshes of a robot have and no other mesh lacks, when it is that of meshes.
fn common_ending(cx: &DocumentCx<'_>) -> Option<String> {
    let mut endings = cx.meshes().map(|mesh| {
        let name = mesh.name();
        name.rsplit_once('.').map_or("", |(_, ending)| ending).to_lowercase()
    });
    let first = endings.next()?;
    let others: Vec<String> = endings.collect();
    let is_common = !others.is_empty() && others.iter().all(|ending| *ending == first);
    (is_common && !first.is_empty() && !CONSTRUCTION.contains(&first.as_str())).then_some(first)
}
