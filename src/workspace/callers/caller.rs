//! A file that calls descriptions, as it was read.

use std::path::{Path, PathBuf};

use super::era::Era;
use super::file_names::{self, name_of};
use super::meant::may_mean;
use super::uses::Uses;
use base::FastMap;
use packages::Packages;

/// A file that names descriptions.
#[derive(Clone, Debug)]
pub struct Caller {
    pub(super) path: PathBuf,
    /// The names of the description files, each with the folders that are written in front of it.
    pub(super) descriptions: FastMap<String, Vec<NamePrefix>>,
    /// What further names end with, whose beginnings are computed.
    pub(super) endings: Vec<String>,
    /// Whether whoever calls it names the description.
    pub(super) is_open: bool,
    /// Whether it names a description that is there.
    pub(super) has_default: bool,
    /// The xacro that it runs.
    pub(super) era: Option<Era>,
    /// Whether it starts a simulator, a planner or controllers.
    pub(super) simulates: bool,
    /// Whether it loads files into Bullet.
    pub(super) is_bullet: bool,
    /// Whether it loads files into Isaac Gym.
    pub(super) is_isaac: bool,
    /// Whether it loads files into RaiSim.
    pub(super) is_raisim: bool,
    /// The arguments it gives, in order.
    pub args: Vec<GivenArg>,
    /// The package whose configuration it completes.
    pub(super) based_on: Option<String>,
}

/// What is written in front of the name of a description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct NamePrefix {
    /// The package, where the text says it.
    pub(super) package: Option<String>,
    pub(super) folders: PathBuf,
}

impl NamePrefix {
    /// How well a file fits: its package first, then its folders, and then whether these are all that it has in its package.
    pub(super) fn fit(&self, file: &Path, packages: &Packages) -> (bool, usize, bool) {
        let folder = file.parent().unwrap_or(file);
        let pairs = folder.iter().rev().zip(self.folders.iter().rev());
        let count = pairs.take_while(|(a, b)| a == b).count();
        let own = (self.package.is_some() || count > 0)
            .then(|| packages.containing(file))
            .flatten();
        let is_in_package =
            self.package.is_some() && own.as_ref().map(|own| &own.name) == self.package.as_ref();
        let is_all = count > 0 && own.is_some_and(|own| folder == own.folder.join(&self.folders));
        (is_in_package, count, is_all)
    }
}

/// An argument that a caller gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GivenArg {
    /// Its name.
    pub name: String,
    /// Its value, where the text says it.
    pub value: Option<String>,
}

impl Caller {
    /// Whether the text runs xacro, as far as it says.
    pub fn runs_xacro(&self) -> bool {
        self.era.is_some()
    }

    /// Whether the text names a description, or the end of its name.
    pub(super) fn says(&self, file: &Path) -> bool {
        self.descriptions.contains_key(name_of(file)) || self.ends(file)
    }

    /// Whether the text names the end of the name of a description.
    pub(super) fn ends(&self, file: &Path) -> bool {
        let is_end =
            |ending: &String| !ending.is_empty() && name_of(file).ends_with(ending.as_str());
        self.endings.iter().any(is_end)
    }

    /// Whether the text names the end of the name of a description with a part of a word, not only with dots.
    pub(super) fn ends_in_word(&self, file: &Path) -> bool {
        let says_more = |ending: &&String| !ending.is_empty() && !ending.starts_with('.');
        let mut endings = self.endings.iter().filter(says_more);
        endings.any(|ending| name_of(file).ends_with(ending.as_str()))
    }

    /// Whether the text names the end of the name of one description of a package alone.
    pub(super) fn ends_for_one(&self, file: &Path, all: &Uses, packages: &Packages) -> bool {
        self.ends(file)
            && packages.containing(file).is_some_and(|package| {
                let own = all.sorted.iter();
                let mut own = own.filter(|other| other.starts_with(&package.folder));
                own.all(|other| other == file || !self.ends(other))
            })
    }

    /// Whether this is a file to be read, not run.
    pub(super) fn is_page(&self) -> bool {
        file_names::is_page(&self.path)
    }

    /// Whether this is a program, and no test of one.
    pub(super) fn is_program(&self) -> bool {
        file_names::is_program(&self.path)
    }

    /// Whether this is a launch file, by its name or folder.
    pub(super) fn is_launch(&self) -> bool {
        file_names::is_launch(&self.path)
    }

    /// Whether this is a launch file to try something out, by its name.
    pub(super) fn is_trial(&self) -> bool {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        self.is_launch() && name.to_lowercase().starts_with("test")
    }

    /// Whether it loads robots and may mean `file`: a launch file, or a program or build file of the same package, since programs
    /// elsewhere pick one of many.
    pub(super) fn may_load(&self, file: &Path, packages: &Packages) -> bool {
        self.is_launch() && may_mean(&self.path, file, packages)
            || (self.is_program() || self.path.ends_with("CMakeLists.txt"))
                && packages
                    .containing(file)
                    .is_some_and(|package| self.path.starts_with(package.folder))
    }

    /// Whether the text says nothing of the file, so that its package may be computed as well.
    pub(super) fn computes_the_file(&self) -> bool {
        self.descriptions.is_empty() && self.endings.iter().any(String::is_empty)
    }
}
