//! Between the protocol and the analysis: events are added here, and one thread takes them out in order.
//!
//! A handler may not touch state. It adds its event as its first statement and then only waits, so events are taken
//! in the order in which their messages arrived.
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::oneshot;
use tower_lsp::jsonrpc;

use crate::failure::RequestFailure;
use base::CancelFlag;

/// Where events `E` are added.
pub(super) struct Queue<E> {
    events: Sender<E>,
    status: QueueStatus,
}

/// How many events wait, and what is done meanwhile.
#[derive(Clone, Default)]
pub(super) struct QueueStatus {
    waiting: Arc<AtomicUsize>,
    /// Edits that were read and are not in the queue yet.
    announced: Arc<AtomicUsize>,
    background: Arc<Mutex<CancelFlag>>,
}

impl QueueStatus {
    /// Whether an event waits.
    pub fn has_waiting(&self) -> bool {
        self.waiting.load(Ordering::Acquire) > 0
    }

    /// A flag for work that any new event should interrupt.
    pub fn background(&self) -> CancelFlag {
        let flag = CancelFlag::default();
        *self
            .background
            .lock()
            .unwrap_or_else(PoisonError::into_inner) = flag.clone();
        if self.has_waiting() {
            flag.cancel();
        }
        flag
    }

    /// An edit was read: its event will be added in a moment, so what is said of the text now would be out of date.
    pub fn announce_edit(&self) {
        self.announced.fetch_add(1, Ordering::AcqRel);
    }

    /// An edit that was announced is here. Said by who takes it out and not by who adds it, whose word could come too
    /// late: it would be waited for.
    pub fn edit_arrived(&self) {
        let one_less = |announced: usize| Some(announced.saturating_sub(1));
        let _ = self
            .announced
            .fetch_update(Ordering::AcqRel, Ordering::Acquire, one_less);
    }

    /// Whether an edit is on its way.
    pub fn is_edit_announced(&self) -> bool {
        self.announced.load(Ordering::Acquire) > 0
    }

    /// What was announced did not come: it was no edit after all.
    pub fn forget_announced(&self) {
        self.announced.store(0, Ordering::Release);
    }

    /// An event was taken out.
    pub fn taken(&self) {
        self.waiting.fetch_sub(1, Ordering::AcqRel);
    }
}

/// A new queue, and its other end.
pub(super) fn queue<E>() -> (Queue<E>, Receiver<E>, QueueStatus) {
    let (events, taken) = mpsc::channel();
    let status = QueueStatus::default();
    (
        Queue {
            events,
            status: status.clone(),
        },
        taken,
        status,
    )
}

// a derived one would ask for events that can be cloned
impl<E> Clone for Queue<E> {
    fn clone(&self) -> Self {
        Self {
            events: self.events.clone(),
            status: self.status.clone(),
        }
    }
}

impl<E> Queue<E> {
    /// Add an event.
    pub fn send(&self, event: E) {
        self.status.waiting.fetch_add(1, Ordering::AcqRel);
        self.status
            .background
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .cancel();
        // the other end is gone only when the process ends
        let _ = self.events.send(event);
    }
}

/// The way back of the answer to a request.
pub(super) struct Reply<R> {
    answer: oneshot::Sender<Result<R, RequestFailure>>,
    cancel: CancelFlag,
}

/// What waits for the answer. Dropping it cancels the work, and that is what cancelling a request does.
pub(super) struct Waiting<R> {
    answer: oneshot::Receiver<Result<R, RequestFailure>>,
    _cancel: CancelOnDrop,
}

struct CancelOnDrop(CancelFlag);

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// The two ends of the way that an answer takes.
pub(super) fn reply<R>() -> (Reply<R>, Waiting<R>) {
    let (answer, wait) = oneshot::channel();
    let cancel = CancelFlag::default();
    let waiting = Waiting {
        answer: wait,
        _cancel: CancelOnDrop(cancel.clone()),
    };
    (Reply { answer, cancel }, waiting)
}

impl<R> Reply<R> {
    /// Answer by some work, unless nobody waits any more.
    pub fn answer(self, work: impl FnOnce(&CancelFlag) -> Result<R, RequestFailure>) {
        if !self.cancel.is_cancelled() {
            let _ = self.answer.send(work(&self.cancel));
        }
    }
}

impl<R> Waiting<R> {
    /// Wait for the answer.
    pub async fn answer(self) -> jsonrpc::Result<R> {
        match self.answer.await {
            Ok(result) => result.map_err(RequestFailure::into_error),
            // the work panicked: that was logged
            Err(_) => Err(jsonrpc::Error {
                message: "internal error; see the log for details".into(),
                ..jsonrpc::Error::internal_error()
            }),
        }
    }
}
