//! Meshes and textures of an expanded robot under names that work elsewhere: `--strip-protocols`, `--relative-paths` and
//! `--copy-assets-to` of `expand`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use base::FastMap;
use base::limits::MESH_BYTES;
use expand::{Expansion, XAttr, XId};
use model::Meshes;
use packages::{Packages, UriOutcome};
use vfs::{Vfs, relative, slashed, without_parents};

/// What is done with the names of assets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AssetOptions {
    /// `--strip-protocols`: paths in place of `package://`, `file://` and `model://`.
    pub strip_protocols: bool,
    /// `--relative-paths`: paths from the folder of the output.
    pub relative_paths: bool,
    /// `--copy-assets-to`
    pub copy_to: Option<String>,
}

impl AssetOptions {
    /// Whether any name changes.
    pub fn are_given(&self) -> bool {
        self.strip_protocols || self.relative_paths || self.copy_to.is_some()
    }
}

/// Where an expansion read from, and where its output goes.
pub(super) struct AssetPaths<'p> {
    pub vfs: &'p Vfs,
    pub packages: &'p Packages,
    pub cwd: &'p Path,
    /// The folder of the output.
    pub output: &'p Path,
}

/// Rename the assets of a robot, and copy them where that is asked for. Answers with what is to be said about those
/// that keep their names.
///
/// # Errors
/// A sentence about the file that could not be copied.
pub(super) fn rename(
    expansion: &mut Expansion,
    options: &AssetOptions,
    places: &AssetPaths<'_>,
) -> Result<Vec<String>, String> {
    let named = named_assets(expansion, places.cwd);
    let around = places
        .packages
        .around(expansion.files.first().map(|root| &*root.source.path));
    let belongs = |path: &Path| is_asset(path) && around.hold(path);
    let mut names: BTreeMap<PathBuf, String> = BTreeMap::new();
    let mut complaints: BTreeSet<String> = BTreeSet::new();
    let mut copies = options
        .copy_to
        .as_ref()
        .map(|folder| AssetCopies::to(without_parents(&places.cwd.join(folder))));
    for (id, attr, from) in named {
        let path = match asset(&attr.value, &from, places, &belongs) {
            Ok(path) => path,
            Err(why) => {
                complaints.insert(format!("`{}` is unchanged: {why}", attr.value));
                continue;
            }
        };
        let new = match names.get(&path) {
            Some(known) => known.clone(),
            None => {
                let place = match &mut copies {
                    Some(copies) => copies.copy_mesh(&path, places, &belongs)?,
                    None => path.clone(),
                };
                let is_relative =
                    options.relative_paths || copies.is_some() && !options.strip_protocols;
                let new = slashed(&if is_relative {
                    relative(places.output, &place)
                } else {
                    place
                });
                names.insert(path, new.clone());
                new
            }
        };
        expansion.tree.set_attr(
            id,
            XAttr {
                value: new.into(),
                pieces: Box::default(),
                ..attr
            },
        );
    }
    complaints.extend(copies.into_iter().flat_map(|copies| copies.left_out));
    Ok(complaints.into_iter().collect())
}

/// The elements that name a mesh or a texture, with the attribute and the file that it stands in.
fn named_assets(expansion: &Expansion, cwd: &Path) -> Vec<(XId, XAttr, PathBuf)> {
    let tree = &expansion.tree;
    let elements = tree
        .below(XId::DOCUMENT)
        .filter(|&id| ["mesh", "texture"].contains(&tree.get(id).text.as_str()));
    let named = elements.filter_map(|id| {
        let attr = tree
            .attr(id, "filename")
            .filter(|attr| !attr.value.is_empty())?;
        let place = expansion.place(attr.origin);
        let file = place.and_then(|place| expansion.files.get(place.file));
        let from = file.map_or_else(
            || cwd.join("robot.urdf"),
            |file| file.source.path.to_path_buf(),
        );
        Some((id, attr.clone(), from))
    });
    named.collect()
}

/// The file that a name means; or why it is left as it is.
fn asset(
    name: &str,
    from: &Path,
    places: &AssetPaths<'_>,
    belongs: &dyn Fn(&Path) -> bool,
) -> Result<PathBuf, String> {
    let path = match places.packages.resolve_uri(name, from).outcome {
        UriOutcome::Found(path) => path,
        UriOutcome::Missing(path) => {
            return Err(format!("`{}` does not exist", vfs::slashed(&path)));
        }
        UriOutcome::UnknownPackage(error) => {
            return Err(format!("package `{}` not found", error.name));
        }
        UriOutcome::Malformed(why) => return Err(why.to_owned()),
        UriOutcome::Elsewhere => return Err("it is not a file on this machine".to_owned()),
    };
    // what a description names may be anything, such as a key: it is not carried away
    if !belongs(&path) {
        return Err("it is not a mesh or picture in a package or beside the robot".to_owned());
    }
    Ok(path)
}

/// Whether a file is a mesh, a material or a picture by its name.
fn is_asset(path: &Path) -> bool {
    const ENDINGS: [&str; 17] = [
        "stl", "dae", "obj", "mtl", "gltf", "glb", "bin", "ply", "png", "jpg", "jpeg", "tga",
        "bmp", "tif", "tiff", "dds", "webp",
    ];
    let ending = path
        .extension()
        .and_then(|ending| ending.to_str())
        .unwrap_or("");
    ENDINGS
        .iter()
        .any(|known| ending.eq_ignore_ascii_case(known))
}

/// The copies of assets in one folder: of a package by its name and the path inside it, of other files by their folder.
struct AssetCopies {
    folder: PathBuf,
    /// Which file each copy is of.
    of: FastMap<PathBuf, PathBuf>,
    meshes: Meshes,
    left_out: Vec<String>,
}

impl AssetCopies {
    fn to(folder: PathBuf) -> Self {
        Self {
            folder,
            of: FastMap::default(),
            meshes: Meshes::default(),
            left_out: Vec::new(),
        }
    }

    /// Copy a mesh and the files that it needs; answers with the place of the copy.
    fn copy_mesh(
        &mut self,
        path: &Path,
        places: &AssetPaths<'_>,
        belongs: &dyn Fn(&Path) -> bool,
    ) -> Result<PathBuf, String> {
        let copy = self.copy(path, places)?;
        let mesh = self.meshes.get(places.vfs, path);
        for (name, needed) in self.meshes.files(places.vfs, path, &mesh) {
            // the mesh keeps the name: the copy must lie at the same place beside it
            let from = path.parent().unwrap_or(Path::new(""));
            let beside = copy
                .parent()
                .unwrap_or(Path::new(""))
                .join(relative(from, &needed));
            let inside = without_parents(&beside);
            if !inside.starts_with(&self.folder) || !belongs(&needed) {
                self.left_out.push(format!(
                    "`{name}`, which `{}` needs, is not copied",
                    vfs::slashed(path)
                ));
                continue;
            }
            self.copy_as(&needed, inside, places)?;
        }
        Ok(copy)
    }

    fn copy(&mut self, path: &Path, places: &AssetPaths<'_>) -> Result<PathBuf, String> {
        let package = places.packages.containing(path);
        let below = package.and_then(|package| {
            Some(Path::new(&package.name).join(path.strip_prefix(&package.folder).ok()?))
        });
        let parts = path.iter().rev().take(2).collect::<Vec<_>>();
        let below = below.unwrap_or_else(|| parts.into_iter().rev().collect());
        let mut place = self.folder.join(&below);
        let mut number = 2;
        while self.of.get(&place).is_some_and(|other| other != path) {
            place = self.folder.join(number.to_string()).join(&below);
            number += 1;
        }
        self.copy_as(path, place, places)
    }

    fn copy_as(
        &mut self,
        path: &Path,
        place: PathBuf,
        places: &AssetPaths<'_>,
    ) -> Result<PathBuf, String> {
        if self.of.insert(place.clone(), path.to_owned()).is_none() {
            let bytes = places.vfs.bytes(path, MESH_BYTES);
            let bytes = bytes.map_err(|error| {
                format!("cannot read {}: {}", vfs::slashed(path), error.reason())
            })?;
            vfs::write_atomically(&place, &bytes)
                .map_err(|error| format!("cannot write {}: {error}", vfs::slashed(&place)))?;
        }
        Ok(place)
    }
}
