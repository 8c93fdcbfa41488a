//! The analysis thread: it alone owns the state, and works off one job after the other.
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::Duration;

use lsp_types::MessageType;

use crate::diagnostics::make_diagnostics;
use crate::preview::make_previews;
use crate::queue::Job;
use crate::scanning::scan;
use crate::state::State;
use base::clock::Instant;

/// How long an edit takes at most from its message to its job.
const ON_ITS_WAY: Duration = Duration::from_millis(2);

/// Work off jobs until nobody can post one any more.
pub(super) fn run(mut state: State, jobs: &Receiver<Job<State>>) {
    loop {
        let job = match pause(&state) {
            None => jobs.recv().map_err(|_| RecvTimeoutError::Disconnected),
            Some(pause) => jobs.recv_timeout(pause),
        };
        match job {
            Ok(job) => {
                state.status.taken();
                guarded(&mut state, job);
            }
            Err(RecvTimeoutError::Timeout) => {
                state.status.forget_announced();
                guarded(&mut state, Box::new(idle));
            }
            Err(RecvTimeoutError::Disconnected) => return,
        }
    }
}

/// How long to wait for a job before idle work; none: for ever.
pub(super) fn pause(state: &State) -> Option<Duration> {
    if state.previews.due && !state.previews.views.is_empty() {
        return Some(Duration::ZERO);
    }
    if let Some(due) = state.schedule.due {
        let rest = due.saturating_duration_since(Instant::now());
        return Some(if state.status.is_edit_announced() {
            rest.max(ON_ITS_WAY)
        } else {
            rest
        });
    }
    (state.initialized && !state.world.is_scanned()).then_some(Duration::ZERO)
}

/// What is done when nobody waits for anything.
pub(super) fn idle(state: &mut State) {
    if state.previews.due && !state.previews.views.is_empty() {
        return make_previews(state);
    }
    if state.schedule.due.is_some_and(|due| due <= Instant::now()) {
        return make_diagnostics(state);
    }
    if state.schedule.due.is_none() && state.initialized && !state.world.is_scanned() {
        scan(state);
    }
}

/// Run a job; a panic in it is logged and ends that job only.
pub(super) fn guarded(state: &mut State, job: Job<State>) {
    let Err(panic) = catch_unwind(AssertUnwindSafe(|| job(state))) else {
        return;
    };
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("unknown error");
    let message = format!("internal error: {text}; please report it with the file that caused it");
    tracing::error!("{message}");
    state.outbox.log_as(MessageType::ERROR, message.clone());
    if !std::mem::replace(&mut state.sent.fault, true) {
        state.outbox.show(MessageType::ERROR, message);
    }
}

/// Fail as a fault of ours would.
#[cfg(debug_assertions)]
#[allow(clippy::panic, reason = "that is what it is for")]
pub(super) fn fail(
    _: &mut State,
    (): (),
    _: &base::CancelFlag,
) -> Result<serde_json::Value, crate::failure::Failure> {
    panic!("this job was asked to fail")
}
