//! Repositories of others that were copied into a workspace, and what the workspace uses of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Callers;
use super::file_names;
use super::meant::may_mean;
use super::uses::Uses;
use base::FastSet;
use packages::{MANIFEST, Packages};
use vfs::Vfs;

/// Files and folders at the top of a repository that mean something only there.
const MARKS: [&str; 12] = [
    ".github",
    ".gitlab-ci.yml",
    ".travis.yml",
    ".circleci",
    ".appveyor.yml",
    "Jenkinsfile",
    ".pre-commit-config.yaml",
    ".gitmodules",
    "CODE_OF_CONDUCT.md",
    "CONTRIBUTING.md",
    "codecov.yml",
    ".codecov.yml",
];

/// Folders of what others have written.
const OTHERS: [&str; 8] = [
    "external",
    "externals",
    "vendor",
    "third_party",
    "thirdparty",
    "third-party",
    "3rdparty",
    "3rd_party",
];

/// What tools write into a manifest for somebody to fill in.
const DRAFTS: [&str; 2] = ["@todo.todo", "<license>TODO"];

/// First words of names of packages that say nothing about whose they are.
const COMMON: [&str; 10] = [
    "gazebo", "gz", "ign", "moveit", "my", "nav2", "robot", "ros", "ros2", "simple",
];

/// The folders of the repositories of others below a folder.
pub(super) type CopiedFolders = Vec<PathBuf>;

/// A package, as far as it matters whose it is.
struct PackageIdentity {
    name: String,
    folder: PathBuf,
    /// The folder of the repository that it was copied with.
    copied: Option<PathBuf>,
    /// Whether its manifest is as a tool made it, with things to be filled in: nobody else has published it.
    is_draft: bool,
    people: Vec<String>,
    /// The first words of the names of the packages that it needs.
    needs: Vec<String>,
}

impl Callers {
    /// Whether a repository of others was copied into the sources around a file.
    pub fn has_copies(&self, file: &Path) -> bool {
        !self.copies(file).is_empty()
    }

    /// The folder of the repository of others that a file was copied with into this workspace.
    pub fn copied_with(&self, file: &Path) -> Option<PathBuf> {
        around(&self.copies(file), file).map(Path::to_owned)
    }

    /// Whether a file lies in a folder of what others have written.
    pub fn is_of_others(&self, file: &Path) -> bool {
        let top = self.packages.sources_around(file);
        let inside = |folder: &&Path| top.as_ref().is_some_and(|top| folder.starts_with(top));
        let mut folders = file.ancestors().skip(1).take_while(inside);
        folders.any(is_below_others)
    }

    /// Whether a file belongs to a repository of others that was copied into this workspace, and nothing else in the workspace
    /// names it or what leads to it. `includers` gives the files that include a description.
    pub fn is_unused_copy(&self, file: &Path, includers: impl Fn(&Path) -> Vec<PathBuf>) -> bool {
        let copies = self.copies(file);
        if around(&copies, file).is_none() {
            return false;
        }
        let mut open = vec![file.to_owned()];
        let mut seen: FastSet<PathBuf> = FastSet::default();
        while let Some(file) = open.pop() {
            if around(&copies, &file).is_none() {
                return false;
            }
            let Some(users) = self.users(&file, &copies) else {
                return false;
            };
            let users = users.into_iter().chain(includers(&file));
            open.extend(users.filter(|user| !seen.contains(user)));
            seen.insert(file);
        }
        true
    }

    /// Whether a file belongs to a package of a repository of others that was copied into this workspace, and nothing else in the
    /// workspace names the package or one of that repository whose files name it.
    pub fn is_in_unused_package(&self, file: &Path) -> bool {
        let copies = self.copies(file);
        let mentions = self.mentions(file).filter(|all| all.is_whole);
        let (Some(mentions), Some(package)) = (mentions, self.packages.containing(file)) else {
            return false;
        };
        let mut open = vec![package.name];
        let mut seen: FastSet<String> = FastSet::default();
        while let Some(name) = open.pop() {
            if !seen.insert(name.clone()) {
                continue;
            }
            for by in mentions.uses(&name) {
                if around(&copies, by).is_none() {
                    return false;
                }
                open.extend(self.packages.containing(by).map(|package| package.name));
            }
        }
        around(&copies, file).is_some()
    }

    /// Whether nothing but tests names a file in a folder of tests of its package: it is what they need, right or wrong.
    pub fn is_for_tests(&self, file: &Path, includers: impl Fn(&Path) -> Vec<PathBuf>) -> bool {
        let package = self.packages.containing(file).map(|package| package.folder);
        let Some(package) = package.filter(|_| is_of_tests(file, &self.packages)) else {
            return false;
        };
        let Some(mentions) = self.mentions(file).filter(|all| all.is_whole) else {
            return false;
        };
        // tests of other &self.packages may use it as well
        let is_test = |path: &Path| {
            let is_listed = path.ends_with("CMakeLists.txt") || path.ends_with("package.xml");
            is_listed && path.starts_with(&package) || is_of_tests(path, &self.packages)
        };
        // a page that lists it is no use
        let mut named = mentions
            .of(file)
            .filter(|by| !file_names::is_page(by) && may_mean(by, file, &self.packages))
            .peekable();
        let is_included = |by: &PathBuf| !is_test(by);
        named.peek().is_some() && named.all(is_test) && !includers(file).iter().any(is_included)
    }

    /// Whether a file belongs to the tests of its package.
    pub fn is_of_tests(&self, file: &Path) -> bool {
        is_of_tests(file, &self.packages)
    }

    /// The texts that lead to a file of a copy, but for includes; none when something that runs names its package, or not all
    /// texts are known.
    fn users(&self, file: &Path, copies: &CopiedFolders) -> Option<Vec<PathBuf>> {
        let mentions = self.mentions(file).filter(|mentions| mentions.is_whole)?;
        let package = self.packages.containing(file).map(|package| package.name);
        let is_used = |package: String| {
            mentions
                .uses(&package)
                .any(|by| around(copies, by).is_none())
        };
        // whoever uses a package does not run its tests
        if !is_of_tests(file, &self.packages) && package.is_some_and(is_used) {
            return None;
        }
        let uses = self.around(file)?;
        let computing = uses.callers.iter().filter(|caller| caller.ends(file));
        let users = mentions
            .of(file)
            .chain(computing.map(|caller| &*caller.path));
        Some(
            users
                .filter(|user| may_mean(user, file, &self.packages))
                .map(Path::to_owned)
                .collect(),
        )
    }

    /// The copies in the sources around a file.
    fn copies(&self, file: &Path) -> Arc<CopiedFolders> {
        let Some(top) = self.packages.sources_around(file) else {
            return Arc::default();
        };
        let uses = || self.around(file);
        self.copies.get(top.clone(), || {
            Arc::new(copied_below(&top, &self.packages, uses))
        })
    }
}

/// Whether a file belongs to the tests of its package.
fn is_of_tests(file: &Path, packages: &Packages) -> bool {
    let Some(package) = packages.containing(file) else {
        return false;
    };
    let inside = file
        .strip_prefix(&package.folder)
        .ok()
        .and_then(Path::parent);
    let is_test =
        |name: &std::ffi::OsStr| name.to_string_lossy().to_lowercase().starts_with("test");
    inside.is_some_and(|inside| inside.iter().any(is_test))
}

/// The folder of the copy that a file lies in.
fn around<'c>(copies: &'c CopiedFolders, file: &Path) -> Option<&'c Path> {
    copies
        .iter()
        .map(PathBuf::as_path)
        .find(|folder| file.starts_with(folder))
}

/// The folders of the repositories that were copied below a folder: they have marks of a repository or are released, and share
/// neither people nor names with the packages of this one, which are drafts, or have robots. What is cloned, with a `.git` of its
/// own, may be anybody's.
fn copied_below(
    top: &Path,
    packages: &Packages,
    uses: impl FnOnce() -> Option<Arc<Uses>>,
) -> CopiedFolders {
    let member = |(name, folder): (String, PathBuf)| {
        let manifest = packages.vfs().text(&folder.join(MANIFEST));
        let manifest = manifest.as_ref().map_or("", |file| &*file.text);
        PackageIdentity {
            name,
            copied: copied_with(top, &folder, packages.vfs()),
            folder,
            is_draft: DRAFTS.iter().any(|draft| manifest.contains(draft)),
            people: people(manifest),
            needs: needs(manifest)
                .filter_map(family)
                .map(str::to_owned)
                .collect(),
        }
    };
    let mut members: Vec<PackageIdentity> = packages.below(top).into_iter().map(member).collect();
    if members.iter().all(|one| one.copied.is_none()) {
        return CopiedFolders::new();
    }
    // whoever shares people or names with packages of this repository is no other
    while let Some(folder) = related(&members) {
        let own = members
            .iter_mut()
            .filter(|one| one.copied.as_ref() == Some(&folder));
        own.for_each(|one| one.copied = None);
    }
    let has_drafts = members.iter().any(PackageIdentity::is_own_draft);
    // a repository that is published as a whole may hold what is released, and what is not yet
    let is_published = !has_drafts && has_mark(packages.vfs(), top);
    let copied = members.iter().filter_map(|one| one.copied.clone());
    let mut folders: Vec<PathBuf> = copied
        .filter(|folder| {
            !is_published
                || !members.iter().any(|one| one.folder == *folder)
                || has_mark(packages.vfs(), folder)
        })
        .collect();
    folders.sort();
    folders.dedup();
    let has_robots = |uses: Arc<Uses>| {
        let mut own = members.iter().filter(|one| one.copied.is_none());
        own.any(|one| {
            let descriptions = uses.files.values().flatten();
            let mut files = descriptions.chain(uses.callers.iter().map(|caller| &caller.path));
            files.any(|file| file.starts_with(&one.folder))
        })
    };
    let is_workspace = !folders.is_empty() && (has_drafts || uses().is_some_and(has_robots));
    if is_workspace {
        folders
    } else {
        CopiedFolders::new()
    }
}

impl PackageIdentity {
    fn is_own_draft(&self) -> bool {
        self.is_draft && self.copied.is_none()
    }
}

/// The folder of the repository that a package was copied with below a folder.
fn copied_with(top: &Path, package: &Path, vfs: &Vfs) -> Option<PathBuf> {
    let folders = package
        .ancestors()
        .take_while(|folder| folder.starts_with(top) && *folder != top);
    let is_cloned = |folder: &Path| vfs.exists(&folder.join(".git"));
    if folders.clone().any(is_cloned) {
        return None;
    }
    folders
        .filter(|folder| has_mark(vfs, folder) || is_below_others(folder))
        .last()
        .or_else(|| Some(package).filter(|package| vfs.is_file(&package.join("CHANGELOG.rst"))))
        .map(Path::to_owned)
}

/// Whether a folder lies in one of what others have written.
fn is_below_others(folder: &Path) -> bool {
    let above = folder.parent().and_then(Path::file_name);
    above.is_some_and(|above| OTHERS.iter().any(|name| above.eq_ignore_ascii_case(name)))
}

/// Whether a folder has a mark of a repository, or holds packages with a page and a license or `.gitignore` of its own.
fn has_mark(vfs: &Vfs, folder: &Path) -> bool {
    let entries = vfs.list_dir(folder);
    let has = |starts: &[&str]| {
        entries.iter().any(|entry| {
            starts
                .iter()
                .any(|start| entry.name.to_uppercase().starts_with(start))
        })
    };
    let is_package = entries.iter().any(|entry| entry.name == MANIFEST);
    entries
        .iter()
        .any(|entry| MARKS.contains(&entry.name.as_str()))
        || !is_package && has(&["README"]) && has(&["LICENSE", ".GITIGNORE"])
}

/// A copy one of whose packages shares people or the first word of its name with one of this repository, or one that it needs: with
/// the drafts, where there are some.
fn related(members: &[PackageIdentity]) -> Option<PathBuf> {
    let has_drafts = members.iter().any(PackageIdentity::is_own_draft);
    let own = members
        .iter()
        .filter(|one| one.copied.is_none() && (one.is_draft || !has_drafts));
    let known: FastSet<&String> = own.clone().flat_map(|one| &one.people).collect();
    let needed = own
        .clone()
        .flat_map(|one| one.needs.iter().map(String::as_str));
    let families: FastSet<&str> = own
        .filter_map(|one| family(&one.name))
        .chain(needed)
        .collect();
    let is_related = |one: &&PackageIdentity| {
        one.people.iter().any(|person| known.contains(person))
            || family(&one.name).is_some_and(|family| families.contains(family))
    };
    members
        .iter()
        .filter(|one| one.copied.is_some())
        .find(is_related)?
        .copied
        .clone()
}

/// The first word of the name of a package, where it says something.
fn family(name: &str) -> Option<&str> {
    name.split(['_', '-'])
        .next()
        .filter(|word| !COMMON.contains(word))
}

/// The packages that a manifest says it needs.
fn needs(manifest: &str) -> impl Iterator<Item = &str> {
    let elements = manifest.split('<').filter_map(|part| part.split_once('>'));
    let is_need = |(tag, _): &(&str, &str)| {
        let tag = tag.split_whitespace().next().unwrap_or("");
        tag.ends_with("depend") && !tag.starts_with('/') && !tag.starts_with("buildtool")
    };
    elements.filter(is_need).map(|(_, name)| name.trim())
}

/// The addresses of the people that a manifest names.
fn people(manifest: &str) -> Vec<String> {
    let address = |part: &str| {
        let quote = part.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        part.get(1..)?.split(quote).next().map(str::to_lowercase)
    };
    manifest
        .split("email=")
        .skip(1)
        .filter_map(address)
        .filter(|address| !is_example(address))
        .collect()
}

/// Whether an address stands for one that somebody is to fill in.
fn is_example(address: &str) -> bool {
    ["@example.com", "@todo.com"]
        .iter()
        .any(|end| address.ends_with(end))
}
