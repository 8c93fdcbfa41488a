//! The sources around a file.

use std::path::{Path, PathBuf};

use super::Packages;
use super::root::is_too_wide;
use vfs::without_parents;

impl Packages {
    /// The widest folder of sources around a file: the folder that is checked, or the workspace above, else the package,
    /// else the folder of the file. The whole disk is none, and so is a home for a file that only lies there: to read it
    /// takes long, and who uses the file is not found by it.
    pub fn sources_around(&self, file: &Path) -> Option<PathBuf> {
        let beside = file.parent()?;
        if let Some(known) = self.sources.known(beside) {
            return known;
        }
        self.sources
            .get(beside.to_owned(), || self.widest_around(file))
    }

    fn widest_around(&self, file: &Path) -> Option<PathBuf> {
        let file = without_parents(&self.vfs.absolute(file));
        let mut sources = self.source_folders(&file);
        sources.retain(|folder| {
            let is_disk = folder.parent().is_none();
            !is_disk && file.starts_with(folder) && self.vfs.is_dir(folder)
        });
        let widest = sources
            .into_iter()
            .min_by_key(|folder| folder.components().count());
        let package = || self.containing(&file).map(|package| package.folder);
        let home = self.env.home().map(Path::new);
        let beside = file.parent().filter(|folder| !is_too_wide(folder, home));
        widest
            .or_else(package)
            .or_else(|| beside.map(Path::to_owned))
    }

    /// Whether a file can be read, and its text is like this.
    pub fn is_text(&self, path: &Path, is_wanted: impl FnOnce(&str) -> bool) -> bool {
        self.vfs.text(path).is_ok_and(|file| is_wanted(&file.text))
    }
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::super::{PackageOptions, Packages};
    use vfs::testing::Tree;

    fn sources(tree: &Tree, folders: &[PathBuf], file: &Path) -> Option<PathBuf> {
        let options = PackageOptions {
            workspace_folders: folders.to_vec(),
            ..PackageOptions::default()
        };
        let home = tree.path("home/me");
        let env = tree.environment(&[("HOME", home.to_str().unwrap())]);
        Packages::new(tree.vfs().clone(), &env, options).sources_around(file)
    }

    #[test]
    fn neither_the_disk_nor_a_home_around_a_file() {
        let tree = Tree::new();
        for file in ["home/me/a.urdf", "home/me/robots/a.urdf", "other/a.urdf"] {
            tree.write(file, "<robot/>");
        }
        for (file, expected) in [
            ("home/me/a.urdf", None),
            ("home/a.urdf", None),
            ("home/me/robots/a.urdf", Some("home/me/robots")),
            ("other/a.urdf", Some("other")),
        ] {
            let found = sources(&tree, &[], &tree.path(file));
            assert_eq!(found, expected.map(|path| tree.path(path)), "{file}");
        }
        let disk = PathBuf::from("/");
        assert_eq!(sources(&tree, &[], Path::new("/a.urdf")), None);
        let below = sources(&tree, &[disk], &tree.path("other/a.urdf"));
        assert_eq!(below, Some(tree.path("other")));
        // who opens the whole home means it
        let home = tree.path("home/me");
        let opened = sources(
            &tree,
            std::slice::from_ref(&home),
            &tree.path("home/me/a.urdf"),
        );
        assert_eq!(opened, Some(home));
    }
}
