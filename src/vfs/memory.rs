//! Files in memory, which somebody puts there.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use super::disk::Disk;
use super::{SharedState, Vfs};

impl Vfs {
    /// Files in memory, at first none: see [`Vfs::put`]. Nothing of the machine is seen.
    pub fn in_memory(max_file_bytes: u64, cwd: PathBuf) -> Self {
        let shared = Arc::new(SharedState {
            disk: Disk::memory(),
            ..SharedState::default()
        });
        Self {
            shared,
            ..Self::with_cwd(max_file_bytes, cwd)
        }
    }

    /// Put a file among those in memory, or take it away (`None`); false where files are on a disk, which stay as they
    /// are.
    pub fn put(&self, path: &Path, bytes: Option<Vec<u8>>) -> bool {
        self.shared
            .disk
            .put(self.absolute(path), bytes, self.next_revision())
    }

    /// Put the name of a file among those in memory whose content is elsewhere: see [`Vfs::take_wanted`].
    pub fn put_name(&self, path: &Path) -> bool {
        let (path, revision) = (self.absolute(path), self.next_revision());
        self.shared.disk.put_name(path, revision)
    }

    /// The files in memory of which only the names were put, and whose content was asked for since the last call.
    pub fn take_wanted(&self) -> Vec<PathBuf> {
        self.shared.disk.take_wanted()
    }

    /// Whether files are in memory, so that none can be written.
    pub fn is_in_memory(&self) -> bool {
        matches!(self.shared.disk, Disk::Memory(_))
    }

    /// The files in memory as they are without what is open; none where files are on a disk.
    pub fn uncovered(&self) -> Option<Self> {
        let limit = self.max_file_bytes.load(Ordering::Relaxed);
        self.is_in_memory().then(|| Self {
            shared: self.shared.clone(),
            ..Self::with_cwd(limit, self.cwd.clone())
        })
    }

    /// The files in memory below a folder, in the order of their paths; none where files are on a disk.
    pub fn files_in_memory(&self, folder: &Path) -> Option<Vec<PathBuf>> {
        self.shared.disk.below(&self.absolute(folder))
    }
}
