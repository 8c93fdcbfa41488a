//! The workspace a file lies in.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::manifest::MANIFEST;
use vfs::{DirEntry, Vfs};

/// Folders that colcon and catkin make beside `src`; nothing in them is a source.
const BUILT: [&str; 7] = [
    "install",
    "build",
    "devel",
    "log",
    "install_isolated",
    "build_isolated",
    "devel_isolated",
];

/// Whether a folder of that name is made by a build tool of ROS.
pub fn is_built(name: impl AsRef<OsStr>) -> bool {
    BUILT.iter().any(|built| name.as_ref() == *built)
}

/// Whether a folder says that a tool made it and can make it again, by the tag of <https://bford.info/cachedir/>.
pub fn is_cache(names: &[DirEntry]) -> bool {
    names.iter().any(|entry| entry.name == "CACHEDIR.TAG")
}

/// The workspace that `start` (a folder) lies in: the nearest folder above it that holds the `src` it lies
/// in, or that holds `src` and is `start` itself or has folders of a build tool; else the top of its repository. A package
/// with sources in `src` is no workspace, and neither are `home` and the folders above it.
pub fn workspace_root(vfs: &Vfs, start: &Path, home: Option<&Path>) -> Option<PathBuf> {
    let start = vfs.absolute(start);
    let mut repository = None;
    for folder in start.ancestors() {
        if is_too_wide(folder, home) {
            break;
        }
        if is_workspace(vfs, folder, &start) {
            return Some(folder.to_owned());
        }
        if repository.is_none() && vfs.exists(&folder.join(".git")) {
            repository = Some(folder.to_owned());
        }
    }
    repository
}

/// Whether a folder holds more than one's sources: the disk, `home` and what is above it.
pub(super) fn is_too_wide(folder: &Path, home: Option<&Path>) -> bool {
    folder.parent().is_none() || home.is_some_and(|home| home.starts_with(folder))
}

fn is_workspace(vfs: &Vfs, folder: &Path, start: &Path) -> bool {
    let sources = folder.join("src");
    (start.starts_with(&sources)
        || vfs.is_dir(&sources) && (folder == start || has_built(vfs, folder)))
        && !vfs.is_file(&folder.join(MANIFEST))
}

/// Whether a build tool has left something in a folder.
fn has_built(vfs: &Vfs, folder: &Path) -> bool {
    BUILT
        .iter()
        .chain(&[".catkin_tools"])
        .any(|name| vfs.is_dir(&folder.join(name)))
}

#[cfg(test)]
mod tests {
    use super::workspace_root;
    use vfs::testing::Tree;

    #[test]
    fn roots() {
        let tree = Tree::new();
        for file in [
            "home/ws/src/repo/pkg/urdf/a.xacro",
            "home/ws/src/repo/.git/HEAD",
            "home/ws/src/cpp/package.xml",
            "home/ws/src/cpp/src/a.cpp",
            "home/built/src/x",
            "home/built/install/setup.bash",
            "home/built/top.xacro",
            "home/repo/.git",
            "home/repo/pkg/src/x",
            "home/repo/pkg/package.xml",
            "home/plain/src/x",
            "home/plain/top.xacro",
            "home/src/project/x",
            "home/src/clone/.git/HEAD",
        ] {
            tree.write(file, "");
        }
        let table = [
            ("home/ws/src/repo/pkg/urdf", Some("home/ws")),
            ("home/ws/src", Some("home/ws")),
            ("home/ws/src/cpp/src", Some("home/ws")),
            ("home/built", Some("home/built")),
            ("home/built/src", Some("home/built")),
            ("home/repo/pkg", Some("home/repo")),
            ("home/repo/pkg/src", Some("home/repo")),
            ("home/plain", Some("home/plain")),
            ("home/plain/doc", None),
            ("home/src/project", None),
            ("home/src/clone", Some("home/src/clone")),
        ];
        for (start, expected) in table {
            let found = workspace_root(tree.vfs(), &tree.path(start), Some(&tree.path("home")));
            assert_eq!(found, expected.map(|path| tree.path(path)), "{start}");
        }
    }
}
