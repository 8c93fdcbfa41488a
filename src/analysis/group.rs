//! One defect, one finding: places of one defect are put together at the very end, for whoever reads the report.
//! Until then each place is a finding of its own: suppressions, baselines, fixes and `--changed` count places.
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use indexmap::IndexMap;

use super::report::Report;
use super::series::Series;
use base::{FastMap, FastSet, FileId, Span, counted};
use rules::{Edit, Finding, Fix, Group, Related, Severity};

/// Files that say the same, or nearly.
struct AlikeFiles {
    /// Those whose text another one has as well, each with the first of that text.
    copied: FastMap<FileId, FileId>,
    series: Series,
}

/// What the findings of a group share.
#[derive(PartialEq, Eq, Hash)]
struct GroupKey {
    rule: &'static str,
    severity: Severity,
    /// None: any file.
    file: Option<FileId>,
    group: Group,
    /// The reported text, where it counts.
    text: String,
}

/// Put the places of one defect together: the first one stays, with the others beside it and a fix that
/// edits all of them.
#[must_use]
pub fn grouped(mut report: Report) -> Report {
    let alike = AlikeFiles {
        copied: copied(&report),
        series: Series::of(&report.findings, &report.paths),
    };
    let groups = groups(&report.findings, Some(&alike), |span| text(&report, span));
    let mut findings: Vec<Option<Finding>> = report.findings.into_iter().map(Some).collect();
    for group in groups {
        let mut members = group
            .iter()
            .filter_map(|&i| findings.get_mut(i).and_then(Option::take));
        let mut joined = members.next().map(|first| join(first, members.collect()));
        // files have numbers in the order in which they were read, which is another one each time
        let edits = joined.iter_mut().flat_map(|joined| &mut joined.fix);
        edits.for_each(|fix| sort_by_path(&mut fix.edits, &report.paths));
        if let Some(place) = group.first().and_then(|&at| findings.get_mut(at)) {
            *place = joined;
        }
    }
    report.findings = findings.into_iter().flatten().collect();
    report
}

/// The files with findings whose text another one has as well, each with the first of that text.
fn copied(report: &Report) -> FastMap<FileId, FileId> {
    let files: BTreeSet<FileId> = report
        .findings
        .iter()
        .map(|finding| finding.span.file)
        .collect();
    let mut by_text: FastMap<u64, Vec<FileId>> = FastMap::default();
    for file in files {
        if let Some(source) = report.source(file) {
            by_text.entry(source.hash).or_default().push(file);
        }
    }
    let several = by_text.into_values().filter(|files| files.len() > 1);
    several
        .flat_map(|files| {
            let first = files.first().copied();
            files
                .into_iter()
                .filter_map(move |file| Some((file, first?)))
        })
        .collect()
}

/// Mark the places of one defect for an editor. There every file is looked at by itself: the first place in a file
/// keeps its severity and names the others, and the others become hints that lead to the first.
pub fn mark_groups(report: &mut Report) {
    let mut findings = std::mem::take(&mut report.findings);
    mark(&mut findings, |span| text(report, span));
    report.findings = findings;
}

fn text(report: &Report, span: Span) -> Option<String> {
    Some(report.source(span.file)?.document.slice(span.range))
}

/// The same for findings, of whose places `text` gives the texts.
fn mark(findings: &mut [Finding], text: impl Fn(Span) -> Option<String>) {
    for group in groups(findings, None, text) {
        let Some((&first, others)) = group.split_first() else {
            continue;
        };
        let Some(at) = findings
            .get(first)
            .filter(|first| first.severity > Severity::Hint)
        else {
            continue;
        };
        let (span, message) = (
            at.span,
            format!("the first of {} locations with this problem", group.len()),
        );
        let places: Vec<Related> = others
            .iter()
            .filter_map(|&i| findings.get(i))
            .map(further_place)
            .collect();
        for other in others {
            if let Some(other) = findings.get_mut(*other) {
                other.severity = Severity::Hint;
                other.related.insert(
                    0,
                    Related {
                        span,
                        message: message.clone(),
                        is_call: false,
                    },
                );
            }
        }
        if let Some(first) = findings.get_mut(first) {
            first.message.push_str(&more(span, &places));
            first.related.extend(places);
        }
    }
}

/// The numbers of the findings of each group, in order: of every file by itself where nothing is said of files that are alike.
fn groups(
    findings: &[Finding],
    alike: Option<&AlikeFiles>,
    text: impl Fn(Span) -> Option<String>,
) -> Vec<Vec<usize>> {
    let mut groups: IndexMap<GroupKey, Vec<usize>> = IndexMap::new();
    for (number, finding) in findings.iter().enumerate() {
        if let Some(key) = key(finding, alike, &text) {
            groups.entry(key).or_default().push(number);
        }
    }
    if alike.is_none() {
        groups.retain(|key, members| members.len() >= key.group.least());
        return groups.into_values().collect();
    }
    copies(findings, groups)
}

/// Join groups and single findings of which the first ones say the very same: robots are made by copying files.
fn copies(findings: &[Finding], groups: IndexMap<GroupKey, Vec<usize>>) -> Vec<Vec<usize>> {
    let mut joined: IndexMap<(&str, Severity, &str), MergedGroup> = IndexMap::new();
    for (key, members) in groups {
        let is_group = members.len() >= key.group.least();
        let units = if is_group {
            vec![members]
        } else {
            members.into_iter().map(|one| vec![one]).collect()
        };
        for unit in units {
            let Some(first) = unit.first().and_then(|&first| findings.get(first)) else {
                continue;
            };
            let place = (first.rule.code, first.severity, first.message.as_str());
            let joined = joined.entry(place).or_default();
            joined.is_group |= is_group;
            joined.members.extend(unit);
        }
    }
    let groups = joined
        .into_values()
        .filter(|joined| joined.is_group || joined.members.len() >= COPIES);
    let sorted = |mut joined: MergedGroup| {
        joined.members.sort_unstable();
        joined.members
    };
    groups.map(sorted).collect()
}

/// The members of groups that say the same.
#[derive(Default)]
struct MergedGroup {
    members: Vec<usize>,
    /// Whether one of them is a group already.
    is_group: bool,
}

/// How many copies of a finding are one.
const COPIES: usize = 3;

fn key(
    finding: &Finding,
    alike: Option<&AlikeFiles>,
    text: impl Fn(Span) -> Option<String>,
) -> Option<GroupKey> {
    let mut group = finding
        .group
        .clone()
        .unwrap_or_else(|| finding.rule.group());
    let original = alike
        .and_then(|alike| alike.copied.get(&finding.span.file))
        .filter(|_| group == Group::Place);
    if let Some(original) = original {
        let range = finding.span.range;
        group = Group::Thing(format!("{}:{}-{}", original.0, range.start, range.end).into());
    }
    if let Some(series) = alike.and_then(|alike| alike.series.around(finding)) {
        group = Group::Thing(series.into());
    }
    let text = match group {
        Group::Place => return None,
        Group::Text => text(finding.span)?,
        _ => String::new(),
    };
    let anywhere = matches!(group, Group::Value(_) | Group::Thing(_)) && alike.is_some();
    let file = (!anywhere).then_some(finding.span.file);
    Some(GroupKey {
        rule: finding.rule.code,
        severity: finding.severity,
        file,
        group,
        text,
    })
}

/// The first finding of a group with the others beside it.
fn join(first: Finding, others: Vec<Finding>) -> Finding {
    let places: Vec<Related> = others.iter().map(further_place).collect();
    let message = format!("{}{}", first.message, more(first.span, &places));
    let mut fixes: Vec<Fix> = first
        .fix
        .into_iter()
        .chain(others.into_iter().filter_map(|other| other.fix))
        .collect();
    let fix = (!fixes.is_empty())
        .then(|| fixes.remove(0))
        .map(|fix| joined_fix(fix, fixes));
    Finding {
        message,
        fix,
        places,
        ..first
    }
}

fn further_place(finding: &Finding) -> Related {
    Related {
        span: finding.span,
        message: finding.message.clone(),
        is_call: false,
    }
}

/// `; 3 more locations in this file`
fn more(first: Span, places: &[Related]) -> String {
    let files: FastSet<FileId> = places
        .iter()
        .map(|place| place.span.file)
        .chain([first.file])
        .collect();
    let more = counted(places.len(), "more location");
    match files.len() {
        1 => format!("; {more} in this file"),
        files => format!("; {more}, in {files} files"),
    }
}

/// A fix with the edits of the others that are as safe. One that gets in the way of an earlier one is left out.
fn joined_fix(mut fix: Fix, others: Vec<Fix>) -> Fix {
    let mut taken: BTreeMap<(FileId, u32, u32), Edit> = BTreeMap::new();
    let own = std::mem::take(&mut fix.edits);
    let alike = others
        .into_iter()
        .filter(|other| other.safety == fix.safety)
        .map(|other| other.edits);
    for edits in std::iter::once(own).chain(alike) {
        let clashes = |edit: &Edit| {
            let (file, start, end) = place_of(edit);
            let before = taken.range(..=(file, end, u32::MAX)).next_back();
            before.is_some_and(|(&(other, _, until), old)| {
                other == file && until >= start && old != edit
            })
        };
        if !edits.iter().any(clashes) {
            taken.extend(edits.into_iter().map(|edit| (place_of(&edit), edit)));
        }
    }
    fix.edits = taken.into_values().collect();
    fix
}

fn sort_by_path(edits: &mut [Edit], paths: &BTreeMap<FileId, Arc<Path>>) {
    edits.sort_by_key(|edit| (paths.get(&edit.span.file), edit.span.range.start));
}

fn place_of(edit: &Edit) -> (FileId, u32, u32) {
    let Span { file, range } = edit.span;
    (file, range.start, range.end)
}

/// Say at the errors that left out parts of robots which rules did not run because of them, once a robot.
pub fn mark_cuts(report: &mut Report) {
    for (robot, cut) in &report.partial {
        let finding = cut
            .cause(&report.findings)
            .and_then(|number| report.findings.get_mut(number));
        let (Some(finding), Some(sentence)) = (finding, cut.sentence(robot)) else {
            continue;
        };
        finding.help = Some(match finding.help.take() {
            // one robot is enough where several suffer
            Some(help) if help.contains("is not checked in full") => help,
            Some(help) => format!("{help}\n{sentence}"),
            None => sentence,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::{join, mark};
    use base::{FileId, Span, TextRange};
    use rules::{Edit, Finding, Fix, Safety, Severity, by_code};

    fn span(file: u32, start: u32, end: u32) -> Span {
        Span {
            file: FileId(file),
            range: TextRange::new(start, end),
        }
    }

    /// A finding of `zero-inertia`.
    fn finding(file: u32, start: u32) -> Finding {
        Finding::new(
            by_code("INR003").unwrap(),
            span(file, start, start + 1),
            format!("link {start}"),
        )
    }

    #[test]
    fn an_editor_marks_every_place_and_every_file_has_a_first_one() {
        let places = [
            (0, 1),
            (0, 5),
            (1, 2),
            (0, 9),
            (1, 4),
            (1, 6),
            (2, 1),
            (2, 3),
        ];
        let mut findings: Vec<Finding> = places
            .iter()
            .map(|&(file, start)| finding(file, start))
            .collect();
        let own = findings[0].severity;
        mark(&mut findings, |_| None);
        let marked: Vec<bool> = findings
            .iter()
            .map(|finding| finding.severity == Severity::Hint)
            .collect();
        assert_eq!(marked, [false, true, false, true, true, true, false, false]);
        assert_eq!(findings[0].severity, own);
        assert_eq!(findings[0].message, "link 1; 2 more locations in this file");
        assert_eq!(
            findings[0]
                .related
                .iter()
                .map(|place| place.span)
                .collect::<Vec<_>>(),
            [span(0, 5, 6), span(0, 9, 10)]
        );
        assert_eq!(
            (findings[3].message.as_str(), findings[3].related[0].span),
            ("link 9", span(0, 1, 2))
        );
        assert_eq!(
            findings[6].message, "link 1",
            "two places in a file are two findings"
        );
    }

    #[test]
    fn findings_in_copies_of_a_file_are_one() {
        let tree = vfs::testing::Tree::new();
        let twice = "<robot name='r'><link name='a'/><link name='a'/></robot>";
        tree.write("one/r.urdf", twice);
        tree.write("two/r.urdf", twice);
        tree.write("other/r.urdf", &twice.replace("'/>", "' />"));
        let setup = crate::Setup {
            folders: vec![tree.root().to_owned()],
            ..crate::Setup::default()
        };
        let session = crate::Session::new(&tree.environment(&[]), setup).unwrap();
        let paths = vec![tree.root().to_owned()];
        let options = crate::CheckOptions {
            paths,
            ..crate::CheckOptions::default()
        };
        let report = super::grouped(crate::check(&session, &options));
        let found = report
            .findings
            .iter()
            .filter(|finding| finding.rule.name == "duplicate-link-name");
        let found: Vec<&str> = found.map(|finding| finding.message.as_str()).collect();
        assert_eq!(
            found,
            [
                "duplicate link name `a`; 1 more location, in 2 files",
                "duplicate link name `a`"
            ]
        );
    }

    #[test]
    fn a_joined_fix_has_no_edits_that_clash() {
        let with = |safety: Safety, edits: &[(u32, u32)]| {
            let edit = |&(start, end): &(u32, u32)| Edit {
                span: span(0, start, end),
                content: "x".to_owned(),
            };
            let fix = Fix {
                safety,
                message: String::new(),
                edits: edits.iter().map(edit).collect(),
            };
            Finding {
                fix: Some(fix),
                ..finding(0, 0)
            }
        };
        let others = vec![
            with(Safety::Safe, &[(10, 12), (20, 21)]),
            // clashes with the first one: left out as a whole
            with(Safety::Safe, &[(2, 4), (30, 31)]),
            // the same edit once more
            with(Safety::Safe, &[(10, 12)]),
            with(Safety::Unsafe, &[(40, 41)]),
        ];
        let joined = join(with(Safety::Safe, &[(1, 3)]), others);
        let edits: Vec<Span> = joined
            .fix
            .unwrap()
            .edits
            .iter()
            .map(|edit| edit.span)
            .collect();
        assert_eq!(edits, [span(0, 1, 3), span(0, 10, 12), span(0, 20, 21)]);
        assert_eq!(joined.places.len(), 4);
    }
}
