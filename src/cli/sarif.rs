//! Findings as SARIF 2.1.0, which code scanning services read.

use std::path::Path;

use indexmap::IndexMap;
use serde_json::{Value, json};

use super::fingerprints::Fingerprints;
use super::render::shown_path;
use analysis::Report;
use base::Span;
use base::paths::HERE;
use rules::{Finding, Fix, Rule, Severity};

const SCHEMA: &str = "https://json.schemastore.org/sarif-2.1.0.json";

/// All findings as one document.
pub(super) fn document(report: &Report, cwd: &Path) -> String {
    let writer = SarifWriter { report, cwd };
    let mut rules: IndexMap<&str, &Rule> = IndexMap::new();
    for finding in &report.findings {
        rules.entry(finding.rule.code).or_insert(finding.rule);
    }
    rules.sort_unstable_keys();
    let mut fingerprints = Fingerprints::default();
    let results = report.findings.iter().map(|finding| {
        let index = rules.get_index_of(finding.rule.code).unwrap_or(0);
        writer.result(finding, index, &fingerprints.of(report, finding, cwd))
    });
    let results: Vec<Value> = results.collect();
    let descriptors: Vec<Value> = rules.values().map(|rule| descriptor(rule)).collect();
    let document = json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {
                "name": "xacro-lint",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": descriptors,
            }},
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    });
    format!("{document:#}\n")
}

/// Without the keys that have no value.
fn object(fields: impl IntoIterator<Item = (&'static str, Option<Value>)>) -> Value {
    Value::Object(
        fields
            .into_iter()
            .filter_map(|(key, value)| Some((key.to_owned(), value?)))
            .collect(),
    )
}

fn descriptor(rule: &Rule) -> Value {
    let summary = rule.summary().replace('\n', " ");
    object([
        ("id", Some(json!(rule.code))),
        ("name", Some(json!(rule.name))),
        ("shortDescription", Some(json!({"text": summary}))),
        (
            "help",
            Some(json!({"text": summary, "markdown": rule.docs})),
        ),
        ("helpUri", rule.url().map(Value::String)),
        (
            "defaultConfiguration",
            Some(json!({"level": level(rule.severity)})),
        ),
        ("properties", Some(json!({"tags": [rule.category.name()]}))),
    ])
}

fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info | Severity::Hint => "note",
    }
}

struct SarifWriter<'a> {
    report: &'a Report,
    cwd: &'a Path,
}

impl SarifWriter<'_> {
    fn result(&self, finding: &Finding, rule_index: usize, fingerprint: &str) -> Value {
        let text = match &finding.help {
            Some(help) => format!("{}; {help}", finding.message),
            None => finding.message.clone(),
        };
        let related: Vec<Value> = finding
            .related
            .iter()
            .chain(&finding.places)
            .map(|related| json!({"physicalLocation": self.place(related.span), "message": {"text": related.message}}))
            .collect();
        object([
            ("ruleId", Some(json!(finding.rule.code))),
            ("ruleIndex", Some(json!(rule_index))),
            ("level", Some(json!(level(finding.severity)))),
            ("message", Some(json!({"text": text}))),
            (
                "locations",
                Some(json!([{"physicalLocation": self.place(finding.span)}])),
            ),
            (
                "relatedLocations",
                (!related.is_empty()).then_some(Value::Array(related)),
            ),
            (
                "partialFingerprints",
                Some(json!({"xacroLint/v1": fingerprint})),
            ),
            (
                "fixes",
                finding
                    .fix
                    .as_ref()
                    .filter(|fix| !fix.edits.is_empty())
                    .map(|fix| self.fixes(fix)),
            ),
        ])
    }

    fn place(&self, span: Span) -> Value {
        json!({"artifactLocation": self.artifact(span), "region": self.region(span)})
    }

    fn artifact(&self, span: Span) -> Value {
        json!({"uri": uri(&shown_path(self.report.path(span.file), self.cwd))})
    }

    fn region(&self, span: Span) -> Value {
        let position = self.report.position(span);
        json!({
            "startLine": position.start.0,
            "startColumn": position.start.1,
            "endLine": position.end.0,
            "endColumn": position.end.1,
        })
    }

    /// A fix, its edits by file.
    fn fixes(&self, fix: &Fix) -> Value {
        let mut files: IndexMap<u32, (Value, Vec<Value>)> = IndexMap::new();
        for edit in &fix.edits {
            let artifact = || (self.artifact(edit.span), Vec::new());
            let (_, replacements) = files.entry(edit.span.file.0).or_insert_with(artifact);
            let region = self.region(edit.span);
            replacements
                .push(json!({"deletedRegion": region, "insertedContent": {"text": edit.content}}));
        }
        let changes: Vec<Value> = files
            .into_values()
            .map(|(artifact, replacements)| json!({"artifactLocation": artifact, "replacements": replacements}))
            .collect();
        json!([{"description": {"text": fix.message}, "artifactChanges": changes}])
    }
}

/// A path as a URI: relative ones stay relative.
fn uri(path: &str) -> String {
    if HERE.is_absolute(path) {
        return HERE.file_uri(path);
    }
    let mut out = String::new();
    for byte in path.bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'~' => out.push(byte as char),
            byte if byte.is_ascii_alphanumeric() => out.push(byte as char),
            byte => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::uri;

    #[test]
    fn uris() {
        for (path, expected) in [
            ("urdf/arm.xacro", "urdf/arm.xacro"),
            (
                "/ws/my robot/ärm#1.xacro",
                "file:///ws/my%20robot/%C3%A4rm%231.xacro",
            ),
        ] {
            assert_eq!(uri(path), expected);
        }
    }
}
