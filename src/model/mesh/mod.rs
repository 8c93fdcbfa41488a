//! Meshes: what the files say that visuals and collisions name.
//!
//! The readers are our own: they say what is wrong with a file, where a library would only refuse it, and they
//! read no more than the triangles and the names of further files.

mod bounds;
mod dae;
mod dae_geometry;
mod defect;
mod draft;
mod gltf;
mod gltf_json;
mod gltf_mesh;
mod library;
mod mtl;
mod node_transform;
mod obj;
mod rewrite;
mod soup;
mod stl;
#[cfg(test)]
mod tests;
mod topology;
mod triangles;

pub use bounds::Bounds;
pub use defect::{Defect, DefectKind};
pub use draft::{Dependency, MeshFormat, UpAxis};
pub use library::{Meshes, MissingDependency};
pub use rewrite::plain_stl;
pub use topology::Edges;
pub use triangles::Triangles;

use draft::MeshBuilder;
use gltf::FileLoader;
use soup::Soup;

/// A mesh file.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Its format: by its ending, and for STL by its content.
    pub format: MeshFormat,
    /// Its triangles; none when it could not be read.
    pub surface: Option<Surface>,
    /// What is wrong with it.
    pub defect: Option<Defect>,
    /// Meters a unit, where the file says so.
    pub unit: Option<f64>,
    /// The axis that points up, where the file says so.
    pub up_axis: Option<UpAxis>,
    /// The files it needs.
    pub dependencies: Vec<Dependency>,
}

/// The triangles of a mesh, taken together; meters, in the axes of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Number of triangles.
    pub triangles: usize,
    /// The box around them.
    pub bounds: Bounds,
    /// How they hang together.
    pub edges: Edges,
    /// The volume they enclose when they are closed, cubic meters; negative when they face inward.
    pub volume: f64,
}

impl Mesh {
    /// Read a file from its ending (small letters, without point) and bytes; `beside` reads a file that it names.
    pub fn read(ending: &str, bytes: &[u8], beside: FileLoader<'_>) -> Self {
        let (draft, read) = draft(ending, bytes, beside, false);
        Self::of(draft, read)
    }

    fn of(draft: MeshBuilder, read: Result<(), Defect>) -> Self {
        let MeshBuilder {
            format,
            soup,
            unit,
            up_axis,
            dependencies,
            defect,
            ..
        } = draft;
        let surface = read
            .as_ref()
            .ok()
            .and_then(|()| Surface::of(&soup.complete()));
        let defect = match read {
            Err(defect) => Some(defect),
            Ok(()) if surface.is_none() => Some(Defect::corrupt("it has no triangles")),
            Ok(()) => defect,
        };
        Self {
            format,
            surface,
            defect,
            unit,
            up_axis,
            dependencies,
        }
    }
}

/// The number of zeros that a file begins with.
fn zeros(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| **byte == 0).count()
}

/// Whether a file holds nothing, or zeros where all formats say what follows: the head of a binary STL and its number of triangles
/// are the longest of them.
fn is_overwritten(bytes: &[u8]) -> bool {
    const LONGEST: usize = 84;
    zeros(bytes) >= bytes.len().min(LONGEST)
}

/// What the reader of a format finds; colors only when they are wanted.
fn draft(
    ending: &str,
    bytes: &[u8],
    beside: FileLoader<'_>,
    tinted: bool,
) -> (MeshBuilder, Result<(), Defect>) {
    let format = match ending {
        "stl" => MeshFormat::StlBinary { solid: false },
        "obj" => MeshFormat::Obj,
        "dae" => MeshFormat::Dae,
        "gltf" | "glb" => MeshFormat::Gltf,
        _ => MeshFormat::Other,
    };
    let mut draft = MeshBuilder {
        tinted,
        ..MeshBuilder::new(format)
    };
    let read = match format {
        _ if is_lfs_pointer(bytes) => Err(lfs_pointer()),
        MeshFormat::Other => Err(Defect::unread("its format is not supported")),
        _ if is_overwritten(bytes) => Err(Defect::empty(zeros(bytes))),
        MeshFormat::StlAscii | MeshFormat::StlBinary { .. } => stl::read(bytes, &mut draft),
        MeshFormat::Obj => obj::read(bytes, beside, &mut draft),
        MeshFormat::Dae => dae::read(&vfs::text_of(bytes.to_vec()), &mut draft),
        MeshFormat::Gltf => gltf::read(bytes, beside, &mut draft),
    };
    (draft, read)
}

impl Surface {
    fn of(soup: &Soup) -> Option<Self> {
        let bounds = Bounds::around(soup.points.iter().copied())?;
        let edges = Edges::of(soup, bounds);
        // measured from a corner of the box, numbers stay small
        let [x, y, z] = bounds.min;
        let volume = soup.triangles.iter().map(|&triangle| {
            let [a, b, c] = soup
                .corners(triangle)
                .map(|[px, py, pz]| nalgebra::Vector3::new(px - x, py - y, pz - z));
            a.dot(&b.cross(&c)) / 6.0
        });
        Some(Self {
            triangles: soup.triangles.len(),
            bounds,
            edges,
            volume: volume.sum(),
        })
    }
}

fn is_lfs_pointer(bytes: &[u8]) -> bool {
    bytes.starts_with(b"version https://git-lfs") && bytes.len() < 1024
}

fn lfs_pointer() -> Defect {
    let message = "it is a Git LFS pointer, not the mesh".to_owned();
    Defect {
        kind: DefectKind::LfsPointer,
        message,
    }
}
