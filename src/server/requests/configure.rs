//! The configuration of a rule, changed from one of its findings: the file is made where there is none.
use std::path::{Path, PathBuf};

use lsp_types::{
    CodeAction, CodeActionKind, CreateFile, Diagnostic, DocumentChangeOperation, DocumentChanges,
    OneOf, OptionalVersionedTextDocumentIdentifier, Range, ResourceOp, TextDocumentEdit, TextEdit,
    WorkspaceEdit,
};

use crate::convert;
use crate::requests::code_action::code_action;
use crate::requests::rename::is_ours;
use crate::state::ServerState;
use base::{Span, TextRange};
use ide::{Action, ActionKind};
use rules::{Edit, Finding, Severity};
use workspace::config::{CONFIG_NAMES, find_config};

/// What is written into a configuration file: the range that is replaced, and by what.
type ConfigEdit = Option<(TextRange, String)>;

/// The actions that change what the project's configuration says of the rule of a finding: off, or the next severity below.
pub(super) fn configured(
    state: &ServerState,
    path: &Path,
    finding: &Finding,
    shown: &Diagnostic,
) -> Vec<CodeAction> {
    let rule = finding.rule.name;
    let off = |text: &str| ide::ignored_in_config(text, rule);
    let title = format!("disable `{rule}` for this project");
    let mut found: Vec<_> = changed(state, path, title, &off, shown)
        .into_iter()
        .collect();
    if let Some(severity) = below(finding.severity) {
        let name = severity.name();
        let lower = |text: &str| ide::severity_in_config(text, rule, name);
        let mut title = format!("configure `{rule}` as {name} for this project");
        if state
            .host
            .session()
            .editor_sets_severity(path, finding.rule)
        {
            title.push_str(" (overridden here by the editor's `severity` setting)");
        }
        found.extend(changed(state, path, title, &lower, shown));
    }
    found
}

fn below(severity: Severity) -> Option<Severity> {
    match severity {
        Severity::Error => Some(Severity::Warning),
        Severity::Warning => Some(Severity::Info),
        Severity::Info => Some(Severity::Hint),
        Severity::Hint => None,
    }
}

/// The action that makes one change to the configuration that holds for a file.
fn changed(
    state: &ServerState,
    path: &Path,
    title: String,
    change: &dyn Fn(&str) -> ConfigEdit,
    shown: &Diagnostic,
) -> Option<CodeAction> {
    let vfs = &state.host.session().vfs;
    let Some(config) = find_config(vfs, path.parent()?) else {
        return made(state, path, title, change("")?.1, shown);
    };
    let (range, content) = change(&vfs.text(&config).ok()?.text)?;
    let file = vfs.file_id(&config);
    let action = Action {
        title,
        kind: ActionKind::Fix,
        edits: vec![Edit {
            span: Span { file, range },
            content,
        }],
    };
    code_action(state, action, Some(shown))
}

/// The same where there is no configuration yet: a file in the workspace folder, for clients that make files.
fn made(
    state: &ServerState,
    path: &Path,
    title: String,
    text: String,
    shown: &Diagnostic,
) -> Option<CodeAction> {
    let config = new_config(state, path)?;
    let uri = convert::file_uri(&config)?;
    let create = ResourceOp::Create(CreateFile {
        uri: uri.clone(),
        options: None,
        annotation_id: None,
    });
    let insert = TextDocumentEdit {
        text_document: OptionalVersionedTextDocumentIdentifier { uri, version: None },
        edits: vec![OneOf::Left(TextEdit::new(Range::default(), text))],
    };
    let operations = vec![
        DocumentChangeOperation::Op(create),
        DocumentChangeOperation::Edit(insert),
    ];
    let edit = WorkspaceEdit {
        document_changes: Some(DocumentChanges::Operations(operations)),
        ..WorkspaceEdit::default()
    };
    Some(CodeAction {
        title: crate::requests::code_action::sentence_case(&title),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![shown.clone()]),
        edit: Some(edit),
        ..CodeAction::default()
    })
}

/// Where a first configuration of a file belongs: the innermost workspace folder that holds it.
fn new_config(state: &ServerState, path: &Path) -> Option<PathBuf> {
    if !state.client.edits.creates_files || !is_ours(state, path) {
        return None;
    }
    let folders = state.host.folders().iter();
    let folder = folders
        .filter(|folder| path.starts_with(folder))
        .max_by_key(|folder| folder.components().count())?;
    Some(folder.join(CONFIG_NAMES.first()?))
}
