//! Between the protocol and the analysis: handlers post jobs, one thread works them off in order.
//!
//! A handler may not touch state. It sends its job as its first statement and then only waits, so jobs are
//! worked off in the order in which their messages arrived.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::sync::oneshot;
use tower_lsp::jsonrpc;

use super::engine::Engine;
use super::failure::Failure;
use base::CancelFlag;

/// Work for the analysis thread.
pub(super) type Job = Box<dyn FnOnce(&mut Engine) + Send>;

/// Where handlers post their jobs.
#[derive(Clone)]
pub(super) struct Letterbox {
    jobs: Sender<Job>,
    pressure: Pressure,
}

/// How many jobs wait, and what is done meanwhile.
#[derive(Clone, Default)]
pub(super) struct Pressure {
    waiting: Arc<AtomicUsize>,
    /// Edits that were read and are not posted yet.
    announced: Arc<AtomicUsize>,
    background: Arc<Mutex<CancelFlag>>,
}

impl Pressure {
    /// Whether a job waits.
    pub fn is_high(&self) -> bool {
        self.waiting.load(Ordering::Acquire) > 0
    }

    /// A flag for work that any new job should interrupt.
    pub fn background(&self) -> CancelFlag {
        let flag = CancelFlag::default();
        *self.background.lock().unwrap_or_else(PoisonError::into_inner) = flag.clone();
        if self.is_high() {
            flag.cancel();
        }
        flag
    }

    /// An edit was read: its job will be posted in a moment, so what is said of the text now would be out of date.
    pub fn announce_edit(&self) {
        self.announced.fetch_add(1, Ordering::AcqRel);
    }

    /// An edit that was announced is here.
    pub fn edit_arrived(&self) {
        let one_less = |announced: usize| Some(announced.saturating_sub(1));
        let _ = self.announced.fetch_update(Ordering::AcqRel, Ordering::Acquire, one_less);
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

/// A new letterbox, and its other end.
pub(super) fn letterbox() -> (Letterbox, Receiver<Job>, Pressure) {
    let (jobs, taken) = mpsc::channel();
    let pressure = Pressure::default();
    (Letterbox { jobs, pressure: pressure.clone() }, taken, pressure)
}

impl Letterbox {
    /// Post a job.
    pub fn post(&self, job: Job) {
        self.pressure.waiting.fetch_add(1, Ordering::AcqRel);
        self.pressure.background.lock().unwrap_or_else(PoisonError::into_inner).cancel();
        // the other end is gone only when the process ends
        let _ = self.jobs.send(job);
    }

    /// Post an edit.
    pub fn tell_edit<P: Send + 'static>(&self, params: P, work: fn(&mut Engine, P)) {
        self.post(Box::new(move |engine| {
            // said by who works it off: said by who posts it, it could come too late, and would be waited for
            engine.pressure.edit_arrived();
            work(engine, params);
        }));
    }

    /// Post a notification.
    pub fn tell<P: Send + 'static>(&self, params: P, work: fn(&mut Engine, P)) {
        self.post(Box::new(move |engine| work(engine, params)));
    }

    /// Post a request and wait for its answer. Dropping the future cancels the work.
    pub async fn ask<P, R>(
        &self,
        params: P,
        work: fn(&mut Engine, P, &CancelFlag) -> Result<R, Failure>,
    ) -> jsonrpc::Result<R>
    where
        P: Send + 'static,
        R: Send + 'static,
    {
        let (answer, wait) = oneshot::channel();
        let cancel = CancelOnDrop(CancelFlag::default());
        let flag = cancel.0.clone();
        self.post(Box::new(move |engine| {
            if !flag.is_cancelled() {
                let _ = answer.send(work(engine, params, &flag));
            }
        }));
        match wait.await {
            Ok(result) => result.map_err(Failure::into_error),
            // the job panicked: that was logged
            Err(_) => Err(jsonrpc::Error {
                message: "an internal fault: the log says more".into(),
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
