//! A first look at an edit, for robots that take long to check: what the last check said is carried along with the
//! text, and only the items that were touched are looked at again. The whole check follows when there is time.

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use super::analyzed::Analyzed;
use super::context::RootChoice;
use super::edits::Edits;
use super::job::{self, Outcome};
use super::report::Report;
use super::roots::{Job, Reason};
use super::world::World;
use base::{CancelFlag, Span, TextRange};
use expand::Focus;
use facts::Definitions;
use rules::{Category, Finding, LEFT_TO_DO, Suppressions, check_part};
use vfs::SourceFile;
use xml::{Document, NodeKind};

/// What the last check said of an open file, and what was edited since.
pub(super) struct Settled {
    root: RootChoice,
    source: Arc<SourceFile>,
    findings: Vec<Finding>,
    /// Where the file defines names; of large robots.
    definitions: Definitions,
    /// Whether some comment says what the linter is to hide.
    has_suppressions: bool,
    edits: Edits,
    /// All edits were in comments that mean nothing to anybody but people.
    only_comments: bool,
}

/// What can be said at once of an edit.
pub struct FirstLook {
    /// Findings in the edited file.
    pub findings: Vec<Finding>,
    /// Whether that is all there is to say, in all files.
    pub is_complete: bool,
}

impl Settled {
    /// Bytes of the file, which was `before` until now, are replaced.
    pub fn note_edit(&mut self, before: Option<&SourceFile>, range: TextRange, text: &str) {
        self.edits.note(range, text.len() as u32);
        self.only_comments &= before.is_some_and(|source| is_idle_talk(&source.document, range, text));
    }

    /// All findings where they stand now; one whose place was edited is dropped.
    fn all_carried(&self) -> Vec<Finding> {
        self.findings.iter().filter_map(|finding| self.carried(finding)).collect()
    }

    fn moved_span(&self, span: Span) -> Option<Span> {
        if span.file != self.source.id {
            return Some(span);
        }
        Some(Span { range: self.edits.moved(span.range)?, ..span })
    }

    /// A finding where it stands now; none when its place was edited.
    fn carried(&self, finding: &Finding) -> Option<Finding> {
        let mut finding = Finding { span: self.moved_span(finding.span)?, ..finding.clone() };
        finding.related.retain_mut(|related| {
            let moved = self.moved_span(related.span);
            related.span = moved.unwrap_or(related.span);
            moved.is_some()
        });
        let edits = finding.fix.iter_mut().flat_map(|fix| &mut fix.edits);
        let moved = edits.map(|edit| self.moved_span(edit.span).map(|span| edit.span = span));
        // a fix is whole or it is none
        if moved.collect::<Vec<_>>().contains(&None) {
            finding.fix = None;
        }
        Some(finding)
    }
}

/// Most items that a first look is worth, and most bytes of them.
const MOST_ITEMS: usize = 8;
const MOST_BYTES: u32 = 64 << 10;

impl World {
    /// Robots with fewer nodes are checked in no time, and need no first look.
    const LARGE: usize = 300;

    /// Remember what a check said of a file.
    pub(super) fn settle(&mut self, path: &Path, root: RootChoice, report: &Report) {
        let Some(source) = self.document(path) else { return };
        let own = report.findings.iter().filter(|finding| finding.span.file == source.id);
        let findings = own.cloned().collect();
        let is_large = self.last(&root).is_some_and(|last| last.expansion.tree.len() >= Self::LARGE);
        let definitions = if is_large { Definitions::of(&source.document) } else { Definitions::default() };
        let has_suppressions = !Suppressions::of(&source.document).list.is_empty();
        let (edits, only_comments) = (Edits::default(), true);
        let settled = Settled { root, source, findings, definitions, has_suppressions, edits, only_comments };
        self.settled.insert(path.to_path_buf(), settled);
    }

    /// What can be said at once of an open file that was edited since its last check; none when the robot is
    /// small, when the edit is too large, or when it was cancelled.
    pub fn first_look(&self, path: &Path, cancel: &CancelFlag) -> Option<FirstLook> {
        let settled = self.settled.get(path).filter(|settled| !settled.edits.is_empty())?;
        let is_sound = |source: &SourceFile| source.document.errors().is_empty();
        if settled.only_comments && is_sound(&settled.source) && is_sound(&*self.document(path)?) {
            return Some(FirstLook { findings: settled.all_carried(), is_complete: true });
        }
        let last = self.last(&settled.root).filter(|last| last.expansion.tree.len() >= Self::LARGE)?;
        let source = self.document(path)?;
        let items = source.document.items_not_in(&settled.source.document)?;
        if items.len() > MOST_ITEMS || stretch(&source.document, &items).len() > MOST_BYTES {
            return None;
        }
        let mut findings = self.look_at(settled, last, path, &items, cancel)?;
        // of a file that is not well-formed, only that is said
        let carried = if is_sound(&source) { settled.all_carried() } else { Vec::new() };
        for carried in carried {
            let same = |new: &Finding| new.rule.code == carried.rule.code && new.span == carried.span;
            if !findings.iter().any(same) {
                findings.push(carried);
            }
        }
        findings.sort_by_key(|finding| (finding.span.range.start, finding.rule.code));
        Some(FirstLook { findings, is_complete: false })
    }

    /// The last expansion of the robot of an open file, when the robot is large and nothing but this file was edited
    /// since: what it says of other places still holds, as far as that rests on nothing edited.
    pub fn before_typing(&mut self, path: &Path) -> Option<Arc<Analyzed>> {
        let settled = self.settled.get(path).filter(|settled| !settled.edits.is_empty())?;
        let last = self.last(&settled.root).filter(|last| last.expansion.tree.len() >= Self::LARGE)?.clone();
        let is_sound = self.document(path)?.document.errors().is_empty();
        let is_news = is_sound && !self.is_valid(&last) && self.is_valid_beside(&last, path);
        (is_news && self.context(path).root.as_ref() == Some(&last.root)).then_some(last)
    }

    /// Expand and check some items of a file.
    fn look_at(
        &self,
        settled: &Settled,
        last: &Analyzed,
        path: &Path,
        items: &Range<usize>,
        cancel: &CancelFlag,
    ) -> Option<Vec<Finding>> {
        let session = self.session();
        let RootChoice { file, args, preset } = settled.root.clone();
        let job = Job { file, reason: Reason::Named, args, preset };
        let edited = self.document(path)?;
        let needed = settled.definitions.needed(&edited.document, items.clone());
        let focus = Focus { path: path.to_path_buf(), items: items.clone(), needed };
        let expansion = job::part(session, cancel, &job, focus);
        if cancel.is_cancelled() {
            return None;
        }
        let source = &expansion.files.iter().find(|file| *file.source.path == *path)?.source;
        let settings = session.settings(&job.file);
        let mut findings = check_part(&expansion, session.surroundings(&settings.config));
        let stretch = stretch(&source.document, items);
        findings.retain(|finding| {
            let here = finding.span.file == source.id && stretch.contains_range(finding.span.range);
            here && !is_known_elsewhere(finding, source, last)
                || finding.rule.code == "XML001" && finding.span.file == source.id
        });
        // comments for the linter are looked for in the whole file
        let may_hide =
            settled.has_suppressions || source.document.slice(stretch).contains(Suppressions::MARK);
        let files = if may_hide { vec![source.clone()] } else { Vec::new() };
        let is_robot = last.is_robot();
        let outcome = Outcome {
            job,
            is_robot,
            is_context: false,
            complete: false,
            reads: Vec::new(),
            files,
            findings,
            has_arguments: false,
            includes: Vec::new(),
            called: base::FastSet::default(),
        };
        let report = session.conclude(&self.options(&[path.to_path_buf()]), vec![outcome]);
        let own =
            |finding: &Finding| finding.span.file == source.id && finding.rule.category != Category::Linter;
        Some(report.findings.into_iter().filter(own).collect())
    }
}

/// The bytes of some items.
fn stretch(document: &Document, items: &Range<usize>) -> TextRange {
    let start = document.item(items.start).map_or(document.footer_start(), |(base, _)| base);
    let end = document.item(items.end).map_or(document.footer_start(), |(base, _)| base);
    TextRange::new(start, end)
}

/// Whether a name that is missing here is defined by something that was not looked at.
fn is_known_elsewhere(finding: &Finding, source: &SourceFile, last: &Analyzed) -> bool {
    const MISSING: [&str; 4] = ["XAC001", "XAC002", "XAC003", "XAC004"];
    if !MISSING.contains(&finding.rule.code) {
        return false;
    }
    let text = source.document.slice(finding.span.range);
    let name = text.trim_start_matches('<').trim_start_matches("xacro:");
    last.expansion.symbols.definitions.iter().any(|definition| definition.name == name)
}

/// Whether an edit changes nothing but words in a comment: not where lines begin, and no word that a tool looks for.
fn is_idle_talk(document: &Document, range: TextRange, text: &str) -> bool {
    const MEANT_FOR_TOOLS: [&str; 2] = ["xacro", "$"];
    let place = document.item_at(range.start);
    let Some(start) = range.start.checked_sub(place.start) else { return false };
    let inner = TextRange::new(start, start + range.len());
    let mut nodes = place.item.all_nodes().filter(|node| node.kind() == NodeKind::Comment);
    let Some(comment) = nodes.find(|node| node.raw_range().contains_range(inner)) else { return false };
    let cut = |from: u32, to: u32| TextRange::new(from, to).slice(place.item.text());
    let whole = comment.raw_range();
    let after = [cut(whole.start, inner.start), text, cut(inner.end, whole.end)].concat();
    let is_plain = |text: &str| !MEANT_FOR_TOOLS.iter().chain(&LEFT_TO_DO).any(|word| text.contains(word));
    let keeps_shape = |text: &str| !text.contains(['\n', '\r', '>']);
    is_plain(comment.raw())
        && is_plain(&after)
        && keeps_shape(text)
        && keeps_shape(cut(inner.start, inner.end))
}
