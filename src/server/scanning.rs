//! The scan of the workspace, with progress.
use serde_json::{Value, json};

use crate::failure::RequestFailure;
use crate::refreshing::refresh;
use crate::scheduler::Cause;
use crate::state::ServerState;
use base::CancelFlag;
use base::clock::Instant;

/// The client made the token for the scan, or will not show it.
pub fn progress_created(state: &mut ServerState, made: bool) {
    if made {
        state.progress = Some("xacro/scan".to_owned());
        report_progress(
            state,
            json!({ "kind": "begin", "title": "Indexing robot descriptions" }),
        );
    }
    // some clients turn their sign from here on, whether it began or not
    if made && state.host.is_scanned() {
        end_progress(state);
    }
}

/// Look at more files of the workspace, until an event comes in.
pub fn scan(state: &mut ServerState) {
    let status = state.status.clone();
    scan_until(state, &|| status.has_waiting());
}

/// Look at more files of the workspace, with progress, until `stop` says so; whether all were looked at.
fn scan_until(state: &mut ServerState, stop: &dyn Fn() -> bool) -> bool {
    match state.host.scan(stop) {
        // still searching for them
        Some((_, 0)) => false,
        Some((done, total)) => {
            let message = format!("{done} of {total} files");
            report_progress(state, json!({ "kind": "report", "message": message }));
            false
        }
        None => {
            scanned(state);
            true
        }
    }
}

/// Look at all files of the workspace before an answer that would be wrong without one of them.
///
/// # Errors
/// The request was cancelled.
pub fn scan_all(state: &mut ServerState, cancel: &CancelFlag) -> Result<(), RequestFailure> {
    while !state.host.is_scanned() {
        let end = Instant::now() + ServerState::SCAN_REPORT;
        if !scan_until(state, &|| cancel.is_cancelled() || Instant::now() >= end)
            && cancel.is_cancelled()
        {
            return Err(RequestFailure::Cancelled);
        }
    }
    Ok(())
}

/// Look at the workspace before an answer that depends on it, when that takes a moment only: who asks for
/// diagnostics of a part as soon as it is open gets those of the robot around it.
pub fn scan_first(state: &mut ServerState) {
    if state.initialized
        && !state.host.is_scanned()
        && state.host.scan_within(ServerState::SCAN_FIRST)
    {
        scanned(state);
    }
}

/// Other roots may be known now.
fn scanned(state: &mut ServerState) {
    tracing::info!(
        descriptions = state.host.known_files().len(),
        "workspace indexed"
    );
    end_progress(state);
    if !state.documents.is_empty() {
        state.schedule(Cause::Indexed);
        refresh(state);
    }
}

fn end_progress(state: &mut ServerState) {
    report_progress(state, json!({ "kind": "end" }));
    state.progress = None;
}

fn report_progress(state: &ServerState, value: Value) {
    if let Some(token) = &state.progress {
        state
            .outbox
            .notify("$/progress", &json!({ "token": token, "value": value }));
    }
}
