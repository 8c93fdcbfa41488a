//! The manifests around files, and the packages that come along with them.
use std::path::Path;
use std::sync::Arc;

use super::super::context::RuleEnv;
use super::manifest::Manifest;
use base::FastSet;
use expand::{Expansion, FileIdx};
use packages::Package;

/// Packages looked at to find what comes along with a package.
const MOST_PACKAGES: usize = 100;

/// The packages that the files of an expansion belong to.
pub(super) fn packages_of(world: RuleEnv<'_>, expansion: &Expansion) -> Vec<Package> {
    let sources = expansion.files.iter().map(|file| &file.source.path);
    let mut packages: Vec<Package> = Vec::new();
    for package in sources.filter_map(|path| world.packages.containing(path)) {
        if packages.iter().all(|known| known.folder != package.folder) {
            packages.push(package);
        }
    }
    packages
}

/// That of the package around a file of the expansion; none when there is none that can be read.
pub(super) fn manifest_around(world: RuleEnv<'_>, file: &Path) -> Option<Arc<Manifest>> {
    let package = world.packages.containing(file)?;
    let path = package.folder.join("package.xml");
    let text = world.vfs.text(&path).ok()?;
    world
        .manifests
        .get(world.vfs.file_id(&path), &text, package)
}

/// The manifests of the packages that come along with a package.
struct Brought(Vec<Arc<Manifest>>);

/// Whether a package comes along with one of those that come along, as far as they are in the workspace.
pub(super) fn brings(manifest: &Manifest, world: RuleEnv<'_>, package: &str) -> bool {
    // each file of a package asks, about each package that it names
    let read = || Brought(brought(manifest, world));
    let brought = world.packages.of_folder::<Brought>(&manifest.folder, read);
    brought.0.iter().any(|manifest| manifest.declares(package))
}

/// The manifests of the packages that come along with a package, which are looked for from there: whoever asks gets the same.
fn brought(manifest: &Manifest, world: RuleEnv<'_>) -> Vec<Arc<Manifest>> {
    let from = manifest.folder.join("package.xml");
    let mut open: Vec<String> = manifest.runtime.clone();
    let mut seen: FastSet<String> = FastSet::default();
    let mut found = Vec::new();
    while let Some(name) = open.pop() {
        if seen.len() == MOST_PACKAGES || !seen.insert(name.clone()) {
            continue;
        }
        let Ok(folder) = world.packages.find(&name, &from) else {
            continue;
        };
        if let Some(manifest) = manifest_around(world, &folder.path.join("package.xml")) {
            open.extend(manifest.runtime.iter().cloned());
            found.push(manifest);
        }
    }
    found
}

/// The manifest of the package that a file of an expansion belongs to.
pub(super) fn of_file(
    world: RuleEnv<'_>,
    expansion: &expand::Expansion,
    file: FileIdx,
) -> Option<Arc<Manifest>> {
    manifest_around(world, &expansion.files.get(file)?.source.path)
}
