//! Findings as JSON.
use std::path::Path;

use serde::Serialize;

use super::report::Report;
use base::Span;
use rules::{Finding, Fix};
use vfs::shown_path;

#[derive(Serialize)]
struct JsonFinding<'a> {
    code: &'a str,
    name: &'a str,
    severity: &'a str,
    message: &'a str,
    #[serde(flatten)]
    place: JsonLocation,
    help: Option<&'a str>,
    related: Vec<JsonRelated<'a>>,
    /// How many places the finding is about.
    places: usize,
    fix: Option<JsonFix<'a>>,
    url: Option<String>,
}

#[derive(Serialize)]
struct JsonLocation {
    filename: String,
    location: JsonPosition,
    end_location: JsonPosition,
}

#[derive(Serialize)]
struct JsonPosition {
    row: u32,
    column: u32,
}

#[derive(Serialize)]
struct JsonRelated<'a> {
    #[serde(flatten)]
    place: JsonLocation,
    message: &'a str,
}

#[derive(Serialize)]
struct JsonFix<'a> {
    applicability: &'a str,
    message: &'a str,
    edits: Vec<JsonEdit<'a>>,
}

#[derive(Serialize)]
struct JsonEdit<'a> {
    #[serde(flatten)]
    place: JsonLocation,
    content: &'a str,
}

/// All findings as one array of JSON, as `check --format json` prints it; files below `cwd` by their relative paths.
pub fn to_json(report: &Report, cwd: &Path) -> String {
    let place = |span: Span| place(report, span, cwd);
    let list: Vec<JsonFinding<'_>> = report
        .findings
        .iter()
        .map(|finding| object(finding, &place))
        .collect();
    let text = serde_json::to_string_pretty(&list).unwrap_or_else(|_| "[]".to_owned());
    format!("{text}\n")
}

/// One finding of a report as JSON.
pub fn finding_to_json(report: &Report, finding: &Finding, cwd: &Path) -> serde_json::Value {
    let place = |span: Span| place(report, span, cwd);
    serde_json::to_value(object(finding, &place)).unwrap_or_default()
}

fn object<'a>(finding: &'a Finding, place: &dyn Fn(Span) -> JsonLocation) -> JsonFinding<'a> {
    JsonFinding {
        code: finding.rule.code,
        name: finding.rule.name,
        severity: finding.severity.name(),
        message: &finding.message,
        place: place(finding.span),
        help: finding.help.as_deref(),
        related: finding
            .related
            .iter()
            .chain(&finding.places)
            .map(|related| JsonRelated {
                place: place(related.span),
                message: &related.message,
            })
            .collect(),
        places: finding.places.len() + 1,
        fix: finding.fix.as_ref().map(|fix| json_fix(fix, place)),
        url: finding.rule.url(),
    }
}

fn json_fix<'a>(fix: &'a Fix, place: &dyn Fn(Span) -> JsonLocation) -> JsonFix<'a> {
    let edits = fix.edits.iter().map(|edit| JsonEdit {
        place: place(edit.span),
        content: &edit.content,
    });
    JsonFix {
        applicability: fix.safety.name(),
        message: &fix.message,
        edits: edits.collect(),
    }
}

fn place(report: &Report, span: Span, cwd: &Path) -> JsonLocation {
    let position = report.position(span);
    JsonLocation {
        filename: shown_path(report.path(span.file), cwd),
        location: json_position(position.start),
        end_location: json_position(position.end),
    }
}

fn json_position((row, column): (u32, u32)) -> JsonPosition {
    JsonPosition { row, column }
}
