//! Packages that the build tools leave out: nothing runs from them.

use std::path::{Path, PathBuf};

use super::manifest::{MANIFEST, package_name};
use super::root::is_built;
use super::{Package, Packages, RosVersion};
use vfs::DirEntry;

/// Files that have colcon pass over a folder and all that lies below it.
const COLCON_MARKS: [&str; 2] = ["AMENT_IGNORE", "COLCON_IGNORE"];

/// The file that does the same for catkin.
const CATKIN_MARK: &str = "CATKIN_IGNORE";

/// What `catkin_make` writes into the top folder of a workspace, of which it builds the folder [`SOURCES`].
const CATKIN_WORKSPACE: &str = ".catkin_workspace";

/// What builds a package.
const BUILD_SCRIPTS: [&str; 2] = ["CMakeLists.txt", "setup.py"];

/// Fewer packages than this do not tell what a folder is.
const FEW: usize = 3;

/// The folder of a workspace in which its packages lie.
const SOURCES: &str = "src";

impl Packages {
    /// Whether the build tools pass over the package of a file: a folder around it is marked for that, it lies in another
    /// package, or beside the folder `src` of a workspace of catkin.
    pub fn is_never_built(&self, file: &Path) -> bool {
        self.containing(file).is_some_and(|package| {
            self.unbuilt
                .get(package.folder.clone(), || self.is_left_out(&package, file))
        })
    }

    /// Whether a file lies in what a build installed, and the build tool says so: what is missing there was not installed yet.
    pub fn is_in_a_build(&self, file: &Path) -> bool {
        let is_one = |folder: &Path| {
            let mut marks = COLCON_MARKS.iter().chain([&CATKIN_MARK]);
            folder.file_name().is_some_and(is_built)
                && marks.any(|mark| self.vfs.is_file(&folder.join(mark)))
        };
        file.ancestors().skip(1).any(is_one)
    }

    fn is_left_out(&self, package: &Package, file: &Path) -> bool {
        let Some(top) = self.sources_around(file) else {
            return false;
        };
        let folders = package.folder.ancestors();
        folders
            .take_while(|folder| folder.starts_with(&top))
            .any(|folder| {
                let entries = self.vfs.list_dir(folder);
                *folder != *top && self.is_marked(&entries, file)
                    || *folder != *package.folder && self.passes_over(folder, &entries, package)
            })
    }

    /// Whether a folder is marked to be passed over by the tool that builds the package of a file.
    fn is_marked(&self, entries: &[DirEntry], file: &Path) -> bool {
        has(entries, CATKIN_MARK) && self.is_for_catkin(file)
            || COLCON_MARKS.iter().any(|mark| has(entries, mark))
                && (!self.is_for_catkin(file) || self.is_beside_ament(file))
    }

    /// Whether other packages of the sources around a file are for ROS 2: colcon builds all of them.
    fn is_beside_ament(&self, file: &Path) -> bool {
        let Some(top) = self.sources_around(file) else {
            return false;
        };
        let mut packages = self.below(&top).into_iter();
        packages
            .any(|(_, folder)| self.generation(&folder.join(MANIFEST)) == Some(RosVersion::Ros2))
    }

    fn is_for_catkin(&self, file: &Path) -> bool {
        self.generation(file) == Some(RosVersion::Ros1)
    }

    /// Whether a folder above a package is a package that is built, since tools look for none inside of one, or of the same name, or the
    /// top of a workspace of catkin with its sources elsewhere.
    fn passes_over(&self, folder: &Path, entries: &[DirEntry], package: &Package) -> bool {
        let outer = || package_name(&self.vfs, folder);
        let is_built = || BUILD_SCRIPTS.iter().any(|name| has(entries, name));
        has(entries, MANIFEST) && outer().is_some_and(|outer| outer == package.name || is_built())
            || has(entries, SOURCES)
                && !package.folder.starts_with(folder.join(SOURCES))
                && (has(entries, CATKIN_WORKSPACE) || self.holds_most(folder, package))
    }

    /// Whether most packages around one for catkin are in the folder `src`: it is a workspace, of which catkin builds that folder.
    fn holds_most(&self, folder: &Path, package: &Package) -> bool {
        let sources = folder.join(SOURCES);
        let are_most = |all: Vec<(String, PathBuf)>| {
            let inside = all.iter().filter(|(_, other)| other.starts_with(&sources));
            let inside = inside.count();
            inside >= FEW && inside * 2 > all.len()
        };
        self.is_for_catkin(&package.folder.join(MANIFEST)) && are_most(self.below(folder))
    }
}

fn has(entries: &[DirEntry], name: &str) -> bool {
    entries.iter().any(|entry| entry.name == name)
}

#[cfg(test)]
mod tests {
    use crate::{PackageOptions, Packages};
    use vfs::testing::Tree;

    const MANIFEST: &str = "<package><name>arm</name></package>";
    const CATKIN: &str =
        "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>";

    fn check_built(files: &[(&str, &str)], file: &str, expected: bool) {
        let tree = Tree::new();
        for (name, text) in files {
            tree.write(&format!("ws/{name}"), text);
        }
        let options = PackageOptions {
            workspace_folders: vec![tree.path("ws")],
            ..PackageOptions::default()
        };
        let packages = Packages::new(tree.vfs().clone(), &tree.environment(&[]), options);
        let file = tree.path(&format!("ws/{file}"));
        assert_eq!(packages.is_never_built(&file), !expected, "{files:?}");
    }

    #[test]
    fn folders_that_are_marked() {
        for (manifest, mark, expected) in [
            (MANIFEST, "COLCON_IGNORE", false),
            (MANIFEST, "AMENT_IGNORE", false),
            (MANIFEST, "CATKIN_IGNORE", true),
            (CATKIN, "COLCON_IGNORE", true),
            (CATKIN, "CATKIN_IGNORE", false),
        ] {
            let mark = format!("old/{mark}");
            let files = [("old/arm/package.xml", manifest), (mark.as_str(), "")];
            check_built(&files, "old/arm/urdf/arm.urdf", expected);
        }
        // colcon builds the sources when others are for ROS 2
        let files = [
            ("old/arm/package.xml", CATKIN),
            ("old/COLCON_IGNORE", ""),
            ("cart/package.xml", MANIFEST),
        ];
        check_built(&files, "old/arm/urdf/arm.urdf", false);
    }

    #[test]
    fn packages_inside_of_packages() {
        let outer = ("package.xml", MANIFEST);
        let inner = ("arm/package.xml", MANIFEST);
        check_built(&[outer, inner], "arm/urdf/arm.urdf", false);
        check_built(&[outer, inner], "urdf/arm.urdf", true);
        let other = ("arm/package.xml", "<package><name>hand</name></package>");
        check_built(&[outer, other], "arm/urdf/arm.urdf", true);
        let script = ("CMakeLists.txt", "project(arm)");
        check_built(&[outer, other, script], "arm/urdf/arm.urdf", false);
    }

    #[test]
    fn packages_beside_the_sources_of_catkin() {
        let mark = (".catkin_workspace", "");
        let built = ("src/hand/package.xml", CATKIN);
        let beside = ("src_old/arm/package.xml", CATKIN);
        check_built(&[mark, built, beside], "src_old/arm/arm.urdf", false);
        check_built(&[mark, built, beside], "src/hand/hand.urdf", true);
        check_built(&[built, beside], "src_old/arm/arm.urdf", true);
        // without the mark, where most packages are
        let more = [("src/a/package.xml", CATKIN), ("src/b/package.xml", CATKIN)];
        let most = [built, beside, more[0], more[1]];
        check_built(&most, "src_old/arm/arm.urdf", false);
        check_built(&most, "src/hand/hand.urdf", true);
        check_built(
            &[
                built,
                ("src_old/arm/package.xml", MANIFEST),
                more[0],
                more[1],
            ],
            "src_old/arm/arm.urdf",
            true,
        );
    }
}
