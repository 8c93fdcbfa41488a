//! The table of file numbers.

use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError, RwLock};

use base::{FastMap, FileId};

/// Numbers of paths, given out in order of first use and never taken back.
#[derive(Default)]
pub(super) struct Ids(RwLock<Table>);

#[derive(Default)]
struct Table {
    by_path: FastMap<Arc<Path>, FileId>,
    paths: Vec<Arc<Path>>,
}

impl Ids {
    /// The number of an absolute path.
    pub(super) fn id(&self, path: PathBuf) -> FileId {
        if let Some(id) = self.0.read().unwrap_or_else(PoisonError::into_inner).by_path.get(path.as_path()) {
            return *id;
        }
        let mut table = self.0.write().unwrap_or_else(PoisonError::into_inner);
        if let Some(id) = table.by_path.get(path.as_path()) {
            return *id;
        }
        let id = FileId(u32::try_from(table.paths.len()).unwrap_or(u32::MAX));
        let path: Arc<Path> = path.into();
        table.paths.push(path.clone());
        table.by_path.insert(path, id);
        id
    }

    /// The path of a number; empty for one that was never given out.
    pub(super) fn path(&self, id: FileId) -> Arc<Path> {
        let table = self.0.read().unwrap_or_else(PoisonError::into_inner);
        table.paths.get(id.0 as usize).cloned().unwrap_or_else(|| Path::new("").into())
    }
}
