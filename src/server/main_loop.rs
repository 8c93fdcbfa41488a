//! The analysis thread: it alone owns the state, and takes one event after the other.
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::Duration;

use lsp_types::MessageType;

use crate::diagnostics::make_diagnostics;
use crate::events::{ClientReply, Event};
use crate::preview::make_previews;
#[cfg(feature = "preview")]
use crate::preview::pages::page_said;
use crate::scanning::{progress_created, scan};
use crate::settings::configured;
use crate::state::ServerState;

/// How long an edit takes at most from its message to its event.
const ON_ITS_WAY: Duration = Duration::from_millis(2);

/// Take events until nobody can add one any more.
pub(super) fn run(mut state: ServerState, events: &Receiver<Event>) {
    while let Some(event) = next_event(&state, events) {
        take(&mut state, event);
    }
}

fn next_event(state: &ServerState, events: &Receiver<Event>) -> Option<Event> {
    let event = match pause(state) {
        None => events.recv().ok()?,
        Some(pause) => match events.recv_timeout(pause) {
            Ok(event) => event,
            Err(RecvTimeoutError::Timeout) => return Some(Event::Idle),
            Err(RecvTimeoutError::Disconnected) => return None,
        },
    };
    state.status.taken();
    Some(event)
}

/// Do what follows from an event; a panic in it is logged and ends that only.
pub(super) fn take(state: &mut ServerState, event: Event) {
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| dispatch(state, event))) {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
        report_fault(state, text.unwrap_or("unknown error"));
    }
}

fn dispatch(state: &mut ServerState, event: Event) {
    match event {
        Event::Request(request) => request.answer(state),
        Event::Notification(notification) => notification.take(state),
        Event::ClientReply(ClientReply::ProgressCreated(made)) => progress_created(state, made),
        Event::ClientReply(ClientReply::Settings(scopes, values)) => {
            configured(state, &scopes, &values);
        }
        #[cfg(feature = "preview")]
        Event::Viewer(received) => page_said(state, received),
        Event::Idle => idle(state),
    }
}

fn report_fault(state: &mut ServerState, text: &str) {
    let message = format!("internal error: {text}; please report it with the file that caused it");
    tracing::error!("{message}");
    state.outbox.log_as(MessageType::ERROR, message.clone());
    if !std::mem::replace(&mut state.sent.fault, true) {
        state.outbox.show(MessageType::ERROR, message);
    }
}

/// What is done when nobody waits for anything.
#[derive(Clone, Copy, Debug)]
enum IdleWork {
    /// Models of the robots that are shown in 3D.
    Models,
    Diagnostics,
    /// The files of the workspace that were not looked at yet.
    Scan,
}

/// What is to be done next when no event comes, and in how long.
fn idle_work(state: &ServerState) -> Option<(IdleWork, Duration)> {
    if state.previews.due && !state.previews.views.is_empty() {
        return Some((IdleWork::Models, Duration::ZERO));
    }
    if let Some(rest) = state.diagnostics.rest() {
        return Some((IdleWork::Diagnostics, rest));
    }
    let scans = state.initialized && !state.host.is_scanned();
    scans.then_some((IdleWork::Scan, Duration::ZERO))
}

/// How long to wait for an event before [`Event::Idle`]; none: for ever.
pub(super) fn pause(state: &ServerState) -> Option<Duration> {
    let (work, rest) = idle_work(state)?;
    Some(match work {
        IdleWork::Diagnostics if state.status.is_edit_announced() => rest.max(ON_ITS_WAY),
        IdleWork::Models | IdleWork::Diagnostics | IdleWork::Scan => rest,
    })
}

fn idle(state: &mut ServerState) {
    state.status.forget_announced();
    match idle_work(state) {
        Some((IdleWork::Models, _)) => make_previews(state),
        Some((IdleWork::Diagnostics, Duration::ZERO)) => make_diagnostics(state),
        Some((IdleWork::Scan, _)) => scan(state),
        Some((IdleWork::Diagnostics, _)) | None => {}
    }
}
