//! Which fixes can be made together.
use super::plan::{Plan, apply, choose};
use super::proof::{Changed, Claim, Effort, proves};
use super::report::Report;
use super::session::Session;
use base::{FastSet, FileId, TextRange};
use rules::{Category, Finding, Safety, Severity};
use vfs::Vfs;
use xml::Document;

/// Which of several fixes are made.
pub(super) struct Admission<'a> {
    pub(super) session: &'a Session,
    pub(super) report: &'a Report,
    pub(super) most: Safety,
    pub(super) effort: &'a Effort,
}

/// Fixes that can be made together, and those that cannot be made.
pub(super) struct Admitted {
    pub(super) good: Vec<usize>,
    pub(super) refused: Vec<usize>,
}

impl Admission<'_> {
    /// The fixes of these findings that can be made together: all of them, or those of each half that can.
    pub(super) fn of(&self, numbers: &[usize]) -> Admitted {
        let mut good = Vec::new();
        let repairs = self.claiming(Claim::Repaired, numbers);
        self.add(&mut good, &repairs, self.claim(Claim::Repaired));
        // beside repairs nothing else is proved: it waits for the next round
        let has_time = good.is_empty() || self.most == Safety::Unsafe;
        if has_time {
            for wanted in [Claim::Same, Claim::Fitted] {
                let claimed = self.claiming(wanted, numbers);
                self.add(&mut good, &claimed, self.claim(wanted));
            }
        }
        let tried = if has_time { numbers } else { &repairs };
        let refused = tried
            .iter()
            .filter(|number| !good.contains(number))
            .copied()
            .collect();
        Admitted { good, refused }
    }

    /// The findings among these whose fixes claim this.
    fn claiming(&self, wanted: Claim, numbers: &[usize]) -> Vec<usize> {
        let claims = |number: &usize| {
            let found = self.report.findings.get(*number);
            found.is_some_and(|found| claim(found) == wanted)
        };
        numbers.iter().copied().filter(claims).collect()
    }

    fn claim(&self, safe: Claim) -> Claim {
        if self.most == Safety::Unsafe {
            Claim::Accepted
        } else {
            safe
        }
    }

    fn add(&self, good: &mut Vec<usize>, numbers: &[usize], claim: Claim) {
        let tried: Vec<usize> = good.iter().chain(numbers).copied().collect();
        if numbers.is_empty() || self.holds(&tried, claim) {
            *good = tried;
        } else if numbers.len() > 1 {
            let (one, other) = numbers.split_at(numbers.len() / 2);
            self.add(good, one, claim);
            self.add(good, other, claim);
        }
    }

    fn holds(&self, numbers: &[usize], claim: Claim) -> bool {
        let mut numbers = numbers.to_vec();
        numbers.sort_unstable();
        let changes = changes(self.report, &numbers, &self.session.vfs);
        let changes: Vec<Changed> = changes.into_iter().map(|changed| changed.of).collect();
        let is_sound = |changed: &Changed| errors(&changed.new) <= errors(&changed.old);
        changes.iter().all(is_sound) && proves(self.session, &changes, claim, self.effort)
    }
}

/// What a change does to a file, by its number.
pub(super) struct FileChange {
    pub(super) file: FileId,
    pub(super) of: Changed,
}

/// What the fixes of these findings do together.
pub(super) fn changes(report: &Report, numbers: &[usize], vfs: &Vfs) -> Vec<FileChange> {
    let findings = numbers
        .iter()
        .filter_map(|&number| Some((number, report.findings.get(number)?)));
    let Plan { edits, .. } = choose(findings);
    let change = |(file, edits): (FileId, Vec<(TextRange, String)>)| {
        // the text that the findings are about: the file may be another one by now
        let old = report.source(file)?.document.text();
        let new = apply(&old, &edits);
        Some(FileChange {
            file,
            of: Changed {
                path: vfs.path(file),
                old,
                new,
                edits,
            },
        })
    };
    edits.into_iter().filter_map(change).collect()
}

/// Findings by the files that their fixes change: those of one group have nothing to do with the others.
pub(super) fn groups(report: &Report, numbers: &[usize]) -> Vec<Vec<usize>> {
    let mut groups: Vec<(FastSet<FileId>, Vec<usize>)> = Vec::new();
    for &number in numbers {
        let mut files: FastSet<FileId> = files_of(report, number).into_iter().collect();
        let mut own = vec![number];
        groups.retain_mut(|(others, numbers)| {
            let is_apart = others.is_disjoint(&files);
            if !is_apart {
                files.extend(others.drain());
                own.append(numbers);
            }
            is_apart
        });
        own.sort_unstable();
        groups.push((files, own));
    }
    groups.into_iter().map(|(_, numbers)| numbers).collect()
}

/// The files that the fix of a finding changes.
pub(super) fn files_of(report: &Report, number: usize) -> Vec<FileId> {
    let fix = report
        .findings
        .get(number)
        .and_then(|finding| finding.fix.as_ref());
    fix.iter()
        .flat_map(|fix| &fix.edits)
        .map(|edit| edit.span.file)
        .collect()
}

/// How many mistakes of syntax a text has.
fn errors(text: &str) -> usize {
    Document::parse(text).errors().len()
}

/// What a fix that is said to be safe promises.
pub(super) fn claim(finding: &Finding) -> Claim {
    use Category::{Consumers, Joint, Structure, Xacro, Xml};
    if finding.rule.category == Consumers {
        return Claim::Fitted;
    }
    let is_refused = finding.rule.severity == Severity::Error
        && matches!(finding.rule.category, Joint | Structure | Xacro | Xml);
    if is_refused {
        Claim::Repaired
    } else {
        Claim::Same
    }
}
