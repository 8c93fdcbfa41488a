//! Findings as text: drawn, one line each, counted.

use std::cell::LazyCell;
use std::path::{Path, PathBuf};

use super::io::Io;
use super::listing::{FindingList, counts};
use super::render::{
    AnnotatedRange, ProblemReport as Drawing, ShownFile, render, shown_path, visible,
};
use analysis::{Position, Report};
use annotate_snippets::Level;
use base::{FastMap, FastSet, FileId, Span};
use packages::{Packages, TrustedPaths};
use rules::{Finding, Severity};

/// With the source text.
pub(super) fn full(
    listing: &FindingList<'_>,
    report: &Report,
    packages: &Packages,
    cwd: &Path,
    io: &mut Io<'_>,
) {
    let files = LazyCell::new(|| shown_files(report, packages, cwd));
    for finding in &listing.shown {
        io.out(&format!(
            "{}\n\n",
            drawing(finding, &files, report, cwd, io.color_out)
        ));
    }
}

/// One line a finding.
pub(super) fn concise(listing: &FindingList<'_>, report: &Report, cwd: &Path, io: &mut Io<'_>) {
    for finding in &listing.shown {
        let Position {
            start: (row, column),
            ..
        } = report.position(finding.span);
        let path = shown_path(report.path(finding.span.file), cwd);
        let Finding {
            severity,
            message,
            rule,
            ..
        } = finding;
        io.out(&visible(&format!(
            "{path}:{row}:{column}: {severity}: {message} [{}]\n",
            rule.name
        )));
    }
}

/// How often each rule fired, worst first.
pub(super) fn statistics(report: &Report, io: &mut Io<'_>) {
    for (severity, rule, count) in counts(report) {
        let severity = severity.name();
        io.out(&format!(
            "{count:6}  {severity:7}  {}  {}\n",
            rule.code, rule.name
        ));
    }
}

/// Findings of a report with their source text.
pub(super) fn drawings<'f>(
    findings: impl Iterator<Item = &'f Finding>,
    report: &Report,
    packages: &Packages,
    cwd: &Path,
    color: bool,
) -> Vec<String> {
    let files = shown_files(report, packages, cwd);
    findings
        .map(|finding| drawing(finding, &files, report, cwd, color))
        .collect()
}

/// The files whose text may be shown.
fn shown_files<'a>(
    report: &'a Report,
    packages: &Packages,
    cwd: &Path,
) -> FastMap<FileId, ShownFile<'a>> {
    let around = packages.around(report.roots.iter().map(PathBuf::as_path));
    let places = |finding: &Finding| {
        let related = finding
            .related
            .iter()
            .chain(&finding.places)
            .map(|related| related.span.file);
        related.chain([finding.span.file]).collect::<Vec<_>>()
    };
    let named: FastSet<FileId> = report.findings.iter().flat_map(places).collect();
    let sources = report.files.iter().chain(&report.beside);
    let shown =
        sources.filter(|(id, source)| named.contains(id) && is_shown(&source.path, &around));
    let shown = shown.map(|(id, source)| {
        (
            *id,
            ShownFile {
                source,
                path: shown_path(&source.path, cwd),
            },
        )
    });
    shown.collect()
}

/// A finding with its source text.
fn drawing(
    finding: &Finding,
    files: &FastMap<FileId, ShownFile<'_>>,
    report: &Report,
    cwd: &Path,
    color: bool,
) -> String {
    let Some(primary) = mark(files, finding.span, "") else {
        let path = shown_path(report.path(finding.span.file), cwd);
        let (row, column) = report.position(finding.span).start;
        let Finding {
            severity,
            rule,
            message,
            ..
        } = finding;
        let from = finding
            .related
            .iter()
            .find(|related| files.contains_key(&related.span.file))
            .map(|related| {
                let (row, column) = report.position(related.span).start;
                format!(
                    " ({} {}:{row}:{column})",
                    related.message,
                    shown_path(report.path(related.span.file), cwd)
                )
            });
        let from = from.unwrap_or_default();
        return visible(&format!(
            "{severity}[{}]: {path}:{row}:{column}: {message}{from}",
            rule.name
        ));
    };
    let drawing = Drawing {
        level: level(finding.severity),
        id: Some(finding.rule.name.to_owned()),
        url: finding.rule.url().filter(|_| color),
        title: finding.message.clone(),
        primary,
        trace: finding
            .related
            .iter()
            .filter_map(|related| mark(files, related.span, &related.message))
            .collect(),
        places: finding
            .places
            .iter()
            .filter_map(|place| mark(files, place.span, &place.message))
            .collect(),
        help: finding.help.clone(),
    };
    render(&drawing, color)
}

/// A place with a label; none when its text may not be shown.
fn mark<'f>(
    files: &'f FastMap<FileId, ShownFile<'f>>,
    span: Span,
    label: &str,
) -> Option<AnnotatedRange<'f>> {
    Some(AnnotatedRange {
        file: files.get(&span.file)?,
        range: span.range,
        label: label.to_owned(),
    })
}

/// Whether the text of a file may be shown. What is no description by its name, or belongs to no robot, may be anything:
/// a key, say. Its text is not for a log.
pub(super) fn is_shown(path: &Path, around: &TrustedPaths<'_>) -> bool {
    const ENDINGS: [&str; 16] = [
        "xacro", "urdf", "gazebo", "trans", "world", "xml", "srdf", "sdf", "yaml", "yml", "toml",
        "txt", "launch", "py", "sh", "bash",
    ];
    let is_known = |ending: &str| ENDINGS.iter().any(|own| own.eq_ignore_ascii_case(ending));
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(is_known) && around.hold(path)
}

/// The level of a message in a terminal.
pub(super) fn level(severity: Severity) -> Level<'static> {
    match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
        Severity::Hint => Level::NOTE.with_name("hint"),
    }
}

/// A number of things; "info" has no plural.
pub(super) fn counted(count: usize, noun: &str) -> String {
    if noun == "info" {
        return format!("{count} info");
    }
    base::counted(count, noun)
}
