//! The places packages are looked for outside of source trees: prefixes of installed packages.

use std::fmt;
use std::path::{Path, PathBuf};

use super::manifest::MANIFEST;
use vfs::Vfs;

const INDEX: &str = "share/ament_index/resource_index/packages";

/// The kinds of places, in the order they are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PackageSource {
    /// A folder of `package-path`.
    PackagePath,
    /// The package that holds the file being read.
    OwnPackage,
    /// The source tree of the workspace.
    Workspace,
    /// `install` or `devel` beside the workspace.
    Overlay,
    /// `AMENT_PREFIX_PATH`.
    AmentPrefixPath,
    /// `COLCON_PREFIX_PATH`.
    ColconPrefixPath,
    /// `ROS_PACKAGE_PATH`.
    RosPackagePath,
    /// The prefix that the file itself is installed in.
    OwnPrefix,
    /// An installed distribution that no variable names.
    Distribution,
}

impl PackageSource {
    /// All of them in the usual order.
    pub const ALL: [PackageSource; 9] = [
        PackageSource::PackagePath,
        PackageSource::OwnPackage,
        PackageSource::Workspace,
        PackageSource::Overlay,
        PackageSource::AmentPrefixPath,
        PackageSource::ColconPrefixPath,
        PackageSource::RosPackagePath,
        PackageSource::OwnPrefix,
        PackageSource::Distribution,
    ];

    /// Whether the environment decides.
    pub(super) fn is_environment(self) -> bool {
        matches!(
            self,
            PackageSource::AmentPrefixPath
                | PackageSource::ColconPrefixPath
                | PackageSource::RosPackagePath
        )
    }
}

impl fmt::Display for PackageSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            PackageSource::PackagePath => "package-path",
            PackageSource::OwnPackage => "own package",
            PackageSource::Workspace => "workspace",
            PackageSource::Overlay => "overlay",
            PackageSource::AmentPrefixPath => "AMENT_PREFIX_PATH",
            PackageSource::ColconPrefixPath => "COLCON_PREFIX_PATH",
            PackageSource::RosPackagePath => "ROS_PACKAGE_PATH",
            PackageSource::OwnPrefix => "installed beside",
            PackageSource::Distribution => "/opt/ros",
        })
    }
}

/// How installed packages lie below a prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum InstallLayout {
    /// `share/PKG`, announced by a marker in the ament index.
    Indexed,
    /// `share/PKG` with a manifest or a marker.
    Merged,
    /// `PKG/share/PKG`.
    Isolated,
    /// `share/PKG`, whatever it holds; with files of CMake only, the package is used from its sources elsewhere.
    Devel,
}

/// One prefix.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Prefix {
    /// As the variable spells it.
    pub(super) path: PathBuf,
    /// How it is laid out.
    pub(super) layout: InstallLayout,
}

impl Prefix {
    /// `path` with `layout`.
    pub(super) fn new(path: PathBuf, layout: InstallLayout) -> Self {
        Self { path, layout }
    }

    /// The folder of package `name`, if it is installed here, and the place that was looked at.
    pub(super) fn find(&self, vfs: &Vfs, cwd: &Path, name: &str) -> (Option<PathBuf>, PathBuf) {
        let share = self.folder(name);
        let marker = self.path.join(INDEX).join(name);
        let installed = match self.layout {
            InstallLayout::Indexed => vfs.is_file(&cwd.join(&marker)),
            InstallLayout::Merged => {
                vfs.is_file(&cwd.join(share.join(MANIFEST))) || vfs.is_file(&cwd.join(&marker))
            }
            InstallLayout::Isolated => vfs.is_dir(&cwd.join(&share)),
            InstallLayout::Devel => vfs
                .list_dir(&cwd.join(&share))
                .iter()
                .any(|entry| entry.name != "cmake"),
        };
        let place = if self.layout == InstallLayout::Indexed {
            marker
        } else {
            share.clone()
        };
        (installed.then_some(share), place)
    }

    /// Names of the packages installed here.
    pub(super) fn names(&self, vfs: &Vfs, cwd: &Path) -> Vec<String> {
        let folder = match self.layout {
            InstallLayout::Indexed => self.path.join(INDEX),
            InstallLayout::Merged | InstallLayout::Devel => self.path.join("share"),
            InstallLayout::Isolated => self.path.clone(),
        };
        let listed = vfs.list_dir(&cwd.join(folder));
        let names = listed.iter().map(|entry| &entry.name);
        names
            .filter(|name| self.find(vfs, cwd, name).0.is_some())
            .cloned()
            .collect()
    }

    /// Where package `name` would be.
    pub(super) fn folder(&self, name: &str) -> PathBuf {
        match self.layout {
            InstallLayout::Isolated => self.path.join(name).join("share").join(name),
            _ => self.path.join("share").join(name),
        }
    }
}

/// The prefixes a build leaves beside the sources of `workspace`.
pub(super) fn overlays(workspace: &Path) -> [Prefix; 3] {
    let install = workspace.join("install");
    [
        Prefix::new(install.clone(), InstallLayout::Isolated),
        Prefix::new(install, InstallLayout::Merged),
        Prefix::new(workspace.join("devel"), InstallLayout::Devel),
    ]
}

/// The prefixes that a file is installed in: the one with an ament index above it, and where each package has a prefix of
/// its own, those beside it.
pub(super) fn own_prefixes(vfs: &Vfs, file: &Path) -> Vec<Prefix> {
    let mut shares = file
        .ancestors()
        .filter(|folder| folder.file_name().is_some_and(|name| name == "share"));
    let Some(share) = shares.find(|share| vfs.is_dir(&share.join("ament_index"))) else {
        return Vec::new();
    };
    let Some(prefix) = share.parent() else {
        return Vec::new();
    };
    let beside = prefix
        .parent()
        .filter(|base| vfs.is_file(&base.join(".colcon_install_layout")));
    let beside = beside.map(|base| Prefix::new(base.to_owned(), InstallLayout::Isolated));
    std::iter::once(Prefix::new(prefix.to_owned(), InstallLayout::Merged))
        .chain(beside)
        .collect()
}

/// ROS 1 distributions; every other name is one of ROS 2.
const ROS1: [&str; 13] = [
    "boxturtle",
    "cturtle",
    "diamondback",
    "electric",
    "fuerte",
    "groovy",
    "hydro",
    "indigo",
    "jade",
    "kinetic",
    "lunar",
    "melodic",
    "noetic",
];

/// The prefixes of the distributions below `system` (`/opt/ros`), newest first (their names go up the
/// alphabet), those of the wanted generation before the others.
pub(super) fn distributions(vfs: &Vfs, system: &Path, ros1: bool) -> Vec<Prefix> {
    let listed = vfs.list_dir(system);
    let mut names: Vec<&str> = listed
        .iter()
        .filter(|entry| entry.is_dir)
        .map(|entry| entry.name.as_str())
        .collect();
    names.sort_by_key(|name| std::cmp::Reverse((ROS1.contains(name) == ros1, *name)));
    names
        .into_iter()
        .map(|name| Prefix::new(system.join(name), InstallLayout::Merged))
        .collect()
}
