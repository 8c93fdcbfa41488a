//! What a reader has found so far.

use super::defect::Defect;
use super::soup::Soup;
use base::limits::MESH_FILES;

/// The formats of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// STL as text.
    StlAscii,
    /// Binary STL.
    StlBinary {
        /// Whether its header begins with `solid` as text would.
        solid: bool,
    },
    /// Wavefront OBJ.
    Obj,
    /// Collada.
    Dae,
    /// glTF, as JSON or binary.
    Gltf,
    /// Anything else; it is not read.
    Other,
}

/// The axis that points up in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum UpAxis {
    X,
    Y,
    Z,
}

/// A file that a mesh needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dependency {
    /// Its name as the mesh writes it.
    pub name: String,
    /// Whether it is a material library of OBJ, which names textures in turn.
    pub is_material_library: bool,
}

impl Dependency {
    /// A texture or a buffer.
    pub(super) fn file(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            is_material_library: false,
        }
    }
}

/// What a reader has found so far.
#[derive(Debug)]
pub(super) struct MeshBuilder {
    pub(super) format: MeshFormat,
    pub(super) soup: Soup,
    /// Meters a unit, where the file says so.
    pub(super) unit: Option<f64>,
    pub(super) up_axis: Option<UpAxis>,
    pub(super) dependencies: Vec<Dependency>,
    /// A defect that does not keep the rest from being read.
    pub(super) defect: Option<Defect>,
    /// Whether colors are wanted.
    pub(super) tinted: bool,
}

impl MeshBuilder {
    pub(super) fn new(format: MeshFormat) -> Self {
        let (soup, dependencies) = (Soup::default(), Vec::new());
        Self {
            format,
            soup,
            unit: None,
            up_axis: None,
            dependencies,
            defect: None,
            tinted: false,
        }
    }

    /// Note a file that is needed, once.
    pub(super) fn needs(&mut self, dependency: Dependency) {
        let room = self.dependencies.len() < MESH_FILES;
        if room && !dependency.name.is_empty() && !self.dependencies.contains(&dependency) {
            self.dependencies.push(dependency);
        }
    }
}
