//! A mesh of a format that few programs read.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::target::FileLookup;
use packages::edit_distance;

pub(super) static RULE: Rule = Rule {
    code: "GEO003",
    name: "unsupported-mesh-format",
    category: Category::Geometry,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("unsupported-mesh-format"),
    check: Check::Document(check),
};

/// The endings that at least one of the usual programs reads.
const READ: [&str; 12] = [
    "stl", "dae", "obj", "ply", "gltf", "glb", "mesh", "msh", "usd", "usda", "usdc", "usdz",
];

/// Those of which another ending may be a misspelling.
const USUAL: [&str; 3] = ["stl", "dae", "obj"];

/// Formats of meshes that some program reads: who uses one for all meshes has such a program.
const OTHER: [&str; 10] = [
    "fbx", "3ds", "off", "wrl", "vrml", "x3d", "lwo", "x", "osg", "ive",
];

fn check(cx: &DocumentCx<'_>, out: &mut Sink<'_>) {
    let common = [false, true].map(|is_collision| has_common_format(cx, is_collision));
    for mesh in cx.meshes() {
        let name = mesh.name();
        let ending = ending(name);
        let known = READ.contains(&ending.to_lowercase().as_str());
        if known
            || name.is_empty()
            || !mesh.file.is_known()
            || matches!(mesh.target, FileLookup::NoFile(_))
        {
            continue;
        }
        let link = mesh.link.shown();
        let message = match ending {
            "" => format!("mesh `{name}` of link `{link}` has no file extension"),
            _ => format!(
                "mesh of link `{link}` is in format `.{ending}`, which few programs support"
            ),
        };
        let near = USUAL
            .iter()
            .find(|known| edit_distance(known, &ending.to_lowercase()) == 1);
        let help = near.map_or_else(
            || "convert it to STL, OBJ, DAE or GLB".to_owned(),
            |near| {
                format!(
                    "did you mean `.{near}`? Otherwise convert the mesh to STL, OBJ, DAE or GLB"
                )
            },
        );
        // most visuals, or most collisions, in one format are a choice
        let [visuals, collisions] = &common;
        let is_chosen = if mesh.is_collision {
            *collisions
        } else {
            *visuals
        };
        let severity = if is_chosen {
            Severity::Info
        } else {
            Severity::Warning
        };
        out.report(mesh.file.origin, message)
            .severity(severity)
            .group(mesh.group())
            .help(help)
            .done();
    }
}

/// Whether most visuals, or most collisions, of a robot have one of the other formats.
fn has_common_format(cx: &DocumentCx<'_>, is_collision: bool) -> bool {
    let endings: Vec<String> = cx
        .meshes()
        .filter(|mesh| mesh.is_collision == is_collision)
        .map(|mesh| ending(mesh.name()).to_lowercase())
        .collect();
    OTHER.iter().any(|format| {
        let count = endings.iter().filter(|ending| ending == format).count();
        count * 2 > endings.len()
    })
}

/// What follows the last period of a file name; empty without one.
fn ending(name: &str) -> &str {
    name.rsplit_once('.').map_or("", |(_, ending)| ending)
}
