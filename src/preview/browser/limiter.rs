//! How many connections may be open at the same time: a new one closes the oldest when there is no room.
//!
//! So nobody can keep others out by opening connections and sending nothing.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::Notify;

/// The connections that are open.
#[derive(Debug)]
pub(super) struct ConnectionLimiter {
    most: usize,
    inside: Mutex<VecDeque<Arc<Notify>>>,
}

/// One of them; makes room when dropped.
#[derive(Debug)]
pub(super) struct Permit {
    limiter: Arc<ConnectionLimiter>,
    own: Arc<Notify>,
}

impl ConnectionLimiter {
    /// Room for so many.
    pub fn new(most: usize) -> Arc<Self> {
        Arc::new(Self {
            most,
            inside: Mutex::default(),
        })
    }

    /// Admit a connection; the oldest has to go when there is no room.
    pub fn enter(self: &Arc<Self>) -> Permit {
        let own = Arc::new(Notify::new());
        let mut inside = self.inside.lock().unwrap_or_else(PoisonError::into_inner);
        while inside.len() >= self.most {
            let Some(oldest) = inside.pop_front() else {
                break;
            };
            oldest.notify_one();
        }
        inside.push_back(own.clone());
        Permit {
            limiter: self.clone(),
            own,
        }
    }

    #[cfg(test)]
    pub fn len(&self) -> usize {
        self.inside.lock().unwrap().len()
    }
}

impl Permit {
    /// Make room for good: nobody closes the owner from here on.
    pub fn leave(&self) {
        let mut inside = self
            .limiter
            .inside
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        inside.retain(|other| !Arc::ptr_eq(other, &self.own));
    }

    /// Returns when the room is needed for another connection.
    pub async fn lost(&self) {
        self.own.notified().await;
    }
}

impl Drop for Permit {
    fn drop(&mut self) {
        self.leave();
    }
}
