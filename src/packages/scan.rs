//! All packages of a folder tree.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use super::install::BUILD_FILES;
use super::manifest::{self, MANIFEST};
use super::root::{is_built, is_cache};
use base::limits::{SCAN_DEPTH, SCAN_FOLDERS};
use base::{FastMap, FastSet};
use vfs::{DirEntry, Vfs};

/// What a kind of tree takes in and leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Rules {
    /// A folder named by the user: everything in it counts.
    Explicit,
    /// A source workspace: ignore markers and the folders of build tools are respected.
    Workspace,
    /// An entry of `ROS_PACKAGE_PATH`: what lies inside a package is not searched.
    RosPackagePath,
}

impl Rules {
    fn is_ignored(self, names: &[DirEntry]) -> bool {
        let markers: &[&str] = match self {
            Rules::Explicit => &[],
            Rules::Workspace => &["COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"],
            Rules::RosPackagePath => &["CATKIN_IGNORE"],
        };
        let is_marked = names
            .iter()
            .any(|entry| markers.contains(&entry.name.as_str()));
        is_marked || self == Rules::Workspace && is_cache(names)
    }

    fn descends_into(self, name: &str) -> bool {
        // what npm installs is many folders, and no package of ROS
        let is_no_source = is_built(name) || name == "node_modules";
        !(name.starts_with('.') || self == Rules::Workspace && is_no_source)
    }
}

/// The packages of a tree, those nearest to its top first, then by path.
#[derive(Debug, Default)]
pub(super) struct PackageTree {
    packages: Vec<(String, PathBuf)>,
    /// The folders of the packages of a name, each with whether it lies in another package: build tools do not find it there.
    by_name: FastMap<String, Vec<(PathBuf, bool)>>,
    unlisted: Vec<PathBuf>,
}

impl PackageTree {
    /// The package of that name. Of several, as in a folder with several workspaces, one that lies in no other package, of those the
    /// one that shares most folders with `from`, and of those the first.
    pub(super) fn get(&self, name: &str, from: &Path) -> Option<&Path> {
        let folders = self.by_name.get(name)?;
        let best = folders.iter().rev().max_by_key(|(folder, is_inside)| {
            let pairs = folder.components().zip(from.components());
            (!is_inside, pairs.take_while(|(a, b)| a == b).count())
        })?;
        Some(&best.0)
    }

    /// Folders that have no manifest and may be packages all the same: see [`super::packages::Packages::find`].
    pub(super) fn unlisted(&self) -> &[PathBuf] {
        &self.unlisted
    }

    /// Names and folders of all packages.
    pub(super) fn packages(&self) -> &[(String, PathBuf)] {
        &self.packages
    }
}

/// Search `top` and everything below. Paths in the result start with `top` as it is spelled; links are
/// followed, but no folder is visited twice.
pub(super) fn scan(vfs: &Vfs, top: &Path, rules: Rules) -> PackageTree {
    let mut tree = PackageTree::default();
    let mut seen: FastSet<u128> = FastSet::default();
    // A link to a folder above the top would lead out into the rest of the disk.
    seen.extend(
        vfs.canonical(top)
            .ancestors()
            .skip(1)
            .filter_map(|folder| vfs.identity(folder)),
    );
    let mut queue = VecDeque::from([(top.to_owned(), 0, false)]);
    while let Some((folder, depth, is_inside)) = queue.pop_front() {
        let is_new = vfs
            .identity(&folder)
            .is_some_and(|identity| seen.insert(identity));
        if !is_new || seen.len() > SCAN_FOLDERS {
            continue;
        }
        let names = vfs.list_dir(&folder);
        let asked_for = depth == 0 && rules == Rules::Workspace;
        if rules.is_ignored(&names) && !asked_for {
            continue;
        }
        let is_package = names
            .iter()
            .any(|entry| entry.name == MANIFEST && !entry.is_dir);
        if let Some(name) = is_package
            .then(|| manifest::package_name(vfs, &folder))
            .flatten()
        {
            tree.by_name
                .entry(name.clone())
                .or_default()
                .push((folder.clone(), is_inside));
            tree.packages.push((name, folder.clone()));
        } else if names.iter().any(|entry| entry.name == BUILD_FILES[0]) {
            tree.unlisted.push(folder.clone());
        }
        let closed = rules == Rules::RosPackagePath
            && (is_package || names.iter().any(|entry| entry.name == "rospack_nosubdirs"));
        if !closed && depth < SCAN_DEPTH {
            let folders = names
                .iter()
                .filter(|entry| entry.is_dir && rules.descends_into(&entry.name));
            let is_inside = is_inside || is_package;
            queue.extend(folders.map(|entry| (folder.join(&entry.name), depth + 1, is_inside)));
        }
    }
    tree
}

#[cfg(test)]
mod tests {
    use super::{Rules, scan};
    use vfs::testing;

    fn tree(files: &[&str]) -> testing::Tree {
        let tree = testing::Tree::new();
        for file in files {
            let folder = file.rsplit('/').nth(1).unwrap_or("top");
            tree.write(
                file,
                &format!("<package><name>{folder}_name</name></package>"),
            );
        }
        tree
    }

    fn found(tree: &testing::Tree, rules: Rules) -> Vec<String> {
        let found = scan(tree.vfs(), tree.root(), rules);
        let relative = |path: &std::path::Path| {
            path.strip_prefix(tree.root())
                .unwrap()
                .display()
                .to_string()
        };
        found
            .packages()
            .iter()
            .map(|(name, path)| format!("{name} {}", relative(path)))
            .collect()
    }

    #[test]
    fn markers_and_build_folders() {
        let tree = tree(&[
            "a/package.xml",
            "a/inner/package.xml",
            "build/b/package.xml",
            "install/c/package.xml",
            "log/d/package.xml",
            "devel/e/package.xml",
            ".git/f/package.xml",
            "g/package.xml",
            "g/COLCON_IGNORE",
            "a/web/node_modules/j/package.xml",
            "h/AMENT_IGNORE",
            "h/below/package.xml",
            "i/CATKIN_IGNORE",
            "i/package.xml",
            "target/CACHEDIR.TAG",
            "target/k/package.xml",
            "COLCON_IGNORE",
        ]);
        assert_eq!(
            found(&tree, Rules::Workspace),
            ["a_name a", "inner_name a/inner"]
        );
        assert_eq!(
            found(&tree, Rules::Explicit),
            [
                "a_name a",
                "g_name g",
                "i_name i",
                "inner_name a/inner",
                "b_name build/b",
                "e_name devel/e",
                "below_name h/below",
                "c_name install/c",
                "d_name log/d",
                "k_name target/k",
                "j_name a/web/node_modules/j",
            ]
        );
        assert_eq!(
            found(&tree, Rules::RosPackagePath),
            [
                "a_name a",
                "g_name g",
                "b_name build/b",
                "e_name devel/e",
                "below_name h/below",
                "c_name install/c",
                "d_name log/d",
                "k_name target/k"
            ]
        );
    }

    #[test]
    fn names_come_from_the_manifest() {
        let tree = testing::Tree::new();
        tree.write("x/package.xml", "<package><name>real</name></package>");
        tree.write("y/package.xml", "<package><name>real</name></package>");
        tree.write("z/package.xml", "not a manifest");
        let result = scan(tree.vfs(), tree.root(), Rules::Workspace);
        assert_eq!(
            result.get("real", tree.root()),
            Some(tree.path("x").as_path())
        );
        assert_eq!(result.packages().len(), 2);
        assert_eq!(result.get("x", tree.root()), None);
    }

    #[cfg(unix)]
    #[test]
    fn links() {
        use std::os::unix::fs::symlink;
        let tree = tree(&["outside/p/package.xml", "ws/a/package.xml"]);
        symlink("..", tree.path("ws/up")).unwrap();
        symlink("../..", tree.path("ws/a/up")).unwrap();
        symlink(".", tree.path("ws/a/self")).unwrap();
        symlink("gone", tree.path("ws/dangling")).unwrap();
        symlink("../outside/p", tree.path("ws/z")).unwrap();
        let result = scan(tree.vfs(), &tree.path("ws"), Rules::Workspace);
        let expected = [
            ("a_name".to_owned(), tree.path("ws/a")),
            ("p_name".to_owned(), tree.path("ws/z")),
        ];
        assert_eq!(result.packages(), expected);
    }

    #[test]
    fn of_one_name_none_that_lies_in_another_package() {
        let tree = testing::Tree::new();
        for folder in ["cell", "cell/old/arm", "lib/arm"] {
            let name = folder.rsplit('/').next().unwrap_or(folder);
            let manifest = format!("<package><name>{name}</name></package>");
            tree.write(&format!("{folder}/package.xml"), &manifest);
        }
        let found = scan(tree.vfs(), tree.root(), Rules::Workspace);
        let from = tree.path("cell/urdf/r.xacro");
        assert_eq!(found.get("arm", &from), Some(&*tree.path("lib/arm")));
    }
}
