//! A place for what somebody reads off something that never changes.
use std::any::Any;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// Something of a type that the reader knows.
#[derive(Clone, Default)]
pub struct Cache(OnceLock<Arc<dyn Any + Send + Sync>>);

impl Cache {
    /// What was read; made on first use. One type is kept: for another type, `make` is called every time.
    pub fn get_or_make<T: Any + Send + Sync>(&self, make: impl FnOnce() -> Arc<T>) -> Arc<T> {
        if let Some(Ok(value)) = self.0.get().map(|value| Arc::clone(value).downcast::<T>()) {
            return value;
        }
        let value = make();
        // A concurrent caller may have been first; both values are equal then.
        let _ = self.0.set(value.clone());
        value
    }
}

/// What is in it follows from what it stands beside.
impl fmt::Debug for Cache {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Cache")
    }
}
