//! Fixing files: from findings to edits, and on until nothing is left to do.
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::admission::{Admission, Admitted, changes, claim, files_of, groups};
use super::change::Change;
use super::check::{PreviousCheck, check_with};
use super::guard::harms;
use super::options::CheckOptions;
use super::plan::{Plan, choose};
use super::proof::{AffectedRobots, Changed, Claim, Effort};
use super::report::Report;
use super::session::Session;
use super::task_list::homes;
use super::walk::is_description;
use base::limits::{FIX_ROUNDS, PROOF_EXPANSIONS};
use base::{FastMap, FastSet, FileId};
use packages::is_built;
use rules::{Finding, Fix, Safety, Severity};

/// Which findings are fixed.
#[derive(Clone, Copy, Debug)]
pub struct FixOptions {
    /// The least safe fixes that are made.
    pub most: Safety,
    /// The least severity of findings that are fixed; those of rules that were selected by name are fixed in any case.
    pub shown: Severity,
}

/// Files as they would be without the findings that can be fixed. Nothing is written.
#[derive(Debug, Default)]
pub struct Fixed {
    /// What was found first.
    pub found: Report,
    /// What is left; none: nothing was fixed.
    left: Option<Report>,
    /// The files that change, by path.
    pub files: Vec<FixedFile>,
    /// How many findings were fixed.
    pub count: usize,
    /// How many fixes that should be safe were not made, since it could not be proved that they are.
    pub unproved: usize,
    /// How many findings could be fixed that are not shown.
    pub hidden: usize,
    /// How many fixes were taken back, since they would have caused new errors.
    pub taken_back: usize,
}

/// A file that changes.
#[derive(Clone, Debug)]
pub struct FixedFile {
    /// Its path, absolute.
    pub path: Arc<Path>,
    /// Its text.
    pub before: String,
    /// Its new text.
    pub after: String,
}

impl Fixed {
    /// What is left.
    pub fn left(&self) -> &Report {
        self.left.as_ref().unwrap_or(&self.found)
    }

    /// What is left, to keep.
    pub fn into_left(self) -> Report {
        self.left.unwrap_or(self.found)
    }

    /// How many errors are left that were hidden before.
    pub fn revealed(&self) -> usize {
        let Some(left) = &self.left else { return 0 };
        let known: FastSet<_> = self.found.errors().into_iter().collect();
        left.errors()
            .iter()
            .filter(|error| !known.contains(error))
            .count()
    }
}

/// Fix what can be fixed, in memory: the files of the session show the new texts from then on. Safe fixes are made
/// where it is proved that they are; a fix that would break the XML is left out, and so is one for files outside of the
/// workspace.
pub fn fix(session: &Session, options: &CheckOptions, how: FixOptions) -> Fixed {
    let _held = session.vfs.freeze();
    let mut done = PreviousCheck::default();
    let found = check_with(session, options, Some(&mut done));
    let mut work = FixRun::new(session, options, how);
    let mut left = None;
    for _ in 0..FIX_ROUNDS {
        let report = left.as_ref().unwrap_or(&found);
        let texts = work.files.clone();
        let made = work.round(report);
        if made.is_empty() {
            break;
        }
        forget_changed(session, &work.changed, &mut done);
        let mut after = check_with(session, options, Some(&mut done));
        let mut kept = made;
        if harms(report, &after, &kept) {
            let mut check = |changed: &[Changed]| {
                forget_changed(session, changed, &mut done);
                check_with(session, options, Some(&mut done))
            };
            (kept, after) = work.without_harm(report, &texts, &kept, &mut check);
        }
        if !kept.is_empty() {
            work.note(report, &kept);
        }
        left = Some(after);
    }
    let last = left.as_ref().unwrap_or(&found);
    let (unproved, hidden) = (work.unproved(last), work.hidden(last));
    let changed = work
        .files
        .into_values()
        .filter(|file| file.before != file.after);
    let mut changed: Vec<FixedFile> = changed.collect();
    changed.sort_by(|a, b| a.path.cmp(&b.path));
    let taken_back = work.taken_back;
    Fixed {
        found,
        left,
        count: work.count,
        files: changed,
        unproved,
        hidden,
        taken_back,
    }
}

/// Of the findings of a report with these numbers, the fixes that are proved to be safe, to be made together.
pub fn safe_fixes(session: &Session, report: &Report, numbers: &[usize], effort: &Effort) -> Plan {
    let safe = numbered(report, numbers).filter(|(_, finding)| is_said_safe(finding));
    let admission = Admission {
        session,
        report,
        most: Safety::Safe,
        effort,
    };
    let groups = groups(report, &choose(safe).settles);
    let mut proved: Vec<usize> = groups
        .iter()
        .flat_map(|group| admission.of(group).good)
        .collect();
    proved.sort_unstable();
    choose(numbered(report, &proved))
}

/// Forget what rests on files that changed. Who includes whom may decide about files that did not.
fn forget_changed(session: &Session, changed: &[Changed], done: &mut PreviousCheck) {
    let is_simple = |changed: &Changed| {
        let (old, new) = (&changed.old, &changed.new);
        is_description(&changed.path)
            && old.matches("include").count() == new.matches("include").count()
    };
    if changed.iter().all(is_simple) {
        let files: FastSet<&Path> = changed.iter().map(|changed| &*changed.path).collect();
        done.forget(|path| files.contains(path));
        return;
    }
    done.clear();
    session.packages.forget();
    session.forget_uses();
}

/// Whether a file belongs to what was installed for ROS.
pub fn is_installed(session: &Session, path: &Path) -> bool {
    let path = session.vfs.canonical(path);
    let installed = ["AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH"]
        .into_iter()
        .flat_map(|name| session.env.paths(name));
    let mut installed = installed
        .chain([PathBuf::from("/opt/ros")])
        .map(|prefix| session.vfs.canonical(&prefix));
    installed.any(|prefix| path.starts_with(prefix))
}

/// How many findings of a report can be fixed: by fixes that should be safe, and by those that are not.
pub fn fixable(
    session: &Session,
    options: &CheckOptions,
    report: &Report,
    shown: Severity,
) -> (usize, usize) {
    let work = FixRun::new(
        session,
        options,
        FixOptions {
            most: Safety::Unsafe,
            shown,
        },
    );
    let fixes = report
        .findings
        .iter()
        .filter(|finding| work.admits(finding));
    let (safe, others): (Vec<_>, Vec<_>) = fixes.partition(|finding| is_said_safe(finding));
    (safe.len(), others.len())
}

/// The findings of a report with these numbers, each with its number.
fn numbered<'f>(
    report: &'f Report,
    numbers: &[usize],
) -> impl Iterator<Item = (usize, &'f Finding)> {
    numbers
        .iter()
        .filter_map(|&number| Some((number, report.findings.get(number)?)))
}

/// Whether the rule takes the fix of a finding for safe: that remains to be proved.
pub fn is_said_safe(finding: &Finding) -> bool {
    finding
        .fix
        .as_ref()
        .is_some_and(|fix| fix.safety == Safety::Safe)
}

/// The state of a run.
struct FixRun<'a> {
    session: &'a Session,
    options: &'a CheckOptions,
    how: FixOptions,
    homes: Vec<PathBuf>,
    /// None: every file may be changed.
    change: Option<Change<'a>>,
    files: BTreeMap<FileId, FixedFile>,
    /// What the last round changed.
    changed: Vec<Changed>,
    /// Whether robots were repaired since the last time that every fix was tried.
    repaired: bool,
    /// Fixes that could not be proved, by [`key`], with the files they change: until one of these changes.
    refused: FastMap<u64, Vec<FileId>>,
    /// Fixes that led back to texts that were there before.
    circular: FastSet<u64>,
    /// By the texts that there were: how many findings were fixed then, and the fixes made since.
    seen: Vec<(u64, usize, Vec<u64>)>,
    count: usize,
    /// Fixes that were taken back.
    taken_back: usize,
    /// One number for each file, however many paths lead to it.
    first: RefCell<FastMap<u128, FileId>>,
    /// Whether files are the user's own, as far as known.
    own: RefCell<FastMap<FileId, bool>>,
}

impl<'a> FixRun<'a> {
    fn new(session: &'a Session, options: &'a CheckOptions, how: FixOptions) -> Self {
        let homes = homes(session, options)
            .iter()
            .map(|home| session.vfs.canonical(home))
            .collect();
        let change = Change::of(session, options);
        let (files, changed, repaired, refused, circular, count) = Default::default();
        let (first, own) = Default::default();
        let seen = vec![(state(&files), 0, Vec::new())];
        Self {
            session,
            options,
            how,
            homes,
            change,
            files,
            changed,
            repaired,
            refused,
            circular,
            seen,
            count,
            taken_back: 0,
            first,
            own,
        }
    }

    /// Apply fixes once: which ones.
    fn round(&mut self, report: &Report) -> Vec<usize> {
        let admitted = |(_, finding): &(usize, &Finding)| {
            self.admits(finding)
                && (is_said_safe(finding) || self.how.most == Safety::Unsafe)
                && !self.is_refused(report, finding)
        };
        let wanted = choose(report.findings.iter().enumerate().filter(admitted)).settles;
        let cancel = self.options.cancel.clone();
        let effort = Effort {
            expansions: PROOF_EXPANSIONS,
            roots: AffectedRobots::Searched(Arc::default()),
            cancel,
        };
        let admission = Admission {
            session: self.session,
            report,
            most: self.how.most,
            effort: &effort,
        };
        let mut made = Vec::new();
        self.changed.clear();
        for group in groups(report, &wanted) {
            let Admitted { good, refused } = admission.of(&group);
            let keys = refused
                .iter()
                .filter_map(|&n| Some((key(report, report.findings.get(n)?), files_of(report, n))));
            self.refused.extend(keys);
            // what is proved next rests on these texts
            self.show(report, &good);
            made.extend(good);
        }
        if !made.is_empty() {
            return made;
        }
        // robots that were repaired since may prove more
        let again = std::mem::take(&mut self.repaired) && !self.refused.is_empty();
        if again {
            self.refused.clear();
            return self.round(report);
        }
        Vec::new()
    }

    /// Of fixes that cause new errors together, make those that do not, beginning with the texts that were there before:
    /// halves are tried. The report then.
    fn without_harm(
        &mut self,
        report: &Report,
        texts: &BTreeMap<FileId, FixedFile>,
        made: &[usize],
        check: &mut dyn FnMut(&[Changed]) -> Report,
    ) -> (Vec<usize>, Report) {
        let mut good: Vec<usize> = Vec::new();
        let mut open = vec![made.to_vec()];
        while let Some(numbers) = open.pop() {
            let mut tried: Vec<usize> = good.iter().chain(&numbers).copied().collect();
            tried.sort_unstable();
            let after = self.tried(report, texts, &tried, check);
            if !harms(report, &after, &tried) {
                good = tried;
            } else if let [only] = numbers.as_slice() {
                self.circular.extend(
                    report
                        .findings
                        .get(*only)
                        .map(|finding| key(report, finding)),
                );
                self.taken_back += 1;
            } else {
                let (one, other) = numbers.split_at(numbers.len() / 2);
                open.extend([other.to_vec(), one.to_vec()]);
            }
        }
        let after = self.tried(report, texts, &good, check);
        (good, after)
    }

    /// The report with these fixes made and no others since there were those texts.
    fn tried(
        &mut self,
        report: &Report,
        texts: &BTreeMap<FileId, FixedFile>,
        numbers: &[usize],
        check: &mut dyn FnMut(&[Changed]) -> Report,
    ) -> Report {
        self.changed.clear();
        for (file, fixed) in std::mem::replace(&mut self.files, texts.clone()) {
            let old = texts.get(&file).map_or(&fixed.before, |old| &old.after);
            self.session.vfs.set_buffer(&fixed.path, Some(old.clone()));
            // both texts count as changed: what rests on the one says nothing of the other
            let (path, old, new) = (fixed.path, fixed.after, old.clone());
            self.changed.push(Changed {
                path,
                old,
                new,
                edits: Vec::new(),
            });
        }
        self.show(report, numbers);
        let changed = std::mem::take(&mut self.changed);
        check(&changed)
    }

    /// Show the texts with the fixes of these findings made.
    fn show(&mut self, report: &Report, good: &[usize]) {
        for changed in changes(report, good, &self.session.vfs) {
            let fixed = self.files.entry(changed.file).or_insert_with(|| FixedFile {
                path: changed.of.path.clone(),
                before: changed.of.old.clone(),
                after: String::new(),
            });
            fixed.after.clone_from(&changed.of.new);
            self.session
                .vfs
                .set_buffer(&changed.of.path, Some(changed.of.new.clone()));
            self.refused
                .retain(|_, files| !files.contains(&changed.file));
            self.changed.push(changed.of);
        }
    }

    /// Note which fixes were made. When they lead back to texts that were there before, they are not made again.
    fn note(&mut self, report: &Report, made: &[usize]) {
        let findings = made
            .iter()
            .filter_map(|&number| report.findings.get(number));
        self.repaired |= (findings.clone()).any(|finding| claim(finding) == Claim::Repaired);
        let keys = findings.map(|finding| key(report, finding));
        if let Some((_, _, since)) = self.seen.last_mut() {
            since.extend(keys);
        }
        self.count += made.len();
        let now = state(&self.files);
        match self.seen.iter().position(|(known, ..)| *known == now) {
            Some(back) => {
                let circle = self
                    .seen
                    .iter_mut()
                    .skip(back)
                    .flat_map(|(_, _, since)| std::mem::take(since));
                self.circular.extend(circle);
                self.seen.truncate(back + 1);
                self.count = self.seen.last().map_or(0, |(_, count, _)| *count);
            }
            None => self.seen.push((now, self.count, Vec::new())),
        }
    }

    /// How many findings are left that have fixes which should be safe.
    fn unproved(&self, report: &Report) -> usize {
        if self.how.most == Safety::Unsafe {
            return 0;
        }
        let said = report
            .findings
            .iter()
            .filter(|finding| is_said_safe(finding) && self.admits(finding));
        said.filter(|finding| self.is_refused(report, finding))
            .count()
    }

    /// How many findings could be fixed if they were shown.
    fn hidden(&self, report: &Report) -> usize {
        let is_meant =
            |finding: &&Finding| is_said_safe(finding) || self.how.most == Safety::Unsafe;
        let hidden = report
            .findings
            .iter()
            .filter(is_meant)
            .filter(|finding| !self.is_shown(finding));
        hidden.filter(|finding| self.may_fix(finding)).count()
    }

    fn is_refused(&self, report: &Report, finding: &Finding) -> bool {
        let key = key(report, finding);
        self.refused.contains_key(&key) || self.circular.contains(&key)
    }

    fn admits(&self, finding: &Finding) -> bool {
        self.is_shown(finding) && self.may_fix(finding)
    }

    fn is_shown(&self, finding: &Finding) -> bool {
        let path = self.session.vfs.path(finding.span.file);
        finding.severity >= self.how.shown || self.session.settings(&path).names(finding.rule)
    }

    /// Whether there is a fix, in files that may be changed.
    fn may_fix(&self, finding: &Finding) -> bool {
        let fix = finding.fix.as_ref().filter(|fix| !fix.edits.is_empty());
        fix.is_some_and(|fix| fix.edits.iter().all(|edit| self.is_own(edit.span.file)))
    }

    fn is_own(&self, file: FileId) -> bool {
        if let Some(&known) = self.own.borrow().get(&file) {
            return known;
        }
        let path = self.session.vfs.path(file);
        let is_meant = self.change.as_ref().is_none_or(|change| change.has(file));
        let is_text = self
            .session
            .vfs
            .text(&path)
            .is_ok_and(|text| text.encoding_error.is_none());
        let is_own =
            is_meant && is_text && self.is_first(&path, file) && self.lies_in_workspace(&path);
        self.own.borrow_mut().insert(file, is_own);
        is_own
    }

    /// Whether a file lies in the user's workspace, and was not made by a build tool or installed.
    fn lies_in_workspace(&self, path: &Path) -> bool {
        let path = self.session.vfs.canonical(path);
        if is_installed(self.session, &path) {
            return false;
        }
        let workspace = path
            .parent()
            .and_then(|folder| self.session.packages.workspace(folder));
        let below = workspace
            .as_ref()
            .and_then(|workspace| path.strip_prefix(workspace).ok());
        let built = below.is_some_and(|below| below.iter().any(is_built));
        !built && self.homes.iter().any(|home| path.starts_with(home))
    }

    /// Whether `file` is the number that stands for the file at `path` in this run.
    fn is_first(&self, path: &Path, file: FileId) -> bool {
        let Some(identity) = self.session.vfs.identity(path) else {
            return true;
        };
        *self.first.borrow_mut().entry(identity).or_insert(file) == file
    }
}

/// What tells a fix from others, wherever edits in front of it have moved it.
fn key(report: &Report, finding: &Finding) -> u64 {
    let mut hasher = DefaultHasher::new();
    (finding.rule.code, &finding.message, finding.span.file.0).hash(&mut hasher);
    for edit in finding.fix.iter().flat_map(|fix: &Fix| &fix.edits) {
        let old = report
            .source(edit.span.file)
            .map(|source| source.document.slice(edit.span.range));
        (edit.span.file.0, old, &edit.content).hash(&mut hasher);
    }
    hasher.finish()
}

/// What tells the texts of a run from others.
fn state(files: &BTreeMap<FileId, FixedFile>) -> u64 {
    let mut hasher = DefaultHasher::new();
    for (file, fixed) in files
        .iter()
        .filter(|(_, fixed)| fixed.before != fixed.after)
    {
        (file.0, &fixed.after).hash(&mut hasher);
    }
    hasher.finish()
}
