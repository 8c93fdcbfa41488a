//! How many may wait at the same time: who comes when it is full takes the place of who waits longest.
//!
//! So nobody can keep others out by opening connections and saying nothing.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::Notify;

/// Those who are there.
#[derive(Debug)]
pub(super) struct Crowd {
    most: usize,
    inside: Mutex<VecDeque<Arc<Notify>>>,
}

/// A place among them; leaves when dropped.
#[derive(Debug)]
pub(super) struct Pass {
    crowd: Arc<Crowd>,
    own: Arc<Notify>,
}

impl Crowd {
    /// Room for so many.
    pub fn new(most: usize) -> Arc<Self> {
        Arc::new(Self { most, inside: Mutex::default() })
    }

    /// Come in; who is there longest has to go when there is no room.
    pub fn enter(self: &Arc<Self>) -> Pass {
        let own = Arc::new(Notify::new());
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        while inside.len() >= self.most {
            let Some(oldest) = inside.pop_front() else { break };
            oldest.notify_one();
        }
        inside.push_back(own.clone());
        Pass { crowd: self.clone(), own }
    }

    #[cfg(test)]
    pub fn len(&self) -> usize {
        self.inside.lock().unwrap().len()
    }
}

impl Pass {
    /// Leave for good: the place is no longer needed, and nobody sends its owner away.
    pub fn leave(&self) {
        let mut inside = self.crowd.inside.lock().unwrap_or_else(PoisonError::into_inner);
        inside.retain(|other| !Arc::ptr_eq(other, &self.own));
    }

    /// Comes back when the place is needed for somebody else.
    pub async fn lost(&self) {
        self.own.notified().await;
    }
}

impl Drop for Pass {
    fn drop(&mut self) {
        self.leave();
    }
}
