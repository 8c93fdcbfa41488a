//! Findings as diagnostics, pushed when there is a pause.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lsp_types::{
    CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag,
    NumberOrString, Url,
};

use crate::contexts::announce_contexts;
use crate::locations::{LocationCache, places};
use crate::publishing::publish;
use crate::refreshing::refresh_others;
use crate::requests::beside::robots_described;
use crate::requests::code_action::sentence_case;
use crate::scheduler::Cause;
use crate::state::ServerState;
use analysis::{Report, Work, is_settings};
use base::CancelFlag;
use base::clock::Instant;
use base::limits::{DIAGNOSTICS, RELATED};
use rules::{Finding, Rule, Severity, Trait};

/// Make and publish diagnostics; given up when an event comes in meanwhile, and tried again later.
pub fn make_diagnostics(state: &mut ServerState) {
    if state.client.pulls_diagnostics {
        let cause = state.diagnostics.finish();
        let cancel = state.status.background();
        prepare(state, cause, &cancel);
        announce_contexts(state, &cancel);
    } else {
        push_diagnostics(state);
    }
    if !state.diagnostics.is_due() && state.documents.len() > 1 {
        refresh_others(state);
    }
}

/// Expand the robots of what was just opened while nobody waits: the first question about them is answered at once then.
fn prepare(state: &mut ServerState, cause: Option<Cause>, cancel: &CancelFlag) {
    let opened: Vec<PathBuf> = match cause {
        Some(Cause::Opened(path)) => vec![path],
        Some(Cause::Indexed) => state.documents.keys().cloned().collect(),
        _ => return,
    };
    for path in opened.iter().filter(|path| !is_settings(path)) {
        if let Some(root) = analysis::context(&mut state.host, path).root {
            // what is not done when a message comes in, its answer does
            let _ = state.host.analyzed(&root, cancel);
        }
        if let Some(source) = state.host.document(path) {
            let _ = robots_described(state, path, &source, cancel);
        }
    }
}

fn push_diagnostics(state: &mut ServerState) {
    let Some(cause) = state.diagnostics.cause().cloned() else {
        return;
    };
    let cancel = state.status.background();
    if let Some(found) = found(state, None, &cause, &cancel) {
        state.diagnostics.finish();
        publish(state, found);
    }
    announce_contexts(state, &cancel);
}

/// The diagnostics of all open files, of one more, and of the files they depend on. What there is to say of a file
/// may come from the robot of another one, so they are always made together. `None` when cancelled.
pub fn found(
    state: &mut ServerState,
    more: Option<&Path>,
    cause: &Cause,
    cancel: &CancelFlag,
) -> Option<BTreeMap<PathBuf, Vec<Diagnostic>>> {
    let further = more
        .filter(|path| !state.documents.contains_key(*path))
        .map(Path::to_path_buf);
    let open = state.documents.keys().cloned().chain(further);
    let (doubles, checked_files): (Vec<PathBuf>, Vec<PathBuf>) =
        open.partition(|path| state.installed.source_of_double(path).is_some());
    let mut report = checked(state, &checked_files, cause, cancel)?;
    analysis::mark_groups(&mut report);
    analysis::mark_cuts(&mut report);
    let mut found = spread(state, &report);
    for path in checked_files.into_iter().chain(doubles) {
        found.entry(path).or_default();
    }
    Some(found)
}

/// Check files, and log why, what was done again for it, and how long it took.
fn checked(
    state: &mut ServerState,
    open: &[PathBuf],
    cause: &Cause,
    cancel: &CancelFlag,
) -> Option<Report> {
    let start = Instant::now();
    let before = state.host.work();
    let report = analysis::report_on(&mut state.host, open, cancel);
    let ms = start.elapsed().as_micros() as f64 / 1000.0;
    let Work {
        expanded,
        items_left_out,
    } = state.host.work().since(before);
    match &report {
        Some(report) => {
            let (robots, findings) = (report.roots.len(), report.findings.len());
            tracing::info!(
                files = open.len(),
                robots,
                expanded,
                items_left_out,
                findings,
                ms,
                "checked: {cause}"
            );
        }
        None => tracing::debug!(expanded, ms, "check interrupted by a new message: {cause}"),
    }
    report
}

/// The findings of a report by the files they are shown in.
fn spread(state: &mut ServerState, report: &Report) -> BTreeMap<PathBuf, Vec<Diagnostic>> {
    let mut found: BTreeMap<PathBuf, Vec<Diagnostic>> = BTreeMap::new();
    let mut left_out: BTreeMap<PathBuf, usize> = BTreeMap::new();
    let mut places = places(state);
    for finding in &report.findings {
        let Some(diagnostic) = diagnostic(&mut places, finding) else {
            continue;
        };
        let path = report.path(finding.span.file);
        let list = found.entry(path.to_path_buf()).or_default();
        if list.len() < DIAGNOSTICS {
            list.push(diagnostic);
        } else {
            *left_out.entry(path.to_path_buf()).or_default() += 1;
        }
    }
    for list in found.values_mut() {
        list.sort_by_key(|diagnostic| diagnostic.range.start);
    }
    for (path, count) in left_out {
        found.entry(path).or_default().push(more(count));
    }
    found
}

pub fn diagnostic(places: &mut LocationCache<'_>, finding: &Finding) -> Option<Diagnostic> {
    let place = places.location(finding.span)?;
    let related = finding.related.iter().take(RELATED).filter_map(|related| {
        let location = places.location(related.span)?;
        Some(DiagnosticRelatedInformation {
            location,
            message: related.message.clone(),
        })
    });
    let related: Vec<_> = related.collect();
    let message = match &finding.help {
        Some(help) => format!("{}\n{help}", finding.message),
        None => finding.message.clone(),
    };
    Some(Diagnostic {
        range: place.range,
        severity: Some(severity(finding.severity)),
        code: Some(NumberOrString::String(finding.rule.name.to_owned())),
        code_description: page(finding.rule.name).map(|href| CodeDescription { href }),
        source: Some("xacro".to_owned()),
        message,
        related_information: (!related.is_empty()).then_some(related),
        tags: tags(finding.rule),
        data: fix_data(places, finding),
    })
}

/// The edits of a fix, so that a code action needs no new analysis.
fn fix_data(places: &mut LocationCache<'_>, finding: &Finding) -> Option<serde_json::Value> {
    let fix = finding.fix.as_ref()?;
    let edits: Option<Vec<_>> = fix
        .edits
        .iter()
        .map(|edit| {
            let place = places.location(edit.span)?;
            Some(serde_json::json!({ "uri": place.uri, "range": place.range, "newText": edit.content }))
        })
        .collect();
    Some(
        serde_json::json!({ "title": sentence_case(&fix.message), "safety": fix.safety.name(), "edits": edits? }),
    )
}

/// Says that there are more findings than are shown.
fn more(count: usize) -> Diagnostic {
    Diagnostic {
        severity: Some(DiagnosticSeverity::INFORMATION),
        source: Some("xacro".to_owned()),
        message: format!("{count} more findings in this file not shown"),
        ..Diagnostic::default()
    }
}

fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Info => DiagnosticSeverity::INFORMATION,
        Severity::Hint => DiagnosticSeverity::HINT,
    }
}

fn tags(rule: &Rule) -> Option<Vec<DiagnosticTag>> {
    let tag = if rule.has(Trait::Unnecessary) {
        DiagnosticTag::UNNECESSARY
    } else if rule.has(Trait::Deprecated) {
        DiagnosticTag::DEPRECATED
    } else {
        return None;
    };
    Some(vec![tag])
}

/// The page of a rule.
fn page(rule: &str) -> Option<Url> {
    const REPOSITORY: &str = env!("CARGO_PKG_REPOSITORY");
    if REPOSITORY.is_empty() {
        return None;
    }
    Url::parse(&format!("{REPOSITORY}/blob/main/docs/rules/{rule}.md")).ok()
}
