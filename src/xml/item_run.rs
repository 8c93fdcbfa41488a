//! Some items in a row, and what was read off them together.
use std::any::Any;
use std::ops::Deref;
use std::sync::Arc;

use super::item::Item;
use base::Cache;

/// Some items in a row. States of a document share the rows that no edit touched, so what is read off one stays with it.
#[derive(Clone)]
pub struct ItemRun {
    items: Vec<Arc<Item>>,
    cache: Cache,
}

impl ItemRun {
    pub(super) fn new(items: Vec<Arc<Item>>) -> Self {
        let cache = Cache::default();
        Self { items, cache }
    }

    /// Replace the items of `range` by `new`.
    pub(super) fn splice(&mut self, range: std::ops::Range<usize>, new: Vec<Arc<Item>>) {
        self.items.splice(range, new);
        self.cache = Cache::default();
    }

    /// What was read off the items; made on first use. One type is kept: for another type, `make` is called every time.
    pub fn cached<T: Any + Send + Sync>(
        &self,
        make: impl FnOnce(&[Arc<Item>]) -> Arc<T>,
    ) -> Arc<T> {
        self.cache.get_or_make(|| make(&self.items))
    }
}

impl Deref for ItemRun {
    type Target = [Arc<Item>];

    fn deref(&self) -> &[Arc<Item>] {
        &self.items
    }
}
