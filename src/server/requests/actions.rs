//! Quick fixes and refactorings.
//!
//! Fixes are taken from the findings for the text as it is now, never from what a client sends along: a
//! diagnostic may be older than the text, and its data may come from anywhere.
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams,
    CodeActionTriggerKind, Command, Diagnostic, DocumentChangeOperation, DocumentChanges,
    NumberOrString, RenameFile, ResourceOp, TextDocumentPositionParams, Url,
    WorkDoneProgressOptions, WorkspaceEdit,
};
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::convert;
use crate::diagnostics::diagnostic;
use crate::failure::RequestFailure;
use crate::locations::places;
use crate::outbox::ClientRequest;
use crate::requests::arguments::set_arguments;
use crate::requests::code_action::{APPLY, code_action, refactor};
use crate::requests::configure::configured;
use crate::requests::navigation::{about_files, asked};
use crate::requests::refactorings::refactor_actions;
use crate::requests::rename::is_ours;
use crate::state::ServerState;
use analysis::{Report, apply};
use base::limits::{PROOF_EXPANSIONS, QUICK_PROOF_EXPANSIONS};
use base::{CancelFlag, Span, TextRange};
use expand::ProblemKind;
use facts::{FactKind, facts};
use ide::{self, Action, ActionKind, MacroFile};
use rules::{Edit, Finding, Rule, named};
use vfs::SourceFile;
use xml::Document;

/// All safe fixes of a file at once.
const FIX_ALL: CodeActionKind = CodeActionKind::new("source.fixAll.xacro");
/// Files offered for an include, at most.
const MOST_FILES: usize = 5;
/// Findings that fixes are looked for, at most.
const MOST_FINDINGS: usize = 50;

/// The kinds of actions there are.
pub(crate) fn offered() -> CodeActionOptions {
    CodeActionOptions {
        code_action_kinds: Some(vec![
            CodeActionKind::QUICKFIX,
            CodeActionKind::REFACTOR_EXTRACT,
            CodeActionKind::REFACTOR_INLINE,
            CodeActionKind::REFACTOR_REWRITE,
            FIX_ALL,
        ]),
        resolve_provider: Some(true),
        work_done_progress_options: WorkDoneProgressOptions::default(),
    }
}

/// Edits, and the texts that they were made for.
#[derive(Deserialize, Serialize)]
pub(crate) struct MadeFor {
    edit: WorkspaceEdit,
    versions: BTreeMap<Url, Option<i32>>,
}

/// A finding that the client names.
struct NamedFinding<'a> {
    shown: &'a Diagnostic,
    rule: &'a str,
    range: TextRange,
    /// It stands in the range that is asked about, and nothing is found at just this place any more.
    is_old: bool,
}

pub fn actions(
    state: &mut ServerState,
    params: CodeActionParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<CodeActionOrCommand>>, RequestFailure> {
    let (path, source) = state.source(&params.text_document.uri)?;
    let only = params.context.only.as_deref();
    let mut found = Vec::new();
    if wants(only, &CodeActionKind::QUICKFIX) {
        found.extend(quick_fixes(state, &params, &path, &source, cancel)?);
    }
    if ["extract", "inline", "rewrite"]
        .iter()
        .any(|kind| wants(only, &refactor(kind)))
    {
        let actions = refactor_actions(state, &params, wants(only, &refactor("inline")), cancel)?;
        let actions = actions
            .into_iter()
            .filter(|action| action.kind.as_ref().is_some_and(|k| wants(only, k)));
        found.extend(actions.collect::<Vec<_>>());
    }
    // asked for by name only: it needs the findings of the whole file
    if only.is_some() && wants(only, &FIX_ALL) {
        found.extend(fix_all(state, &path, &source, cancel)?);
    }
    Ok(Some(
        found
            .into_iter()
            .filter_map(|action| in_its_form(state, action))
            .collect(),
    ))
}

/// An action as the client takes it: one that knows commands only has the server make the edits.
fn in_its_form(state: &ServerState, action: CodeAction) -> Option<CodeActionOrCommand> {
    if state.client.actions.literals {
        return Some(CodeActionOrCommand::CodeAction(action));
    }
    let apply = |edit| Command {
        title: action.title.clone(),
        command: APPLY.to_owned(),
        arguments: Some(vec![json!(MadeFor {
            edit,
            versions: versions(state)
        })]),
    };
    let edit = action.edit.filter(|_| state.client.edits.on_request);
    edit.map(apply)
        .or(action.command)
        .map(CodeActionOrCommand::Command)
}

/// The versions of all open files.
fn versions(state: &ServerState) -> BTreeMap<Url, Option<i32>> {
    state
        .documents
        .values()
        .map(|open| (open.uri.clone(), open.version))
        .collect()
}

/// Have the client make edits that it was offered as a command.
pub fn apply_offered(state: &mut ServerState, offered: MadeFor) -> Result<(), RequestFailure> {
    if offered.versions != versions(state) {
        return Err(RequestFailure::Outdated);
    }
    state
        .outbox
        .request(ClientRequest::ApplyEdit(Box::new(offered.edit)));
    Ok(())
}

/// A file with tags of xacro gets a name that says so.
fn renamed_to_xacro(
    state: &ServerState,
    params: &CodeActionParams,
    path: &Path,
    shown: &Diagnostic,
) -> Option<CodeAction> {
    let is_urdf = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("urdf"));
    let name = path.file_stem().filter(|_| is_urdf)?.to_str()?;
    let new = path.with_file_name(format!("{name}.urdf.xacro"));
    if !state.client.edits.renames_files
        || !is_ours(state, path)
        || state.host.session().vfs.exists(&new)
    {
        return None;
    }
    let rename = ResourceOp::Rename(RenameFile {
        old_uri: params.text_document.uri.clone(),
        new_uri: convert::file_uri(&new)?,
        options: None,
        annotation_id: None,
    });
    let changes = Some(DocumentChanges::Operations(vec![
        DocumentChangeOperation::Op(rename),
    ]));
    Some(CodeAction {
        title: format!("Rename file to `{name}.urdf.xacro`"),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![shown.clone()]),
        edit: Some(WorkspaceEdit {
            document_changes: changes,
            ..WorkspaceEdit::default()
        }),
        ..CodeAction::default()
    })
}

/// The fixes of the findings at the range that is asked about: of those that the client names, if it names any of
/// ours, and else of all.
fn quick_fixes(
    state: &mut ServerState,
    params: &CodeActionParams,
    path: &Path,
    source: &Arc<SourceFile>,
    cancel: &CancelFlag,
) -> Result<Vec<CodeAction>, RequestFailure> {
    let is_automatic = params.context.trigger_kind == Some(CodeActionTriggerKind::AUTOMATIC);
    let named = params
        .context
        .diagnostics
        .iter()
        .any(|shown| rule(shown).is_some());
    if is_automatic && !named && state.diagnostics.is_due() {
        // a sign beside the text is not to wait for a check of the whole robot; findings bring the next request
        return Ok(Vec::new());
    }
    let report = analysis::report_on(&mut state.host, &[path.to_path_buf()], cancel)
        .ok_or(RequestFailure::Cancelled)?;
    let effort = state.host.effort(path, QUICK_PROOF_EXPANSIONS, cancel);
    let mut found: Vec<CodeAction> = Vec::new();
    for (number, diagnostic) in asked_about_in(state, params, &report, path, source) {
        let Some(finding) = report.findings.get(number) else {
            continue;
        };
        let (rule, range) = (finding.rule, finding.span.range);
        found.extend(set_arguments(state, params, finding, &diagnostic, cancel)?);
        let mut actions: Vec<(Action, bool)> = Vec::new();
        if let Some(fix) = &finding.fix {
            let (title, edits) = (fix.message.clone(), fix.edits.clone());
            let action = Action {
                title,
                kind: ActionKind::Fix,
                edits,
            };
            let proved = analysis::safe_fixes(state.host.session(), &report, &[number], &effort);
            actions.push((action, !proved.settles.is_empty()));
        }
        let more = further_fixes(state, params, path, source, finding, cancel)?;
        actions.extend(more.into_iter().map(|action| (action, false)));
        found.extend(mesh_rewritten(state, params, &diagnostic, rule, cancel)?);
        if rule == named::XACRO_TAGS_IN_URDF {
            found.extend(renamed_to_xacro(state, params, path, &diagnostic));
        }
        let more = ide::quick_fixes(source, rule, range);
        actions.extend(more.into_iter().map(|action| (action, false)));
        for (action, preferred) in actions {
            let made = code_action(state, action, Some(&diagnostic));
            found.extend(made.map(|made| CodeAction {
                is_preferred: preferred.then_some(true),
                ..made
            }));
        }
        found.extend(configured(state, path, finding, &diagnostic));
    }
    Ok(found)
}

/// The findings that are asked about, by their numbers, and each as the client knows it.
fn asked_about_in(
    state: &ServerState,
    params: &CodeActionParams,
    report: &Report,
    path: &Path,
    source: &SourceFile,
) -> Vec<(usize, Diagnostic)> {
    let document = &source.document;
    let asked = convert::text_range(document, params.range, state.encoding);
    let own = |finding: &&Finding| report.path(finding.span.file) == path;
    let named = params
        .context
        .diagnostics
        .iter()
        .filter_map(|shown| Some((shown, rule(shown)?)));
    let named = named.map(|(shown, rule)| {
        let range = convert::text_range(document, shown.range, state.encoding);
        // what is shown may be older than the text: it stands for what is there now
        let mut own = report.findings.iter().filter(own);
        let is_current = own.any(|it| it.rule.name == rule && it.span.range == range);
        NamedFinding {
            shown,
            rule,
            range,
            is_old: !is_current && touch(range, asked),
        }
    });
    let named: Vec<NamedFinding<'_>> = named.take(MOST_FINDINGS).collect();
    let mut places = places(state);
    let mut found: Vec<(usize, Diagnostic)> = Vec::new();
    let mut seen = BTreeSet::new();
    for (number, finding) in report.findings.iter().enumerate().filter(|(_, it)| own(it)) {
        let (name, range) = (finding.rule.name, finding.span.range);
        let is_here = touch(range, asked);
        let is_meant = |named: &&NamedFinding<'_>| {
            named.rule == name && (named.range == range || is_here && named.is_old)
        };
        let diagnostic = match named.iter().find(is_meant) {
            Some(named) => Some(named.shown.clone()),
            None if named.is_empty() && is_here => diagnostic(&mut places, finding),
            None => None,
        };
        let diagnostic = diagnostic.filter(|_| seen.insert((name, range.start, range.end)));
        found.extend(diagnostic.map(|diagnostic| (number, diagnostic)));
    }
    found.truncate(MOST_FINDINGS);
    found
}

/// Fixes that need more than the text: other files, what names mean.
fn further_fixes(
    state: &mut ServerState,
    params: &CodeActionParams,
    path: &Path,
    source: &Arc<SourceFile>,
    finding: &Finding,
    cancel: &CancelFlag,
) -> Result<Vec<Action>, RequestFailure> {
    let range = finding.span.range;
    let mut actions = Vec::new();
    if finding.fix.is_none() {
        actions.extend(
            finding
                .similar
                .as_deref()
                .and_then(|near| ide::suggested(source, range, near)),
        );
    }
    if finding.problem == Some(ProblemKind::UndefinedMacro) {
        state.host.scan(|| cancel.is_cancelled());
        actions.extend(ide::include_macro(source, range, |name| {
            files_with_macro(state, path, name)
        }));
    }
    actions.extend(with_meaning(state, params, finding, cancel)?);
    Ok(actions)
}

/// The mesh that a finding names, written again by a command: no edit of text can do that.
fn mesh_rewritten(
    state: &mut ServerState,
    params: &CodeActionParams,
    diagnostic: &Diagnostic,
    rule: &Rule,
    cancel: &CancelFlag,
) -> Result<Option<CodeAction>, RequestFailure> {
    let title = if rule == named::ASCII_STL {
        "Convert mesh to binary STL"
    } else if rule == named::BINARY_STL_SOLID_HEADER {
        "Change header of the mesh"
    } else {
        return Ok(None);
    };
    let at = TextDocumentPositionParams::new(params.text_document.clone(), diagnostic.range.start);
    let asked = asked(state, &at, cancel)?;
    let mesh = about_files(state, &asked, ide::file_definition).map(|(_, place)| place.path);
    let can_write = !state.host.session().vfs.is_in_memory();
    let uri = mesh
        .filter(|path| can_write && is_ours(state, path))
        .and_then(|path| state.uri(&path));
    let action = |uri| CodeAction {
        title: title.to_owned(),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![diagnostic.clone()]),
        command: Some(Command {
            title: title.to_owned(),
            command: "xacro.rewriteMesh".to_owned(),
            arguments: Some(vec![json!({ "uri": uri })]),
        }),
        ..CodeAction::default()
    };
    Ok(uri.map(action))
}

/// Fixes that need to know what names mean.
fn with_meaning(
    state: &mut ServerState,
    params: &CodeActionParams,
    finding: &Finding,
    cancel: &CancelFlag,
) -> Result<Option<Action>, RequestFailure> {
    let is_shadowed = finding.problem == Some(ProblemKind::ShadowedBuiltin);
    if !is_shadowed && finding.problem != Some(ProblemKind::UseBeforeDefinition) {
        return Ok(None);
    }
    let at = TextDocumentPositionParams::new(params.text_document.clone(), params.range.start);
    let asked = asked(state, &at, cancel)?;
    if is_shadowed {
        return Ok(ide::other_name(
            &asked.cx(),
            &asked.names(state),
            finding.span.range,
        ));
    }
    let given = finding
        .related
        .iter()
        .find(|related| related.span.file == finding.span.file);
    Ok(given.and_then(|given| ide::before_use(&asked.cx(), finding.span.range, given.span.range)))
}

/// Known files that define a macro, as an include in the file at `path` names them.
fn files_with_macro(state: &ServerState, path: &Path, name: &str) -> Vec<MacroFile> {
    let packages = &state.host.session().packages;
    let files = state
        .host
        .known_files()
        .into_iter()
        .filter(|file| file != path);
    let files = files.filter(|file| {
        state
            .host
            .document(file)
            .is_some_and(|own| defines_macro(&own.document, name))
    });
    let include = |file: std::path::PathBuf| {
        let beside = file.parent() == path.parent();
        let filename = match packages.containing(&file) {
            Some(package) if !beside => {
                let inside = file
                    .strip_prefix(&package.folder)
                    .ok()?
                    .to_str()?
                    .to_owned();
                format!("$(find {})/{inside}", package.name)
            }
            _ if beside => file.file_name()?.to_str()?.to_owned(),
            _ => file.to_str()?.to_owned(),
        };
        Some(MacroFile { filename })
    };
    files.filter_map(include).take(MOST_FILES).collect()
}

fn defines_macro(document: &Document, name: &str) -> bool {
    facts(document).any(|(_, facts)| facts.of(FactKind::Macro).any(|fact| fact.name == name))
}

/// All safe fixes of a file that change nothing else and leave its syntax whole.
fn fix_all(
    state: &mut ServerState,
    path: &Path,
    source: &SourceFile,
    cancel: &CancelFlag,
) -> Result<Option<CodeAction>, RequestFailure> {
    let report = analysis::report_on(&mut state.host, &[path.to_path_buf()], cancel)
        .ok_or(RequestFailure::Cancelled)?;
    let own = |(_, finding): &(usize, &Finding)| {
        finding
            .fix
            .iter()
            .flat_map(|fix| &fix.edits)
            .all(|edit| edit.span.file == source.id)
    };
    let numbers: Vec<usize> = report
        .findings
        .iter()
        .enumerate()
        .filter(own)
        .map(|(n, _)| n)
        .collect();
    let effort = state.host.effort(path, PROOF_EXPANSIONS, cancel);
    let plan = analysis::safe_fixes(state.host.session(), &report, &numbers, &effort);
    let Some(edits) = plan.edits.get(&source.id) else {
        return Ok(None);
    };
    let changed = Document::parse(&apply(&source.document.text(), edits));
    if changed.errors().len() > source.document.errors().len() {
        return Ok(None);
    }
    let edit = |(range, content): &(TextRange, String)| Edit {
        span: Span {
            file: source.id,
            range: *range,
        },
        content: content.clone(),
    };
    let title = "apply all safe fixes".to_owned();
    let action = Action {
        title,
        kind: ActionKind::Fix,
        edits: edits.iter().map(edit).collect(),
    };
    Ok(code_action(state, action, None).map(|made| CodeAction {
        kind: Some(FIX_ALL),
        ..made
    }))
}

/// Whether two ranges have a place in common.
fn touch(a: TextRange, b: TextRange) -> bool {
    a.start <= b.end && b.start <= a.end
}

/// The rule of one of our diagnostics.
fn rule(diagnostic: &Diagnostic) -> Option<&str> {
    match &diagnostic.code {
        Some(NumberOrString::String(code)) if diagnostic.source.as_deref() == Some("xacro") => {
            Some(code)
        }
        _ => None,
    }
}

/// Whether a client that asks for these kinds wants this one; a kind stands for all below it.
fn wants(only: Option<&[CodeActionKind]>, kind: &CodeActionKind) -> bool {
    let Some(only) = only else { return true };
    only.iter().any(|wanted| {
        let below = kind.as_str().strip_prefix(wanted.as_str());
        wanted.as_str().is_empty()
            || below.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    })
}
