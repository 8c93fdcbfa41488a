//! Another name or file for a mesh that some consumer does not read.
use std::path::Path;

use super::super::context::{DocumentCx, is_plain_urdf};
use super::super::finding::Edit;
use super::super::geometry::{MeshUse, is_replaceable};
use super::super::rule::Safety;
use super::super::sink::span_of;
use super::consumer::Consumer;
use super::fix::Remedy;
use super::meshes::rows;
use super::met::Met;
use super::table::{Outcome, construct};
use model::{Bounds, Mesh, UpAxis};
use vfs::{relative, slashed};

/// Formats of meshes, those that most consumers read first.
const FORMATS: [&str; 4] = ["stl", "obj", "dae", "glb"];
/// The part of their size by which two meshes of one shape may differ: they are written with few digits.
const ROUNDING: f64 = 1e-4;

/// The rows of meshes, for visuals or for collisions.
struct Rows<'w> {
    prefix: &'static str,
    wanted: &'w [&'static Consumer],
}

/// The same mesh by another name, or a file of another format beside it.
pub(super) fn other_mesh(
    cx: &DocumentCx<'_>,
    met: &Met,
    wanted: &[&'static Consumer],
) -> Option<Remedy> {
    let row = met.construct.name.as_str();
    let (prefix, row) = row
        .strip_prefix("collision-")
        .map_or(("", row), |row| ("collision-", row));
    let row = row.strip_prefix("mesh-")?;
    let is_it = |mesh: &MeshUse<'_>| {
        mesh.file.origin == met.origin && mesh.is_collision != prefix.is_empty()
    };
    let mesh = cx.meshes().find(is_it)?;
    let rows = Rows { prefix, wanted };
    let (safety, uri) = match row {
        "package" | "file" => (
            Safety::Unsafe,
            relative_name(cx, &mesh).filter(|uri| rows.admit_name(&mesh, uri))?,
        ),
        "relative" => (
            Safety::Unsafe,
            name_in_package(cx, &mesh).filter(|uri| rows.admit_name(&mesh, uri))?,
        ),
        "stl" | "stl-upper-case" | "stl-ascii" | "obj" | "dae" | "gltf" | "glb" | "ply"
        | "format-unknown" => file_beside(cx, &mesh, &rows)?,
        _ => return None,
    };
    let edit = Edit {
        span: span_of(cx.expansion, mesh.file.origin)?,
        content: uri.clone(),
    };
    let message = format!("replace with `{uri}`");
    is_replaceable(mesh.file, &uri).then(|| Remedy {
        safety,
        message,
        edits: vec![edit],
    })
}

impl Rows<'_> {
    /// Whether all consumers accept a mesh under a name.
    fn admit(&self, uri: &str, mesh: &Mesh) -> bool {
        self.refused(uri, mesh).is_empty()
    }

    /// Whether no consumer minds another name of a mesh that did not mind the old one.
    fn admit_name(&self, mesh: &MeshUse<'_>, uri: &str) -> bool {
        let Some(own) = mesh.mesh else { return false };
        let old = self.refused(&mesh.file.value, own);
        self.refused(uri, own).iter().all(|row| old.contains(row))
    }

    /// The rows that some consumer does not accept.
    fn refused(&self, uri: &str, mesh: &Mesh) -> Vec<&'static str> {
        let is_refused = |row: &&str| {
            let row = construct(&format!("{}{row}", self.prefix));
            row.is_some_and(|row| {
                self.wanted
                    .iter()
                    .any(|consumer| row.outcome(consumer) > Outcome::Accepts)
            })
        };
        rows(uri, mesh).into_iter().filter(is_refused).collect()
    }
}

/// The path from the file to the mesh, when consumers read the file itself.
fn relative_name(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<String> {
    let [file] = cx.expansion.files.as_slice() else {
        return None;
    };
    let folder = file
        .source
        .path
        .parent()
        .filter(|_| is_plain_urdf(&file.source.path))?;
    Some(slashed(&relative(folder, mesh.target.file()?)))
}

/// `package://PACKAGE/PATH`, when the mesh lies in the package of the file that names it.
fn name_in_package(cx: &DocumentCx<'_>, mesh: &MeshUse<'_>) -> Option<String> {
    let place = cx.expansion.place(mesh.file.origin)?;
    let file = cx.expansion.files.get(place.file)?;
    let package = cx.world.packages.containing(&file.source.path)?;
    package
        .uri(mesh.target.file()?)
        .filter(|uri| !uri.contains(".."))
}

/// A file of the same name with another ending that all consumers read, and whether it can take the place of the mesh.
fn file_beside(
    cx: &DocumentCx<'_>,
    mesh: &MeshUse<'_>,
    rows: &Rows<'_>,
) -> Option<(Safety, String)> {
    let (path, uri) = (mesh.target.file()?, mesh.file.value.as_str());
    let ending = Path::new(uri).extension()?.to_str()?;
    let stem = uri.strip_suffix(ending)?;
    FORMATS
        .iter()
        .filter(|format| **format != ending)
        .find_map(|format| {
            let (path, uri) = (path.with_extension(format), format!("{stem}{format}"));
            cx.world.meshes.note(&path);
            if !cx.world.vfs.is_file(&path) {
                return None;
            }
            let other = cx.world.meshes.get(cx.world.vfs, &path);
            let safety = exchange(mesh, &other).filter(|_| rows.admit(&uri, &other))?;
            Some((safety, uri))
        })
}

/// Whether a mesh can be exchanged for another one: not for another shape. Visuals may lose their colors.
fn exchange(mesh: &MeshUse<'_>, other: &Mesh) -> Option<Safety> {
    let own = mesh.mesh?;
    let Some(known) = own.surface else {
        return other.surface.map(|_| Safety::Unsafe);
    };
    let surface = other.surface.as_ref()?;
    let size = known.bounds.size().into_iter().fold(0.0, f64::max);
    let mut pairs = corners(known.bounds).zip(corners(surface.bounds));
    let is_same = pairs.all(|(a, b)| (a - b).abs() <= ROUNDING * size)
        && (known.volume - surface.volume).abs() <= 0.01 * known.volume.abs();
    let is_safe = mesh.is_collision && !is_turned(own) && !is_turned(other);
    is_same.then_some(if is_safe {
        Safety::Safe
    } else {
        Safety::Unsafe
    })
}

/// Whether some programs turn a mesh.
fn is_turned(mesh: &Mesh) -> bool {
    !matches!(mesh.up_axis, None | Some(UpAxis::Z))
}

fn corners(bounds: Bounds) -> impl Iterator<Item = f64> {
    bounds.min.into_iter().chain(bounds.max)
}
