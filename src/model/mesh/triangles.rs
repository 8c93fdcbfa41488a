//! The triangles of a mesh themselves, for those who draw it.

use super::defect::Defect;
use super::draft;
use super::gltf::FileLoader;

/// The triangles of a mesh; meters, in the axes of the file.
#[derive(Clone, Debug, Default)]
pub struct Triangles {
    /// The points, each different from the others.
    pub points: Vec<[f64; 3]>,
    /// Corners as indices of points.
    pub corners: Vec<[u32; 3]>,
    /// From which triangle on the file gives which color: red, green, blue, opacity; 0 to 1, as URDF writes them.
    pub tints: Vec<(usize, Option<[f64; 4]>)>,
}

impl Triangles {
    /// Read a file from its ending (small letters, without point) and bytes.
    pub(super) fn read(ending: &str, bytes: &[u8], beside: FileLoader<'_>) -> Result<Self, Defect> {
        let (draft, read) = draft(ending, bytes, beside, true);
        read?;
        let soup = draft.soup.complete();
        if soup.triangles.is_empty() {
            return Err(Defect::corrupt("it has no triangles"));
        }
        Ok(Self {
            points: soup.points,
            corners: soup.triangles,
            tints: soup.tints,
        })
    }
}
