//! Which documents are open through links in an install space.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What is open through links, by the paths of the links.
#[derive(Default)]
pub(super) struct InstalledLinks {
    /// The sources that they stand for.
    pub links: BTreeMap<PathBuf, PathBuf>,
    /// The sources of those that are open besides their source: texts of their own, checked at the source alone.
    pub doubles: BTreeMap<PathBuf, PathBuf>,
}

impl InstalledLinks {
    /// The file that a path of the client stands for.
    pub fn source(&self, path: PathBuf) -> PathBuf {
        self.links.get(&path).cloned().unwrap_or(path)
    }

    /// The source of a document that is the second one of its file.
    pub fn source_of_double(&self, path: &Path) -> Option<&Path> {
        self.doubles.get(path).map(PathBuf::as_path)
    }
}
