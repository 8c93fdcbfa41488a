//! Names of findings that survive edits elsewhere in their files.

use std::path::Path;

use super::render::shown_path;
use analysis::{Report, fingerprint};
use base::FastMap;
use rules::Finding;

/// Gives every finding of a report a name of its own.
#[derive(Default)]
pub(super) struct Fingerprints {
    seen: FastMap<u64, u32>,
}

impl Fingerprints {
    /// Made of the rule, the file and the text of the line; equal ones are counted.
    pub(super) fn of(&mut self, report: &Report, finding: &Finding, cwd: &Path) -> String {
        let path = shown_path(report.path(finding.span.file), cwd);
        let line = report.line(finding.span);
        let hash = fingerprint(&[finding.rule.name, &path, line.trim()]);
        let count = self.seen.entry(hash).or_default();
        *count += 1;
        format!("{hash:016x}:{count}")
    }
}
