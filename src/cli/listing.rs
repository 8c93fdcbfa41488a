//! What `check` prints for people: which findings, and what is said below them.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::Path;

use indexmap::IndexMap;

use super::check_args::{CheckArgs, Show};
use super::text::counted;
use analysis::{Cut, CutBy, Report};
use base::limits::{DRAWN_IN_ALL, DRAWN_OF_A_RULE};
use base::{Encoding, FastMap, FastSet, FileId, Span};
use rules::{Finding, Rule, Severity};

/// Up to so many findings, nobody needs to be told which rules they are of, and what to do next.
const HANDFUL: usize = 5;
/// Rules of a summary.
const MOST_RULES: usize = 8;

/// The findings of a report that are printed, and how many are not.
pub(super) struct FindingList<'a> {
    report: &'a Report,
    /// Those that are printed.
    pub(super) shown: Vec<&'a Finding>,
    /// How many are left out because there are too many of their rule.
    left_out: usize,
    /// The least severity that is printed.
    least: Severity,
    /// How many are not severe enough.
    hidden: FastMap<Severity, usize>,
    /// Whether only what files reach that changed was checked: there need be no robot.
    is_change: bool,
}

/// Whether every place is a finding of its own, and none of them is left out.
pub(super) fn wants_all(args: &CheckArgs) -> bool {
    args.no_group || args.show == Some(Show::All)
}

/// The least severity that people are shown.
pub(super) fn least_shown(args: &CheckArgs) -> Severity {
    let asked = match args.show {
        None => Severity::Warning,
        Some(Show::Info) => Severity::Info,
        Some(Show::Hint | Show::All) => Severity::Hint,
    };
    // what makes a run fail is never hidden
    asked.min(args.fail_level.severity())
}

impl<'a> FindingList<'a> {
    pub(super) fn of(report: &'a Report, args: &CheckArgs) -> Self {
        let (least, all) = (least_shown(args), wants_all(args));
        let mut listing = Self {
            report,
            shown: Vec::new(),
            left_out: 0,
            least,
            hidden: FastMap::default(),
            is_change: args.changed,
        };
        let mut in_file: FastMap<(&str, Severity, FileId), usize> = FastMap::default();
        let mut in_all: FastMap<(&str, Severity), usize> = FastMap::default();
        for finding in &report.findings {
            let (code, severity) = (finding.rule.code, finding.severity);
            if severity < least {
                *listing.hidden.entry(severity).or_default() += 1;
                continue;
            }
            let here = in_file
                .entry((code, severity, finding.span.file))
                .or_default();
            let there = in_all.entry((code, severity)).or_default();
            if all || *here < DRAWN_OF_A_RULE && *there < DRAWN_IN_ALL {
                (*here, *there) = (*here + 1, *there + 1);
                listing.shown.push(finding);
            } else {
                listing.left_out += 1;
            }
        }
        listing
    }

    /// `2 errors, 1 warning in 2 files (1 robot, 7 files checked); 3 info not shown: --show info`
    fn summary(&self) -> String {
        let printed = self
            .report
            .findings
            .iter()
            .filter(|finding| finding.severity >= self.least);
        let mut parts = vec![summary(self.report, printed, self.hidden.is_empty())];
        parts.extend(self.not_shown());
        parts.join("; ")
    }

    /// What is not printed, and how to see it.
    fn not_shown(&self) -> Vec<String> {
        let hidden = |severity: Severity| Some((severity.name(), *self.hidden.get(&severity)?));
        let hidden = Severity::ALL.into_iter().filter_map(hidden);
        let (kinds, options): (Vec<String>, Vec<String>) = hidden
            .map(|(name, count)| (counted(count, name), format!("--show {name}")))
            .unzip();
        let left_out =
            (self.left_out > 0).then(|| format!("{} more not shown (--show all)", self.left_out));
        let hidden = (!kinds.is_empty())
            .then(|| format!("{} not shown: {}", kinds.join(" and "), options.join(", ")));
        left_out.into_iter().chain(hidden).collect()
    }

    /// The lines below findings that are drawn.
    pub(super) fn footer(&self, done: &str, could: &str) -> Vec<String> {
        let mut lines = vec![self.summary()];
        lines.extend(self.part_of());
        lines.extend(self.without_robot());
        lines.extend(self.incomplete());
        lines.extend(self.partial());
        if self.is_many() {
            lines.extend(self.by_rule());
        }
        lines.extend([done.to_owned(), could.to_owned(), self.next()]);
        lines.retain(|line| !line.is_empty());
        lines
    }

    /// The same below findings of a line each: nothing where they speak for themselves.
    pub(super) fn note(&self, could: &str) -> Vec<String> {
        if !self.is_many() {
            let summary = (!self.hidden.is_empty()).then(|| self.summary());
            let partial = if self.has_errors() {
                Vec::new()
            } else {
                self.partial()
            };
            let parts = self.part_of().into_iter().chain(self.without_robot());
            let robots = parts.chain(self.incomplete()).chain(partial);
            return summary.into_iter().chain(robots).collect();
        }
        let next = [could.to_owned(), self.next()];
        let next: Vec<String> = next.into_iter().filter(|part| !part.is_empty()).collect();
        vec![self.summary(), next.join("; ")]
    }

    /// The robots that the named files are parts of.
    fn part_of(&self) -> Option<String> {
        const MOST: usize = 3;
        let robots = &self.report.part_of;
        let names: Vec<String> = robots
            .iter()
            .take(MOST)
            .map(|robot| format!("`{}`", file_name(robot)))
            .collect();
        let more = robots.len().saturating_sub(MOST);
        let more = if more > 0 {
            format!(" and {}", counted(more, "other robot"))
        } else {
            String::new()
        };
        let has_robots = !names.is_empty() && self.report.robots > 0;
        has_robots.then(|| format!("checked as part of {}{more}", names.join(", ")))
    }

    /// That no robot was found, and why: without errors it would look like success.
    fn without_robot(&self) -> Option<String> {
        let Report {
            robots,
            roots,
            nameless,
            skipped,
            ..
        } = self.report;
        if self.is_change || *robots > 0 || self.has_errors() || !self.report.compared.is_empty() {
            return None;
        }
        let why = match (nameless.first(), roots.is_empty(), skipped.is_empty()) {
            (Some(file), ..) => {
                let file = file_name(file);
                format!("<robot> in `{file}` has no name: add name=\"...\", unless other files include it")
            }
            (None, true, true) => "there are no *.urdf or *.xacro files".to_owned(),
            (None, true, false) => "everything is excluded".to_owned(),
            (None, false, _) => {
                "a robot needs a <robot name=\"...\"> and a link; these files contain only parts of robots"
                    .to_owned()
            }
        };
        Some(format!("no robot found: {why}"))
    }

    /// That robots were not checked in full: without findings it would look like success.
    fn incomplete(&self) -> Option<String> {
        incomplete(self.report)
    }

    /// That robots were not checked in full because of errors, for those of which no package is said to be missing: where
    /// these left out a part, and where they made names unknown.
    fn partial(&self) -> Vec<String> {
        let lines = [CutBy::Loss, CutBy::Names].map(|by| self.cut_by(by));
        lines.into_iter().flatten().collect()
    }

    fn cut_by(&self, by: CutBy) -> Option<String> {
        let Report {
            partial,
            incomplete,
            ..
        } = self.report;
        let cuts = partial
            .iter()
            .filter(|(robot, cut)| cut.by == by && !incomplete.contains_key(*robot));
        let cuts: Vec<&Cut> = cuts.map(|(_, cut)| cut).collect();
        let robots = (!cuts.is_empty()).then(|| counted(cuts.len(), "robot"))?;
        let whose = if cuts.len() == 1 { "it" } else { "them" };
        let at = self.first_place(&cuts);
        let why = match by {
            CutBy::Loss => {
                let what = at.map_or_else(
                    || format!("parts of {whose}"),
                    |at| format!("what stands at {at}"),
                );
                format!(
                    "errors left out {what}, so rules about missing or unused parts did not run"
                )
            }
            CutBy::Names => {
                let at = at.map_or_else(String::new, |at| format!(" at {at}"));
                format!(
                    "names of links or joints{at} cannot be computed, so rules that look up names did not run, or only in part"
                )
            }
        };
        Some(format!("{robots} not checked in full: {why}"))
    }

    /// `arm.xacro:4 and 2 other places`, where cuts come from.
    fn first_place(&self, cuts: &[&Cut]) -> Option<String> {
        let places: BTreeSet<Span> = cuts.iter().flat_map(|cut| cut.at.iter().copied()).collect();
        let first = cuts.iter().find_map(|cut| cut.at.first())?;
        let source = self.report.files.get(&first.file)?;
        let line = source
            .document
            .line_col(first.range.start, Encoding::Utf8)
            .line
            + 1;
        let more = match places.len() - 1 {
            0 => String::new(),
            more => format!(" and {}", counted(more, "other place")),
        };
        Some(format!("{}:{line}{more}", file_name(&source.path)))
    }

    fn has_errors(&self) -> bool {
        self.report
            .findings
            .iter()
            .any(|finding| finding.severity == Severity::Error)
    }

    fn is_many(&self) -> bool {
        self.shown.len() + self.left_out > HANDFUL
    }

    /// The rules that are printed, worst first.
    fn by_rule(&self) -> Vec<String> {
        let mut counts = counts(self.report);
        counts.retain(|(severity, ..)| *severity >= self.least);
        let width = counts
            .iter()
            .map(|(.., count)| count.to_string().len())
            .max()
            .unwrap_or(0);
        let lines = counts
            .iter()
            .take(MOST_RULES)
            .map(|(severity, rule, count)| {
                let severity = severity.name();
                format!("  {count:width$}  {severity:7}  {}", rule.name)
            });
        let left = counts.len().saturating_sub(MOST_RULES);
        let more =
            (left > 0).then(|| format!("  and {}: --statistics", counted(left, "more rule")));
        lines.chain(more).collect()
    }

    /// What to do with many findings.
    fn next(&self) -> String {
        let worst = counts(self.report).first().map(|(_, rule, _)| rule.name);
        match worst.filter(|_| self.is_many()) {
            Some(name) => format!(
                "run `xacro-lint explain {name}` for details on a rule, or `--write-baseline FILE` to accept these findings"
            ),
            None => String::new(),
        }
    }
}

/// How many findings of each severity of a rule there are, worst first.
pub(super) fn counts(report: &Report) -> Vec<(Severity, &'static Rule, usize)> {
    let mut counts: IndexMap<(Severity, &str), (&'static Rule, usize)> = IndexMap::new();
    for finding in &report.findings {
        counts
            .entry((finding.severity, finding.rule.code))
            .or_insert((finding.rule, 0))
            .1 += 1;
    }
    let mut counts: Vec<_> = counts
        .into_iter()
        .map(|((severity, _), (rule, count))| (severity, rule, count))
        .collect();
    counts
        .sort_by_key(|(severity, rule, count)| (std::cmp::Reverse((*severity, *count)), rule.code));
    counts
}

fn file_name(path: &Path) -> Cow<'_, str> {
    path.file_name().unwrap_or_default().to_string_lossy()
}

/// `2 errors, 1 warning in 2 files (1 robot, 7 files checked)`
fn summary<'f>(
    report: &Report,
    printed: impl Iterator<Item = &'f Finding>,
    is_all: bool,
) -> String {
    let robots = counted(report.robots, "robot");
    let files = counted(report.files.len(), "file");
    let checked = format!("{robots}, {files} checked");
    let mut counts = [0; Severity::ALL.len()];
    let mut with_findings: FastSet<FileId> = FastSet::default();
    for finding in printed {
        with_findings.insert(finding.span.file);
        with_findings.extend(finding.places.iter().map(|place| place.span.file));
        for (count, severity) in counts.iter_mut().zip(Severity::ALL) {
            *count += usize::from(severity == finding.severity);
        }
    }
    let named = counts
        .into_iter()
        .zip(Severity::ALL)
        .filter(|(count, _)| *count > 0);
    let named: Vec<String> = named
        .map(|(count, severity)| counted(count, severity.name()))
        .collect();
    if !named.is_empty() {
        format!(
            "{} in {} ({checked})",
            named.join(", "),
            counted(with_findings.len(), "file")
        )
    } else if is_all {
        format!("no findings ({checked})")
    } else {
        format!("no errors or warnings ({checked})")
    }
}

/// `1 robot not checked in full: package `arm` not found`
pub(super) fn incomplete(report: &Report) -> Option<String> {
    const MOST: usize = 5;
    let robots = &report.incomplete;
    let packages: BTreeSet<&String> = robots.values().flatten().collect();
    let names: Vec<String> = packages
        .iter()
        .take(MOST)
        .map(|name| format!("`{name}`"))
        .collect();
    let what = if packages.len() == 1 {
        "package"
    } else {
        "packages"
    };
    let more = packages.len().saturating_sub(MOST);
    let more = if more > 0 {
        format!(" and {more} more")
    } else {
        String::new()
    };
    let robots = counted(robots.len(), "robot");
    (!names.is_empty()).then(|| {
        format!(
            "{robots} not checked in full: {what} {}{more} not found",
            names.join(", ")
        )
    })
}
