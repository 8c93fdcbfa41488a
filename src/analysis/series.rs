//! Robots that a program wrote in series: what is wrong with one is wrong in the program.
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use base::{FastMap, FastSet, FileId};
use rules::{Finding, Severity};

/// A rule in one severity.
type Kind = (&'static str, Severity);

/// Files of one folder whose names differ in numbers alone, by what is found in many of them.
#[derive(Default)]
pub struct Series(FastMap<(Kind, FileId), Arc<str>>);

impl Series {
    /// How many files make a series. A few may be variants that somebody wrote, each with defects of its own.
    const LEAST: usize = 10;

    /// The series among the files of findings.
    pub fn of(findings: &[Finding], paths: &BTreeMap<FileId, Arc<Path>>) -> Self {
        let mut files: FastMap<(Kind, Arc<str>), FastSet<FileId>> = FastMap::default();
        let mut names: FastMap<FileId, Option<Arc<str>>> = FastMap::default();
        for finding in findings {
            let file = finding.span.file;
            let name = names
                .entry(file)
                .or_insert_with(|| paths.get(&file).and_then(|path| name(path)).map(Arc::from));
            if let Some(name) = name {
                let key = (kind(finding), name.clone());
                files.entry(key).or_default().insert(file);
            }
        }
        let series = files
            .into_iter()
            .filter(|(_, files)| files.len() >= Self::LEAST);
        let members = series.flat_map(|((kind, name), files)| {
            files
                .into_iter()
                .map(move |file| ((kind, file), name.clone()))
        });
        Self(members.collect())
    }

    /// The series in which many files have a finding of this kind.
    pub fn around(&self, finding: &Finding) -> Option<&str> {
        let key = (kind(finding), finding.span.file);
        self.0.get(&key).map(|name| &**name)
    }
}

fn kind(finding: &Finding) -> Kind {
    (finding.rule.code, finding.severity)
}

/// The path of a file whose name has a number, without the number.
fn name(path: &Path) -> Option<String> {
    let file = path.file_name()?.to_str()?;
    let parts: Vec<&str> = file
        .split(|c: char| c.is_ascii_digit())
        .filter(|part| !part.is_empty())
        .collect();
    let is_numbered = file.contains(|c: char| c.is_ascii_digit());
    let folder = path.parent()?.to_string_lossy();
    is_numbered.then(|| format!("{folder}/{}", parts.join("#")))
}
