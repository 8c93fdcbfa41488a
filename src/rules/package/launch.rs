//! The launch files of a package.
use std::path::{Path, PathBuf};

use super::super::context::{FileCx, RuleEnv};
use super::super::package::dependencies::manifest_around;

/// The launch files in the folder `launch` of the package that a file belongs to.
pub(super) fn files(world: RuleEnv<'_>, file: &Path) -> Vec<PathBuf> {
    let Some(manifest) = manifest_around(world, file) else {
        return Vec::new();
    };
    let folder = manifest.folder.join("launch");
    let paths = world
        .vfs
        .list_dir(&folder)
        .iter()
        .map(|entry| folder.join(&entry.name))
        .collect::<Vec<_>>();
    paths.into_iter().filter(|path| is_launch(path)).collect()
}

pub(super) fn is_launch(path: &Path) -> bool {
    let name = path
        .file_name()
        .map(|name| name.to_string_lossy())
        .unwrap_or_default();
    [".launch", ".launch.xml", ".py"]
        .iter()
        .any(|ending| name.ends_with(ending))
}

/// What a launch file that expands a description names: the program, or the package of ROS 2 whose launch files run it.
const EXPANDERS: [&str; 2] = ["xacro", "urdf_launch"];

/// Whether a launch file of the package names a file without running xacro, nor another launch file that does: it is read as
/// it stands.
pub fn reads_as_it_stands(cx: &FileCx<'_>) -> bool {
    let Some(name) = cx.source.path.file_name().and_then(|name| name.to_str()) else {
        return false;
    };
    let files = files(cx.world, &cx.source.path);
    let texts: Vec<_> = files
        .iter()
        .filter_map(|path| Some((path.file_name()?, cx.world.vfs.text(path).ok()?)))
        .collect();
    let texts = texts.iter().map(|(name, file)| (*name, &*file.text));
    let mut plain = texts
        .clone()
        .filter(|(_, text)| text.contains(name) && !expands(text));
    plain.any(|(_, text)| {
        let mut others = texts.clone().filter(|(_, other)| expands(other));
        !others.any(|(other, _)| other.to_str().is_some_and(|other| text.contains(other)))
    })
}

/// Whether a launch file runs xacro.
fn expands(text: &str) -> bool {
    EXPANDERS.iter().any(|expander| text.contains(expander))
}
