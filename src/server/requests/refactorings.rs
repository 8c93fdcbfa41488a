//! Refactorings: what is offered at a place, and the edits of what was selected.
//!
//! A client that asks for edits when an action is selected gets none before. They are worked out for the text as it is
//! then; when that is another one, the client is told to ask again.
use std::path::Path;

use lsp_types::{
    CodeAction, CodeActionDisabled, CodeActionParams, CodeActionTriggerKind, CreateFile,
    DocumentChangeOperation, DocumentChanges, OneOf, OptionalVersionedTextDocumentIdentifier,
    Range, ResourceOp, TextDocumentEdit, TextDocumentPositionParams, TextEdit, Url, WorkspaceEdit,
};
use serde::{Deserialize, Serialize};

use crate::convert;
use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::code_action::{code_action, kind, sentence_case};
use crate::requests::navigation::asked;
use crate::requests::rename::is_ours;
use crate::scanning::scan_all;
use crate::state::ServerState;
use base::limits::QUICK_PROOF_EXPANSIONS;
use base::{CancelFlag, TextRange};
use facts::{MentionKind, facts};
use ide::{self, Action, ActionKind};
use vfs::SourceFile;
use xml::Document;

/// Robots of fewer nodes are expanded in a few milliseconds.
const SMALL: usize = 5_000;

/// Where an action was offered, so that its edits can be made later.
#[derive(Clone, Debug, Deserialize, Serialize)]
struct OfferedAction {
    uri: Url,
    range: Range,
    /// The version of the text; none when the file was not open.
    version: Option<i32>,
}

/// Whether it is tried out what a robot would be with a macro's text in the place of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inline {
    /// Nobody wants to know.
    No,
    /// Nobody asked, the editor wants to show a sign: in a large robot that would hold up what is typed.
    InSmallRobots,
    /// Whatever it takes.
    Yes,
}

/// The refactorings at a place, with their edits unless the client asks for these later.
pub fn refactor_actions(
    state: &mut ServerState,
    params: &CodeActionParams,
    inlines: bool,
    cancel: &CancelFlag,
) -> Result<Vec<CodeAction>, RequestFailure> {
    let (uri, range) = (&params.text_document.uri, params.range);
    let later = state.client.actions.resolves;
    let version = state
        .documents
        .get(&state.path(uri))
        .and_then(|open| open.version);
    let data = serde_json::to_value(OfferedAction {
        uri: uri.clone(),
        range,
        version,
    })
    .ok();
    let is_automatic = params.context.trigger_kind == Some(CodeActionTriggerKind::AUTOMATIC);
    let inline = match (inlines, is_automatic) {
        (false, _) => Inline::No,
        (true, true) => Inline::InSmallRobots,
        (true, false) => Inline::Yes,
    };
    let mut found = all_refactorings(state, uri, range, inline, cancel)?;
    for action in found
        .iter_mut()
        .filter(|action| later && action.edit.is_some())
    {
        (action.edit, action.data) = (None, data.clone());
    }
    Ok(found)
}

/// Those that change text, those that make files, and those that cannot be made, with the reason.
fn all_refactorings(
    state: &mut ServerState,
    uri: &Url,
    range: Range,
    inline: Inline,
    cancel: &CancelFlag,
) -> Result<Vec<CodeAction>, RequestFailure> {
    let (path, source) = state.source(uri)?;
    let selection = convert::text_range(&source.document, range, state.encoding);
    let document = lsp_types::TextDocumentIdentifier { uri: uri.clone() };
    let asked = asked(
        state,
        &TextDocumentPositionParams::new(document, range.start),
        cancel,
    )?;
    let mut found: Vec<CodeAction> = inlined_macro(state, &asked, selection.start, inline, cancel)?
        .into_iter()
        .collect();
    let actions = refactorings(state, &asked, selection, cancel)?;
    found.extend(
        actions
            .into_iter()
            .filter_map(|action| code_action(state, action, None)),
    );
    found.extend(moved_to_file(state, &path, &source, selection));
    found.extend(refused(state, &asked, selection));
    Ok(found)
}

/// The text of a macro in the place of its call. That it leaves the robot the same has to be tried out: where it
/// does not, it cannot be made.
fn inlined_macro(
    state: &mut ServerState,
    asked: &Asked,
    offset: u32,
    inline: Inline,
    cancel: &CancelFlag,
) -> Result<Option<CodeAction>, RequestFailure> {
    let is_tried = match inline {
        Inline::No => false,
        Inline::InSmallRobots => asked.analyzed.expansion.tree.len() < SMALL,
        Inline::Yes => true,
    };
    let Some(action) = ide::inline_macro(&asked.cx(), offset).filter(|_| is_tried) else {
        return Ok(None);
    };
    if expansion_unchanged(state, asked, &action, cancel)? {
        return Ok(code_action(state, action, None));
    }
    let reason =
        "this would change the robot: the arguments of the call have another meaning there";
    Ok(state
        .client
        .actions
        .shows_disabled
        .then(|| disabled(sentence_case(&action.title), action.kind, reason.to_owned())))
}

/// The same action with its edits.
pub fn resolve_action(
    state: &mut ServerState,
    action: CodeAction,
    cancel: &CancelFlag,
) -> Result<CodeAction, RequestFailure> {
    let offered = action
        .data
        .clone()
        .and_then(|data| serde_json::from_value::<OfferedAction>(data).ok());
    let Some(OfferedAction {
        uri,
        range,
        version,
    }) = offered.filter(|_| action.edit.is_none())
    else {
        return Ok(action);
    };
    if state
        .documents
        .get(&state.path(&uri))
        .and_then(|open| open.version)
        != version
    {
        return Err(RequestFailure::Outdated);
    }
    let inlines = action.kind.as_ref() == Some(&kind(ActionKind::Inline));
    let inline = if inlines { Inline::Yes } else { Inline::No };
    let all = all_refactorings(state, &uri, range, inline, cancel)?;
    let same = |known: &CodeAction| known.title == action.title && known.kind == action.kind;
    let edit = all
        .into_iter()
        .find(same)
        .and_then(|known| known.edit)
        .ok_or(RequestFailure::Outdated)?;
    Ok(CodeAction {
        edit: Some(edit),
        ..action
    })
}

/// Whether every robot is the same with the edits of an action, which are all in the file that was asked about.
fn expansion_unchanged(
    state: &ServerState,
    asked: &Asked,
    action: &Action,
    cancel: &CancelFlag,
) -> Result<bool, RequestFailure> {
    let edits = action
        .edits
        .iter()
        .map(|edit| (edit.span.range, edit.content.clone()))
        .collect();
    let effort = state
        .host
        .effort(&asked.source.path, QUICK_PROOF_EXPANSIONS, cancel);
    let is_same =
        analysis::expansion_unchanged(state.host.session(), &asked.source.path, edits, &effort);
    if cancel.is_cancelled() {
        Err(RequestFailure::Cancelled)
    } else {
        Ok(is_same)
    }
}

/// What cannot be made, for clients that show it.
fn refused(state: &ServerState, asked: &Asked, selection: TextRange) -> Option<CodeAction> {
    if !state.client.actions.shows_disabled || !asked.source.document.errors().is_empty() {
        return None;
    }
    let session = state.host.session();
    let settings = session.settings(&asked.source.path);
    let rule_env = session.rule_env(&settings.config);
    let ide::Refused { title, reason } =
        ide::of_mesh(&asked.cx(), rule_env, selection.start).err()?;
    Some(disabled(sentence_case(&title), ActionKind::Rewrite, reason))
}

fn refactorings(
    state: &mut ServerState,
    asked: &Asked,
    selection: TextRange,
    cancel: &CancelFlag,
) -> Result<Vec<Action>, RequestFailure> {
    let session = state.host.session();
    let settings = session.settings(&asked.source.path);
    let rule_env = session.rule_env(&settings.config);
    let mut actions = ide::refactorings(&asked.cx(), rule_env, selection);
    if let Some((_, name)) = ide::inlinable(&asked.cx(), selection.start) {
        // files of other robots may read the property
        scan_all(state, cancel)?;
        let mut others = state
            .host
            .known_files()
            .into_iter()
            .filter(|file| !asked.analyzed.includes(file))
            .filter_map(|file| state.host.document(&file));
        if others.any(|other| mentions(&other.document, &name)) {
            actions.retain(|action| action.kind != ActionKind::Inline);
        }
    }
    Ok(actions)
}

/// Elements moved to a file of their own, for clients that make files.
fn moved_to_file(
    state: &ServerState,
    path: &Path,
    source: &SourceFile,
    selection: TextRange,
) -> Option<CodeAction> {
    if !state.client.edits.creates_files || !is_ours(state, path) {
        return None;
    }
    let folder = path.parent()?;
    let vfs = &state.host.session().vfs;
    let (action, file) =
        ide::move_to_file(source, selection, |name| vfs.exists(&folder.join(name)))?;
    let uri = convert::file_uri(&folder.join(&file.name))?;
    let mut operations = vec![
        DocumentChangeOperation::Op(ResourceOp::Create(CreateFile {
            uri: uri.clone(),
            options: None,
            annotation_id: None,
        })),
        DocumentChangeOperation::Edit(TextDocumentEdit {
            text_document: OptionalVersionedTextDocumentIdentifier { uri, version: None },
            edits: vec![OneOf::Left(TextEdit::new(Range::default(), file.text))],
        }),
    ];
    let made = code_action(state, action, None)?;
    operations.extend(document_edits(made.edit.clone()?));
    let changes = Some(DocumentChanges::Operations(operations));
    let edit = WorkspaceEdit {
        document_changes: changes,
        ..WorkspaceEdit::default()
    };
    Some(CodeAction {
        edit: Some(edit),
        ..made
    })
}

/// The edits of documents, in the form in which they stand beside files that are made.
fn document_edits(edit: WorkspaceEdit) -> Vec<DocumentChangeOperation> {
    let of_file = |(uri, edits): (Url, Vec<TextEdit>)| TextDocumentEdit {
        text_document: OptionalVersionedTextDocumentIdentifier { uri, version: None },
        edits: edits.into_iter().map(OneOf::Left).collect(),
    };
    let edits = match edit.document_changes {
        Some(DocumentChanges::Edits(edits)) => edits,
        Some(DocumentChanges::Operations(operations)) => return operations,
        None => edit.changes.into_iter().flatten().map(of_file).collect(),
    };
    edits
        .into_iter()
        .map(DocumentChangeOperation::Edit)
        .collect()
}

/// An action that cannot be made, and why.
fn disabled(title: String, of: ActionKind, reason: String) -> CodeAction {
    CodeAction {
        title,
        kind: Some(kind(of)),
        disabled: Some(CodeActionDisabled { reason }),
        ..CodeAction::default()
    }
}

/// Whether an expression of a document reads a name.
fn mentions(document: &Document, name: &str) -> bool {
    let reads =
        |mention: &facts::Mention| mention.kind == MentionKind::Name && mention.name == name;
    facts(document).any(|(_, facts)| facts.mentions().any(reads))
}
