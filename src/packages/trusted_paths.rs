//! What belongs to a robot, and what merely lies on the same disk.

use std::path::{Path, PathBuf};

use super::Packages;
use base::FastSet;

/// What is said instead of a message about a file that belongs to no robot: the message may quote the file.
pub const UNQUOTED: &str =
    "the file is outside the packages and folders of this robot, so its text is not shown";

/// What belongs to some robots: see [`Packages::around`].
pub struct TrustedPaths<'p> {
    packages: &'p Packages,
    folders: FastSet<PathBuf>,
}

impl Packages {
    /// What belongs to the robots of these root files: whatever lies in a package, near a root file (its folder, the one
    /// above), or below the working directory. The home folder and what is above it are near to nothing, unless a root
    /// file itself lies there.
    pub fn around<'r>(&self, roots: impl IntoIterator<Item = &'r Path>) -> TrustedPaths<'_> {
        let home = self
            .env
            .home()
            .map(|home| self.vfs.canonical(Path::new(home)));
        let cwd = self.vfs.canonical(&self.env.cwd);
        let mut folders: FastSet<PathBuf> = [cwd]
            .into_iter()
            .filter(|cwd| !is_wide(cwd, home.as_deref()))
            .collect();
        for own in roots
            .into_iter()
            .filter_map(Path::parent)
            .map(|folder| self.vfs.canonical(folder))
        {
            folders.extend(
                own.parent()
                    .filter(|above| !is_wide(above, home.as_deref()))
                    .map(Path::to_owned),
            );
            folders.extend(Some(own).filter(|own| !has_all(own)));
        }
        TrustedPaths {
            packages: self,
            folders,
        }
    }
}

/// Whether a folder holds everything: the top of a disk.
fn has_all(folder: &Path) -> bool {
    folder.parent().is_none()
}

/// Whether a folder is the home folder or above it.
fn is_wide(folder: &Path, home: Option<&Path>) -> bool {
    has_all(folder) || home.is_some_and(|home| home.starts_with(folder))
}

impl TrustedPaths<'_> {
    /// Whether a file belongs to them. Links are followed first: one that lies in a package and leads to a key at home
    /// makes that key no part of it.
    pub fn hold(&self, file: &Path) -> bool {
        let vfs = &self.packages.vfs;
        let folder = file.parent().map(|folder| vfs.canonical(folder));
        let file = match (folder, file.file_name()) {
            (Some(folder), Some(name)) => vfs.canonical(&folder.join(name)),
            _ => vfs.canonical(file),
        };
        self.packages.containing(&file).is_some()
            || file
                .ancestors()
                .skip(1)
                .any(|folder| self.folders.contains(folder))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{PackageOptions, Packages};
    use vfs::testing::Tree;

    #[test]
    fn what_belongs() {
        let tree = Tree::new();
        tree.write(
            "home/ws/src/arm/package.xml",
            "<package><name>arm</name></package>",
        );
        for file in [
            "home/key",
            "home/loose/r.urdf",
            "home/ws/token",
            "home/ws/src/arm/c.yaml",
            "etc/passwd",
        ] {
            tree.write(file, "secret");
        }
        let packages = |cwd: &str| {
            let mut env = tree.environment(&[("HOME", "{root}/home")]);
            env.cwd = tree.path(cwd);
            Packages::new(tree.vfs().clone(), &env, PackageOptions::default())
        };
        // file, root file, working directory
        let table = [
            ("home/ws/src/arm/c.yaml", "home/loose/r.urdf", "etc", true),
            ("home/loose/c.yaml", "home/loose/r.urdf", "etc", true),
            ("home/loose/c.yaml", "home/loose/urdf/r.urdf", "etc", true),
            (
                "home/loose/c.yaml",
                "home/loose/a/urdf/r.urdf",
                "etc",
                false,
            ),
            (
                "home/loose/c.yaml",
                "home/ws/src/arm/r.urdf",
                "home/loose",
                true,
            ),
            ("home/key", "home/loose/r.urdf", "home/loose", false),
            ("home/key", "home/loose/r.urdf", "home", false),
            ("home/key", "home/r.urdf", "etc", true),
            ("home/ws/token", "home/ws/src/arm/r.urdf", "etc", false),
            ("etc/passwd", "home/loose/r.urdf", "home/ws", false),
            (
                "home/loose/../../etc/passwd",
                "home/loose/r.urdf",
                "home/ws",
                false,
            ),
        ];
        for (file, root, cwd, expected) in table {
            let packages = packages(cwd);
            let belongs = packages.around([&*tree.path(root)]).hold(&tree.path(file));
            assert_eq!(belongs, expected, "{file} of {root} in {cwd}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_belong_to_where_they_lead() {
        let tree = Tree::new();
        tree.write("arm/package.xml", "<package><name>arm</name></package>");
        tree.write("arm/config/c.yaml", "{}");
        tree.write("elsewhere/key", "secret");
        std::os::unix::fs::symlink(tree.path("elsewhere/key"), tree.path("arm/config/key.yaml"))
            .unwrap();
        std::fs::create_dir_all(tree.path("install/far")).unwrap();
        std::os::unix::fs::symlink(
            tree.path("arm/config/c.yaml"),
            tree.path("install/far/c.yaml"),
        )
        .unwrap();
        let mut env = tree.environment(&[]);
        env.cwd = tree.path("arm");
        let packages = Packages::new(tree.vfs().clone(), &env, PackageOptions::default());
        let root = tree.path("arm/urdf/r.urdf");
        let around = packages.around([&*root]);
        let belongs = |file: &str| around.hold(&tree.path(file));
        assert_eq!(
            (
                belongs("arm/config/key.yaml"),
                belongs("install/far/c.yaml")
            ),
            (false, true)
        );
    }
}
