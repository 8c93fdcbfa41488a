//! Hiding findings as comments in the files ask for, and finding the comments that hide nothing.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use super::check::CheckOptions;
use super::job::Outcome;
use super::roots::Reason;
use super::session::Session;
use crate::base::{FastSet, FileId};
use crate::rules::{
    Check, Directive, Finding, Rule, Selector, Suppression, Suppressions, all, by_code, unused_suppression,
};
use crate::vfs::SourceFile;

/// A comment: file, number in the file, number of the rule it names.
type Used = (FileId, usize, usize);

/// The suppressions of all files of a run.
pub(super) struct Hiding<'a> {
    session: &'a Session,
    files: BTreeMap<FileId, (Arc<SourceFile>, Suppressions)>,
    /// Files about which all rules had their say.
    judged: FastSet<FileId>,
    used: FastSet<Used>,
}

impl<'a> Hiding<'a> {
    /// Those of the files that `outcomes` read.
    pub(super) fn new(session: &'a Session, options: &CheckOptions, outcomes: &[Outcome]) -> Self {
        let mut files = BTreeMap::new();
        for file in outcomes.iter().flat_map(|outcome| &outcome.files) {
            files.entry(file.id).or_insert_with(|| (file.clone(), Suppressions::of(&file.document)));
        }
        files.retain(|_, (_, found)| !found.list.is_empty());
        let judged = judged(session, options, outcomes);
        Self { session, files, judged, used: FastSet::default() }
    }

    /// Whether a comment hides a finding, where it stands or at a call that leads there.
    pub(super) fn hides(&mut self, finding: &Finding) -> bool {
        let calls = finding.related.iter().filter(|related| related.is_call).map(|related| related.span);
        let mut hidden = false;
        for span in std::iter::once(finding.span).chain(calls) {
            let Some((_, found)) = self.files.get(&span.file) else { continue };
            let Some(number) = found.hiding(finding.rule, span.range.start) else { continue };
            hidden = true;
            let rules = found.list.get(number).into_iter().flat_map(|suppression| &suppression.rules);
            let named = rules.enumerate().filter(|(_, selector)| selector.names(finding.rule));
            self.used.extend(named.map(|(i, _)| (span.file, number, i)));
        }
        hidden
    }

    /// The comments that hid nothing, when all findings were shown.
    pub(super) fn finish(mut self) -> Vec<Finding> {
        let Some(own) = by_code("LNT001") else { return Vec::new() };
        // comments about this very rule come last: they may hide what is said about the others
        let mut findings = self.unused(|selector| !selector.names(own));
        findings.retain(|finding| !self.hides(finding));
        findings.extend(self.unused(|selector| selector.names(own)));
        findings
    }

    fn unused(&self, wanted: impl Fn(&Selector) -> bool) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (&file, (source, found)) in &self.files {
            for (number, suppression) in found.list.iter().enumerate() {
                let is_unused = |i: usize, selector: &Selector| match suppression.directive {
                    Directive::Enable => self.ends_nothing(source, suppression, selector, found),
                    _ => !self.used.contains(&(file, number, i)) && self.is_judged(source, selector),
                };
                let rules = suppression.rules.iter().enumerate();
                let unused: Vec<&Selector> = rules
                    .filter(|(i, selector)| wanted(selector) && is_unused(*i, selector))
                    .map(|(_, selector)| selector)
                    .collect();
                if !unused.is_empty() {
                    findings.push(unused_suppression(file, &source.document, suppression, &unused));
                }
            }
        }
        findings
    }

    /// Whether the rules that a selector means had their say about a file. A rule that does not run hides
    /// nothing, and that is no news.
    fn is_judged(&self, source: &SourceFile, selector: &Selector) -> bool {
        let mut running = self.running(source, selector).peekable();
        let whole = self.judged.contains(&source.id);
        running.peek().is_some() && running.all(|rule| whole || matches!(rule.check, Check::File(_)))
    }

    fn running(&self, source: &SourceFile, selector: &Selector) -> impl Iterator<Item = &'static Rule> {
        let settings = self.session.settings(&source.path);
        all().filter(move |rule| selector.names(rule) && settings.runs(rule, &source.path))
    }

    fn ends_nothing(
        &self,
        source: &SourceFile,
        suppression: &Suppression,
        selector: &Selector,
        found: &Suppressions,
    ) -> bool {
        let runs = self.running(source, selector).next().is_some();
        runs && !found.ended_by(selector, suppression.comment.start)
    }
}

/// The files about which all rules had their say: those of robots that could be expanded as a whole. What is
/// only included may serve robots outside of this run as well, unless whole folders are checked; and one preset
/// of several, as in an editor, says nothing about the others.
fn judged(session: &Session, options: &CheckOptions, outcomes: &[Outcome]) -> FastSet<FileId> {
    let absolute = options.paths.iter().map(|path| session.vfs.absolute(path));
    let folders: Vec<PathBuf> = absolute.filter(|path| session.vfs.is_dir(path)).collect();
    let mut judged = FastSet::default();
    for outcome in outcomes.iter().filter(|outcome| outcome.is_robot && outcome.complete) {
        let alone = outcome.job.reason == Reason::Named;
        if alone && outcome.job.preset.is_some() {
            continue;
        }
        let known = outcome.files.iter().enumerate().filter(|(number, file)| {
            *number == 0 || !alone && folders.iter().any(|folder| file.path.starts_with(folder))
        });
        judged.extend(known.map(|(_, file)| file.id));
    }
    judged
}
