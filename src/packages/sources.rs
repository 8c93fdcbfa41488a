//! The sources around a file.

use std::path::{Path, PathBuf};

use super::Packages;
use vfs::without_parents;

impl Packages {
    /// The widest folder of sources around a file: the folder that is checked, or the workspace above, else the package,
    /// else the folder of the file.
    pub fn sources_around(&self, file: &Path) -> Option<PathBuf> {
        let file = without_parents(&self.vfs.absolute(file));
        let mut sources = self.source_folders(&file);
        sources.retain(|folder| file.starts_with(folder) && self.vfs.is_dir(folder));
        let widest = sources
            .into_iter()
            .min_by_key(|folder| folder.components().count());
        let package = || self.containing(&file).map(|package| package.folder);
        widest
            .or_else(package)
            .or_else(|| file.parent().map(Path::to_owned))
    }

    /// Whether a file can be read, and its text is like this.
    pub fn is_text(&self, path: &Path, is_wanted: impl FnOnce(&str) -> bool) -> bool {
        self.vfs.text(path).is_ok_and(|file| is_wanted(&file.text))
    }
}
