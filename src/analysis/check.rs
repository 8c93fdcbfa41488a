//! Checking files and folders.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::beside::{
    ComparisonResult, Robots, Sort, beside_files, beside_findings, beside_roots, pairing_of, sort,
};
use super::change::Change;
use super::check_task::{CheckReason, CheckTask};
use super::config_findings::config_findings;
use super::coverage::{in_turns, uncovered, without_covered};
use super::drift::drift_findings;
use super::launch_findings::launch_findings;
use super::launched::{launched_tasks, missing_arguments, prefer_calls};
use super::lock::locked;
use super::merge::merge;
use super::options::CheckOptions;
use super::report::{Report, SkipReason, Skipped, Unreadable};
use super::root_analysis::{RootAnalysis, run_kept};
use super::root_config::RootConfig;
use super::root_result::RootResult;
use super::run_task;
use super::session::Session;
use super::suppress::SuppressionFilter;
use super::task_list::{homes, tasks};
use super::threads::map_all;
use super::unused::{read_for_used, settle_copies, settle_settings};
use base::limits::MESSAGE_LETTERS;
use base::{FastMap, FastSet, FileId};
use packages::UNQUOTED;
use rules::{Finding, Severity, named};

/// What a check did, for another one of the same files.
#[derive(Default)]
pub(super) struct PreviousCheck {
    results: FastMap<TaskKey, RootResult>,
}

/// The expansions that files beside robots are compared with.
struct KeptRobots {
    wanted: BTreeSet<RootConfig>,
    robots: Mutex<Robots>,
}

impl KeptRobots {
    fn of(wanted: Vec<RootConfig>) -> Self {
        Self {
            wanted: wanted.into_iter().collect(),
            robots: Mutex::default(),
        }
    }

    fn add(&self, analyzed: RootAnalysis) {
        locked(&self.robots).insert(analyzed.root.clone(), Arc::new(analyzed));
    }
}

/// What tells a task from others.
type TaskKey = (PathBuf, CheckReason, Vec<(String, String)>, Option<String>);

/// The files that expansions read; parts are named by many robots.
fn read_by(results: &[RootResult]) -> BTreeSet<PathBuf> {
    let read: FastSet<&PathBuf> = results.iter().flat_map(|result| &result.reads).collect();
    read.into_iter().cloned().collect()
}

fn key(task: &CheckTask) -> TaskKey {
    (
        task.file.clone(),
        task.reason,
        task.args.clone(),
        task.preset.clone(),
    )
}

impl PreviousCheck {
    /// Forget what rests on changed files.
    pub(super) fn forget(&mut self, is_changed: impl Fn(&Path) -> bool) {
        self.results.retain(|_, result| {
            !is_changed(&result.task.file) && !result.reads.iter().any(|path| is_changed(path))
        });
    }

    /// Keep what was done, where somebody wants it.
    fn note(&mut self, results: &[RootResult], is_wanted: bool) {
        let known = results.iter().filter(|_| is_wanted);
        self.results
            .extend(known.map(|result| (key(&result.task), result.clone())));
    }

    /// Forget everything.
    pub(super) fn clear(&mut self) {
        self.results.clear();
    }
}

/// Check files and folders.
pub fn check(session: &Session, options: &CheckOptions) -> Report {
    check_with(session, options, None)
}

/// The same; what `done` holds is not done again, and what is done is put there.
pub(super) fn check_with(
    session: &Session,
    options: &CheckOptions,
    done: Option<&mut PreviousCheck>,
) -> Report {
    let _held = session.vfs.freeze();
    let mut report = Report::default();
    let tasks = tasks(session, options, &mut report);
    options.progress.begin(tasks.len());
    let mut reads: BTreeSet<PathBuf> = tasks.iter().map(|task| task.file.clone()).collect();
    // most files are parts of robots: those are expanded first, and what they include needs no look of its own
    let (first, later) = in_turns(session, tasks);
    let mut files = beside_files(session, options);
    if let Some(change) = Change::of(session, options) {
        let reached: FastSet<&PathBuf> =
            first.iter().chain(&later).map(|task| &task.file).collect();
        files.retain(|file| {
            let reaches = |root: &RootConfig| reached.contains(&root.file);
            change.holds(file) || pairing_of(session, file).roots.iter().any(reaches)
        });
    }
    let compared = KeptRobots::of(beside_roots(session, &files));
    let mut results = run_all(session, options, first, done.as_deref(), Some(&compared));
    let waiting = later.len();
    let later = uncovered(session, later, &results);
    options.progress.skip(waiting - later.len());
    results.extend(run_all(
        session,
        options,
        later,
        done.as_deref(),
        Some(&compared),
    ));
    let mut made = PreviousCheck::default();
    made.note(&results, done.is_some());
    reads.extend(read_by(&results));
    let mut kept = without_covered(session, results);
    let called = called(session, options, &kept, done.as_deref());
    made.note(&called, done.is_some());
    reads.extend(read_by(&called));
    kept.extend(called);
    prefer_calls(&mut kept);
    if let Some(done) = done {
        *done = made;
    }
    reads.extend(session.config_files());
    reads.extend(session.mesh_files());
    if let Some(change) = Change::of(session, options) {
        kept.retain(|result| change.is_read_by(result));
    }
    let Report {
        mut unreadable,
        mut skipped,
        ..
    } = report;
    unreadable.extend(
        session
            .unreadable_configs()
            .into_iter()
            .map(|error| Unreadable {
                path: error.path.clone(),
                error,
            }),
    );
    reads.extend(files.iter().cloned());
    let robots = analyzed_all(session, options, compared);
    let beside = beside_findings(session, &files, &options.cancel, &robots);
    let unpaired = options.paths.iter().map(|path| session.vfs.absolute(path));
    let unpaired = unpaired.filter(|path| files.contains(path) && !beside.files.contains(path));
    let unpaired = unpaired.filter(|path| sort(path) == Some(Sort::Yaml));
    skipped.extend(unpaired.map(|path| Skipped {
        path,
        reason: SkipReason::NoRobot,
    }));
    Report {
        unreadable,
        skipped,
        reads,
        ..build_report(session, options, kept, beside)
    }
}

/// The same robots as launch files call them. Whoever gives arguments asks for these.
fn called(
    session: &Session,
    options: &CheckOptions,
    kept: &[RootResult],
    done: Option<&PreviousCheck>,
) -> Vec<RootResult> {
    let tasks = if options.args.is_empty() {
        launched_tasks(session, kept)
    } else {
        Vec::new()
    };
    options.progress.add(tasks.len());
    run_all(session, options, tasks, done, None)
}

/// Take the words out of findings in files that belong to no robot: a link or an include can lead to any file, and
/// the report may stand in a public log.
pub(super) fn conceal(session: &Session, report: &Report, findings: &mut [Finding]) {
    let around = session.packages.around(
        report
            .roots
            .iter()
            .chain(&report.compared)
            .map(PathBuf::as_path),
    );
    let mut known: FastMap<FileId, bool> = FastMap::default();
    let mut belongs = |file: FileId| {
        *known
            .entry(file)
            .or_insert_with(|| around.hold(&session.vfs.path(file)))
    };
    for finding in findings {
        if !belongs(finding.span.file) {
            finding.message = UNQUOTED.to_owned();
            (finding.help, finding.fix) = (None, None);
            // the include in the robot that led there stays
            finding.related.retain(|related| belongs(related.span.file));
            finding.call_sites.clear();
        }
    }
}

/// Write the line ends of fixes as the files have them.
fn adapt_line_ends(session: &Session, findings: &mut [Finding]) {
    let edits = findings
        .iter_mut()
        .filter_map(|finding| finding.fix.as_mut())
        .flat_map(|fix| &mut fix.edits);
    for edit in edits.filter(|edit| edit.content.contains('\n') && !edit.content.contains('\r')) {
        let source = session.vfs.document(&session.vfs.path(edit.span.file));
        if source.is_ok_and(|source| source.document.line_end() == "\r\n") {
            edit.content = edit.content.replace('\n', "\r\n");
        }
    }
}

/// Check files; what `kept` asks for is not expanded again for the files beside it.
fn run_all(
    session: &Session,
    options: &CheckOptions,
    tasks: Vec<CheckTask>,
    done: Option<&PreviousCheck>,
    kept: Option<&KeptRobots>,
) -> Vec<RootResult> {
    let run = |task: CheckTask| {
        let is_kept =
            task.called.is_none() && kept.is_some_and(|kept| kept.wanted.contains(&task.root()));
        let known = done.and_then(|done| done.results.get(&key(&task)).cloned());
        let result = match known {
            Some(known) => RootResult { task, ..known },
            None => match kept.filter(|_| is_kept) {
                Some(kept) => {
                    let (result, analyzed) = run_kept(session, options, task);
                    kept.add(analyzed);
                    result
                }
                None => run_task::run(session, options, task),
            },
        };
        options.progress.step();
        result
    };
    map_all(tasks, run)
}

/// All roots that are wanted, expanded.
fn analyzed_all(session: &Session, options: &CheckOptions, kept: KeptRobots) -> Robots {
    let mut robots = kept
        .robots
        .into_inner()
        .unwrap_or_else(PoisonError::into_inner);
    let roots: Vec<RootConfig> = kept
        .wanted
        .into_iter()
        .filter(|root| !robots.contains_key(root))
        .collect();
    let make = |root: RootConfig| {
        let analyzed = Arc::new(RootAnalysis::of(session, &root, options));
        (root, analyzed)
    };
    robots.extend(map_all(roots, make));
    robots
}

/// One report of many results and of what there is to say beside them: merged, as configured, in order.
pub(super) fn build_report(
    session: &Session,
    options: &CheckOptions,
    mut kept: Vec<RootResult>,
    mut beside: ComparisonResult,
) -> Report {
    let has_robots = !kept.is_empty();
    let mut report = Report::default();
    for result in &kept {
        report
            .files
            .extend(result.files.iter().map(|file| (file.id, file.clone())));
        if result.task.called.is_some() {
            continue;
        }
        report.roots.push(result.task.file.clone());
        report.robots += usize::from(result.is_robot);
        if !result.unfound.is_empty() {
            let names = report
                .incomplete
                .entry(result.task.file.clone())
                .or_default();
            names.extend(result.unfound.iter().cloned());
        }
        report.partial.extend(
            result
                .cut
                .clone()
                .map(|cut| (result.task.file.clone(), cut)),
        );
        if !result.consumers.is_empty() {
            let counted = report
                .consumers
                .entry(result.task.file.clone())
                .or_default();
            counted.extend(result.consumers.iter().map(|(name, worst)| (*name, *worst)));
        }
        report
            .nameless
            .extend(result.is_nameless.then(|| result.task.file.clone()));
    }
    let homes = homes(session, options);
    let mut hiding = SuppressionFilter::new(session, options, &kept);
    for result in &mut kept {
        let includes = std::mem::take(&mut result.includes);
        result
            .findings
            .retain(|finding| !hiding.hides(finding, &includes));
    }
    let config_findings = config_findings(session, options, &report, &kept);
    let drift_findings = drift_findings(session, options, &kept);
    beside
        .findings
        .retain(|finding| !hiding.hides(finding, &[]));
    settle_settings(session, options, &mut beside.findings);
    let documents = beside
        .files
        .iter()
        .filter_map(|file| session.vfs.document(file).ok());
    report.files.extend(documents.map(|file| (file.id, file)));
    report.compared = beside.files;
    let missing_arguments = missing_arguments(&mut kept);
    let used = read_for_used(session, options, &mut kept);
    let mut findings = merge(kept);
    findings.extend(beside.findings);
    findings.extend(hiding.finish());
    findings.extend(config_findings);
    findings.extend(drift_findings);
    findings.extend(missing_arguments);
    if has_robots {
        findings.extend(launch_findings(session, options));
    }
    findings.retain(|finding| !is_of_broken_text(finding, &report));
    if let Some(used) = used {
        settle_copies(session, options, &used, &mut findings);
    }
    findings.retain_mut(|finding| admit(session, finding, &homes));
    adapt_line_ends(session, &mut findings);
    for finding in &mut findings {
        let mut seen = FastSet::default();
        finding
            .related
            .retain(|related| seen.insert((related.span, related.message.clone())));
    }
    conceal(session, &report, &mut findings);
    if let Some(change) = Change::of(session, options) {
        findings.retain(|finding| change.concerns(finding));
    }
    findings.sort_by_cached_key(|f| {
        (
            session.vfs.path(f.span.file),
            f.span.range.start,
            f.rule.code,
        )
    });
    for finding in &findings {
        let spans =
            std::iter::once(finding.span).chain(finding.related.iter().map(|related| related.span));
        let edits = finding
            .fix
            .iter()
            .flat_map(|fix| &fix.edits)
            .map(|edit| edit.span);
        report.paths.extend(
            spans
                .chain(edits)
                .map(|span| (span.file, session.vfs.path(span.file))),
        );
    }
    report.read_beside(&session.vfs);
    report.findings = findings;
    report
}

/// Whether a finding is wanted; sets its severity as configured.
fn admit(session: &Session, finding: &mut Finding, homes: &[PathBuf]) -> bool {
    let path = session.vfs.path(finding.span.file);
    let Some(severity) = session.settings(&path).severity(finding, &path) else {
        return false;
    };
    finding.severity = severity;
    // what `$(find)` made absolute is shown as the user would write it
    let cwd = format!("{}/", vfs::slashed(&session.env.cwd));
    let related = finding
        .related
        .iter_mut()
        .map(|related| &mut related.message);
    for text in std::iter::once(&mut finding.message)
        .chain(&mut finding.help)
        .chain(related)
    {
        if text.contains(&cwd) {
            *text = text.replace(&cwd, "");
        }
        shorten(text);
    }
    let is_config = finding.rule == named::INVALID_CONFIG;
    severity == Severity::Error || is_config || homes.iter().any(|home| path.starts_with(home))
}

/// Names can be as long as files and hold line ends: what a message shows of them has a bound and stands in one
/// line, so that it is never taken for a line of its own by whoever reads a log.
fn shorten(message: &mut String) {
    if message.contains(['\n', '\r']) {
        *message = message
            .split(['\n', '\r'])
            .map(str::trim)
            .collect::<Vec<_>>()
            .join(" ");
    }
    if message.len() > MESSAGE_LETTERS {
        message.truncate(message.floor_char_boundary(MESSAGE_LETTERS));
        message.push('…');
    }
}
/// Whether a finding quotes bytes that could not be read as text: that they cannot is a finding of its own.
fn is_of_broken_text(finding: &Finding, report: &Report) -> bool {
    let source = || report.files.get(&finding.span.file);
    finding.message.contains('\u{fffd}')
        && finding.rule != named::XML_ENCODING_MISMATCH
        && source().is_some_and(|source| source.encoding_error.is_some())
}
