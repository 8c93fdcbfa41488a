//! Where an editor shows a finding in the body of a macro: at the call whose argument is wrong, or that is the only
//! one in which it holds; else in the body, and once more as a note at the calls in files that are open.

use std::path::Path;

use super::report::Report;
use base::Span;
use rules::{Finding, Group, Related, Severity, Way};
use vfs::Vfs;

/// Notes at calls, of one finding.
const MOST_NOTES: usize = 10;

/// Show the findings of a report where an editor shows them.
pub(super) fn place(report: &mut Report, vfs: &Vfs, is_open: impl Fn(&Path) -> bool) {
    let mut placed: Vec<Finding> = Vec::new();
    for finding in std::mem::take(&mut report.findings) {
        let moves = |way: &&Way| way.argument.is_some() || finding.partial;
        let moved: Vec<Finding> =
            finding.ways.iter().filter(moves).map(|way| at_call(&finding, way)).collect();
        if moved.is_empty() || moved.len() < finding.ways.len() {
            let open = |span: Span| is_open(&vfs.path(span.file));
            placed.extend(notes(&finding, &moved, vfs, open));
            // the calls are told apart from here on: nobody asks for them again
            placed.push(Finding { ways: Vec::new(), ..finding });
        }
        placed.extend(moved);
    }
    for span in placed.iter().map(|finding| finding.span) {
        report.paths.entry(span.file).or_insert_with(|| vfs.path(span.file));
    }
    placed.sort_by_cached_key(|found| (vfs.path(found.span.file), found.span.range.start, found.rule.code));
    report.findings = placed;
}

/// A finding at the call that is to blame.
fn at_call(finding: &Finding, way: &Way) -> Finding {
    let body =
        Related { span: finding.span, message: format!("here in macro `{}`", way.name), is_call: false };
    let span = way.argument.unwrap_or(way.call);
    let others = finding.related.iter().filter(|related| related.span != span && related.span != way.call);
    let own =
        |related: &&Related| !related.is_call || finding.ways.iter().all(|way| way.call != related.span);
    let alone = finding.ways.len() == 1;
    Finding {
        span,
        message: way.message.clone(),
        help: way.help.clone(),
        related: std::iter::once(body).chain(others.filter(own).cloned()).collect(),
        fix: finding.fix.clone().filter(|_| alone),
        ways: Vec::new(),
        ..finding.clone()
    }
}

/// Notes at the calls that lead to a finding.
fn notes(finding: &Finding, moved: &[Finding], vfs: &Vfs, open: impl Fn(Span) -> bool) -> Vec<Finding> {
    if finding.severity < Severity::Warning {
        return Vec::new();
    }
    // an error of a closed file is shown as it is at the first call in an open one, which the server does
    let is_elsewhere = finding.severity == Severity::Error && !open(finding.span);
    let mut open_calls = finding.related.iter().filter(|related| related.is_call && open(related.span));
    let shown = open_calls.next().filter(|_| is_elsewhere).map(|call| call.span);
    let calls = finding.related.iter().filter(|related| Some(related.span) != shown).filter(|related| {
        let told = moved.iter().any(|other| other.span == related.span) || related.span == finding.span;
        related.is_call && !told && open(related.span) && is_call_tag(related.span, vfs)
    });
    let note = |call: &Related| Finding {
        severity: Severity::Info,
        message: format!("this call leads to a finding: {}", finding.message),
        span: call.span,
        related: vec![Related { span: finding.span, message: "it stands here".to_owned(), is_call: false }],
        fix: None,
        ways: Vec::new(),
        group: Some(Group::Place),
        ..finding.clone()
    };
    calls.take(MOST_NOTES).map(note).collect()
}

/// Whether the tag at a span calls a macro.
fn is_call_tag(span: Span, vfs: &Vfs) -> bool {
    const OTHERS: [&str; 3] = ["<xacro:include", "<xacro:insert_block", "<xacro:property"];
    let Ok(source) = vfs.document(&vfs.path(span.file)) else { return false };
    let text = source.document.slice(span.range);
    text.starts_with("<xacro:") && !OTHERS.contains(&text.as_ref())
}
