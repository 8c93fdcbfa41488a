//! Where files are once a package is built: `CMakeLists.txt` and `setup.py` move files of the source tree to other
//! places below `share/PACKAGE`, and make files from templates.

mod cmake;
mod commands;
mod required;
mod setup_py;

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use self::cmake::CMAKE_LISTS;
pub use self::required::RequiredSource;
use self::setup_py::SETUP_PY;
use super::manifest::{MANIFEST, is_package_name, name_in};
use super::packages::Packages;
use base::FastSet;
use base::limits::GLOB_ENTRIES;
use vfs::Vfs;
use vfs::without_parents;

/// Names of build files: what they say decides where packages have their files.
pub const BUILD_FILES: [&str; 2] = [CMAKE_LISTS, SETUP_PY];

/// How a template is named beside the file that is made from it.
const TEMPLATE: &str = ".in";

/// How far above a package without build files one is looked for.
const BUILD_FILE_LEVELS: usize = 3;

/// A file or folder of the source tree that stands for one that only the build makes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    /// Where it is now.
    pub path: PathBuf,
    /// Whether the build makes the file from it, with variables replaced.
    pub is_template: bool,
}

/// What the build of a package does with the files of its source tree.
#[derive(Debug, Default)]
pub struct Build {
    /// The build files that were read or looked for.
    pub files: Vec<PathBuf>,
    /// Whether it installs something by rules that could not be worked out.
    pub is_opaque: bool,
    /// The stems of the files that it names outside of rules of installation: it may download or generate them.
    pub(crate) named: FastSet<String>,
    /// Whether it is one of ROS 2, which installs a package whenever it builds it.
    pub is_ament: bool,
    /// What must be there of the sources.
    required: Vec<RequiredSource>,
    /// Paths that commands name which may make files.
    made: FastSet<PathBuf>,
    /// Places of the installed package (`share/...`), of the folder of the build and of the sources, each with what
    /// is put there.
    rules: Vec<(PathBuf, InstallSource)>,
}

/// Where something comes from.
#[derive(Debug)]
enum InstallSource {
    /// A file or folder.
    Path(PathBuf),
    /// The files that a pattern matches, without their folders.
    Files(PathBuf),
    /// A file with variables to be replaced.
    Template(PathBuf),
}

/// The name of a file up to its first dot; none without one.
fn stem(name: &str) -> Option<String> {
    name.split_once('.')
        .map(|(stem, _)| stem.to_owned())
        .filter(|stem| !stem.is_empty())
}

impl Packages {
    /// What stands for a path that does not exist, below the folder of a package, once that package is built: a
    /// template beside it, or the file or folder that is installed there.
    pub fn built(&self, missing: &Path) -> Option<Built> {
        let missing = without_parents(&self.vfs.absolute(missing));
        let beside = template_of(&missing);
        if self.vfs.is_file(&beside) {
            return Some(Built {
                path: beside,
                is_template: true,
            });
        }
        let (name, folder) = self.package_around(&missing)?;
        let build = self.build(&folder);
        let share = Path::new("share")
            .join(name)
            .join(missing.strip_prefix(&folder).ok()?);
        build
            .find(&self.vfs, &share, 0)
            .or_else(|| build.find(&self.vfs, &missing, 0))
    }

    /// Whether the build of its package names a file that does not exist, or one of the same stem: it may download it, or
    /// generate it from the other.
    pub fn may_be_made(&self, missing: &Path) -> bool {
        let stem = missing
            .file_name()
            .and_then(|name| stem(&name.to_string_lossy()));
        stem.is_some_and(|stem| {
            self.build_around(missing)
                .is_some_and(|build| build.named.contains(&stem))
        })
    }

    /// The path to open for `path`: itself where it exists, else what the build puts there, else itself.
    pub fn present<'p>(&self, path: &'p Path) -> Cow<'p, Path> {
        if self.vfs.exists(path) {
            return path.into();
        }
        self.built(path)
            .map_or(path.into(), |built| built.path.into())
    }

    /// The build of the package that a path lies in.
    pub fn build_around(&self, path: &Path) -> Option<Arc<Build>> {
        let (_, folder) = self.package_around(&without_parents(&self.vfs.absolute(path)))?;
        Some(self.build(&folder))
    }

    /// Name and folder of the package that a path lies in, with or without a manifest.
    fn package_around(&self, path: &Path) -> Option<(String, PathBuf)> {
        if let Some(package) = self.containing(path) {
            return Some((package.name, package.folder));
        }
        let name = |folder: &Path| Some((self.unlisted_name(folder)?, folder.to_owned()));
        path.ancestors().skip(1).find_map(name)
    }

    /// The build of the package in `folder`. Where it has no build file, one above it may install it.
    fn build(&self, folder: &Path) -> Arc<Build> {
        self.builds.get(folder.to_owned(), || {
            let mut build = Build::default();
            for folder in folder.ancestors().take(1 + BUILD_FILE_LEVELS) {
                if self.vfs.is_file(&folder.join(CMAKE_LISTS)) && !self.is_of_python(folder) {
                    cmake::read(&self.vfs, folder, &mut build);
                    break;
                }
                build.files.push(folder.join(CMAKE_LISTS));
                setup_py::read(&self.vfs, folder, &mut build);
                if self.vfs.is_file(&folder.join(SETUP_PY)) {
                    build.is_ament |= self.is_of_python(folder);
                    break;
                }
            }
            Arc::new(build)
        })
    }

    /// Whether a package is built by its `setup.py`, whatever else lies beside it.
    fn is_of_python(&self, folder: &Path) -> bool {
        let manifest = || self.vfs.text(&folder.join(MANIFEST)).ok();
        self.vfs.is_file(&folder.join(SETUP_PY))
            && manifest().is_some_and(|file| file.text.contains("<build_type>ament_python<"))
    }

    /// The name of a package whose manifest the build makes, or that has none: what the template of the manifest or
    /// the project is called, if that project installs files for a package of its name.
    pub(super) fn unlisted_name(&self, folder: &Path) -> Option<String> {
        self.unlisted_names.get(folder.to_owned(), || {
            let project = || {
                let lists = self.vfs.text(&folder.join(CMAKE_LISTS)).ok()?;
                cmake::project(&lists.text).filter(|name| !name.contains('$'))
            };
            let template = folder.join(format!("{MANIFEST}{TEMPLATE}"));
            let name = match self.vfs.text(&template) {
                Ok(manifest) => name_in(&manifest.text)
                    .filter(|name| !name.contains(['@', '$']))
                    .or_else(project),
                Err(_) => project().filter(|name| self.build(folder).installs(name)),
            };
            name.filter(|name| is_package_name(name))
        })
    }
}

impl Build {
    fn add(&mut self, to: PathBuf, source: InstallSource) {
        self.rules.push((to, source));
    }

    /// Whether it installs files that only a package of this name finds.
    fn installs(&self, package: &str) -> bool {
        let share = Path::new("share").join(package);
        self.rules.iter().any(|(to, _)| to.starts_with(&share))
    }

    /// What its rules need and the sources do not have: the installation stops there. Without what the build itself may make.
    pub fn missing<'b>(&'b self, vfs: &'b Vfs) -> impl Iterator<Item = &'b RequiredSource> {
        let is_made = |path: &Path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            self.made.iter().any(|made| made.starts_with(path))
                || stem(&name).is_some_and(|stem| self.named.contains(&stem))
        };
        let required = self.required.iter();
        required.filter(move |source| !vfs.exists(&source.path) && !is_made(&source.path))
    }

    /// Whether a file of a package is installed where it is in the sources.
    pub fn installs_file(&self, vfs: &Vfs, package: &str, inside: &Path) -> bool {
        let place = Path::new("share").join(package).join(inside);
        self.find(vfs, &place, 0).is_some()
    }

    /// Whether anything is installed at, above or below a folder of a package.
    pub fn covers(&self, package: &str, folder: &str) -> bool {
        let folder = tidy(&Path::new("share").join(package).join(folder));
        self.rules.iter().any(|(to, _)| {
            to.starts_with("share") && (folder.starts_with(to) || to.starts_with(&folder))
        })
    }

    /// What is put at `place`.
    fn find(&self, vfs: &Vfs, place: &Path, depth: u32) -> Option<Built> {
        /// From the sources to the folder of the build, from there to be installed, and one to spare.
        const MOST: u32 = 3;
        if depth > MOST {
            return None;
        }
        let below = |(to, source)| Some((place.strip_prefix::<&PathBuf>(to).ok()?, source));
        let rules = self
            .rules
            .iter()
            .map(|(to, source)| (to, source))
            .filter_map(below);
        rules
            .into_iter()
            .find_map(|(rest, source)| self.taken(vfs, source, rest, depth))
    }

    fn taken(&self, vfs: &Vfs, source: &InstallSource, rest: &Path, depth: u32) -> Option<Built> {
        match source {
            InstallSource::Path(path) => {
                let path = if rest.as_os_str().is_empty() {
                    path.clone()
                } else {
                    path.join(rest)
                };
                if vfs.exists(&path) {
                    return Some(Built {
                        path,
                        is_template: false,
                    });
                }
                let template = template_of(&path);
                let template = vfs.is_file(&template).then_some(Built {
                    path: template,
                    is_template: true,
                });
                template.or_else(|| self.find(vfs, &path, depth + 1))
            }
            InstallSource::Files(pattern) => {
                let name = rest
                    .file_name()
                    .filter(|_| rest.components().count() == 1)?;
                let mut left = GLOB_ENTRIES;
                let found = vfs
                    .glob(pattern.to_str()?, Path::new("/"), &mut left)
                    .ok()?;
                let path = found
                    .into_iter()
                    .find(|path| path.file_name() == Some(name))?;
                Some(Built {
                    path,
                    is_template: false,
                })
            }
            InstallSource::Template(path) if rest.as_os_str().is_empty() && vfs.is_file(path) => {
                Some(Built {
                    path: path.clone(),
                    is_template: true,
                })
            }
            InstallSource::Template(_) => None,
        }
    }
}

fn template_of(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(TEMPLATE);
    name.into()
}

/// The path without `.` and `folder/..`, by its text alone.
fn tidy(path: &Path) -> PathBuf {
    without_parents(path)
        .components()
        .filter(|part| *part != Component::CurDir)
        .collect()
}

#[cfg(test)]
mod tests;
