//! Telling the client under which root its files are shown.
use std::path::Path;

use serde_json::json;

use crate::refreshing::refresh;
use crate::requests::mapping::{label, named};
use crate::scheduler::Cause;
use crate::state::ServerState;
use analysis::{Context, RootConfig};
use base::CancelFlag;

/// The user sees files in another way now.
pub fn context_changed(state: &mut ServerState, cancel: &CancelFlag) {
    announce_contexts(state, cancel);
    state.schedule(Cause::RobotSelected);
    refresh(state);
}

/// Tell the client under which root each open file is shown, where that is news.
pub fn announce_contexts(state: &mut ServerState, cancel: &CancelFlag) {
    if !state.client.own.context_changed {
        return;
    }
    let open: Vec<_> = state.documents.keys().cloned().collect();
    for path in open {
        announce_context(state, &path, cancel);
    }
}

/// Tell the client under which root a file is shown now.
fn announce_context(state: &mut ServerState, path: &std::path::Path, cancel: &CancelFlag) {
    let context = analysis::context(&mut state.host, path);
    let Some(uri) = state.uri(path) else { return };
    let active = context
        .root
        .as_ref()
        .and_then(|root| named(state, root).ok());
    let ShownContext { text, instance } = seen_as(state, path, &context, cancel);
    let params = json!({
        "textDocument": { "uri": uri }, "active": active, "text": text, "instance": instance,
    });
    if state
        .sent
        .contexts
        .insert(path.to_path_buf(), params.clone())
        .as_ref()
        == Some(&params)
    {
        return;
    }
    state.outbox.notify("xacro/contextChanged", &params);
}

/// What a file is seen as.
pub(super) struct ShownContext {
    /// For a status line: the call that was selected, or else the root with its arguments, or else why there is none.
    pub text: String,
    /// The call that was selected.
    pub instance: Option<String>,
}

/// What a file is seen as in a context.
pub(super) fn seen_as(
    state: &mut ServerState,
    path: &std::path::Path,
    context: &Context,
    cancel: &CancelFlag,
) -> ShownContext {
    let Some(root) = &context.root else {
        let text = context.reason.text().to_owned();
        return ShownContext {
            text,
            instance: None,
        };
    };
    let instance = selected_label(state, path, root, cancel);
    ShownContext {
        text: instance.clone().unwrap_or_else(|| root.label()),
        instance,
    }
}

/// The call that was selected under a root, when it is a call of a macro of the file.
pub fn selected_label(
    state: &mut ServerState,
    path: &Path,
    root: &RootConfig,
    cancel: &CancelFlag,
) -> Option<String> {
    let selected = state
        .selected_instances
        .get(&root.file)
        .filter(|selected| selected.file == path)?
        .clone();
    let analyzed = state.host.analyzed(root, cancel)?;
    let frame = ide::selected_frame(&analyzed.expansion, &selected)?;
    Some(label(state, &analyzed, frame))
}
