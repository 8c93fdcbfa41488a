//! Files that are not text, and how folders spell the names in them.

use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use super::cache::Cache;
use super::decode;
use super::error::LoadError;
use super::{DirEntry, Vfs};

/// What was made of files on disk, kept until they change.
pub struct FileCache<T>(Cache<T>);

impl<T> Default for FileCache<T> {
    fn default() -> Self {
        Self(Cache::default())
    }
}

impl Vfs {
    /// What `make` makes of the bytes of a file; not made again while the file stays as it is. Buffers are
    /// not looked at: nobody edits such files in an editor of text.
    ///
    /// # Errors
    /// Whatever keeps the file from being read; also more than `limit` bytes.
    pub fn cached_read<T>(
        &self,
        cache: &FileCache<T>,
        path: &Path,
        limit: u64,
        make: impl FnOnce(Vec<u8>) -> T,
    ) -> Result<Arc<T>, LoadError> {
        let id = self.file_id(path);
        let path = self.path(id);
        let stat = self.stat(id, &path)?;
        cache.0.get(id, stat.stamp, || {
            Ok(Arc::new(make(self.shared.disk.bytes(&path, &stat, limit)?)))
        })
    }

    /// The bytes of a file on disk, at most `limit` of them.
    ///
    /// # Errors
    /// Whatever keeps the file from being read; also more than `limit` bytes.
    pub fn bytes(&self, path: &Path, limit: u64) -> Result<Vec<u8>, LoadError> {
        let path = self.absolute(path);
        self.shared
            .disk
            .bytes(&path, &self.shared.disk.stat(&path)?, limit)
    }

    /// The names in a folder as [`list_dir`](Self::list_dir) gives them; not read again while it stays as it is.
    pub fn names(&self, folder: &Path) -> Arc<Vec<DirEntry>> {
        let id = self.file_id(folder);
        let path = self.path(id);
        let listed = self.stat(id, &path).and_then(|stat| {
            self.shared
                .folders
                .get(id, stat.stamp, || Ok(self.list_dir(&path)))
        });
        listed.unwrap_or_default()
    }

    /// `path` with the names below `base` as the folders on the way spell them. The exact name wins over one
    /// that differs in the case of its letters; none when a folder has neither. On a disk that does not tell
    /// cases apart, this tells whether another system would find the file.
    pub fn as_listed(&self, base: &Path, path: &Path) -> Option<PathBuf> {
        let Ok(rest) = path.strip_prefix(base) else {
            return self.exists(path).then(|| path.to_owned());
        };
        let mut found = base.to_owned();
        for component in rest.components() {
            match component {
                Component::Normal(name) => {
                    let name = self.spelling(&found, name.to_str()?)?;
                    found.push(name);
                }
                other => found.push(other),
            }
        }
        Some(found)
    }

    /// How `folder` spells `name`.
    fn spelling(&self, folder: &Path, name: &str) -> Option<String> {
        let names = self.names(folder);
        let exact = names
            .binary_search_by(|entry| entry.name.as_str().cmp(name))
            .is_ok();
        // a folder may be entered without being read
        if exact || names.is_empty() && self.exists(&folder.join(name)) {
            return Some(name.to_owned());
        }
        let folded = name.to_lowercase();
        names
            .iter()
            .find(|entry| entry.name.to_lowercase() == folded)
            .map(|entry| entry.name.clone())
    }
}

/// The text of bytes: by byte order mark, else by XML declaration, else UTF-8; bad bytes become U+FFFD.
pub fn text_of(bytes: Vec<u8>) -> String {
    decode::decode(bytes).text
}

#[cfg(test)]
mod tests {
    use super::super::testing::Tree;
    use super::FileCache;

    #[test]
    fn spellings() {
        let tree = Tree::new();
        for file in ["Meshes/Base.STL", "Meshes/arm.stl", "Meshes/ARM.stl"] {
            tree.write(file, "");
        }
        let found = |path: &str| {
            let found = tree.vfs().as_listed(tree.root(), &tree.path(path))?;
            Some(
                found
                    .strip_prefix(tree.root())
                    .unwrap()
                    .display()
                    .to_string(),
            )
        };
        assert_eq!(found("Meshes/Base.STL").as_deref(), Some("Meshes/Base.STL"));
        assert_eq!(found("meshes/base.stl").as_deref(), Some("Meshes/Base.STL"));
        assert_eq!(found("meshes/arm.stl").as_deref(), Some("Meshes/arm.stl"));
        assert_eq!(found("meshes/gone.stl"), None);
        assert_eq!(found("x/../Meshes/arm.stl"), None);
    }

    #[test]
    fn files_are_read_once_and_again_when_they_change() {
        let tree = Tree::new();
        tree.write("a", "1");
        std::thread::sleep(std::time::Duration::from_millis(150));
        let cache = FileCache::default();
        let made = std::cell::Cell::new(0);
        let length = |limit| {
            let make = |bytes: Vec<u8>| {
                made.set(made.get() + 1);
                bytes.len()
            };
            tree.vfs().cached_read(&cache, &tree.path("a"), limit, make)
        };
        assert_eq!(
            (*length(9).unwrap(), *length(9).unwrap(), made.get()),
            (1, 1, 1)
        );
        tree.write("a", "123");
        assert_eq!((*length(9).unwrap(), made.get()), (3, 2));
        tree.write("a", "12345");
        assert!(length(3).is_err());
    }
}
