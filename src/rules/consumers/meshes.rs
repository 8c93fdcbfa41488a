//! Mesh files: how they are named, where they are, what is in them.
use std::path::Path;

use super::super::geometry::{FileTarget, MeshUse};
use super::facts::{ConstructCollector, RobotFacts, link_owner};
use base::FastMap;
use model::{DefectKind, Mesh, MeshFormat, ShapeKind};

/// Meshes of more triangles are too many for MuJoCo.
const HUGE: usize = 200_000;

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    without_name(facts, out);
    for mesh in facts
        .cx
        .meshes()
        .filter(|mesh| mesh.file.is_known() && !mesh.file.value.is_empty())
    {
        let prefix = if mesh.is_collision { "collision-" } else { "" };
        let owner = link_owner(mesh.link);
        let mut add = |row: &str| out.add(&format!("{prefix}{row}"), mesh.file.origin, owner);
        let uri = facts.seen(mesh.file);
        let uri = uri.as_str();
        add(scheme(uri));
        if uri.contains(' ') {
            add("mesh-space");
        }
        match missing(facts, &mesh) {
            Some(row) => add(row),
            None if uri.contains("$(") => {}
            None => file(uri, mesh.mesh).into_iter().for_each(&mut add),
        }
        if let Some(factors) = mesh.factors() {
            scale(factors).into_iter().for_each(&mut add);
        }
    }
    same_stem(facts, out);
}

fn without_name(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    for link in &facts.robot.links {
        let visuals = link.visuals.iter().map(|body| (body, ""));
        for (body, prefix) in visuals.chain(link.collisions.iter().map(|body| (body, "collision-")))
        {
            let Some(shape) = body.shape() else { continue };
            let row = match &shape.kind {
                ShapeKind::Mesh { filename: None, .. } => "mesh-without-filename",
                ShapeKind::Mesh {
                    filename: Some(name),
                    ..
                } if name.value.is_empty() => "mesh-filename-empty",
                _ => continue,
            };
            out.add(
                &format!("{prefix}{row}"),
                facts.at(shape.element),
                link_owner(link),
            );
        }
    }
}

/// The rows of a mesh file under a name, beside those that say where it is missing.
pub(super) fn rows(uri: &str, mesh: &Mesh) -> Vec<&'static str> {
    [scheme(uri)]
        .into_iter()
        .chain(file(uri, Some(mesh)))
        .collect()
}

/// The rows of a file and what is in it.
fn file(uri: &str, mesh: Option<&Mesh>) -> Vec<&'static str> {
    let content: Vec<&str> = mesh.into_iter().flat_map(content).collect();
    // the name alone does not tell text from bytes
    let format =
        format(uri).filter(|row| *row != "mesh-stl" || !content.contains(&"mesh-stl-ascii"));
    format.into_iter().chain(content).collect()
}

/// The row of a way to name a file.
fn scheme(uri: &str) -> &'static str {
    let lower = uri.to_ascii_lowercase();
    match () {
        () if uri.contains('\\') => "mesh-backslash",
        () if uri.contains("$(find") => "mesh-find",
        () if uri.starts_with("package://") => "mesh-package",
        () if lower.starts_with("package://") => "mesh-scheme-upper-case",
        () if uri.starts_with("file:") => "mesh-file",
        () if uri.starts_with("model://") => "mesh-model",
        () if lower.starts_with("http://") || lower.starts_with("https://") => "mesh-http",
        () if uri.starts_with('/') => "mesh-absolute",
        () => "mesh-relative",
    }
}

fn missing(facts: &RobotFacts<'_, '_>, mesh: &MeshUse<'_>) -> Option<&'static str> {
    let uri = mesh.file.value.as_str();
    let world = facts.cx.world;
    let from = facts
        .cx
        .expansion
        .files
        .first()
        .map(|file| file.source.path.as_ref())
        .unwrap_or(Path::new(""));
    let package = uri
        .strip_prefix("package://")
        .and_then(|rest| rest.split('/').next());
    match mesh.target {
        FileTarget::Unknown
            if package.is_some_and(|name| world.packages.find(name, from).is_err()) =>
        {
            Some("mesh-package-unknown")
        }
        FileTarget::OtherCase(_) => Some("mesh-case"),
        FileTarget::Missing(..) | FileTarget::NoFile(_) | FileTarget::Malformed => {
            Some("mesh-missing")
        }
        FileTarget::Unknown | FileTarget::File(_) => None,
    }
}

/// The row of the format that the name of a file tells.
fn format(uri: &str) -> Option<&'static str> {
    let ending = Path::new(uri).extension()?.to_str()?;
    match ending.to_ascii_lowercase().as_str() {
        "stl" if ending != "stl" => Some("mesh-stl-upper-case"),
        "stl" => Some("mesh-stl"),
        "obj" => Some("mesh-obj"),
        "dae" => Some("mesh-dae"),
        "gltf" => Some("mesh-gltf"),
        "glb" => Some("mesh-glb"),
        "ply" => Some("mesh-ply"),
        _ => Some("mesh-format-unknown"),
    }
}

/// The rows of what is in a file.
fn content(mesh: &Mesh) -> Vec<&'static str> {
    let mut rows = Vec::new();
    if mesh.format == MeshFormat::StlAscii {
        rows.push("mesh-stl-ascii");
    }
    let corrupt = mesh
        .defect
        .as_ref()
        .filter(|defect| matches!(defect.kind, DefectKind::Corrupt | DefectKind::LfsPointer));
    match (&mesh.surface, corrupt) {
        (None, Some(defect)) if defect.message.contains("no triangles") => {
            rows.push("mesh-without-triangles")
        }
        (_, Some(_)) => rows.push("mesh-corrupt"),
        (Some(surface), None) => match surface.triangles {
            count if count > HUGE => rows.push("mesh-huge"),
            count if count < 2 => rows.push("mesh-one-triangle"),
            _ if surface.bounds.size().contains(&0.0) => rows.push("mesh-flat"),
            _ => {}
        },
        (None, None) => {}
    }
    rows
}

fn scale(factors: [f64; 3]) -> Option<&'static str> {
    match () {
        () if factors.contains(&0.0) => Some("mesh-scale-zero"),
        () if factors.iter().any(|&factor| factor < 0.0) => Some("mesh-scale-negative"),
        #[allow(clippy::float_cmp)] // what is written as 1
        () if factors.iter().any(|&factor| factor != 1.0) => Some("mesh-scale"),
        () => None,
    }
}

/// Collision meshes of one file name in different folders.
fn same_stem(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let mut first: FastMap<String, &Path> = FastMap::default();
    for mesh in facts.cx.meshes().filter(|mesh| mesh.is_collision) {
        let Some(path) = mesh.target.file() else {
            continue;
        };
        let stem = path
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
        let known = *first.entry(stem).or_insert(path);
        if known != path {
            out.add(
                "meshes-of-one-stem",
                mesh.file.origin,
                link_owner(mesh.link),
            );
        }
    }
}
