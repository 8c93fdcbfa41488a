//! Fixing files: from findings to edits, and on until nothing is left to do.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::change::Change;
use super::check::CheckOptions;
use super::report::Report;
use super::session::Session;
use crate::base::limits::FIX_ROUNDS;
use crate::base::{FastMap, FastSet, FileId, TextRange};
use crate::rules::{Edit, Finding, Fix, Safety};
use crate::workspace::is_built;
use crate::xml::Document;

/// Edits that can be made together.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// By file: replacements in order, which neither overlap nor touch.
    pub edits: BTreeMap<FileId, Vec<(TextRange, String)>>,
    /// Numbers of the findings that they settle.
    pub settles: Vec<usize>,
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
}

/// The fixes that can be made together: each with all its edits or not at all, the first of those that get
/// in each other's way. The same edit wanted by several findings is made once.
pub fn choose(findings: &[Finding], admits: impl Fn(&Fix) -> bool) -> Plan {
    let mut plan = Plan::default();
    for (number, finding) in findings.iter().enumerate() {
        let Some(fix) = finding.fix.as_ref().filter(|fix| !fix.edits.is_empty() && admits(fix)) else {
            continue;
        };
        let is_old = |edit: &&Edit| plan.has(edit);
        let new: Vec<&Edit> = fix.edits.iter().filter(|edit| !is_old(edit)).collect();
        let among = new.iter().enumerate().any(|(i, edit)| new.iter().skip(i + 1).any(|o| touch(edit, o)));
        if among || new.iter().any(|edit| plan.is_in_the_way(edit)) {
            continue;
        }
        for edit in new {
            let edits = plan.edits.entry(edit.span.file).or_default();
            let at = edits.partition_point(|(range, _)| range.start < edit.span.range.start);
            edits.insert(at, (edit.span.range, edit.content.clone()));
        }
        plan.settles.push(number);
    }
    plan
}

impl Plan {
    fn has(&self, edit: &Edit) -> bool {
        let edits = self.edits.get(&edit.span.file);
        edits.is_some_and(|edits| edits.iter().any(|(r, c)| *r == edit.span.range && *c == edit.content))
    }

    fn is_in_the_way(&self, edit: &Edit) -> bool {
        let Some(edits) = self.edits.get(&edit.span.file) else { return false };
        edits.iter().any(|(range, _)| touches(*range, edit.span.range))
    }
}

fn touch(a: &Edit, b: &Edit) -> bool {
    a.span.file == b.span.file && touches(a.span.range, b.span.range)
}

/// Edits that touch wait for the next round, when what stands there is known.
fn touches(a: TextRange, b: TextRange) -> bool {
    a.start <= b.end && b.start <= a.end
}

/// A text with replacements made; they are in order and do not overlap. Everything else stays as it is.
pub fn apply(text: &str, edits: &[(TextRange, String)]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for (range, content) in edits {
        out.push_str(TextRange::new(at, range.start).slice(text));
        out.push_str(content);
        at = range.end;
    }
    out.push_str(TextRange::new(at, text.len() as u32).slice(text));
    out
}

impl Session {
    /// Fix what can be fixed by fixes that are at most as unsafe as `most`, in memory: the files of this
    /// session show the new texts from then on. A fix that would break the XML is left out, and so is one
    /// for files outside of the workspace.
    pub fn fix(&self, options: &CheckOptions, most: Safety) -> Fixed {
        let _held = self.vfs.hold();
        let found = self.check(options);
        let mut work = Work::new(self, options, most);
        let mut left = None;
        for _ in 0..FIX_ROUNDS {
            let report = left.as_ref().unwrap_or(&found);
            if !work.round(report) {
                break;
            }
            self.packages.forget();
            self.forget_uses();
            left = Some(self.check(options));
        }
        Fixed { found, left, count: work.count, files: work.files.into_values().collect() }
    }

    /// Whether a file belongs to what was installed for ROS.
    pub fn is_installed(&self, path: &Path) -> bool {
        let path = self.vfs.canonical(path);
        let installed =
            ["AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH"].into_iter().flat_map(|name| self.env.paths(name));
        let mut installed =
            installed.chain([PathBuf::from("/opt/ros")]).map(|prefix| self.vfs.canonical(&prefix));
        installed.any(|prefix| path.starts_with(prefix))
    }

    /// How many findings of a report can be fixed: by safe fixes, and by those that are not.
    pub fn fixable(&self, options: &CheckOptions, report: &Report) -> (usize, usize) {
        let work = Work::new(self, options, Safety::Unsafe);
        let fixes = report.findings.iter().filter_map(|finding| finding.fix.as_ref());
        let fixes: Vec<&Fix> = fixes.filter(|fix| !fix.edits.is_empty() && work.admits(fix)).collect();
        let safe = fixes.iter().filter(|fix| fix.safety == Safety::Safe).count();
        (safe, fixes.len() - safe)
    }
}

/// The state of a run.
struct Work<'a> {
    session: &'a Session,
    homes: Vec<PathBuf>,
    /// None: every file may be changed.
    change: Option<Change<'a>>,
    most: Safety,
    files: BTreeMap<FileId, FixedFile>,
    /// Files that a fix would have broken.
    broken: FastSet<FileId>,
    /// Texts that were there before: a run that comes back to them would not end.
    seen: FastSet<u64>,
    count: usize,
    /// One number for each file, however many paths lead to it.
    first: RefCell<FastMap<u128, FileId>>,
    /// Whether files are the user's own, as far as known.
    own: RefCell<FastMap<FileId, bool>>,
}

impl<'a> Work<'a> {
    fn new(session: &'a Session, options: &CheckOptions, most: Safety) -> Self {
        let homes = session.homes(options).iter().map(|home| session.vfs.canonical(home)).collect();
        let change = Change::of(session, options);
        let (files, count) = (BTreeMap::new(), 0);
        let (broken, seen, first, own) = Default::default();
        Self { session, homes, change, most, files, broken, seen, count, first, own }
    }

    /// Apply fixes once; whether something changed.
    fn round(&mut self, report: &Report) -> bool {
        loop {
            let plan = choose(&report.findings, |fix| self.admits(fix));
            let mut new = Vec::new();
            let mut broken = BTreeSet::new();
            for (&file, edits) in &plan.edits {
                let path = self.session.vfs.path(file);
                // the text that the findings are about: the file may be another one by now
                let Some(source) = report.source(file) else { continue };
                let old = source.document.text();
                let text = apply(&old, edits);
                if errors(&text) > errors(&old) {
                    broken.insert(file);
                }
                new.push((file, path, old, text));
            }
            if broken.is_empty() {
                return self.commit(new, plan.settles.len());
            }
            self.broken.extend(broken);
        }
    }

    /// Show the new texts.
    fn commit(&mut self, new: Vec<(FileId, Arc<Path>, String, String)>, count: usize) -> bool {
        let changed: Vec<_> = new.into_iter().filter(|(_, _, old, text)| old != text).collect();
        if changed.is_empty() {
            return false;
        }
        for (file, path, old, text) in changed {
            let before = || old.clone();
            let fixed = self.files.entry(file).or_insert_with(|| FixedFile {
                path,
                before: before(),
                after: before(),
            });
            fixed.after.clone_from(&text);
            self.session.vfs.set_buffer(&fixed.path, Some(text));
        }
        self.count += count;
        let mut hasher = DefaultHasher::new();
        for (file, fixed) in &self.files {
            (file.0, &fixed.after).hash(&mut hasher);
        }
        self.seen.insert(hasher.finish())
    }

    fn admits(&self, fix: &Fix) -> bool {
        let is_safe = fix.safety == Safety::Safe || self.most == Safety::Unsafe;
        let may_change = |file| !self.broken.contains(&file) && self.is_own(file);
        is_safe && fix.edits.iter().all(|edit| may_change(edit.span.file))
    }

    fn is_own(&self, file: FileId) -> bool {
        if let Some(&known) = self.own.borrow().get(&file) {
            return known;
        }
        let path = self.session.vfs.path(file);
        let is_meant = self.change.as_ref().is_none_or(|change| change.has(file));
        let is_own = is_meant && self.is_first(&path, file) && self.lies_in_workspace(&path);
        self.own.borrow_mut().insert(file, is_own);
        is_own
    }

    /// Whether a file lies in the user's workspace, and was not made by a build tool or installed.
    fn lies_in_workspace(&self, path: &Path) -> bool {
        let path = self.session.vfs.canonical(path);
        if self.session.is_installed(&path) {
            return false;
        }
        let workspace = path.parent().and_then(|folder| self.session.packages.workspace(folder));
        let below = workspace.as_ref().and_then(|workspace| path.strip_prefix(workspace).ok());
        let built = below.is_some_and(|below| below.iter().any(is_built));
        !built && self.homes.iter().any(|home| path.starts_with(home))
    }

    /// Whether `file` is the number that stands for the file at `path` in this run.
    fn is_first(&self, path: &Path, file: FileId) -> bool {
        let Some(identity) = self.session.vfs.identity(path) else { return true };
        *self.first.borrow_mut().entry(identity).or_insert(file) == file
    }
}

/// How many mistakes of syntax a text has.
fn errors(text: &str) -> usize {
    Document::parse(text).errors().len()
}

#[cfg(test)]
mod tests {
    use super::{apply, choose};
    use crate::base::{FileId, Span, TextRange};
    use crate::rules::{Edit, Finding, Fix, Safety, by_code};

    /// A finding whose fix makes these edits: file, start, end, new text.
    fn finding(edits: &[(u32, u32, u32, &str)]) -> Finding {
        let span = |file, start, end| Span { file: FileId(file), range: TextRange::new(start, end) };
        let edits = edits
            .iter()
            .map(|&(file, start, end, content)| Edit {
                span: span(file, start, end),
                content: content.into(),
            })
            .collect();
        let fix = Fix { safety: Safety::Safe, message: String::new(), edits };
        Finding { fix: Some(fix), ..Finding::new(by_code("XML001").unwrap(), span(0, 0, 0), "") }
    }

    #[test]
    fn whole_fixes_that_do_not_touch() {
        for (fixes, settles, expected) in [
            (vec![vec![(0, 1, 2, "X")], vec![(0, 4, 4, "Y")]], vec![0, 1], "0X23Y456789"),
            (vec![vec![(0, 4, 4, "Y")], vec![(0, 1, 2, "X")]], vec![0, 1], "0X23Y456789"),
            // the same edit twice, and one beside it
            (vec![vec![(0, 1, 2, "X")], vec![(0, 1, 2, "X"), (0, 5, 6, "")]], vec![0, 1], "0X2346789"),
            // overlapping, touching, inserted at one place
            (vec![vec![(0, 1, 4, "X")], vec![(0, 3, 5, "Y")]], vec![0], "0X456789"),
            (vec![vec![(0, 1, 4, "X")], vec![(0, 4, 4, "Y")]], vec![0], "0X456789"),
            (vec![vec![(0, 4, 4, "X")], vec![(0, 4, 4, "Y")]], vec![0], "0123X456789"),
            // half of a fix is no fix
            (vec![vec![(0, 1, 4, "X")], vec![(0, 2, 3, "Y"), (0, 8, 9, "Z")]], vec![0], "0X456789"),
            // a fix that gets into its own way
            (vec![vec![(0, 1, 4, "X"), (0, 2, 3, "Y")], vec![(0, 0, 1, "")]], vec![1], "123456789"),
            // another file
            (vec![vec![(0, 1, 4, "X")], vec![(1, 2, 3, "Y")]], vec![0, 1], "0X456789"),
        ] {
            let findings: Vec<Finding> = fixes.iter().map(|edits| finding(edits)).collect();
            let plan = choose(&findings, |_| true);
            assert_eq!(plan.settles, settles, "{fixes:?}");
            assert_eq!(apply("0123456789", &plan.edits[&FileId(0)]), expected, "{fixes:?}");
        }
        assert!(choose(&[finding(&[(0, 1, 2, "X")]), finding(&[])], |_| false).settles.is_empty());
    }
}
