//! Telling the client to ask again.
use crate::outbox::{ClientRequest, Refresh};
use crate::state::ServerState;

/// Have the client ask again for what it has asked for before.
pub fn refresh(state: &ServerState) {
    refresh_others(state);
    refresh_when(
        state,
        state.client.refresh.tokens,
        &[Refresh::SemanticTokens],
    );
    refresh_when(state, state.client.refresh.lenses, &[Refresh::CodeLens]);
}

/// After an edit: clients ask again for the file they changed, but findings and values in the other
/// open files may be different now too.
pub fn refresh_others(state: &ServerState) {
    let pulls = state.client.pulls_diagnostics && state.client.refresh.diagnostics;
    refresh_when(state, pulls, &[Refresh::Diagnostics]);
    refresh_when(state, state.client.refresh.hints, &[Refresh::InlayHints]);
}

fn refresh_when(state: &ServerState, supported: bool, what: &'static [Refresh]) {
    if supported && state.initialized {
        state.outbox.request(ClientRequest::Refresh(what));
    }
}
