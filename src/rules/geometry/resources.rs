//! The files that a description names: where they are, and the meshes in them.
use std::cell::LazyCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rayon::prelude::*;

use super::super::context::{DocumentCx, RuleEnv};
use super::super::geometry::target::{FileLookup, Resources};
use super::super::grouping::Group;
use super::uri::defect;
use base::FastMap;
use expand::{Expansion, FileIdx, XId, XTree};
use model::{AttrValue, Link, Mesh, Robot, Shape, ShapeKind};
use packages::{UriKind, UriOutcome};

/// A mesh that a visual or collision names.
pub struct MeshUse<'a> {
    /// The link.
    pub link: &'a Link,
    /// Whether it is a collision.
    pub is_collision: bool,
    /// The element `mesh`.
    pub element: XId,
    /// Its `filename`.
    pub file: &'a AttrValue,
    /// Its `scale`.
    pub scale: Option<&'a AttrValue>,
    /// Where the name leads.
    pub target: &'a FileLookup,
    /// The mesh, when there is a file.
    pub mesh: Option<&'a Mesh>,
}

impl MeshUse<'_> {
    /// The factors along the axes; none when they are not known.
    pub fn factors(&self) -> Option<[f64; 3]> {
        factors(self.scale)
    }

    /// What makes one finding of several about the file.
    pub fn group(&self) -> Group {
        self.target.place().map_or(Group::File, |path| {
            Group::Thing(path.to_string_lossy().into())
        })
    }

    /// What makes one finding of several about the files of a folder: the program that wrote one of them wrote all of them.
    pub fn folder_group(&self) -> Group {
        let folder = self.target.place().and_then(Path::parent);
        folder.map_or(Group::File, |path| {
            Group::Thing(path.to_string_lossy().into())
        })
    }

    /// The name of the file for messages, without folders.
    pub fn name(&self) -> &str {
        self.file
            .value
            .rsplit(['/', '\\'])
            .next()
            .unwrap_or_default()
    }
}

/// The factors of a scale that may be absent; none when they are not known.
pub fn factors(scale: Option<&AttrValue>) -> Option<[f64; 3]> {
    scale.map_or(Some([1.0; 3]), AttrValue::numbers)
}

impl DocumentCx<'_> {
    /// The meshes that visuals and collisions name, in document order.
    pub(in super::super) fn meshes(&self) -> impl Iterator<Item = MeshUse<'_>> {
        let resources = self.resources();
        self.mesh_references().iter().filter_map(|named| {
            let (target, mesh) = resources.meshes.get(&named.element)?;
            let &MeshReference {
                link,
                is_collision,
                element,
                file,
                scale,
            } = named;
            let mesh = mesh.as_deref();
            Some(MeshUse {
                link,
                is_collision,
                element,
                file,
                scale,
                target,
                mesh,
            })
        })
    }

    /// The meshes that visuals and collisions name, looked for once.
    fn mesh_references(&self) -> &[MeshReference<'_>] {
        let robot = self.robot.into_iter();
        self.mesh_references
            .get_or_init(|| robot.flat_map(named).collect())
    }

    fn resources(&self) -> &Resources {
        self.look_beyond();
        self.resources.get_or_init(|| read_meshes(self))
    }

    /// The mesh of a shape, when its file could be read.
    pub(in super::super) fn mesh(&self, shape: &Shape) -> Option<&Mesh> {
        let resources = self.resources();
        resources.meshes.get(&shape.element)?.1.as_deref()
    }
}

/// A mesh before its file is looked for.
pub(in super::super) struct MeshReference<'a> {
    link: &'a Link,
    is_collision: bool,
    element: XId,
    file: &'a AttrValue,
    scale: Option<&'a AttrValue>,
}

fn named(robot: &Robot) -> impl Iterator<Item = MeshReference<'_>> {
    let bodies = robot.links.iter().flat_map(|link| {
        let visuals = link.visuals.iter().map(|body| (body, false));
        let all = visuals.chain(link.collisions.iter().map(|body| (body, true)));
        all.map(move |(body, is_collision)| (link, body, is_collision))
    });
    bodies.filter_map(|(link, body, is_collision)| {
        let shape = body.shape()?;
        let ShapeKind::Mesh {
            filename: Some(file),
            scale,
        } = &shape.kind
        else {
            return None;
        };
        Some(MeshReference {
            link,
            is_collision,
            element: shape.element,
            file,
            scale: scale.as_ref(),
        })
    })
}

/// Find the files that meshes name, and read them.
fn read_meshes(cx: &DocumentCx<'_>) -> Resources {
    let mut known: FastMap<(Option<FileIdx>, &str), FileLookup> = FastMap::default();
    let mut targets = Vec::new();
    let compiler = LazyCell::new(|| compiler(&cx.expansion.tree));
    for named in cx.mesh_references() {
        let file = cx
            .expansion
            .place(named.file.origin)
            .map(|place| place.file);
        let target = if named.file.is_known() {
            let key = (file, named.file.value.as_str());
            known
                .entry(key)
                .or_insert_with(|| {
                    let target = resolve(cx.expansion, cx.world, named.file);
                    let is_missing = matches!(target, FileLookup::Missing(..));
                    let compiler = is_missing.then(|| *compiler).flatten();
                    let found = compiler
                        .and_then(|compiler| in_mesh_folder(cx, compiler, &named.file.value));
                    found.unwrap_or(target)
                })
                .clone()
        } else {
            FileLookup::Unknown
        };
        targets.push((named.element, target));
    }
    let mut paths: Vec<&Path> = targets
        .iter()
        .filter_map(|(_, target)| target.file())
        .collect();
    paths.sort_unstable();
    paths.dedup();
    let (meshes, vfs) = (cx.world.meshes, cx.world.vfs);
    known
        .values()
        .filter_map(FileLookup::place)
        .for_each(|path| meshes.note(path));
    let get = |path: &&Path| meshes.get(vfs, path);
    // threads are only started where there is work for them
    let read: Vec<Arc<Mesh>> = match paths.len() {
        0 | 1 => paths.iter().map(get).collect(),
        _ => paths.par_iter().map(get).collect(),
    };
    let read: FastMap<&Path, Arc<Mesh>> = paths.into_iter().zip(read).collect();
    Resources {
        meshes: targets
            .iter()
            .map(|(id, target)| {
                let mesh = target.file().and_then(|path| read.get(path).cloned());
                (*id, (target.clone(), mesh))
            })
            .collect(),
    }
}

/// The settings of MuJoCo in a robot: `<mujoco><compiler meshdir="..."/>`.
fn compiler(tree: &XTree) -> Option<XId> {
    child(tree, child(tree, tree.root()?, "mujoco")?, "compiler")
}

/// Where MuJoCo finds a mesh that is missing elsewhere: in the folder that its settings name, by the name of the file alone unless
/// they say `strippath="false"`.
fn in_mesh_folder(cx: &DocumentCx<'_>, compiler: XId, name: &str) -> Option<FileLookup> {
    let tree = &cx.expansion.tree;
    let keeps_path = tree
        .attr(compiler, "strippath")
        .is_some_and(|attr| attr.value == "false");
    let name = if keeps_path {
        name
    } else {
        name.rsplit(['/', '\\']).next()?
    };
    let root = &cx.expansion.files.first()?.source.path;
    let folder = tree.attr(compiler, "meshdir")?.value.as_str();
    let path = vfs::without_parents(&root.parent()?.join(folder).join(name));
    cx.world
        .vfs
        .is_file(&path)
        .then_some(FileLookup::File(path))
}

/// The first child element of a name.
fn child(tree: &XTree, element: XId, name: &str) -> Option<XId> {
    tree.elements(element).find(|&id| tree.get(id).text == name)
}

/// Find the file that an attribute names.
pub fn resolve(expansion: &Expansion, world: RuleEnv<'_>, name: &AttrValue) -> FileLookup {
    let place = expansion
        .place(name.origin)
        .filter(|_| name.is_known() && !name.value.trim().is_empty());
    let Some(place) = place else {
        return FileLookup::Unknown;
    };
    let files = [place.file, FileIdx(0)];
    let from = files.map(|file| {
        expansion
            .files
            .get(file)
            .map(|file| file.source.path.as_ref())
    });
    let mut first = None;
    // a relative path counts from the file it stands in, or from the file that is loaded
    for from in from.into_iter().flatten() {
        let target = resolve_from(world, &name.value, from);
        if !matches!(target, FileLookup::Missing(..) | FileLookup::OtherCase(_)) {
            return target;
        }
        first.get_or_insert(target);
    }
    // a path with such faults leads nowhere because of them
    let faulty = matches!(first, Some(FileLookup::Missing(..))) && defect(&name.value).is_some();
    if faulty {
        FileLookup::Malformed
    } else {
        first.unwrap_or(FileLookup::Unknown)
    }
}

fn resolve_from(world: RuleEnv<'_>, uri: &str, from: &Path) -> FileLookup {
    let result = world.packages.resolve_uri(uri, from);
    let package = uri
        .strip_prefix("package://")
        .and_then(|rest| rest.split('/').next());
    let package = package
        .and_then(|name| world.packages.find(name, from).ok())
        .map(|found| world.vfs.absolute(&found.path));
    let base = match result.kind {
        UriKind::Package | UriKind::Model => package.clone(),
        UriKind::Relative => from.parent().map(Path::to_owned),
        _ => None,
    };
    match result.outcome {
        UriOutcome::Elsewhere => FileLookup::Unknown,
        UriOutcome::UnknownPackage(_) => FileLookup::Unknown,
        UriOutcome::Malformed(_) => FileLookup::Malformed,
        UriOutcome::Found(path) => {
            let path = world.vfs.absolute(&path);
            let listed = base.and_then(|base| world.vfs.as_listed(&base, &path));
            match listed.filter(|listed| *listed != path) {
                Some(listed) => FileLookup::OtherCase(listed),
                None if world.vfs.is_file(&path) => FileLookup::File(path),
                None => FileLookup::NoFile(path),
            }
        }
        UriOutcome::Missing(path) => {
            let path = world.vfs.absolute(&path);
            let base = base.unwrap_or_else(|| PathBuf::from("/"));
            match world
                .vfs
                .as_listed(&base, &path)
                .filter(|listed| world.vfs.is_file(listed))
            {
                Some(listed) if listed != path => FileLookup::OtherCase(listed),
                _ => FileLookup::Missing(path, package),
            }
        }
    }
}
