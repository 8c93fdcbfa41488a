//! Diagnostics that the client asks for.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::{
    Diagnostic, DocumentDiagnosticParams, DocumentDiagnosticReport, DocumentDiagnosticReportResult,
    FullDocumentDiagnosticReport, RelatedFullDocumentDiagnosticReport,
    RelatedUnchangedDocumentDiagnosticReport, UnchangedDocumentDiagnosticReport,
    WorkspaceDiagnosticParams, WorkspaceDiagnosticReport, WorkspaceDiagnosticReportResult,
    WorkspaceDocumentDiagnosticReport, WorkspaceFullDocumentDiagnosticReport,
    WorkspaceUnchangedDocumentDiagnosticReport,
};

use crate::diagnostics::found;
use crate::failure::RequestFailure;
use crate::publishing::fingerprint;
use crate::scanning::scan_first;
use crate::scheduler::Cause;
use crate::state::ServerState;
use base::CancelFlag;

pub fn pull_diagnostics(
    state: &mut ServerState,
    params: DocumentDiagnosticParams,
    cancel: &CancelFlag,
) -> Result<DocumentDiagnosticReportResult, RequestFailure> {
    let (path, _) = state.source(&params.text_document.uri)?;
    scan_first(state);
    let mut found =
        found(state, Some(&path), &Cause::Requested, cancel).ok_or(RequestFailure::Cancelled)?;
    let items = found.remove(&path).unwrap_or_default();
    let id = result_id(&items);
    let report = if params.previous_result_id.as_deref() == Some(&id) {
        let unchanged = UnchangedDocumentDiagnosticReport { result_id: id };
        DocumentDiagnosticReport::Unchanged(RelatedUnchangedDocumentDiagnosticReport {
            related_documents: None,
            unchanged_document_diagnostic_report: unchanged,
        })
    } else {
        let full = FullDocumentDiagnosticReport {
            result_id: Some(id),
            items,
        };
        DocumentDiagnosticReport::Full(RelatedFullDocumentDiagnosticReport {
            related_documents: None,
            full_document_diagnostic_report: full,
        })
    };
    Ok(DocumentDiagnosticReportResult::Report(report))
}

pub fn pull_workspace(
    state: &mut ServerState,
    params: WorkspaceDiagnosticParams,
    cancel: &CancelFlag,
) -> Result<WorkspaceDiagnosticReportResult, RequestFailure> {
    let mut found =
        found(state, None, &Cause::Requested, cancel).ok_or(RequestFailure::Cancelled)?;
    let known = params.previous_result_ids.into_iter();
    let known: BTreeMap<PathBuf, String> =
        known.map(|id| (state.path(&id.uri), id.value)).collect();
    let with_findings = found
        .iter()
        .filter(|(_, items)| !items.is_empty())
        .map(|(path, _)| path.clone())
        .collect();
    let reported = std::mem::replace(&mut state.sent.workspace_files, with_findings);
    // what was reported of a file stays until a report says otherwise
    for path in known.keys().cloned().chain(reported) {
        found.entry(path).or_default();
    }
    let report = |(path, items): (PathBuf, Vec<Diagnostic>)| {
        report_of(state, &path, items, known.get(&path))
    };
    let report = WorkspaceDiagnosticReport {
        items: found.into_iter().filter_map(report).collect(),
    };
    Ok(WorkspaceDiagnosticReportResult::Report(report))
}

/// What there is to say of a file, or that it is what was said before.
fn report_of(
    state: &ServerState,
    path: &Path,
    items: Vec<Diagnostic>,
    before: Option<&String>,
) -> Option<WorkspaceDocumentDiagnosticReport> {
    let version = state
        .documents
        .get(path)
        .and_then(|open| open.version)
        .map(i64::from);
    let (uri, result_id) = (state.uri(path)?, result_id(&items));
    Some(if before == Some(&result_id) {
        WorkspaceDocumentDiagnosticReport::Unchanged(WorkspaceUnchangedDocumentDiagnosticReport {
            uri,
            version,
            unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id },
        })
    } else {
        WorkspaceDocumentDiagnosticReport::Full(WorkspaceFullDocumentDiagnosticReport {
            uri,
            version,
            full_document_diagnostic_report: FullDocumentDiagnosticReport {
                result_id: Some(result_id),
                items,
            },
        })
    })
}

/// What tells one list of findings from another.
fn result_id(items: &[Diagnostic]) -> String {
    format!(
        "{:x}",
        fingerprint(&serde_json::to_vec(items).unwrap_or_default())
    )
}
