//! The table of file numbers.

use std::borrow::Borrow;
use std::ffi::OsStr;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError, RwLock};

use base::{FastMap, FileId, IdVec};

/// Numbers of paths, given out in order of first use and never taken back.
#[derive(Default)]
pub(super) struct Ids(RwLock<IdTable>);

#[derive(Default)]
struct IdTable {
    by_path: FastMap<Spelled, FileId>,
    paths: IdVec<FileId, Arc<Path>>,
}

/// A path that is compared letter by letter: all of them are absolute and without detours, and to take each apart, as paths
/// are compared, would cost more than all else about a file.
struct Spelled(Arc<Path>);

impl PartialEq for Spelled {
    fn eq(&self, other: &Self) -> bool {
        self.0.as_os_str() == other.0.as_os_str()
    }
}

impl Eq for Spelled {}

impl Hash for Spelled {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.as_os_str().hash(state);
    }
}

impl Borrow<OsStr> for Spelled {
    fn borrow(&self) -> &OsStr {
        self.0.as_os_str()
    }
}

impl Ids {
    /// The number of an absolute path.
    pub(super) fn id(&self, path: PathBuf) -> FileId {
        if let Some(id) = self
            .0
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .by_path
            .get(path.as_os_str())
        {
            return *id;
        }
        let mut table = self.0.write().unwrap_or_else(PoisonError::into_inner);
        if let Some(id) = table.by_path.get(path.as_os_str()) {
            return *id;
        }
        let path: Arc<Path> = path.into();
        let id = table.paths.push(path.clone());
        table.by_path.insert(Spelled(path), id);
        id
    }

    /// The path of a number; empty for one that was never given out.
    pub(super) fn path(&self, id: FileId) -> Arc<Path> {
        let table = self.0.read().unwrap_or_else(PoisonError::into_inner);
        table
            .paths
            .get(id)
            .cloned()
            .unwrap_or_else(|| Path::new("").into())
    }
}
