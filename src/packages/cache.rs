//! Remembered answers.

use std::borrow::Borrow;
use std::hash::Hash;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use base::FastMap;

/// Answers by question. Threads that ask the same at the same time share one search; the lock is not
/// held while searching.
pub struct AnswerCache<K, V>(Mutex<FastMap<K, Arc<OnceLock<V>>>>);

impl<K, V> Default for AnswerCache<K, V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash, V: Clone> AnswerCache<K, V> {
    /// The answer to `key`; `make` runs the first time.
    pub fn get(&self, key: K, make: impl FnOnce() -> V) -> V {
        let cell = self
            .0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .entry(key)
            .or_default()
            .clone();
        cell.get_or_init(make).clone()
    }

    /// The answer to `key`, where it is known.
    pub fn known<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        let cells = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        cells.get(key)?.get().cloned()
    }

    /// Forget the answer to `key`.
    pub fn remove(&self, key: &K) {
        let mut cells = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        cells.remove(key);
    }

    /// Forget everything.
    pub fn clear(&self) {
        self.0
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clear();
    }
}
