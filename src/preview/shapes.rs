//! Shapes and colors: meshes found on the disk, materials looked up by name.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ecow::EcoString;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde::Serialize;

use super::files::{MeshFile, ModelFiles};
use analysis::Session;
use base::{FastMap, FastSet};
use expand::{Expansion, Origin};
use model::{self, Material, Robot, ShapeKind};
use packages::UriOutcome;

/// What a body looks like; lengths in meters.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum ShapeModel {
    /// Centered, full lengths.
    Box {
        /// Along x, y and z.
        size: [f64; 3],
    },
    /// Along z, centered.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Length.
        length: f64,
    },
    /// Along z, centered, with half spheres at its ends.
    Capsule {
        /// Radius.
        radius: f64,
        /// Length without the half spheres.
        length: f64,
    },
    /// Centered.
    Sphere {
        /// Radius.
        radius: f64,
    },
    /// A file.
    Mesh {
        /// Its name as it is written.
        uri: String,
        /// Factors along x, y and z.
        scale: [f64; 3],
        /// Its id.
        #[serde(skip_serializing_if = "Option::is_none")]
        mesh: Option<String>,
        /// Why it has none.
        #[serde(skip_serializing_if = "Option::is_none")]
        problem: Option<String>,
    },
    /// Nothing that can be drawn.
    Unknown {
        /// Why nothing can be drawn, for people.
        problem: String,
    },
}

/// The color of a body.
#[derive(Clone, Debug, Default)]
pub(super) struct Look {
    pub color: Option<[f64; 4]>,
    pub texture: Option<String>,
}

/// Where shapes and colors are looked up.
pub(super) struct Shapes<'a> {
    session: &'a Session,
    expansion: &'a Expansion,
    table: &'a ModelFiles,
    /// Materials with a color or a texture: the first of each name.
    materials: FastMap<EcoString, &'a Material>,
    /// Files named so far.
    files: BTreeMap<String, MeshFile>,
}

impl<'a> Shapes<'a> {
    pub fn new(
        session: &'a Session,
        expansion: &'a Expansion,
        robot: &'a Robot,
        table: &'a ModelFiles,
    ) -> Self {
        let inside = robot.links.iter().flat_map(|link| &link.visuals);
        let inside = inside.filter_map(|visual| visual.material.as_deref());
        let mut materials = FastMap::default();
        for material in robot.materials.iter().chain(inside) {
            let name = material.name.as_ref().and_then(|name| name.name());
            if let Some(name) =
                name.filter(|_| material.rgba.is_some() || material.texture_file.is_some())
            {
                materials.entry(name.clone()).or_insert(material);
            }
        }
        Self {
            session,
            expansion,
            table,
            materials,
            files: BTreeMap::new(),
        }
    }

    /// Read all meshes of the robot, several at once: of a large robot they take most of the time.
    pub fn read_meshes(&self, robot: &Robot) {
        let bodies = robot
            .links
            .iter()
            .flat_map(|link| link.visuals.iter().chain(&link.collisions));
        let paths: FastSet<PathBuf> = bodies
            .filter_map(|body| match &body.shape()?.kind {
                ShapeKind::Mesh { filename, .. } => self.find(filename.as_ref()?).ok(),
                _ => None,
            })
            .collect();
        let Session { vfs, .. } = self.session;
        paths
            .par_iter()
            .for_each(|path| drop(self.session.meshes().get(vfs, path)));
    }

    /// The files that were named.
    pub fn take_files(&mut self) -> BTreeMap<String, MeshFile> {
        std::mem::take(&mut self.files)
    }

    /// The color that a material gives, by itself or by its name.
    pub fn look(&mut self, material: Option<&Material>) -> Look {
        let Some(own) = material else {
            return Look::default();
        };
        let name = own.name.as_ref().and_then(|name| name.name());
        let named = name.and_then(|name| self.materials.get(name).copied());
        let has_own = own.rgba.is_some() || own.texture_file.is_some();
        let Some(material) = Some(own).filter(|_| has_own).or(named) else {
            return Look::default();
        };
        let texture = material.texture_file.as_ref().and_then(|file| {
            let path = self.find(file).ok()?;
            Some(self.file(&path))
        });
        Look {
            color: material.rgba.as_ref().and_then(|rgba| rgba.numbers()),
            texture,
        }
    }

    /// The shape of a body.
    pub fn shape(&mut self, body: &model::Body) -> ShapeModel {
        let Some(shape) = body.shape() else {
            return ShapeModel::Unknown {
                problem: "it has no geometry".to_owned(),
            };
        };
        let number =
            |text: &Option<model::AttrValue>| text.as_ref().and_then(model::AttrValue::number);
        let found = match &shape.kind {
            ShapeKind::Box { size } => size.as_ref().and_then(|size| {
                Some(ShapeModel::Box {
                    size: size.numbers()?,
                })
            }),
            ShapeKind::Cylinder { radius, length } => number(radius)
                .zip(number(length))
                .map(|(radius, length)| ShapeModel::Cylinder { radius, length }),
            ShapeKind::Capsule { radius, length } => number(radius)
                .zip(number(length))
                .map(|(radius, length)| ShapeModel::Capsule { radius, length }),
            ShapeKind::Sphere { radius } => {
                number(radius).map(|radius| ShapeModel::Sphere { radius })
            }
            ShapeKind::Mesh { filename, scale } => {
                let scale = scale
                    .as_ref()
                    .map_or(Some([1.0; 3]), model::AttrValue::numbers);
                filename
                    .as_ref()
                    .map(|file| self.mesh(file, scale.unwrap_or([1.0; 3])))
            }
            ShapeKind::Other => None,
        };
        found.unwrap_or_else(|| ShapeModel::Unknown {
            problem: "its dimensions are unknown".to_owned(),
        })
    }

    fn mesh(&mut self, name: &model::AttrValue, scale: [f64; 3]) -> ShapeModel {
        let (mesh, problem) = match self.find(name) {
            Ok(path) => (Some(self.mesh_file(&path)), None),
            Err(problem) => (None, Some(problem)),
        };
        ShapeModel::Mesh {
            uri: name.value.to_string(),
            scale,
            mesh,
            problem,
        }
    }

    /// The file that a name leads to.
    fn find(&self, name: &model::AttrValue) -> Result<PathBuf, String> {
        let from = self.file_of(name.origin).ok_or("its file is unknown")?;
        let uri = name.name().ok_or("its name is unknown")?;
        match self.session.packages.resolve_uri(uri, from).outcome {
            UriOutcome::Found(path) if self.session.vfs.is_file(&path) => Ok(path),
            UriOutcome::Found(path) => Err(format!("{} is not a file", vfs::slashed(&path))),
            UriOutcome::Missing(path) => Err(format!("{} not found", vfs::slashed(&path))),
            UriOutcome::UnknownPackage(_) => Err("its package was not found".to_owned()),
            UriOutcome::Malformed(why) => Err(why.to_owned()),
            UriOutcome::Elsewhere => Err("it is not on this computer".to_owned()),
        }
    }

    fn file_of(&self, origin: Origin) -> Option<&Path> {
        let place = self.expansion.place(origin)?;
        Some(&self.expansion.files.get(place.file)?.source.path)
    }

    fn mesh_file(&mut self, path: &Path) -> String {
        let id = self.table.id(path, self.session.vfs.state_on_disk(path));
        if self.files.contains_key(&id) {
            return id;
        }
        let mesh = self.session.meshes().get(&self.session.vfs, path);
        let beside = self.session.meshes().files(&self.session.vfs, path, &mesh);
        let files = beside
            .into_iter()
            .map(|(name, path)| (name, self.file(&path)))
            .collect();
        let bounds = mesh
            .surface
            .map(|surface| [surface.bounds.min, surface.bounds.max]);
        self.files.insert(
            id.clone(),
            MeshFile {
                bounds,
                files,
                ..self.plain(path)
            },
        );
        id
    }

    /// A file that is no mesh.
    fn file(&mut self, path: &Path) -> String {
        let id = self.table.id(path, self.session.vfs.state_on_disk(path));
        if !self.files.contains_key(&id) {
            self.files.insert(id.clone(), self.plain(path));
        }
        id
    }

    fn plain(&self, path: &Path) -> MeshFile {
        MeshFile {
            name: path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
            format: path
                .extension()
                .unwrap_or_default()
                .to_string_lossy()
                .to_lowercase(),
            bytes: self.session.vfs.size(path).unwrap_or(0),
            bounds: None,
            files: BTreeMap::new(),
        }
    }
}
