//! Findings in the forms of services: GitHub, GitLab, and whatever reads JUnit.

use std::path::Path;

use indexmap::IndexMap;
use serde_json::{Value, json};

use super::fingerprints::Fingerprints;
use super::render::{shown_path, visible};
use analysis::{Position, Report};
use base::escape_xml;
use rules::{Finding, Severity};

/// The findings that people are shown.
fn shown(report: &Report, hints: bool) -> impl Iterator<Item = &Finding> {
    report
        .findings
        .iter()
        .filter(move |finding| hints || finding.severity > Severity::Hint)
}

/// Commands that GitHub Actions turns into annotations.
pub(super) fn github(report: &Report, cwd: &Path, hints: bool) -> String {
    let mut out = String::new();
    for finding in shown(report, hints) {
        let command = match finding.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Info | Severity::Hint => "notice",
        };
        let Position { start, end } = report.position(finding.span);
        let file = property(&shown_path(report.path(finding.span.file), cwd));
        let title = property(&format!("{} ({})", finding.rule.name, finding.rule.code));
        let message = visible(&escape(&finding.message));
        out.push_str(&format!(
            "::{command} file={file},line={},endLine={},col={},endColumn={},title={title}::{message}\n",
            start.0, end.0, start.1, end.1
        ));
    }
    out
}

fn escape(text: &str) -> String {
    text.replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

fn property(text: &str) -> String {
    visible(&escape(text).replace(':', "%3A").replace(',', "%2C"))
}

/// A code quality report of GitLab.
pub(super) fn gitlab(report: &Report, cwd: &Path, hints: bool) -> String {
    let mut fingerprints = Fingerprints::default();
    let object = |finding: &Finding| {
        let Position { start, end } = report.position(finding.span);
        let severity = match finding.severity {
            Severity::Error => "major",
            Severity::Warning => "minor",
            Severity::Info | Severity::Hint => "info",
        };
        json!({
            "description": format!("{}: {}", finding.rule.name, finding.message),
            "check_name": finding.rule.name,
            "fingerprint": fingerprints.of(report, finding, cwd),
            "severity": severity,
            "location": {
                "path": shown_path(report.path(finding.span.file), cwd),
                "positions": {
                    "begin": {"line": start.0, "column": start.1},
                    "end": {"line": end.0, "column": end.1},
                },
            },
        })
    };
    let list: Vec<Value> = shown(report, hints).map(object).collect();
    format!("{:#}\n", Value::Array(list))
}

/// A JUnit report: a suite for each file, a test for each finding; findings of at least `least` fail, and a
/// file without findings is a test that passes.
pub(super) fn junit(report: &Report, cwd: &Path, hints: bool, least: Severity) -> String {
    let mut suites: IndexMap<String, Vec<&Finding>> = report
        .files
        .values()
        .map(|file| (shown_path(&file.path, cwd), Vec::new()))
        .collect();
    for finding in shown(report, hints) {
        suites
            .entry(shown_path(report.path(finding.span.file), cwd))
            .or_default()
            .push(finding);
    }
    suites.sort_unstable_keys();
    let all = suites
        .values()
        .map(|findings| findings.len().max(1))
        .sum::<usize>();
    let is_failure = |finding: &&Finding| finding.severity >= least;
    let failed = suites
        .values()
        .flatten()
        .copied()
        .filter(|finding| is_failure(finding))
        .count();
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"xacro-lint\" tests=\"{all}\" failures=\"{failed}\" errors=\"0\">\n"
    );
    for (path, findings) in &suites {
        let path = quoted(path);
        let failures = findings.iter().copied().filter(is_failure).count();
        let tests = findings.len().max(1);
        out.push_str(&format!(
            "  <testsuite name=\"{path}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"0\">\n"
        ));
        if findings.is_empty() {
            out.push_str(&format!(
                "    <testcase classname=\"{path}\" name=\"no findings\"/>\n"
            ));
        }
        for finding in findings {
            out.push_str(&test(report, finding, &path, is_failure(finding)));
        }
        out.push_str("  </testsuite>\n");
    }
    out.push_str("</testsuites>\n");
    out
}

fn test(report: &Report, finding: &Finding, path: &str, fails: bool) -> String {
    let Position {
        start: (row, column),
        ..
    } = report.position(finding.span);
    let (name, severity) = (finding.rule.name, finding.severity);
    let message = quoted(&finding.message);
    let text = format!("{path}:{row}:{column}: {severity}: {message} [{name}]");
    let head = format!(
        "    <testcase classname=\"{path}\" name=\"{name}:{row}:{column}\" file=\"{path}\" line=\"{row}\">\n"
    );
    let body = if fails {
        format!("      <failure type=\"{severity}\" message=\"{message}\">{text}</failure>\n")
    } else {
        format!("      <system-out>{text}</system-out>\n")
    };
    format!("{head}{body}    </testcase>\n")
}

/// Text for XML, in an attribute or between tags.
pub(super) fn quoted(text: &str) -> String {
    let text = escape_xml(&visible(text));
    // characters that no XML may hold
    text.replace(['\n', '\t'], " ")
        .replace(['\u{FFFE}', '\u{FFFF}'], "\u{FFFD}")
}
