//! Between the protocol and the analysis: handlers add jobs, one thread works them off in order.
//!
//! A handler may not touch state. It sends its job as its first statement and then only waits, so jobs are
//! processed in the order in which their messages arrived.
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::oneshot;
use tower_lsp::jsonrpc;

use crate::failure::Failure;
use base::CancelFlag;

/// Work for the analysis thread, which owns the state `S`.
pub(super) type Job<S> = Box<dyn FnOnce(&mut S) + Send>;

/// Where handlers add their jobs.
pub(super) struct Queue<S> {
    jobs: Sender<Job<S>>,
    status: QueueStatus,
}

/// How many jobs wait, and what is done meanwhile.
#[derive(Clone, Default)]
pub(super) struct QueueStatus {
    waiting: Arc<AtomicUsize>,
    /// Edits that were read and are not in the queue yet.
    announced: Arc<AtomicUsize>,
    background: Arc<Mutex<CancelFlag>>,
}

impl QueueStatus {
    /// Whether a job waits.
    pub fn has_waiting(&self) -> bool {
        self.waiting.load(Ordering::Acquire) > 0
    }

    /// A flag for work that any new job should interrupt.
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

    /// An edit was read: its job will be added in a moment, so what is said of the text now would be out of date.
    pub fn announce_edit(&self) {
        self.announced.fetch_add(1, Ordering::AcqRel);
    }

    /// An edit that was announced is here.
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

    /// A job was taken out.
    pub fn taken(&self) {
        self.waiting.fetch_sub(1, Ordering::AcqRel);
    }
}

/// A new queue, and its other end.
pub(super) fn queue<S>() -> (Queue<S>, Receiver<Job<S>>, QueueStatus) {
    let (jobs, taken) = mpsc::channel();
    let status = QueueStatus::default();
    (
        Queue {
            jobs,
            status: status.clone(),
        },
        taken,
        status,
    )
}

// a derived one would ask for a state that can be cloned
impl<S> Clone for Queue<S> {
    fn clone(&self) -> Self {
        Self {
            jobs: self.jobs.clone(),
            status: self.status.clone(),
        }
    }
}

impl<S: 'static> Queue<S> {
    /// Add a job.
    pub fn send(&self, job: Job<S>) {
        self.status.waiting.fetch_add(1, Ordering::AcqRel);
        self.status
            .background
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .cancel();
        // the other end is gone only when the process ends
        let _ = self.jobs.send(job);
    }

    /// Add an edit.
    pub fn notify_edit<P: Send + 'static>(&self, params: P, work: fn(&mut S, P)) {
        let status = self.status.clone();
        self.send(Box::new(move |state| {
            // said here and not by the sender, whose word could come too late: it would be waited for
            status.edit_arrived();
            work(state, params);
        }));
    }

    /// Add a notification.
    pub fn notify<P: Send + 'static>(&self, params: P, work: fn(&mut S, P)) {
        self.send(Box::new(move |state| work(state, params)));
    }

    /// Add a request and wait for its answer. Dropping the future cancels the work.
    pub async fn request<P, R>(
        &self,
        params: P,
        work: fn(&mut S, P, &CancelFlag) -> Result<R, Failure>,
    ) -> jsonrpc::Result<R>
    where
        P: Send + 'static,
        R: Send + 'static,
    {
        let (answer, wait) = oneshot::channel();
        let cancel = CancelOnDrop(CancelFlag::default());
        let flag = cancel.0.clone();
        self.send(Box::new(move |state| {
            if !flag.is_cancelled() {
                let _ = answer.send(work(state, params, &flag));
            }
        }));
        match wait.await {
            Ok(result) => result.map_err(Failure::into_error),
            // the job panicked: that was logged
            Err(_) => Err(jsonrpc::Error {
                message: "internal error; see the log for details".into(),
                ..jsonrpc::Error::internal_error()
            }),
        }
    }
}

/// Cancels when the handler's future is dropped, which is what cancelling a request does.
struct CancelOnDrop(CancelFlag);

impl Drop for CancelOnDrop {
    fn drop(&mut self) {
        self.0.cancel();
    }
}
