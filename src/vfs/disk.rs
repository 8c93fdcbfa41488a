//! What lies below the buffers: the disk of this machine, or files in memory where there is none, as in a browser.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError, RwLock};

use super::DirEntry;
use super::error::{LoadError, LoadErrorKind};
use super::read::{self, EntryKind, Identity, Stamp, Stat};

/// Said of a file that may not be looked at.
const OUTSIDE: &str = "Outside of the folders that may be read";

/// Where files are.
#[derive(Default)]
pub(super) enum Disk {
    /// The file system of the machine.
    #[default]
    System,
    /// Folders of the machine, without links in their paths; nothing outside of them is seen.
    Within(Vec<PathBuf>),
    /// Files that somebody put there.
    Memory(Memory),
}

/// Files that somebody put, and those whose content somebody should put.
#[derive(Default)]
pub(super) struct Memory {
    files: RwLock<MemoryFiles>,
    wanted: Mutex<BTreeSet<PathBuf>>,
}

/// Files in memory by their absolute paths. Folders exist as long as there is something in them.
pub(super) type MemoryFiles = BTreeMap<PathBuf, MemoryFile>;

/// A file in memory.
pub(super) struct MemoryFile {
    /// None: only its name is known.
    bytes: Option<Arc<[u8]>>,
    /// Different for every content of every file.
    revision: u64,
}

impl Disk {
    /// A place for files in memory.
    pub(super) fn memory() -> Self {
        Self::Memory(Memory::default())
    }

    /// Only these folders of the machine; all of it when there are none.
    pub(super) fn within(folders: &[PathBuf]) -> Self {
        if folders.is_empty() {
            return Self::System;
        }
        let real = |folder: &PathBuf| std::fs::canonicalize(folder).unwrap_or(folder.clone());
        Self::Within(folders.iter().map(real).collect())
    }

    /// Put a file in memory, or take it away; whether this is the place for it.
    pub(super) fn put(&self, path: PathBuf, bytes: Option<Vec<u8>>, revision: u64) -> bool {
        let file = bytes.map(|bytes| MemoryFile {
            bytes: Some(bytes.into()),
            revision,
        });
        self.set(path, file)
    }

    /// Put the name of a file in memory whose content is elsewhere; whether this is the place for it.
    pub(super) fn put_name(&self, path: PathBuf, revision: u64) -> bool {
        let file = MemoryFile {
            bytes: None,
            revision,
        };
        self.set(path, Some(file))
    }

    fn set(&self, path: PathBuf, file: Option<MemoryFile>) -> bool {
        let Self::Memory(Memory { files, .. }) = self else {
            return false;
        };
        let mut files = files.write().unwrap_or_else(PoisonError::into_inner);
        match file {
            Some(file) => files.insert(path, file),
            None => files.remove(&path),
        };
        true
    }

    /// The files whose content was asked for, and of which only the names are here.
    pub(super) fn take_wanted(&self) -> Vec<PathBuf> {
        let Self::Memory(Memory { wanted, .. }) = self else {
            return Vec::new();
        };
        let mut wanted = wanted.lock().unwrap_or_else(PoisonError::into_inner);
        std::mem::take(&mut *wanted).into_iter().collect()
    }

    /// The state of a file or folder.
    ///
    /// # Errors
    /// When there is none, or none that may be looked at.
    pub(super) fn stat(&self, path: &Path) -> Result<Stat, LoadError> {
        self.in_memory(|files| stat(files, path))
            .unwrap_or_else(|| self.allowed(path).and_then(|()| read::stat(path)))
    }

    /// The bytes of a regular file of at most `limit` bytes, `known` to be one since a moment ago.
    ///
    /// # Errors
    /// When it is not one, or cannot be read.
    pub(super) fn bytes(
        &self,
        path: &Path,
        known: &Stat,
        limit: u64,
    ) -> Result<Vec<u8>, LoadError> {
        let in_memory = self.in_memory(|files| {
            read::may_be_read(known.kind, known.size, path, limit)?;
            let file = files
                .get(path)
                .ok_or_else(|| LoadError::new(LoadErrorKind::NotFound, path))?;
            Ok(file.bytes.clone())
        });
        let in_memory = in_memory.map(|found| match found? {
            Some(bytes) => Ok(bytes.to_vec()),
            None => Err(self.want(path)),
        });
        in_memory.unwrap_or_else(|| {
            self.allowed(path)
                .and_then(|()| read::bytes(path, known, limit))
        })
    }

    /// Note that the content of a file is wanted; why there is none.
    fn want(&self, path: &Path) -> LoadError {
        if let Self::Memory(Memory { wanted, .. }) = self {
            let mut wanted = wanted.lock().unwrap_or_else(PoisonError::into_inner);
            wanted.insert(path.to_owned());
        }
        LoadError::elsewhere(path)
    }

    /// The names in the folder at an absolute path, each looked at when it is asked for.
    pub(super) fn entries(&self, path: &Path) -> impl Iterator<Item = DirEntry> + use<> {
        let in_memory = self.in_memory(|files| entries(files, path));
        let is_on_disk = in_memory.is_none() && self.allowed(path).is_ok();
        let on_disk = is_on_disk.then(|| read::entries(path));
        in_memory
            .into_iter()
            .flatten()
            .chain(on_disk.into_iter().flatten())
    }

    /// A path with links and `..` resolved; none when it does not exist.
    pub(super) fn canonical(&self, path: &Path) -> Option<PathBuf> {
        let in_memory = self.in_memory(|files| {
            let path = super::without_parents(path);
            stat(files, &path).is_ok().then_some(path)
        });
        in_memory.unwrap_or_else(|| {
            let path = std::fs::canonicalize(path).ok()?;
            self.allowed(&path).is_ok().then_some(path)
        })
    }

    /// Whether there is anything at `path`, be it a link that leads nowhere.
    pub(super) fn is_present(&self, path: &Path) -> bool {
        let in_memory = self.in_memory(|files| stat(files, path).is_ok());
        in_memory.unwrap_or_else(|| self.is_below(path) && std::fs::symlink_metadata(path).is_ok())
    }

    /// Whether there is a folder at `path` that is no link.
    pub(super) fn is_own_folder(&self, path: &Path) -> bool {
        let in_memory = self
            .in_memory(|files| stat(files, path).is_ok_and(|stat| stat.kind == EntryKind::Folder));
        in_memory.unwrap_or_else(|| {
            self.is_below(path) && path.symlink_metadata().is_ok_and(|found| found.is_dir())
        })
    }

    /// Whether a file of the machine may be looked at: it lies in the folders that are seen, wherever links lead.
    ///
    /// # Errors
    /// One that says so, and the same whether there is such a file or not.
    fn allowed(&self, path: &Path) -> Result<(), LoadError> {
        let Self::Within(folders) = self else {
            return Ok(());
        };
        let real = std::fs::canonicalize(path);
        // of a file that does not exist, the folders around it say where it would be
        let around = || {
            let mut folders = path.ancestors().skip(1);
            folders.find_map(|folder| std::fs::canonicalize(folder).ok())
        };
        let lies = real.as_ref().ok().cloned().or_else(around);
        if !lies.is_some_and(|lies| folders.iter().any(|folder| lies.starts_with(folder))) {
            return Err(LoadError::refused(OUTSIDE, path));
        }
        real.map(drop)
            .map_err(|error| LoadError::from_io(&error, path))
    }

    /// Whether the folder that holds `path` may be looked at.
    fn is_below(&self, path: &Path) -> bool {
        path.parent()
            .is_none_or(|folder| self.allowed(folder).is_ok())
    }

    /// The files in memory below a folder; none when they are on the disk.
    pub(super) fn below(&self, folder: &Path) -> Option<Vec<PathBuf>> {
        self.in_memory(|files| below(files, folder).map(|(path, _)| path.clone()).collect())
    }

    fn in_memory<T>(&self, look: impl FnOnce(&MemoryFiles) -> T) -> Option<T> {
        match self {
            Self::System | Self::Within(_) => None,
            Self::Memory(Memory { files, .. }) => {
                Some(look(&files.read().unwrap_or_else(PoisonError::into_inner)))
            }
        }
    }
}

/// The files below a folder, in the order of their paths.
fn below<'a>(
    files: &'a MemoryFiles,
    folder: &'a Path,
) -> impl Iterator<Item = (&'a PathBuf, &'a MemoryFile)> {
    let after = (Bound::Excluded(folder), Bound::Unbounded);
    files
        .range::<Path, _>(after)
        .take_while(move |(path, _)| path.starts_with(folder))
}

fn stat(files: &MemoryFiles, path: &Path) -> Result<Stat, LoadError> {
    if let Some(file) = files.get(path) {
        let size = file.bytes.as_ref().map_or(0, |bytes| bytes.len()) as u64;
        return Ok(Stat {
            kind: EntryKind::Regular,
            size,
            stamp: Stamp::Buffer(file.revision),
            identity: None,
        });
    }
    // what changes when names in it come and go
    let mut inside = below(files, path).peekable();
    if inside.peek().is_none() && path.parent().is_some() {
        return Err(LoadError::new(LoadErrorKind::NotFound, path));
    }
    let names: Vec<&Path> = inside.map(|(path, _)| path.as_path()).collect();
    Ok(Stat {
        kind: EntryKind::Folder,
        size: 0,
        stamp: Stamp::Content(read::hash(&names)),
        identity: Some(Identity::of_name(read::hash(path))),
    })
}

/// The names in a folder.
fn entries(files: &MemoryFiles, folder: &Path) -> Vec<DirEntry> {
    let mut found: Vec<DirEntry> = Vec::new();
    for (path, _) in below(files, folder) {
        let Ok(rest) = path.strip_prefix(folder) else {
            continue;
        };
        let mut parts = rest.components();
        let Some(name) = parts.next().and_then(|name| name.as_os_str().to_str()) else {
            continue;
        };
        if found.last().is_none_or(|last| last.name != name) {
            found.push(DirEntry {
                name: name.to_owned(),
                is_dir: parts.next().is_some(),
            });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::super::{Vfs, without_parents};

    fn vfs(files: &[(&str, &str)]) -> Vfs {
        let vfs = Vfs::in_memory(1000, PathBuf::from("/w"));
        for (path, text) in files {
            vfs.put(Path::new(path), Some(text.as_bytes().to_vec()));
        }
        vfs
    }

    #[test]
    fn files_and_the_folders_they_make() {
        let vfs = vfs(&[
            ("a/urdf/arm.xacro", "<robot/>"),
            ("a/package.xml", "<package/>"),
            ("ab/x", ""),
        ]);
        assert_eq!(
            vfs.text(Path::new("a/urdf/../urdf/arm.xacro"))
                .unwrap()
                .text,
            "<robot/>"
        );
        assert!(
            vfs.is_dir(Path::new("a/urdf"))
                && vfs.is_dir(Path::new("/"))
                && !vfs.exists(Path::new("b"))
        );
        let names = |folder: &str| {
            let list = vfs.list_dir(Path::new(folder));
            list.iter()
                .map(|entry| (entry.name.clone(), entry.is_dir))
                .collect::<Vec<_>>()
        };
        assert_eq!(names("/w"), [("a".into(), true), ("ab".into(), true)]);
        assert_eq!(
            names("a"),
            [("package.xml".into(), false), ("urdf".into(), true)]
        );
        assert_eq!(
            vfs.text(Path::new("a")).unwrap_err().strerror,
            "Is a directory"
        );
        let mut left = 100;
        assert_eq!(
            vfs.glob("a/*/*.xacro", Path::new("/w"), &mut left)
                .unwrap()
                .len(),
            1
        );
        assert_eq!(
            vfs.canonical(Path::new("/w/b/../a")),
            without_parents(Path::new("/w/a"))
        );
    }

    #[test]
    fn content_that_is_elsewhere_is_asked_for() {
        let vfs = vfs(&[("a/package.xml", "<package/>")]);
        let mesh = Path::new("/w/a/mesh.stl");
        assert!(vfs.put_name(mesh) && vfs.is_file(mesh) && vfs.take_wanted().is_empty());
        assert_eq!(vfs.list_dir(Path::new("a")).len(), 2);
        let refused = vfs.bytes(mesh, 100).unwrap_err();
        assert_eq!(refused.strerror, "its content was not loaded");
        assert_eq!(vfs.take_wanted(), [mesh.to_owned()]);
        assert!(vfs.take_wanted().is_empty());
        vfs.put(mesh, Some(b"solid".to_vec()));
        assert_eq!(vfs.bytes(mesh, 100).unwrap(), b"solid");
        let open = vfs.overlay([(mesh.to_owned(), "text".to_owned())]);
        assert_eq!(open.text(mesh).unwrap().text, "text");
        assert_eq!(open.uncovered().unwrap().text(mesh).unwrap().text, "solid");
    }

    #[test]
    fn what_is_put_again_is_read_again() {
        let vfs = vfs(&[("a", "<a/>")]);
        let root = || {
            vfs.document(Path::new("a"))
                .map(|file| file.document.root().unwrap().name().to_owned())
        };
        assert_eq!(root().unwrap(), "a");
        vfs.put(Path::new("a"), Some(b"<b/>".to_vec()));
        assert_eq!(root().unwrap(), "b");
        vfs.put(Path::new("a"), None);
        assert_eq!(root().unwrap_err().strerror, "No such file or directory");
        assert!(
            !Vfs::new(1).put(Path::new("a"), None),
            "files on a disk are not replaced"
        );
    }
}
