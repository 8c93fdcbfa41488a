//! What was made of a file, kept until the file changes.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::error::LoadError;
use super::read::Stamp;
use base::{FastMap, FileId};

type Cell<T> = Arc<OnceLock<Result<Arc<T>, LoadError>>>;

struct Slot<T> {
    stamp: Stamp,
    /// Whether the stamp was old enough when the file was read to notice every later change.
    settled: bool,
    cell: Cell<T>,
}

/// One value per file. Threads that ask for the same value at the same time share one computation.
pub(super) struct Cache<T>(Mutex<FastMap<FileId, Slot<T>>>);

impl<T> Default for Cache<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> Cache<T> {
    /// The value for the file as it is now; `make` runs when the stamp is new.
    pub(super) fn get(
        &self,
        id: FileId,
        stamp: Stamp,
        make: impl FnOnce() -> Result<Arc<T>, LoadError>,
    ) -> Result<Arc<T>, LoadError> {
        let cell = self.cell(id, stamp);
        let result = cell.get_or_init(make).clone();
        if result.is_err() {
            // An error may go away without a change of the stamp (permissions): ask again next time.
            let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            if slots
                .get(&id)
                .is_some_and(|slot| Arc::ptr_eq(&slot.cell, &cell))
            {
                slots.remove(&id);
            }
        }
        result
    }

    /// Whether there is a value for the file as it is now.
    pub(super) fn knows(&self, id: FileId, stamp: Stamp) -> bool {
        let slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        slots
            .get(&id)
            .is_some_and(|slot| slot.stamp == stamp && slot.settled)
    }

    /// The value that was made last for the file, which may have changed since.
    pub(super) fn latest(&self, id: FileId) -> Option<Arc<T>> {
        let slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        slots.get(&id)?.cell.get()?.as_ref().ok().cloned()
    }

    fn cell(&self, id: FileId, stamp: Stamp) -> Cell<T> {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match slots.get(&id) {
            Some(slot) if slot.stamp == stamp && slot.settled => slot.cell.clone(),
            _ => {
                let cell = Cell::default();
                slots.insert(
                    id,
                    Slot {
                        stamp,
                        settled: stamp.is_settled(),
                        cell: cell.clone(),
                    },
                );
                cell
            }
        }
    }
}
