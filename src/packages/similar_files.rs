//! Files that are not where a URI points, but somewhere near.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::packages::Packages;
use super::root::{is_built, is_cache};
use super::similar::nearest;
use base::limits::{NAMESAKE_DEPTH, NAMESAKE_FILES};
use base::{FastMap, FastSet};
use vfs::Vfs;
use vfs::without_parents;

/// The files below a folder by name in small letters.
#[derive(Debug, Default)]
pub(super) struct Index(FastMap<String, Vec<PathBuf>>);

impl Packages {
    /// The files of a name in the sources around a file, whatever the case of its letters, sorted.
    pub fn files_named(&self, name: &str, from: &Path) -> Vec<PathBuf> {
        // of a very large workspace, and of folders that tools made, not all files are in the index
        let package = self.containing(from).map(|package| package.folder);
        let own = from.parent().map(Path::to_owned);
        let folders = package
            .into_iter()
            .chain(own)
            .chain(self.sources_around(from));
        let mut found: Vec<PathBuf> = folders
            .flat_map(|folder| {
                let index = self
                    .indexes
                    .get(folder.clone(), || Arc::new(Index::of(&self.vfs, &folder)));
                index
                    .0
                    .get(&name.to_lowercase())
                    .cloned()
                    .unwrap_or_default()
            })
            .collect();
        found.sort();
        found.dedup();
        found
    }

    /// A file of the name of `missing`, whatever the case of its letters, in `package` (a folder), else in the
    /// workspace around `from`: the one whose folders are most like those of `missing`, if there is only one.
    pub fn namesake(&self, missing: &Path, package: Option<&Path>, from: &Path) -> Option<PathBuf> {
        let name = missing.file_name()?.to_str()?.to_lowercase();
        let own = self.containing(from).map(|package| package.folder);
        let around = self.workspace(without_parents(&self.vfs.absolute(from)).parent()?);
        let folders = package
            .map(Path::to_owned)
            .into_iter()
            .chain(own)
            .chain(around);
        folders.into_iter().find_map(|folder| {
            let index = self
                .indexes
                .get(folder.clone(), || Arc::new(Index::of(&self.vfs, &folder)));
            let others = index.0.get(&name)?.iter();
            let others =
                others.filter(|path| *path != missing && !is_of_another_kind(path, missing));
            let likeness = |path: &Path| {
                (
                    common_tail(path, missing),
                    has_similar_folder(path, missing),
                )
            };
            let mut by_likeness: Vec<_> = others.map(|path| (likeness(path), path)).collect();
            by_likeness.sort_by_key(|(likeness, _)| std::cmp::Reverse(*likeness));
            match by_likeness.as_slice() {
                [(best, path), rest @ ..] if rest.first().is_none_or(|(next, _)| next < best) => {
                    Some((*path).clone())
                }
                _ => None,
            }
        })
    }
}

impl Index {
    fn of(vfs: &Vfs, top: &Path) -> Self {
        let mut index = Self::default();
        let mut seen: FastSet<u128> = FastSet::default();
        let mut open = vec![(top.to_owned(), 0)];
        let mut files = 0;
        while let Some((folder, level)) = open.pop() {
            let is_new = vfs
                .identity(&folder)
                .is_some_and(|identity| seen.insert(identity));
            if !is_new || files > NAMESAKE_FILES {
                continue;
            }
            let entries = vfs.list_dir(&folder);
            if is_cache(&entries) {
                continue;
            }
            for entry in entries.iter() {
                let path = folder.join(&entry.name);
                if entry.is_dir {
                    let passed_over = entry.name.starts_with('.') || is_built(&entry.name);
                    if !passed_over && level < NAMESAKE_DEPTH {
                        open.push((path, level + 1));
                    }
                } else {
                    files += 1;
                    index
                        .0
                        .entry(entry.name.to_lowercase())
                        .or_default()
                        .push(path);
                }
            }
        }
        index
    }
}

/// How many names at the end of two paths are equal but for case.
fn common_tail(a: &Path, b: &Path) -> usize {
    lowercase_names(a)
        .zip(lowercase_names(b))
        .take_while(|(a, b)| a == b)
        .count()
}

/// The names of a path in small letters, the last one first.
fn lowercase_names(path: &Path) -> impl Iterator<Item = String> + '_ {
    path.iter()
        .rev()
        .map(|name| name.to_string_lossy().to_lowercase())
}

/// Whether one path is of what is seen and the other one of what collides: they hold files of the same names.
fn is_of_another_kind(a: &Path, b: &Path) -> bool {
    let (a, b) = (kinds(a), kinds(b));
    [(a, b), (b, a)]
        .into_iter()
        .any(|pair| pair == ([true, false], [false, true]))
}

/// Whether the folders of a path say that it is of what is seen, and of what collides.
fn kinds(path: &Path) -> [bool; 2] {
    let folders = path
        .parent()
        .unwrap_or(path)
        .to_string_lossy()
        .to_lowercase();
    ["visual", "collision"].map(|kind| folders.contains(kind))
}

/// Whether the folders of two files have almost the same name: `visuals`, `visual`.
fn has_similar_folder(a: &Path, b: &Path) -> bool {
    let (Some(a), Some(b)) = (folder_name(a), folder_name(b)) else {
        return false;
    };
    nearest(&a, [b.as_str()]).is_some()
}

fn folder_name(path: &Path) -> Option<String> {
    path.parent()?
        .file_name()
        .map(|name| name.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn the_likest_one_in_the_package_then_in_the_workspace() {
        let tree = Tree::new();
        for file in [
            "ws/src/a/package.xml",
            "ws/src/a/urdf/r.urdf",
            "ws/src/a/models/arm/visual/link.stl",
            "ws/src/a/models/arm/collision/link.stl",
            "ws/src/a/models/arm/visual/only_seen.stl",
            "ws/src/a/.hidden/secret.stl",
            "ws/src/b/package.xml",
            "ws/src/b/meshes/Hand.STL",
        ] {
            let name = file.split('/').nth(2).unwrap();
            tree.write(file, &format!("<package><name>{name}</name></package>"));
        }
        let env = tree.environment(&[]);
        let packages = Packages::new(tree.vfs().clone(), &env, PackageOptions::default());
        let found = |missing: &str| {
            let from = tree.path("ws/src/a/urdf/r.urdf");
            let found =
                packages.namesake(&tree.path(missing), Some(&tree.path("ws/src/a")), &from)?;
            Some(
                found
                    .strip_prefix(tree.path("ws/src"))
                    .unwrap()
                    .display()
                    .to_string(),
            )
        };
        assert_eq!(
            found("ws/src/a/meshes/visual/link.stl").as_deref(),
            Some("a/models/arm/visual/link.stl")
        );
        assert_eq!(
            found("ws/src/a/meshes/visuals/link.stl").as_deref(),
            Some("a/models/arm/visual/link.stl")
        );
        assert_eq!(found("ws/src/a/meshes/collision/only_seen.stl"), None);
        assert_eq!(
            found("ws/src/a/meshes/hand.stl").as_deref(),
            Some("b/meshes/Hand.STL")
        );
        assert_eq!(found("ws/src/a/meshes/secret.stl"), None);
        assert_eq!(found("ws/src/a/meshes/gone.stl"), None);
    }
}
