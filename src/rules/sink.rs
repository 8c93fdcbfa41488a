//! Where rules put what they find.
use std::hash::{Hash, Hasher};

use super::finding::{CallSite, Edit, Finding, Fix, Help, Related};
use super::grouping::Group;
use super::kept_finding::{Habit, KeptFinding, Wording};
use super::rule::{Rule, Safety, Severity};
use base::limits::FINDINGS_OF_A_RULE;
use base::{FastMap, FastSet, Span, TextRange};
use ecow::EcoString;
use expand::{
    Expansion, FileIdx, FileRange, Frame, FrameKind, Origin, blamed_argument, depends_on_parameter,
};

/// Collects findings of one expansion. A place that several expansions of one source text lead to is
/// reported once, with all the calls that lead there.
pub struct Sink<'a> {
    expansion: &'a Expansion,
    rule: &'static Rule,
    /// Whether what is reported is in a macro that nothing calls.
    probed: bool,
    stored: Vec<StoredFinding>,
    by_place: FastMap<(&'static str, Span), usize>,
    /// How often something was reported.
    reported: usize,
    /// How many there are of each rule.
    counts: FastMap<&'static str, usize>,
    /// What is reported, while somebody wants to keep it; none when a part of it cannot be kept.
    kept: Option<Vec<KeptFinding>>,
    /// The help of the last finding.
    help: Option<EcoString>,
    /// The documents so far, and how many findings of each rule have a habit in each of them.
    document: usize,
    habits: FastMap<(&'static str, usize), usize>,
}

/// A finding in the making. It is handed on at each step, and is large.
struct Draft {
    finding: Finding,
    /// The text that is wrong: in the body of a macro, in each call that leads there.
    instance: Option<Origin>,
    /// The same text in further calls.
    others: Vec<Origin>,
    habit: Option<Habit>,
}

/// What was reported at a place, by one or several expansions of its text.
struct StoredFinding {
    finding: Finding,
    /// Of the first of them: its habit, and the document.
    habit: Option<(Habit, usize)>,
    calls: RelatedCalls,
    instances: Vec<Origin>,
    call_sites: Vec<CallSite>,
    /// The calls of these, once there are several.
    called: FastSet<Span>,
}

/// Adds to a finding.
pub struct Reported<'s, 'a> {
    sink: &'s mut Sink<'a>,
    draft: Box<Draft>,
}

impl<'a> Sink<'a> {
    pub(super) fn new(expansion: &'a Expansion, rule: &'static Rule) -> Self {
        Self {
            expansion,
            rule,
            probed: false,
            stored: Vec::new(),
            by_place: FastMap::default(),
            reported: 0,
            counts: FastMap::default(),
            kept: None,
            help: None,
            document: 0,
            habits: FastMap::default(),
        }
    }

    /// From now on, findings are in macros that nothing calls, or in the document.
    pub(super) fn set_probed(&mut self, probed: bool) {
        self.probed = probed;
        self.document += 1;
    }

    /// From now on, findings are of this rule.
    pub(super) fn set_rule(&mut self, rule: &'static Rule) {
        self.rule = rule;
    }

    /// How often something was reported so far.
    pub(super) fn reported(&self) -> usize {
        self.reported
    }

    /// Keep what is reported from now on.
    pub(super) fn start_keeping(&mut self) {
        self.kept = Some(Vec::new());
    }

    /// What was reported since then; none when a part of it has further places or a fix, which another edit may move.
    pub(super) fn take_kept(&mut self) -> Option<Vec<KeptFinding>> {
        self.kept.take()
    }

    /// Report once more what was kept.
    pub(super) fn report_again(&mut self, kept: &KeptFinding) {
        let span = self.span_of(kept.origin).unwrap_or_else(|| self.nowhere());
        self.reported += 1;
        let key = (kept.rule.code, span);
        self.count(kept.rule, kept.habit);
        let known = self.by_place.get(&key);
        if let Some(stored) = known.and_then(|&place| self.stored.get_mut(place)) {
            stored.add(self.expansion, kept.origin, Some(&kept.said));
            return;
        }
        let finding = Finding {
            severity: kept.severity,
            message: kept.said.message.to_string(),
            help: kept.said.help.as_ref().map(EcoString::to_string),
            group: kept.group.clone(),
            ..Finding::new(kept.rule, span, String::new())
        };
        self.store(key, (finding, kept.habit), [kept.origin]);
    }

    /// The findings, with their calls behind the other related places.
    pub(super) fn finish(self) -> Vec<Finding> {
        let finish = |stored: StoredFinding| {
            let mut finding = stored.finding;
            let is_meant = stored.habit.is_some_and(|(habit, document)| {
                let like_it = self.habits.get(&(finding.rule.code, document));
                like_it.is_some_and(|count| *count >= habit.least)
            });
            if is_meant {
                finding.severity = Severity::Info;
            }
            finding.partial = depends_on_parameter(self.expansion, &stored.instances);
            finding.call_sites = stored.call_sites.into();
            stored.calls.list_in(&mut finding);
            finding
        };
        self.stored.into_iter().map(finish).collect()
    }

    /// Report a defect at `origin`; [`Reported::done`] completes it.
    pub fn report(&mut self, origin: Origin, message: impl Into<String>) -> Reported<'_, 'a> {
        let span = self.span_of(origin).unwrap_or_else(|| self.nowhere());
        let mut report = self.draft(span, message.into());
        report.draft.instance = Some(origin);
        report
    }

    /// What the call of the macro around `origin` passes, when the text there is a parameter and nothing else.
    pub fn argument(&self, origin: Origin) -> Option<Span> {
        self.span_of(blamed_argument(self.expansion, origin)?)
    }

    /// Report a defect at an absolute range of a file.
    pub fn report_in(
        &mut self,
        file: FileIdx,
        range: TextRange,
        message: impl Into<String>,
    ) -> Reported<'_, 'a> {
        let span = self.span(FileRange { file, range });
        self.draft(span.unwrap_or_else(|| self.nowhere()), message.into())
    }

    /// Report a defect in a file that need not belong to the expansion.
    pub fn report_span(&mut self, span: Span, message: impl Into<String>) -> Reported<'_, 'a> {
        self.draft(span, message.into())
    }

    fn draft(&mut self, span: Span, message: String) -> Reported<'_, 'a> {
        let finding = Finding {
            probed: self.probed,
            ..Finding::new(self.rule, span, message)
        };
        let draft = Box::new(Draft {
            finding,
            instance: None,
            others: Vec::new(),
            habit: None,
        });
        Reported { draft, sink: self }
    }

    fn push(&mut self, draft: Draft) {
        self.reported += 1;
        let Draft {
            finding,
            instance,
            others,
            habit,
        } = draft;
        self.count(finding.rule, habit);
        let key = (finding.rule.code, finding.span);
        let known = self.by_place.get(&key).copied();
        if known.is_some() || self.kept.is_some() {
            let said = self.said(&finding);
            if let Some(kept) = &mut self.kept {
                match KeptFinding::of((&finding, habit), &said, instance, &others) {
                    Some(one) => kept.push(one),
                    None => self.kept = None,
                }
            }
            if let Some(stored) = known.and_then(|place| self.stored.get_mut(place)) {
                for origin in instance.into_iter().chain(others) {
                    stored.add(self.expansion, origin, Some(&said));
                }
                return;
            }
        }
        let instances = instance.into_iter().chain(others);
        self.store(key, (finding, habit), instances);
    }

    /// What a finding says. Most findings of a rule have the same help.
    fn said(&mut self, finding: &Finding) -> Wording {
        if self.help.as_deref() != finding.help.as_deref() {
            self.help = finding.help.as_deref().map(EcoString::from);
        }
        Wording {
            message: finding.message.as_str().into(),
            help: self.help.clone(),
        }
    }

    /// Count a finding with a habit.
    fn count(&mut self, rule: &Rule, habit: Option<Habit>) {
        if habit.is_some() {
            *self.habits.entry((rule.code, self.document)).or_default() += 1;
        }
    }

    /// Store what is reported first of a place.
    fn store(
        &mut self,
        key: (&'static str, Span),
        (finding, habit): (Finding, Option<Habit>),
        instances: impl IntoIterator<Item = Origin>,
    ) {
        let count = self.counts.entry(key.0).or_default();
        *count += 1;
        if *count <= FINDINGS_OF_A_RULE {
            self.by_place.insert(key, self.stored.len());
            let habit = habit.map(|habit| (habit, self.document));
            let mut stored = StoredFinding::of(finding, habit);
            for origin in instances {
                stored.add(self.expansion, origin, None);
            }
            self.stored.push(stored);
        }
    }

    /// The start of the root file, for what has no place of its own.
    fn nowhere(&self) -> Span {
        let place = FileRange {
            file: FileIdx(0),
            range: TextRange::default(),
        };
        self.span(place).unwrap_or(Span {
            file: base::FileId(0),
            range: TextRange::default(),
        })
    }

    fn span(&self, place: FileRange) -> Option<Span> {
        span(self.expansion, place)
    }

    fn span_of(&self, origin: Origin) -> Option<Span> {
        span_of(self.expansion, origin)
    }
}

impl StoredFinding {
    fn of(finding: Finding, habit: Option<(Habit, usize)>) -> Self {
        Self {
            habit,
            finding,
            calls: RelatedCalls::default(),
            instances: Vec::new(),
            call_sites: Vec::new(),
            called: FastSet::default(),
        }
    }

    /// Add an instance of the text, of which something else may be said than of the first one.
    fn add(&mut self, expansion: &Expansion, origin: Origin, said: Option<&Wording>) {
        self.instances.push(origin);
        self.calls.add(expansion, frames(expansion, origin));
        if self.call_sites.len() >= MOST_CALL_SITES {
            return;
        }
        let innermost = frames(expansion, origin).next();
        let frame = innermost.filter(|frame| frame.kind == FrameKind::Macro);
        let call = frame.and_then(|frame| Some((frame, span_of(expansion, frame.call)?)));
        let Some((frame, call)) = call.filter(|&(_, call)| self.is_new(call)) else {
            return;
        };
        let own = || Wording {
            message: self.finding.message.as_str().into(),
            help: self.finding.help.as_deref().map(EcoString::from),
        };
        let Wording { message, help } = said.cloned().unwrap_or_else(own);
        self.call_sites.push(CallSite {
            call,
            name: frame.name.clone(),
            argument: blamed_argument(expansion, origin)
                .and_then(|argument| span_of(expansion, argument)),
            message,
            help,
        });
    }

    /// Whether no instance is in this call yet; now one is.
    fn is_new(&mut self, call: Span) -> bool {
        if self.call_sites.is_empty() {
            return true;
        }
        if self.called.is_empty() {
            self.called
                .extend(self.call_sites.iter().map(|site| site.call));
        }
        self.called.insert(call)
    }
}

impl Reported<'_, '_> {
    /// With a further place. When it is the very text that is reported, the calls that lead there are
    /// added instead.
    #[must_use]
    pub fn also(mut self, origin: Origin, message: impl Into<String>) -> Self {
        let Some(span) = self.sink.span_of(origin) else {
            return self;
        };
        if span == self.draft.finding.span {
            self.draft.others.push(origin);
        } else {
            let message = message.into();
            self.draft.finding.related.push(Related {
                span,
                message,
                is_call: false,
            });
        }
        self
    }

    /// With a further place of a file.
    #[must_use]
    pub fn also_at(mut self, place: FileRange, message: impl Into<String>) -> Self {
        let span = self
            .sink
            .span(place)
            .filter(|span| *span != self.draft.finding.span);
        self.draft.finding.related.extend(span.map(|span| Related {
            span,
            message: message.into(),
            is_call: false,
        }));
        self
    }

    /// With a further place, which may be in a file that does not belong to the expansion.
    #[must_use]
    pub fn also_span(mut self, span: Option<Span>, message: impl Into<String>) -> Self {
        let span = span.filter(|span| *span != self.draft.finding.span);
        let message = message.into();
        self.draft.finding.related.extend(span.map(|span| Related {
            span,
            message,
            is_call: false,
        }));
        self
    }

    /// With another severity than the rule's own.
    #[must_use]
    pub fn severity(mut self, severity: Severity) -> Self {
        self.draft.finding.severity = severity;
        self
    }

    /// As an info where so many findings of the rule in the document are of this kind.
    #[must_use]
    pub fn unless_habit(mut self, least: usize) -> Self {
        self.draft.habit = Some(Habit { least });
        self
    }

    /// With what it shares with other findings that are the same defect, instead of what the rule says.
    #[must_use]
    pub fn group(mut self, group: Group) -> Self {
        self.draft.finding.group = Some(group);
        self
    }

    /// With advice.
    #[must_use]
    pub fn help(mut self, help: impl Into<Help>) -> Self {
        let Help { text, similar } = help.into();
        (self.draft.finding.help, self.draft.finding.similar) = (Some(text), similar);
        self
    }

    /// With a fix: new texts for ranges of `file`.
    #[must_use]
    pub fn fix(
        mut self,
        safety: Safety,
        message: impl Into<String>,
        file: FileIdx,
        edits: impl IntoIterator<Item = (TextRange, String)>,
    ) -> Self {
        let edit = |(range, content)| {
            Some(Edit {
                span: self.sink.span(FileRange { file, range })?,
                content,
            })
        };
        let edits: Vec<Edit> = edits.into_iter().filter_map(edit).collect();
        self.draft.finding.fix = Some(Fix {
            safety,
            message: message.into(),
            edits,
        });
        self
    }

    /// With a fix of edits in any files.
    #[must_use]
    pub fn edits(mut self, safety: Safety, message: impl Into<String>, edits: Vec<Edit>) -> Self {
        self.draft.finding.fix = Some(Fix {
            safety,
            message: message.into(),
            edits,
        });
        self
    }

    /// With the reported text replaced.
    #[must_use]
    pub fn replace_with(
        mut self,
        safety: Safety,
        message: impl Into<String>,
        content: impl Into<String>,
    ) -> Self {
        let edits = vec![Edit {
            span: self.draft.finding.span,
            content: content.into(),
        }];
        self.draft.finding.fix = Some(Fix {
            safety,
            message: message.into(),
            edits,
        });
        self
    }

    /// The finding is complete.
    pub fn done(self) {
        self.sink.push(*self.draft);
    }
}

/// A place of an expansion in terms that hold beyond it.
pub(super) fn span(expansion: &Expansion, place: FileRange) -> Option<Span> {
    let file = expansion.files.get(place.file)?;
    Some(Span {
        file: file.source.id,
        range: place.range,
    })
}

/// The place of a text of an expansion.
pub fn span_of(expansion: &Expansion, origin: Origin) -> Option<Span> {
    span(expansion, expansion.place(origin)?)
}

/// The steps that led to `origin`, innermost first, but for includes.
fn frames(expansion: &Expansion, origin: Origin) -> impl Iterator<Item = &Frame> {
    let frames = expansion.frames_of(origin);
    frames.filter(|frame| frame.kind != FrameKind::Include)
}

/// The macro calls and inserted blocks that led to `origin`, innermost first.
pub fn calls(expansion: &Expansion, origin: Origin) -> Vec<Related> {
    let related = |frame: &Frame| Some(related(frame, span_of(expansion, frame.call)?));
    frames(expansion, origin).filter_map(related).collect()
}

fn related(frame: &Frame, span: Span) -> Related {
    Related {
        span,
        message: call_message(frame),
        is_call: true,
    }
}

fn call_message(frame: &Frame) -> String {
    match frame.kind {
        FrameKind::Macro => format!("in this call of macro `{}`", frame.name),
        FrameKind::Block => format!("in block `{}` inserted here", frame.name),
        FrameKind::Include | FrameKind::Root => "included here".to_owned(),
    }
}

/// Calls listed with a finding.
const MOST_CALLS: usize = 10;
/// Calls that an editor may show a finding at.
const MOST_CALL_SITES: usize = 1000;

/// Different calls that lead to a place: the first ones, and all of them counted.
#[derive(Default)]
struct RelatedCalls {
    first: Vec<Related>,
    /// What tells them from each other; there may be as many as a robot has elements.
    seen: FastSet<u64>,
}

impl RelatedCalls {
    /// Add those that are not among them yet.
    fn add<'f>(&mut self, expansion: &Expansion, frames: impl Iterator<Item = &'f Frame>) {
        for frame in frames {
            if expansion.place(frame.call).is_none() {
                continue;
            }
            // a text has one place in an expansion, and a tag one name
            let call = (frame.call.src, frame.call.range, frame.kind as u8);
            let mut hasher = rustc_hash::FxHasher::default();
            call.hash(&mut hasher);
            let span = || span_of(expansion, frame.call);
            if self.seen.insert(hasher.finish())
                && self.first.len() < MOST_CALLS
                && let Some(span) = span()
            {
                self.first.push(related(frame, span));
            }
        }
    }

    fn list_in(self, finding: &mut Finding) {
        list_calls(finding, self.first, self.seen.len());
    }
}

/// Put calls behind the related places; of many, the first ones, and the message counts the others.
pub(super) fn limit_calls(finding: &mut Finding, calls: Vec<Related>) {
    let count = calls.len();
    list_calls(finding, calls, count);
}

fn list_calls(finding: &mut Finding, mut first: Vec<Related>, count: usize) {
    first.truncate(MOST_CALLS);
    let more = count.saturating_sub(first.len());
    finding.related.append(&mut first);
    if more > 0 {
        finding
            .message
            .push_str(&format!(" (and {more} more calls)"));
    }
}
