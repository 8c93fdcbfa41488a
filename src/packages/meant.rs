//! Which package is meant by a name that no package has.
use std::path::Path;
use std::sync::Arc;

use super::manifest::{MANIFEST, is_package_name};
use super::package_sources::PackageSource;
use super::packages::{PackageEntry, Packages};
use super::similar::{edit_distance, has_part, is_another, nearest};
use base::FastSet;

/// Letters that a slip of the fingers changes.
const SLIP: usize = 2;

impl Packages {
    /// The known package that the name of a missing one seems to mean in `from`: at most two letters differ, or one name is the
    /// other with words in front or behind. None when a package depends on the one that is missing: it exists somewhere.
    pub fn meant(&self, name: &str, from: &Path) -> Option<String> {
        let folder = from.parent().unwrap_or(from);
        let key = (name.to_owned(), folder.to_owned());
        self.meant.get(key, || self.nearest_package(name, from))
    }

    fn nearest_package(&self, name: &str, from: &Path) -> Option<String> {
        let manifest = self
            .containing(from)
            .and_then(|owner| self.manifest(&owner.folder));
        let declared = || manifest.as_deref().into_iter().flat_map(between_tags);
        if declared().any(|declared| declared == name) || self.is_mentioned(name, from) {
            return None;
        }
        let known = self.all(from);
        let names = known.iter().map(|entry| entry.name.as_str());
        let near = nearest(
            name,
            names.chain(declared().filter(|name| is_package_name(name))),
        );
        let near = near.filter(|near| edit_distance(name, near) <= SLIP && !is_another(name, near));
        near.or_else(|| self.longer(name, from, &known))
            .map(str::to_owned)
    }

    /// The package whose name is the other with words in front or behind, of which the nearest in length.
    fn longer<'k>(&self, name: &str, from: &Path, known: &'k [PackageEntry]) -> Option<&'k str> {
        // only among sources: of all that is installed, something always begins alike
        let is_source = |entry: &&PackageEntry| {
            entry.step <= PackageSource::Workspace && entry.step != PackageSource::OwnPackage
        };
        let is_alike =
            |entry: &&PackageEntry| has_part(&entry.name, name) || has_part(name, &entry.name);
        // a package that adapts another one carries its name: the own package proves nothing
        let own = self.containing(from).map(|own| own.name);
        let alike = known
            .iter()
            .filter(is_source)
            .filter(is_alike)
            .filter(|entry| !self.is_metapackage(&entry.path))
            .filter(|entry| own.as_ref() != Some(&entry.name));
        let nearness = |entry: &&PackageEntry| entry.name.len().abs_diff(name.len());
        Some(alike.min_by_key(nearness)?.name.as_str())
    }

    /// Whether a manifest of the workspace has a text between two tags that is this name: what a package depends on is there
    /// somewhere.
    fn is_mentioned(&self, name: &str, from: &Path) -> bool {
        let tops = self.tree_tops(PackageSource::Workspace, from);
        tops.into_iter().any(|(top, rules)| {
            let mentioned = self.mentioned.get((top.clone(), rules), || {
                let tree = self.tree(&top, rules);
                let folders = tree.packages().iter().map(|(_, folder)| folder);
                let manifests: Vec<String> = folders.filter_map(|at| self.manifest(at)).collect();
                let names = manifests.iter().flat_map(|manifest| between_tags(manifest));
                let names: FastSet<String> = names
                    .filter(|name| is_package_name(name))
                    .map(str::to_owned)
                    .collect();
                Arc::new(names)
            });
            mentioned.contains(name)
        })
    }

    /// Whether a package is only there for what it depends on: no file of it can be meant.
    fn is_metapackage(&self, folder: &Path) -> bool {
        self.manifest(folder)
            .is_some_and(|manifest| manifest.contains("<metapackage"))
    }

    /// The text of the manifest in a folder.
    fn manifest(&self, folder: &Path) -> Option<String> {
        let path = self.env.cwd.join(folder).join(MANIFEST);
        Some(self.vfs.text(&path).ok()?.text.to_string())
    }
}

/// Each text between two tags of a manifest: the names of dependencies are among them.
fn between_tags(manifest: &str) -> impl Iterator<Item = &str> {
    manifest
        .split('>')
        .filter_map(|part| Some(part.split_once('<')?.0.trim()))
}
