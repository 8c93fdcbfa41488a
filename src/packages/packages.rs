//! Package look-up: the one answer to `$(find pkg)`, `package://` and `model://`.

use std::any::{Any, TypeId};
use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::cache::AnswerCache;
use super::hardware::HardwareSources;
use super::install::Build;
use super::manifest::{MANIFEST, is_package_name, package_name};
use super::package_sources::{
    InstallLayout, PackageSource, Prefix, distributions, overlays, own_prefixes,
};
use super::root::workspace_root;
use super::scan::{PackageTree, Rules, scan};
use super::similar_files::Index;
use base::{FastMap, FastSet};
use vfs::{Environment, Vfs, without_parents};

/// Generation of ROS that files are written for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RosVersion {
    /// ROS 1 (noetic and before).
    Ros1,
    /// ROS 2.
    #[default]
    Ros2,
}

/// Where to look for packages.
#[derive(Clone, Debug)]
pub struct PackageOptions {
    /// Folders asked before everything else; relative ones start at the working directory.
    pub explicit: Vec<PathBuf>,
    /// Folders whose sources are searched.
    pub workspace_folders: Vec<PathBuf>,
    /// Whether the workspace found upward from the asking file is searched too.
    pub search_upward: bool,
    /// Whether AMENT_PREFIX_PATH, COLCON_PREFIX_PATH and ROS_PACKAGE_PATH are read.
    pub use_environment: bool,
    /// Whether these come before all sources, as they do for the reference, which knows nothing else.
    pub environment_first: bool,
    /// Which distributions to prefer when the environment names none.
    pub target: RosVersion,
    /// Where distributions are installed.
    pub system: PathBuf,
    /// Whether Git leaves a file out, as a layer knows that reads the rules of Git.
    pub ignored_by_git: fn(&Packages, &Path) -> bool,
}

impl Default for PackageOptions {
    fn default() -> Self {
        Self {
            explicit: Vec::new(),
            workspace_folders: Vec::new(),
            search_upward: true,
            use_environment: true,
            environment_first: false,
            target: RosVersion::default(),
            system: PathBuf::from("/opt/ros"),
            ignored_by_git: |_, _| false,
        }
    }
}

/// A package that was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FoundPackage {
    /// Its folder, spelled as the reference would print it.
    pub path: PathBuf,
    /// The kind of place that gave it.
    pub step: PackageSource,
    /// The places asked before, in order: a package that appears there would change the answer.
    pub tried: Vec<(PackageSource, PathBuf)>,
}

/// A package that was not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotFound {
    /// The name asked for.
    pub name: String,
    /// The places asked, in order.
    pub tried: Vec<(PackageSource, PathBuf)>,
}

/// A package by its manifest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Package {
    /// Its `<name>`.
    pub name: String,
    /// The folder that holds the manifest.
    pub folder: PathBuf,
}

impl Package {
    /// The path of a file in the package, with slashes; none for a file outside and for a name that is not text.
    pub fn inside(&self, file: &Path) -> Option<String> {
        let inside = file.strip_prefix(&self.folder).ok()?;
        inside.to_str().map(|_| vfs::slashed(inside))
    }

    /// The `package://` URI of a file in the package.
    pub fn uri(&self, file: &Path) -> Option<String> {
        Some(format!("package://{}/{}", self.name, self.inside(file)?))
    }
}

/// A line of the table of all packages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackageEntry {
    /// The package.
    pub name: String,
    /// Its folder.
    pub path: PathBuf,
    /// The kind of place that gave it.
    pub step: PackageSource,
    /// Whether an entry above has the same name and wins.
    pub shadowed: bool,
}

/// The package look-up. Folders are searched when an answer needs them, and remembered until
/// [`Packages::forget`].
pub struct Packages {
    pub(super) vfs: Arc<Vfs>,
    pub(super) env: Environment,
    options: PackageOptions,
    trees: AnswerCache<(PathBuf, Rules), Arc<PackageTree>>,
    owners: AnswerCache<PathBuf, Option<Package>>,
    roots: AnswerCache<PathBuf, Option<PathBuf>>,
    /// The widest folders of sources around files, by the folders of these.
    pub(super) sources: AnswerCache<PathBuf, Option<PathBuf>>,
    installed: AnswerCache<Prefix, Arc<Vec<String>>>,
    pub(super) indexes: AnswerCache<PathBuf, Arc<Index>>,
    pub(super) builds: AnswerCache<PathBuf, Arc<Build>>,
    /// What the sources in C++ say about hardware, by folder.
    pub(super) hardware: AnswerCache<PathBuf, Arc<HardwareSources>>,
    /// Names of packages without a manifest, by folder.
    pub(super) unlisted_names: AnswerCache<PathBuf, Option<String>>,
    /// Packages without a manifest below a folder of sources, by the folder.
    unlisted: AnswerCache<(PathBuf, Rules), Arc<FastMap<String, PathBuf>>>,
    /// The packages that names of missing ones seem to mean, by the name and the folder of the asking file.
    pub(super) meant: AnswerCache<(String, PathBuf), Option<String>>,
    /// What the manifests below a folder of sources mention, by the folder.
    pub(super) mentioned: AnswerCache<(PathBuf, Rules), Arc<FastSet<String>>>,
    /// Whether the build tools pass over a package, by folder.
    pub(super) unbuilt: AnswerCache<PathBuf, bool>,
    /// What other layers read off folders, by its type.
    others: AnswerCache<(TypeId, PathBuf), Arc<dyn Any + Send + Sync>>,
}

impl Packages {
    /// A look-up in `vfs`, as seen from `env`.
    pub fn new(vfs: Arc<Vfs>, env: &Environment, options: PackageOptions) -> Self {
        Self {
            vfs,
            env: env.clone(),
            options,
            trees: AnswerCache::default(),
            owners: AnswerCache::default(),
            meant: AnswerCache::default(),
            mentioned: AnswerCache::default(),
            unbuilt: AnswerCache::default(),
            roots: AnswerCache::default(),
            sources: AnswerCache::default(),
            installed: AnswerCache::default(),
            indexes: AnswerCache::default(),
            builds: AnswerCache::default(),
            hardware: AnswerCache::default(),
            unlisted_names: AnswerCache::default(),
            unlisted: AnswerCache::default(),
            others: AnswerCache::default(),
        }
    }

    /// The folder of package `name` for a reference in `from_file`.
    ///
    /// # Errors
    /// When no place has it. A text that cannot be the name of a package is found nowhere. [`Packages::meant`] says which
    /// one may be meant.
    pub fn find(&self, name: &str, from_file: &Path) -> Result<FoundPackage, NotFound> {
        let mut tried = Vec::new();
        if is_package_name(name) {
            for step in self.order() {
                if let Some(path) = self.look(step, name, from_file, &mut tried) {
                    return Ok(FoundPackage { path, step, tried });
                }
            }
        }
        Err(NotFound {
            name: name.to_owned(),
            tried,
        })
    }

    /// The packages that the manifest of the package around `from_file` says it needs when it runs, found or not.
    pub fn declared(&self, from_file: &Path) -> Vec<String> {
        let owner = self.containing(from_file);
        let manifest = owner.and_then(|owner| self.vfs.text(&owner.folder.join(MANIFEST)).ok());
        let Some(manifest) = manifest else {
            return Vec::new();
        };
        let elements = manifest
            .text
            .split('<')
            .filter_map(|part| part.split_once('>'));
        let is_need = |(tag, _): &(&str, &str)| {
            let name = tag.split_whitespace().next().unwrap_or("");
            matches!(name, "depend" | "exec_depend" | "run_depend")
        };
        let names = elements.filter(is_need).map(|(_, text)| text.trim());
        names
            .filter(|name| is_package_name(name))
            .map(str::to_owned)
            .collect()
    }

    /// Every package that can be named from `from_file`, in the order of the look-up.
    pub fn all(&self, from_file: &Path) -> Vec<PackageEntry> {
        let mut entries: Vec<PackageEntry> = Vec::new();
        let mut names = FastSet::default();
        let mut places = FastSet::default();
        for step in self.order() {
            for (name, path) in self.list(step, from_file) {
                if places.insert((name.clone(), path.clone())) {
                    let shadowed = !names.insert(name.clone());
                    entries.push(PackageEntry {
                        name,
                        path,
                        step,
                        shadowed,
                    });
                }
            }
        }
        entries
    }

    /// The package that `file` lies in: the nearest manifest upward.
    pub fn containing(&self, file: &Path) -> Option<Package> {
        let is_tidy =
            file.is_absolute() && !file.components().any(|part| part == Component::ParentDir);
        let file = if is_tidy {
            Cow::from(file)
        } else {
            without_parents(&self.vfs.absolute(file)).into()
        };
        let folder = file.parent()?;
        self.owners.get(folder.to_owned(), || {
            folder.ancestors().find_map(|folder| {
                let is_package = self.vfs.is_file(&folder.join(MANIFEST));
                let name = is_package
                    .then(|| package_name(&self.vfs, folder))
                    .flatten()?;
                Some(Package {
                    name,
                    folder: folder.to_owned(),
                })
            })
        })
    }

    /// The source that a build has copied to `file`; none for sources, links to them, and what has no source here.
    pub fn source_of(&self, file: &Path) -> Option<PathBuf> {
        let (owner, folder) = self.installed_from(file)?;
        let source = folder.join(file.strip_prefix(&owner.folder).ok()?);
        let is_copy =
            self.vfs.is_file(&source) && self.vfs.canonical(&source) != self.vfs.canonical(file);
        is_copy.then_some(source)
    }

    /// The source that the installed `file` is a link to, as `colcon build --symlink-install` makes them, spelled as the
    /// look-up of packages spells it; none for sources, copies, and links to what is not in the package's sources.
    pub fn linked_source(&self, file: &Path) -> Option<PathBuf> {
        let real = self.vfs.canonical(file);
        if real == file {
            return None;
        }
        let (_, folder) = self.installed_from(file)?;
        let inside = real.strip_prefix(self.vfs.canonical(&folder)).ok()?;
        let source = folder.join(inside);
        (source != file && self.vfs.is_file(&source)).then_some(source)
    }

    /// The package that an installed file is in, and the folder with its sources.
    fn installed_from(&self, file: &Path) -> Option<(Package, PathBuf)> {
        let owner = self.containing(file)?;
        if own_prefixes(&self.vfs, file).is_empty() {
            return None;
        }
        let mut tops = self.tree_tops(PackageSource::Workspace, file).into_iter();
        let folder = tops.find_map(|(top, rules)| {
            Some(self.tree(&top, rules).get(&owner.name, file)?.to_owned())
        })?;
        Some((owner, folder))
    }

    /// Whether Git leaves a file out: it may be there on another computer.
    pub fn is_ignored_by_git(&self, file: &Path) -> bool {
        (self.options.ignored_by_git)(self, file)
    }

    /// The files that are searched.
    pub fn vfs(&self) -> &Vfs {
        &self.vfs
    }

    /// What another layer reads off a folder, until [`Packages::forget`].
    pub fn of_folder<T: Any + Send + Sync>(&self, folder: &Path, read: impl Fn() -> T) -> Arc<T> {
        let key = (TypeId::of::<T>(), folder.to_owned());
        let known = self.others.get(key, || Arc::new(read()));
        known.downcast().unwrap_or_else(|_| Arc::new(read()))
    }

    /// Forget what was searched: manifests or folders have come, gone or changed.
    pub fn forget(&self) {
        self.trees.clear();
        self.owners.clear();
        self.meant.clear();
        self.mentioned.clear();
        self.unbuilt.clear();
        self.roots.clear();
        self.sources.clear();
        self.installed.clear();
        self.indexes.clear();
        self.builds.clear();
        self.hardware.clear();
        self.others.clear();
        self.unlisted_names.clear();
        self.unlisted.clear();
    }

    /// Forget what manifests depend on: the text of one has changed.
    pub fn forget_dependencies(&self) {
        self.meant.clear();
        self.mentioned.clear();
        self.others.clear();
    }

    /// Names and folders of the packages below a folder of sources.
    pub fn below(&self, top: &Path) -> Vec<(String, PathBuf)> {
        self.tree(top, Rules::Workspace).packages().to_vec()
    }

    fn order(&self) -> Vec<PackageSource> {
        let mut order: Vec<PackageSource> = PackageSource::ALL.into();
        if !self.options.use_environment {
            order.retain(|step| !step.is_environment());
        }
        if self.options.environment_first {
            order.sort_by_key(|step| match step {
                PackageSource::PackagePath => 0,
                step if step.is_environment() => 1,
                _ => 2,
            });
        }
        order
    }

    /// What `step` says about `name`; the places asked are added to `tried`.
    fn look(
        &self,
        step: PackageSource,
        name: &str,
        from: &Path,
        tried: &mut Vec<(PackageSource, PathBuf)>,
    ) -> Option<PathBuf> {
        if step == PackageSource::OwnPackage {
            let owner = self.containing(from)?;
            tried.push((step, owner.folder.clone()));
            return (owner.name == name).then_some(owner.folder);
        }
        for (top, rules) in self.tree_tops(step, from) {
            let tree = self.tree(&top, rules);
            let found = tree
                .get(name, &without_parents(&self.vfs.absolute(from)))
                .map(Path::to_owned);
            let unlisted = || self.unlisted(&top, rules, &tree).get(name).cloned();
            if let Some(found) = found.or_else(unlisted) {
                return Some(found);
            }
            tried.push((step, top));
        }
        for prefix in self.prefixes(step, from) {
            let (found, place) = prefix.find(&self.vfs, &self.env.cwd, name);
            if found.is_some() {
                return found;
            }
            tried.push((step, place));
        }
        None
    }

    fn list(&self, step: PackageSource, from: &Path) -> Vec<(String, PathBuf)> {
        if step == PackageSource::OwnPackage {
            return self
                .containing(from)
                .into_iter()
                .map(|owner| (owner.name, owner.folder))
                .collect();
        }
        let mut found = Vec::new();
        for (top, rules) in self.tree_tops(step, from) {
            found.extend_from_slice(self.tree(&top, rules).packages());
        }
        for prefix in self.prefixes(step, from) {
            let names = self.installed_names(&prefix);
            found.extend(names.iter().map(|name| (name.clone(), prefix.folder(name))));
        }
        found
    }

    /// The packages of a tree that have no manifest: the first of each name.
    fn unlisted(
        &self,
        top: &Path,
        rules: Rules,
        tree: &PackageTree,
    ) -> Arc<FastMap<String, PathBuf>> {
        self.unlisted.get((top.to_owned(), rules), || {
            let mut names = FastMap::default();
            for folder in tree.unlisted() {
                if let Some(name) = self.unlisted_name(folder) {
                    names.entry(name).or_insert_with(|| folder.clone());
                }
            }
            Arc::new(names)
        })
    }

    /// The trees `step` searches.
    pub(super) fn tree_tops(&self, step: PackageSource, from: &Path) -> Vec<(PathBuf, Rules)> {
        let (tops, rules) = match step {
            PackageSource::PackagePath => (self.options.explicit.clone(), Rules::Explicit),
            PackageSource::Workspace => (
                self.workspaces(from, self.options.search_upward),
                Rules::Workspace,
            ),
            PackageSource::RosPackagePath => {
                (self.env.paths("ROS_PACKAGE_PATH"), Rules::RosPackagePath)
            }
            _ => return Vec::new(),
        };
        tops.into_iter()
            .map(|top| (self.env.cwd.join(top), rules))
            .collect()
    }

    /// The prefixes of installed packages `step` searches.
    fn prefixes(&self, step: PackageSource, from: &Path) -> Vec<Prefix> {
        match step {
            PackageSource::Overlay => self
                .workspaces(from, true)
                .iter()
                .flat_map(|folder| overlays(folder))
                .collect(),
            PackageSource::AmentPrefixPath => {
                self.env_prefixes("AMENT_PREFIX_PATH", &[InstallLayout::Indexed])
            }
            PackageSource::ColconPrefixPath => self.env_prefixes(
                "COLCON_PREFIX_PATH",
                &[InstallLayout::Isolated, InstallLayout::Merged],
            ),
            PackageSource::OwnPrefix => own_prefixes(&self.vfs, &self.vfs.absolute(from)),
            PackageSource::Distribution => self.distributions(),
            _ => Vec::new(),
        }
    }

    fn env_prefixes(&self, variable: &str, layouts: &[InstallLayout]) -> Vec<Prefix> {
        let paths = self.env.paths(variable).into_iter();
        paths
            .flat_map(|path| {
                layouts
                    .iter()
                    .map(move |&layout| Prefix::new(path.clone(), layout))
            })
            .collect()
    }

    /// The folders with sources: those that hold the file first, the narrowest of them first; then, if
    /// `upward`, the workspaces found above the file and above these folders.
    fn workspaces(&self, from: &Path, upward: bool) -> Vec<PathBuf> {
        let file = without_parents(&self.vfs.absolute(from));
        let mut folders: Vec<PathBuf> = self
            .options
            .workspace_folders
            .iter()
            .map(|folder| self.vfs.absolute(folder))
            .collect();
        folders.sort_by_key(|folder| {
            let depth = folder.components().count();
            if file.starts_with(folder) {
                (0, usize::MAX - depth)
            } else {
                (1, 0)
            }
        });
        if upward {
            let starts = file
                .parent()
                .into_iter()
                .chain(folders.iter().map(PathBuf::as_path));
            let above: Vec<PathBuf> = starts.filter_map(|start| self.workspace(start)).collect();
            folders.extend(above);
        }
        let mut seen = FastSet::default();
        folders.retain(|folder| seen.insert(folder.clone()));
        folders
    }

    /// The folders with sources that are searched for a reference in `from`.
    pub(super) fn source_folders(&self, from: &Path) -> Vec<PathBuf> {
        self.workspaces(from, self.options.search_upward)
    }

    /// The workspace that a folder lies in.
    pub fn workspace(&self, start: &Path) -> Option<PathBuf> {
        let home = self.env.home().map(Path::new);
        self.roots
            .get(start.to_owned(), || workspace_root(&self.vfs, start, home))
    }

    /// The distribution the environment names, else all of them.
    fn distributions(&self) -> Vec<Prefix> {
        let system = &self.options.system;
        let mut all = distributions(&self.vfs, system, self.options.target == RosVersion::Ros1);
        if self.options.use_environment {
            let named = self
                .env
                .var("ROS_DISTRO")
                .filter(|name| is_package_name(name));
            let named: Vec<PathBuf> = named.map(|name| system.join(name)).into_iter().collect();
            let of_variables = [
                "AMENT_PREFIX_PATH",
                "COLCON_PREFIX_PATH",
                "ROS_PACKAGE_PATH",
            ];
            let sourced: Vec<PathBuf> = of_variables
                .iter()
                .flat_map(|variable| self.env.paths(variable))
                .chain(named)
                .collect();
            let is_named =
                |prefix: &Prefix| sourced.iter().any(|path| path.starts_with(&prefix.path));
            if all.iter().any(is_named) {
                all.retain(is_named);
            }
        }
        all
    }

    /// The packages below `top`.
    pub(super) fn tree(&self, top: &Path, rules: Rules) -> Arc<PackageTree> {
        self.trees.get((top.to_owned(), rules), || {
            Arc::new(scan(&self.vfs, top, rules))
        })
    }

    fn installed_names(&self, prefix: &Prefix) -> Arc<Vec<String>> {
        self.installed.get(prefix.clone(), || {
            Arc::new(prefix.names(&self.vfs, &self.env.cwd))
        })
    }
}
