//! Lists, tuples, dicts and sets.
//!
//! Mutable containers are shared objects. Readers take a snapshot (a reference count, no copy) and let go of the lock
//! before they look at the items, so a list may contain itself; writers copy only if a snapshot is still around.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ecow::EcoVec;
use indexmap::{IndexMap, IndexSet};
use rustc_hash::FxBuildHasher;

use super::iterative_drop::{drop_iteratively, is_nested};
use super::{Key, Value};

/// The entries of a dict in insertion order.
pub(crate) type DictMap = IndexMap<Key, Value, FxBuildHasher>;
/// The elements of a set in insertion order.
pub(crate) type SetMap = IndexSet<Key, FxBuildHasher>;

/// How often a container was changed in place.
static CHANGES: AtomicU64 = AtomicU64::new(0);

/// How often a list, dict or set was changed in place since the program began: as long as that is the same, what holds one has
/// the same value.
pub fn changes_in_place() -> u64 {
    CHANGES.load(Ordering::SeqCst)
}

fn note_change() {
    CHANGES.fetch_add(1, Ordering::SeqCst);
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A Python list.
#[derive(Clone, Debug)]
pub struct List(Arc<ListObject>);

#[derive(Debug)]
struct ListObject {
    yaml: bool,
    items: Mutex<EcoVec<Value>>,
}

impl Drop for ListObject {
    fn drop(&mut self) {
        let items = std::mem::take(self.items.get_mut().unwrap_or_else(PoisonError::into_inner));
        if items.iter().any(is_nested) {
            drop_iteratively(items);
        }
    }
}

impl List {
    /// A list of `items`; `yaml` makes it wrap what is taken out of it.
    pub(crate) fn new(items: EcoVec<Value>, yaml: bool) -> Self {
        Self(Arc::new(ListObject {
            yaml,
            items: Mutex::new(items),
        }))
    }

    /// The items as they are now.
    pub fn snapshot(&self) -> EcoVec<Value> {
        lock(&self.0.items).clone()
    }

    /// Number of items.
    pub fn len(&self) -> usize {
        lock(&self.0.items).len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The item at `index`, wrapped if this is a list from YAML.
    pub fn get(&self, index: usize) -> Option<Value> {
        let item = lock(&self.0.items).get(index).cloned()?;
        Some(if self.0.yaml { item.wrapped() } else { item })
    }

    /// The items as iteration gives them.
    pub fn items(&self) -> EcoVec<Value> {
        let items = self.snapshot();
        if !self.0.yaml
            || !items
                .iter()
                .any(|item| matches!(item, Value::List(_) | Value::Dict(_)))
        {
            return items;
        }
        items.into_iter().map(Value::wrapped).collect()
    }

    /// Whether it comes from YAML.
    pub fn is_yaml(&self) -> bool {
        self.0.yaml
    }

    /// Change the items; `change` must not evaluate anything.
    pub(crate) fn edit<T>(&self, change: impl FnOnce(&mut EcoVec<Value>) -> T) -> T {
        note_change();
        change(&mut lock(&self.0.items))
    }

    /// Another list with the same items.
    pub(crate) fn copied(&self, yaml: bool) -> Self {
        Self::new(self.snapshot(), yaml)
    }

    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }
}

/// A Python tuple.
#[derive(Clone, Debug)]
pub struct Tuple(Arc<TupleObject>);

#[derive(Debug)]
struct TupleObject(EcoVec<Value>);

impl Drop for TupleObject {
    fn drop(&mut self) {
        if self.0.iter().any(is_nested) {
            drop_iteratively(std::mem::take(&mut self.0));
        }
    }
}

impl Tuple {
    /// A tuple of `items`.
    pub(crate) fn new(items: EcoVec<Value>) -> Self {
        Self(Arc::new(TupleObject(items)))
    }

    /// The items.
    pub fn items(&self) -> &[Value] {
        &self.0.0
    }

    /// The items, shared.
    pub(crate) fn snapshot(&self) -> EcoVec<Value> {
        self.0.0.clone()
    }

    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }
}

/// A Python dict.
#[derive(Clone, Debug)]
pub struct Dict(Arc<DictObject>);

#[derive(Debug)]
struct DictObject {
    yaml: bool,
    map: Mutex<Arc<DictMap>>,
}

impl Drop for DictObject {
    fn drop(&mut self) {
        let map = self.map.get_mut().unwrap_or_else(PoisonError::into_inner);
        if map
            .iter()
            .any(|(key, value)| is_nested(key.value()) || is_nested(value))
        {
            drop_iteratively(std::mem::take(map));
        }
    }
}

impl Dict {
    /// A dict; `yaml` gives it dotted access.
    pub(crate) fn new(map: DictMap, yaml: bool) -> Self {
        Self(Arc::new(DictObject {
            yaml,
            map: Mutex::new(Arc::new(map)),
        }))
    }

    /// The entries as they are now.
    pub(crate) fn snapshot(&self) -> Arc<DictMap> {
        Arc::clone(&lock(&self.0.map))
    }

    /// Keys and values in order, values unwrapped.
    pub fn entries(&self) -> Vec<(Value, Value)> {
        self.snapshot()
            .iter()
            .map(|(key, value)| (key.value().clone(), value.clone()))
            .collect()
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        lock(&self.0.map).len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether it comes from YAML or `dotify`.
    pub fn is_yaml(&self) -> bool {
        self.0.yaml
    }

    /// The value of `key` as `.get(key)` gives it: never wrapped.
    pub(crate) fn get(&self, key: &Key) -> Option<Value> {
        lock(&self.0.map).get(key).cloned()
    }

    /// The value of a string key, unwrapped.
    pub fn get_str(&self, key: &str) -> Option<Value> {
        self.get(&Key::text(key))
    }

    /// Change the entries; `change` must not evaluate anything.
    pub(crate) fn edit<T>(&self, change: impl FnOnce(&mut DictMap) -> T) -> T {
        note_change();
        change(Arc::make_mut(&mut lock(&self.0.map)))
    }

    /// Another dict with the same entries.
    pub(crate) fn copied(&self, yaml: bool) -> Self {
        Self(Arc::new(DictObject {
            yaml,
            map: Mutex::new(self.snapshot()),
        }))
    }

    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }
}

/// A Python set or frozenset.
#[derive(Clone, Debug)]
pub struct Set(Arc<SetObject>);

#[derive(Debug)]
struct SetObject {
    frozen: bool,
    items: Mutex<Arc<SetMap>>,
}

impl Drop for SetObject {
    fn drop(&mut self) {
        let items = self.items.get_mut().unwrap_or_else(PoisonError::into_inner);
        if items.iter().any(|key| is_nested(key.value())) {
            drop_iteratively(std::mem::take(items));
        }
    }
}

impl Set {
    /// A set, or a frozenset.
    pub(crate) fn new(items: SetMap, frozen: bool) -> Self {
        Self(Arc::new(SetObject {
            frozen,
            items: Mutex::new(Arc::new(items)),
        }))
    }

    /// The elements as they are now, in insertion order.
    pub(crate) fn snapshot(&self) -> Arc<SetMap> {
        Arc::clone(&lock(&self.0.items))
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        lock(&self.0.items).len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether it is a frozenset.
    pub fn is_frozen(&self) -> bool {
        self.0.frozen
    }

    /// Change the elements; `change` must not evaluate anything.
    pub(crate) fn edit<T>(&self, change: impl FnOnce(&mut SetMap) -> T) -> T {
        note_change();
        change(Arc::make_mut(&mut lock(&self.0.items)))
    }

    /// The elements in the order Python shows them.
    pub(crate) fn ordered(&self) -> Vec<Value> {
        super::key::set_order(&self.snapshot())
    }

    pub(crate) fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }
}
