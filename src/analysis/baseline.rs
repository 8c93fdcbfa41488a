//! Findings that are known and accepted, kept in a file: only what exceeds them is reported.
use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::report::Report;
use rules::Finding;

/// The form of the file.
const VERSION: u32 = 1;

/// How many findings of a rule each source line may have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Baseline {
    known: BTreeMap<BaselineKey, usize>,
}

/// A rule and a source line. The number of the line is left out: it changes with every edit above.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct BaselineKey {
    file: String,
    rule: String,
    line: String,
}

#[derive(Deserialize, Serialize)]
struct Stored {
    version: u32,
    findings: Vec<BaselineEntry>,
}

#[derive(Deserialize, Serialize)]
struct BaselineEntry {
    rule: String,
    file: String,
    line: String,
    count: usize,
}

impl Baseline {
    /// The findings of a report; files are named relative to `folder`, where the baseline is to lie.
    pub fn of(report: &Report, folder: &Path) -> Self {
        let mut known = BTreeMap::new();
        for finding in &report.findings {
            *known
                .entry(BaselineKey::of(report, finding, folder))
                .or_default() += 1;
        }
        Self { known }
    }

    /// Read a file that [`to_json`](Self::to_json) wrote.
    ///
    /// # Errors
    /// When it is something else.
    pub fn from_json(text: &str) -> Result<Self, String> {
        let stored: Stored =
            serde_json::from_str(text).map_err(|error| format!("not a baseline: {error}"))?;
        if stored.version != VERSION {
            return Err(format!(
                "unsupported baseline version {}; this program supports version {VERSION}",
                stored.version
            ));
        }
        let entry = |entry: BaselineEntry| {
            (
                BaselineKey {
                    file: entry.file,
                    rule: entry.rule,
                    line: entry.line,
                },
                entry.count,
            )
        };
        Ok(Self {
            known: stored.findings.into_iter().map(entry).collect(),
        })
    }

    /// As a file, in an order that makes small differences.
    pub fn to_json(&self) -> String {
        let entry = |(key, &count): (&BaselineKey, &usize)| {
            let BaselineKey { file, rule, line } = key.clone();
            BaselineEntry {
                rule,
                file,
                line,
                count,
            }
        };
        let stored = Stored {
            version: VERSION,
            findings: self.known.iter().map(entry).collect(),
        };
        format!(
            "{}\n",
            serde_json::to_string_pretty(&stored).unwrap_or_default()
        )
    }

    /// How many findings it holds.
    pub fn len(&self) -> usize {
        self.known.values().sum()
    }

    /// Whether it holds none.
    pub fn is_empty(&self) -> bool {
        self.known.is_empty()
    }

    /// Take the known findings out of a report; of more than are known on a line, the first ones. The result is how many
    /// were taken out, and how many did not occur in the files that are `checked`.
    pub fn subtract(
        &self,
        report: &mut Report,
        folder: &Path,
        checked: impl Fn(&Path) -> bool,
    ) -> (usize, usize) {
        let mut left = self.known.clone();
        let before = report.findings.len();
        let mut findings = std::mem::take(&mut report.findings);
        findings.retain(
            |finding| match left.get_mut(&BaselineKey::of(report, finding, folder)) {
                Some(count) if *count > 0 => {
                    *count -= 1;
                    false
                }
                _ => true,
            },
        );
        report.findings = findings;
        let gone = left
            .into_iter()
            .filter(|(key, _)| checked(&folder.join(&key.file)));
        (
            before - report.findings.len(),
            gone.map(|(_, count)| count).sum(),
        )
    }
}

impl BaselineKey {
    fn of(report: &Report, finding: &Finding, folder: &Path) -> Self {
        let path = report.path(finding.span.file);
        let file = vfs::slashed(path.strip_prefix(folder).unwrap_or(path));
        let line = format!("{:016x}", fingerprint(&[report.line(finding.span).trim()]));
        Self {
            file,
            rule: finding.rule.name.to_owned(),
            line,
        }
    }
}

/// A hash that is the same in every version, on every machine (64 bit FNV-1a); parts are kept apart.
pub fn fingerprint(parts: &[&str]) -> u64 {
    let bytes = parts.iter().flat_map(|part| part.bytes().chain([0xFF]));
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3)
    })
}

#[cfg(test)]
mod tests {
    use super::{Baseline, fingerprint};

    #[test]
    fn fingerprints_never_change() {
        // the first is that of the byte that ends a part
        assert_eq!(fingerprint(&[""]), 0xAF64_724C_8602_EB6E);
        assert_ne!(fingerprint(&["a", "b"]), fingerprint(&["ab"]));
        assert_eq!(fingerprint(&["a", "b"]), fingerprint(&["a", "b"]));
    }

    #[test]
    fn what_is_no_baseline() {
        let error = |text: &str| Baseline::from_json(text).unwrap_err();
        assert!(error("[]").starts_with("not a baseline: "));
        assert!(
            error("{\"version\": 2, \"findings\": []}")
                .starts_with("unsupported baseline version 2")
        );
        assert!(
            Baseline::from_json("{\"version\": 1, \"findings\": []}")
                .unwrap()
                .is_empty()
        );
    }
}
