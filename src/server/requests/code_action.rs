//! Actions in the form of the protocol.
use std::collections::BTreeMap;

use lsp_types::{CodeAction, CodeActionKind, Diagnostic, TextEdit, Url, WorkspaceEdit};

use crate::locations::location;
use crate::requests::rename::{is_ours, workspace_edit};
use crate::state::ServerState;
use ide::{Action, ActionKind};
use rules::Edit;

/// Makes the edits of an action, for clients that take actions as commands only.
pub(crate) const APPLY: &str = "xacro.applyEdit";

/// A title as editors show them: messages begin with a small letter, titles do not.
pub(crate) fn sentence_case(title: &str) -> String {
    let mut chars = title.chars();
    chars.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(chars).collect()
    })
}

/// An action for the client; none when it would change a file that is not the user's.
pub(crate) fn code_action(
    state: &ServerState,
    action: Action,
    diagnostic: Option<&Diagnostic>,
) -> Option<CodeAction> {
    Some(CodeAction {
        title: sentence_case(&action.title),
        kind: Some(kind(action.kind)),
        diagnostics: diagnostic.map(|diagnostic| vec![diagnostic.clone()]),
        edit: Some(edits_of(state, &action.edits)?),
        ..CodeAction::default()
    })
}

pub(crate) fn kind(kind: ActionKind) -> CodeActionKind {
    match kind {
        ActionKind::Fix => CodeActionKind::QUICKFIX,
        ActionKind::Extract => CodeActionKind::REFACTOR_EXTRACT,
        ActionKind::Inline => CodeActionKind::REFACTOR_INLINE,
        ActionKind::Rewrite => CodeActionKind::REFACTOR_REWRITE,
    }
}

pub(crate) fn refactor(name: &str) -> CodeActionKind {
    CodeActionKind::from(format!("refactor.{name}"))
}

pub(crate) fn edits_of(state: &ServerState, edits: &[Edit]) -> Option<WorkspaceEdit> {
    let mut changes: BTreeMap<Url, Vec<TextEdit>> = BTreeMap::new();
    for edit in edits {
        let path = state.host.session().vfs.path(edit.span.file);
        let place = location(state, edit.span).filter(|_| is_ours(state, &path))?;
        changes
            .entry(place.uri)
            .or_default()
            .push(TextEdit::new(place.range, edit.content.clone()));
    }
    (!changes.is_empty()).then(|| workspace_edit(state, changes))
}
