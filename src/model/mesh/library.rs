//! Meshes that were read.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::defect::Defect;
use super::draft::{Dependency, MeshFormat};
use super::{Mesh, Triangles, obj};
use base::FastSet;
use base::limits::{MATERIAL_BYTES, MESH_BYTES};
use base::paths::HERE;
use packages::percent_decoded;
use vfs::{FileCache, LoadError, LoadErrorKind, Vfs};

/// Meshes by path; each is read once, and again when it has changed.
#[derive(Default)]
pub struct Meshes {
    meshes: FileCache<Mesh>,
    textures: FileCache<Vec<String>>,
    looked_for: Mutex<FastSet<PathBuf>>,
}

/// A file that a mesh needs and that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MissingDependency {
    /// Its name as it is written.
    pub name: String,
    /// Whether it is an absolute path of Windows.
    pub is_windows_path: bool,
    /// The material library that names it, when the mesh itself does not.
    pub named_in: Option<String>,
}

impl Meshes {
    /// Remember that a description names a file, whether it is there or not.
    pub fn note(&self, path: &Path) {
        let mut paths = self
            .looked_for
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        if !paths.contains(path) {
            paths.insert(path.to_owned());
        }
    }

    /// The files that descriptions named so far.
    pub fn looked_for(&self) -> BTreeSet<PathBuf> {
        self.looked_for
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .iter()
            .cloned()
            .collect()
    }

    /// The mesh in a file.
    pub fn get(&self, vfs: &Vfs, path: &Path) -> Arc<Mesh> {
        let make =
            |bytes: Vec<u8>| Mesh::read(&ending(path), &bytes, &|name| beside(vfs, path, name));
        let read = vfs.cached_read(&self.meshes, path, MESH_BYTES, make);
        read.unwrap_or_else(|error| {
            let (format, dependencies) = (MeshFormat::Other, Vec::new());
            let defect = Some(unreadable(&error));
            Arc::new(Mesh {
                format,
                surface: None,
                defect,
                unit: None,
                up_axis: None,
                dependencies,
            })
        })
    }

    /// The triangles in a file. They are read each time: only who draws them needs more than [`Meshes::get`] keeps.
    ///
    /// # Errors
    /// What is wrong with the file, when it has no triangles that can be drawn.
    pub fn triangles(vfs: &Vfs, path: &Path) -> Result<Triangles, Defect> {
        let bytes = vfs
            .bytes(path, MESH_BYTES)
            .map_err(|error| unreadable(&error))?;
        Triangles::read(&ending(path), &bytes, &|name| beside(vfs, path, name))
    }

    /// The files that the mesh at `path` needs and that are not there. What files say that do not belong to the robot,
    /// as `belongs` tells, is not repeated.
    pub fn missing(
        &self,
        vfs: &Vfs,
        path: &Path,
        mesh: &Mesh,
        belongs: &dyn Fn(&Path) -> bool,
    ) -> Vec<MissingDependency> {
        let mut missing = Vec::new();
        if mesh.dependencies.is_empty() || !belongs(path) {
            return missing;
        }
        for Dependency {
            name,
            is_material_library,
        } in &mesh.dependencies
        {
            // several libraries may be named in one line; a name may have blanks
            let words = name.split_whitespace().collect::<Vec<_>>();
            let is_list = *is_material_library
                && find(vfs, path, name).is_none()
                && words.iter().any(|word| find(vfs, path, word).is_some());
            for name in if is_list { words } else { vec![name.as_str()] } {
                match find(vfs, path, name) {
                    None => missing.push(MissingDependency::new(name, None)),
                    Some(library) if *is_material_library && belongs(&library) => {
                        missing.extend(self.missing_textures(vfs, &library, name));
                    }
                    Some(_) => {}
                }
            }
        }
        missing
    }

    /// The files that the mesh at `path` needs and that are there, by the names they have in it, with the textures of
    /// its material libraries.
    pub fn files(&self, vfs: &Vfs, path: &Path, mesh: &Mesh) -> Vec<(String, PathBuf)> {
        let mut files = Vec::new();
        for Dependency {
            name,
            is_material_library,
        } in &mesh.dependencies
        {
            let found: Vec<_> = match named_file(vfs, path, name) {
                None if *is_material_library => name
                    .split_whitespace()
                    .filter_map(|word| named_file(vfs, path, word))
                    .collect(),
                whole => whole.into_iter().collect(),
            };
            for (_, library) in found.iter().filter(|_| *is_material_library) {
                let make = |bytes: Vec<u8>| obj::textures(&bytes);
                let read = vfs.cached_read(&self.textures, library, MATERIAL_BYTES, make);
                files.extend(
                    read.unwrap_or_default()
                        .iter()
                        .filter_map(|name| named_file(vfs, library, name)),
                );
            }
            files.extend(found);
        }
        files
    }

    fn missing_textures(&self, vfs: &Vfs, library: &Path, name: &str) -> Vec<MissingDependency> {
        let make = |bytes: Vec<u8>| obj::textures(&bytes);
        let textures = vfs
            .cached_read(&self.textures, library, MATERIAL_BYTES, make)
            .unwrap_or_default();
        let gone = textures
            .iter()
            .filter(|texture| find(vfs, library, texture).is_none());
        gone.map(|texture| MissingDependency::new(texture, Some(name)))
            .collect()
    }
}

impl MissingDependency {
    fn new(name: &str, named_in: Option<&str>) -> Self {
        let path = name.trim_start_matches("file:").trim_start_matches('/');
        let drive = path
            .split_once(':')
            .is_some_and(|(drive, rest)| drive.len() == 1 && rest.starts_with(['/', '\\']));
        let is_windows_path = drive || name.starts_with("\\\\");
        Self {
            name: name.to_owned(),
            is_windows_path,
            named_in: named_in.map(str::to_owned),
        }
    }
}

/// The ending of a file in small letters.
fn ending(path: &Path) -> String {
    path.extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase()
}

/// The bytes of a file that the mesh at `path` names; none when it is not there.
fn beside(vfs: &Vfs, path: &Path, name: &str) -> Option<Vec<u8>> {
    let path = first_file(vfs, path, name)?;
    vfs.bytes(&path, MESH_BYTES).ok()
}

fn unreadable(error: &LoadError) -> Defect {
    match error.kind {
        LoadErrorKind::TooLarge { limit } => {
            Defect::too_large(format!("it has more than {} megabytes", limit / 1_000_000))
        }
        LoadErrorKind::PermissionDenied | LoadErrorKind::Other => {
            Defect::unread(format!("it cannot be read: {}", error.reason()))
        }
        _ => Defect::corrupt(format!("it cannot be read: {}", error.reason())),
    }
}

/// The file that `name` means in the file at `path`; names on other machines or in packages count as found.
fn find(vfs: &Vfs, path: &Path, name: &str) -> Option<PathBuf> {
    let elsewhere = ["http:", "https:", "package:", "model:"]
        .iter()
        .any(|scheme| name.starts_with(scheme));
    if elsewhere {
        return Some(PathBuf::from(name));
    }
    first_file(vfs, path, name)
}

/// The file that `name` means in the file at `path`, with that name.
fn named_file(vfs: &Vfs, path: &Path, name: &str) -> Option<(String, PathBuf)> {
    first_file(vfs, path, name).map(|found| (name.to_owned(), found))
}

/// The first of the places of a file where there is one.
fn first_file(vfs: &Vfs, path: &Path, name: &str) -> Option<PathBuf> {
    candidates(path, name)
        .into_iter()
        .find(|path| vfs.is_file(path))
}

/// The places where a file named in another one may be.
fn candidates(path: &Path, name: &str) -> Vec<PathBuf> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let of_uri = name
        .strip_prefix("file:")
        .and_then(|rest| HERE.of_file_uri(rest));
    let plain = of_uri
        .as_deref()
        .or_else(|| name.strip_prefix("file://"))
        .unwrap_or(name);
    let mut spellings = vec![plain.to_owned(), plain.replace('\\', "/")];
    spellings.extend(percent_decoded(plain));
    spellings
        .into_iter()
        .map(|spelling| folder.join(spelling))
        .collect()
}
