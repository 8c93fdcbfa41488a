//! The launch files of a package.

use std::path::{Path, PathBuf};

use super::super::context::{FileCx, Surroundings};
use super::manifest::Manifest;

/// The launch files in the folder `launch` of the package that a file belongs to.
pub(super) fn files(world: Surroundings<'_>, file: &Path) -> Vec<PathBuf> {
    let Some(manifest) = Manifest::around(world, file) else { return Vec::new() };
    let folder = manifest.folder.join("launch");
    let paths = world.vfs.list_dir(&folder).iter().map(|entry| folder.join(&entry.name)).collect::<Vec<_>>();
    paths.into_iter().filter(|path| is_launch(path)).collect()
}

pub(super) fn is_launch(path: &Path) -> bool {
    let name = path.file_name().map(|name| name.to_string_lossy()).unwrap_or_default();
    [".launch", ".launch.xml", ".py"].iter().any(|ending| name.ends_with(ending))
}

/// Whether a launch file of the package names a file without running xacro anywhere: it is read as it stands.
pub fn reads_as_it_stands(cx: &FileCx<'_>) -> bool {
    let Some(name) = cx.source.path.file_name().and_then(|name| name.to_str()) else { return false };
    let reads = |path: &PathBuf| {
        let file = cx.world.vfs.text(path);
        file.is_ok_and(|file| file.text.contains(name) && !file.text.contains("xacro"))
    };
    files(cx.world, &cx.source.path).iter().any(reads)
}
