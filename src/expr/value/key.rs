//! Dict keys and set elements: Python's equality and hash.

use std::hash::{Hash, Hasher};

use rustc_hash::FxHasher;

use super::{Set, SetMap, Str, Value};
use crate::numeric::{Num, hash_num};
use crate::stop::{Eval, Stop};
use base::limits::{KEY_DEPTH, KEY_PARTS};

/// A hashable value.
#[derive(Clone, Debug)]
pub(crate) struct Key(Value);

impl Key {
    /// A key, or `unhashable type: 'list'`.
    pub(crate) fn new(value: Value) -> Eval<Self> {
        match &value {
            Value::Str(_) | Value::Int(_) => {}
            other => {
                let mut parts = 0;
                check(other, 0, &mut parts)?;
            }
        }
        Ok(Self(value))
    }

    /// A key to look up in a set, where a set counts as if it were frozen.
    pub(crate) fn sought(value: &Value) -> Eval<Self> {
        match value {
            Value::Set(set) => Self::new(Value::Set(Set::new((*set.snapshot()).clone(), true))),
            other => Self::new(other.clone()),
        }
    }

    /// A string key.
    pub(crate) fn text(text: impl Into<Str>) -> Self {
        Self(Value::Str(text.into()))
    }

    pub(crate) fn value(&self) -> &Value {
        &self.0
    }

    pub(crate) fn into_value(self) -> Value {
        self.0
    }
}

fn check(value: &Value, depth: u32, parts: &mut u32) -> Eval<()> {
    *parts += 1;
    if depth > KEY_DEPTH || *parts > KEY_PARTS {
        return Err(Stop::recursion(" while hashing a tuple"));
    }
    match value {
        Value::Unknown => Err(Stop::Unknown),
        Value::Tuple(tuple) => tuple
            .items()
            .iter()
            .try_for_each(|item| check(item, depth + 1, parts)),
        Value::Set(set) if set.is_frozen() => set
            .snapshot()
            .iter()
            .try_for_each(|item| check(item.value(), depth + 1, parts)),
        Value::List(_)
        | Value::Dict(_)
        | Value::Set(_)
        | Value::Slice(_)
        | Value::Scope(_)
        | Value::Module(_) => Err(Stop::typ(format!(
            "unhashable type: '{}'",
            value.type_name()
        ))),
        Value::View(view) if view.kind != super::ViewKind::Values => Err(Stop::typ(format!(
            "unhashable type: '{}'",
            value.type_name()
        ))),
        _ => Ok(()),
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        equal(&self.0, &other.0)
    }
}

impl Eq for Key {}

/// Equality of hashable values.
fn equal(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Str(a), Value::Str(b)) => a == b,
        (Value::Int(a), Value::Int(b)) => a == b,
        (Value::Bytes(a), Value::Bytes(b)) => a == b,
        (Value::Tuple(a), Value::Tuple(b)) => {
            let (x, y) = (a.items(), b.items());
            a.address() == b.address()
                || (x.len() == y.len() && x.iter().zip(y).all(|(x, y)| equal(x, y)))
        }
        (Value::Set(a), Value::Set(b)) => {
            let (a, b) = (a.snapshot(), b.snapshot());
            a.len() == b.len() && a.iter().all(|item| b.contains(item))
        }
        (Value::Range(a), Value::Range(b)) => {
            let len = a.len();
            len == b.len() && (len == 0 || (a.start == b.start && (len == 1 || a.step == b.step)))
        }
        (Value::Date(a), Value::Date(b)) => a == b,
        // The object `nan` is found again by identity.
        (Value::Float(a), Value::Float(b)) if a.is_nan() && b.is_nan() => true,
        _ => match (Num::of(a), Num::of(b)) {
            (Some(a), Some(b)) => a.equals(b),
            (None, None) => a.same(b),
            _ => false,
        },
    }
}

impl Hash for Key {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match &self.0 {
            Value::Str(text) => text.hash(state),
            other => state.write_i64(hash_value(other)),
        }
    }
}

/// A hash that equals Python's for numbers and is merely stable for the rest.
pub(crate) fn hash_value(value: &Value) -> i64 {
    if let Some(number) = Num::of(value) {
        return hash_num(number);
    }
    let mut state = FxHasher::default();
    std::mem::discriminant(value).hash(&mut state);
    match value {
        Value::Str(text) => text.hash(&mut state),
        Value::Bytes(bytes) => bytes.hash(&mut state),
        Value::Tuple(tuple) => tuple
            .items()
            .iter()
            .for_each(|item| state.write_i64(hash_value(item))),
        Value::Set(set) => {
            let sum = set
                .snapshot()
                .iter()
                .fold(0i64, |sum, item| sum.wrapping_add(hash_value(item.value())));
            state.write_i64(sum);
        }
        Value::Range(range) => range.len().hash(&mut state),
        Value::Date(date) => date.hash(&mut state),
        Value::Type(kind) => kind.hash(&mut state),
        Value::Builtin(builtin) => builtin.function.name.hash(&mut state),
        other => other.address().hash(&mut state),
    }
    i64::from_ne_bytes(state.finish().to_ne_bytes())
}

/// The elements of a set in the order Python iterates them, if they are all numbers; else in insertion order
/// (Python's order of strings changes from run to run).
pub(crate) fn set_order(items: &SetMap) -> Vec<Value> {
    let hashes: Option<Vec<i64>> = items
        .iter()
        .map(|key| Num::of(key.value()).map(hash_num))
        .collect();
    let values = items.iter().map(|key| key.value().clone());
    match hashes {
        Some(hashes) => {
            let mut slots = slots(&hashes).into_iter().zip(values).collect::<Vec<_>>();
            slots.sort_by_key(|(slot, _)| *slot);
            slots.into_iter().map(|(_, value)| value).collect()
        }
        None => values.collect(),
    }
}

/// The slot of each element in the open-addressing table that CPython builds by adding them one by one.
fn slots(hashes: &[i64]) -> Vec<usize> {
    let mut size = 8usize;
    let mut table = HashTable::new(size);
    for (used, &hash) in hashes.iter().enumerate() {
        table.insert(hash, used);
        let used = used + 1;
        if used * 5 >= (size - 1) * 3 {
            let wanted = if used > 50_000 { used * 2 } else { used * 4 };
            while size <= wanted {
                size *= 2;
            }
            table = table.resized(size);
        }
    }
    let mut slots = vec![0; hashes.len()];
    for (slot, entry) in table.entries.iter().enumerate() {
        if let Some(place) = entry.and_then(|(_, item)| slots.get_mut(item)) {
            *place = slot;
        }
    }
    slots
}

/// Hash and index of the element in each slot.
struct HashTable {
    entries: Vec<Option<(i64, usize)>>,
}

impl HashTable {
    fn new(size: usize) -> Self {
        Self {
            entries: vec![None; size],
        }
    }

    fn resized(&self, size: usize) -> Self {
        let mut bigger = Self::new(size);
        for &(hash, item) in self.entries.iter().flatten() {
            bigger.insert(hash, item);
        }
        bigger
    }

    /// Up to ten neighbors are tried before the next jump.
    fn insert(&mut self, hash: i64, item: usize) {
        const NEIGHBORS: usize = 9;
        let mask = self.entries.len() - 1;
        let hash_bits = hash as usize;
        let (mut perturb, mut at) = (hash_bits, hash_bits & mask);
        loop {
            let run = if at + NEIGHBORS <= mask { NEIGHBORS } else { 0 };
            for slot in at..=at + run {
                if let Some(free @ None) = self.entries.get_mut(slot) {
                    *free = Some((hash, item));
                    return;
                }
            }
            perturb >>= 5;
            at = at.wrapping_mul(5).wrapping_add(1).wrapping_add(perturb) & mask;
        }
    }
}
