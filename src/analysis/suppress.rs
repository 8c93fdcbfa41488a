//! SuppressionFilter findings as comments in the files ask for, and finding the comments that hide nothing.
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use super::check_task::CheckReason;
use super::options::CheckOptions;
use super::proof::enclosing;
use super::root_result::RootResult;
use super::session::Session;
use base::{FastSet, FileId, Span, TextRange};
use rules::{
    Check, Directive, Finding, Rule, Safety, Selector, Suppression, Suppressions, all, named,
    unused_suppression,
};
use vfs::SourceFile;

/// A comment: file, number in the file, number of the rule it names.
type UsedSuppression = (FileId, usize, usize);

/// The suppressions of all files of a run.
pub(super) struct SuppressionFilter<'a> {
    session: &'a Session,
    files: BTreeMap<FileId, (Arc<SourceFile>, Suppressions)>,
    /// Files that all rules have checked.
    judged: FastSet<FileId>,
    used: FastSet<UsedSuppression>,
    /// Where the macros are defined that were called.
    called: FastSet<Span>,
    /// Files of robots that have arguments: with others, more may be hidden.
    variable: FastSet<FileId>,
}

impl<'a> SuppressionFilter<'a> {
    /// Those of the files that `results` read.
    pub(super) fn new(
        session: &'a Session,
        options: &CheckOptions,
        results: &[RootResult],
    ) -> Self {
        let mut files = BTreeMap::new();
        for file in results.iter().flat_map(|result| &result.files) {
            files
                .entry(file.id)
                .or_insert_with(|| (file.clone(), Suppressions::of(&file.document)));
        }
        files.retain(|_, (_, found)| !found.list.is_empty());
        let judged = judged(session, options, results);
        let called = results
            .iter()
            .flat_map(|result| result.called.iter().copied())
            .collect();
        let variable = results.iter().filter(|result| !result.arguments.is_empty());
        let variable = variable
            .flat_map(|result| result.files.iter().map(|file| file.id))
            .collect();
        Self {
            session,
            files,
            judged,
            used: FastSet::default(),
            called,
            variable,
        }
    }

    /// Whether a comment hides a finding, where it stands or at a call or include that leads there. The includes are those
    /// of the robot that the finding is of: files with the tags that include them.
    pub(super) fn hides(&mut self, finding: &Finding, includes: &[(FileId, Span)]) -> bool {
        if self.files.is_empty() {
            return false;
        }
        let calls = finding
            .related
            .iter()
            .filter(|related| related.is_call)
            .map(|related| related.span);
        let mut hidden = false;
        let tags = including(finding.span.file, includes);
        for span in std::iter::once(finding.span).chain(calls).chain(tags) {
            let Some((_, found)) = self.files.get(&span.file) else {
                continue;
            };
            let Some(number) = found.hiding(finding.rule, span.range.start) else {
                continue;
            };
            hidden = true;
            let rules = found
                .list
                .get(number)
                .into_iter()
                .flat_map(|suppression| &suppression.rules);
            let named = rules
                .enumerate()
                .filter(|(_, selector)| selector.names(finding.rule));
            self.used.extend(named.map(|(i, _)| (span.file, number, i)));
        }
        hidden
    }

    /// The comments that hid nothing, when all findings were shown.
    pub(super) fn finish(mut self) -> Vec<Finding> {
        let own = named::UNUSED_SUPPRESSION;
        // comments about this very rule come last: they may hide what is said about the others
        let mut findings = self.unused(|selector| !selector.names(own));
        findings.retain(|finding| !self.hides(finding, &[]));
        findings.extend(self.unused(|selector| selector.names(own)));
        findings
    }

    fn unused(&self, wanted: impl Fn(&Selector) -> bool) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (&file, (source, found)) in &self.files {
            for (number, suppression) in found.list.iter().enumerate() {
                if !self.was_evaluated(source, suppression) {
                    continue;
                }
                let is_unused = |(i, selector): &(usize, &Selector)| match suppression.directive {
                    Directive::Enable => self.ends_nothing(source, suppression, selector, found),
                    _ => {
                        !self.used.contains(&(file, number, *i)) && self.is_judged(source, selector)
                    }
                };
                let rules = suppression.rules.iter().enumerate();
                let unused: Vec<&Selector> = rules
                    .filter(|(_, selector)| wanted(selector))
                    .filter(is_unused)
                    .map(|(_, selector)| selector)
                    .collect();
                if !unused.is_empty() {
                    let safety = if self.is_fixed(source) {
                        Safety::Safe
                    } else {
                        Safety::Unsafe
                    };
                    findings.push(unused_suppression(source, suppression, &unused, safety));
                }
            }
        }
        findings
    }

    /// Whether the text that a comment is about was evaluated whatever the arguments: it stands in no condition, and in no
    /// macro that nobody calls.
    fn was_evaluated(&self, source: &SourceFile, suppression: &Suppression) -> bool {
        let document = &source.document;
        let behind = document.slice(TextRange::new(suppression.comment.end, document.len()));
        let next = behind.find('<').map_or(0, |at| at as u32 + 1);
        [suppression.comment.start, suppression.comment.end + next]
            .into_iter()
            .all(|at| {
                let at = TextRange::empty(at);
                enclosing(document, at, &["xacro:if", "xacro:unless"]).is_empty()
                    && enclosing(document, at, &["xacro:macro"])
                        .into_iter()
                        .all(|place| self.is_called(source.id, place))
            })
    }

    /// Whether all of a file was evaluated, whatever the arguments.
    fn is_fixed(&self, source: &SourceFile) -> bool {
        let elements = source
            .document
            .parts()
            .flat_map(|(base, item)| item.all_nodes().map(move |node| (base, node)));
        let mut open = elements.filter(|(base, node)| match node.name() {
            "xacro:if" | "xacro:unless" => true,
            "xacro:macro" => !self.is_called(source.id, node.range().shift(*base)),
            _ => false,
        });
        !self.variable.contains(&source.id) && open.next().is_none()
    }

    fn is_called(&self, file: FileId, place: TextRange) -> bool {
        self.called
            .iter()
            .any(|span| span.file == file && place.contains_range(span.range))
    }

    /// Whether the rules that a selector means have checked a file. A suppression of a rule that does not run hides
    /// nothing, and that is not reported.
    fn is_judged(&self, source: &SourceFile, selector: &Selector) -> bool {
        let mut running = self.running(source, selector).peekable();
        let whole = self.judged.contains(&source.id);
        running.peek().is_some()
            && running.all(|rule| whole || matches!(rule.check, Check::File(_)))
    }

    fn running(
        &self,
        source: &SourceFile,
        selector: &Selector,
    ) -> impl Iterator<Item = &'static Rule> {
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

/// The tags through which a file was included, directly and by others.
fn including(file: FileId, includes: &[(FileId, Span)]) -> Vec<Span> {
    let mut found: Vec<Span> = Vec::new();
    let mut open = vec![file];
    while let Some(file) = open.pop() {
        for (_, tag) in includes.iter().filter(|(target, _)| *target == file) {
            if !found.contains(tag) {
                found.push(*tag);
                open.push(tag.file);
            }
        }
    }
    found
}

/// The files about which all rules had their say: those of robots that could be expanded as a whole. What is
/// only included may serve robots outside of this run as well, unless whole folders are checked; and one preset
/// of several, as in an editor, says nothing about the others.
fn judged(session: &Session, options: &CheckOptions, results: &[RootResult]) -> FastSet<FileId> {
    let absolute = options.paths.iter().map(|path| session.vfs.absolute(path));
    let folders: Vec<PathBuf> = absolute.filter(|path| session.vfs.is_dir(path)).collect();
    let mut judged = FastSet::default();
    for result in results
        .iter()
        .filter(|result| result.is_robot && result.complete)
    {
        let alone = matches!(result.task.reason, CheckReason::Named | CheckReason::Alone);
        if alone && result.task.preset.is_some() {
            continue;
        }
        let known = result.files.iter().enumerate().filter(|(number, file)| {
            *number == 0 || !alone && folders.iter().any(|folder| file.path.starts_with(folder))
        });
        judged.extend(known.map(|(_, file)| file.id));
    }
    judged
}
