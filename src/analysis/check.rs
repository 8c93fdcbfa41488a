//! Checking files and folders.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::change::Change;
use super::job::{self, Outcome};
use super::merge::merge;
use super::progress::Progress;
use super::report::{Report, Unreadable};
use super::roots::{Job, Reason};
use super::session::Session;
use super::suppress::Hiding;
use super::walk;
use crate::base::limits::MESSAGE_LETTERS;
use crate::base::{CancelFlag, FastMap, FastSet, FileId};
use crate::expand::large_stacks;
use crate::rules::{Finding, Severity, invalid_config};
use crate::workspace::UNQUOTED;

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct CheckOptions {
    /// Files and folders.
    pub paths: Vec<PathBuf>,
    /// Files that are robots, whatever their content looks like.
    pub entries: Vec<PathBuf>,
    /// Files that changed, when only what concerns them is asked for; below `paths`, or elsewhere.
    pub changed: Vec<PathBuf>,
    /// Arguments of every expansion, over those of configured roots.
    pub args: Vec<(String, String)>,
    /// Set to stop early.
    pub cancel: CancelFlag,
    /// Says how far the check is.
    pub progress: Progress,
}

impl Session {
    /// Check files and folders.
    pub fn check(&self, options: &CheckOptions) -> Report {
        let _held = self.vfs.hold();
        let mut report = Report::default();
        let jobs = self.jobs(options, &mut report);
        options.progress.begin(jobs.len());
        let mut reads: BTreeSet<PathBuf> = jobs.iter().map(|job| job.file.clone()).collect();
        // most files are parts of robots: those are expanded first, and what they include needs no look of its own
        let (first, later) = self.in_turns(jobs);
        let mut outcomes = self.run_all(options, first);
        let waiting = later.len();
        let later = self.uncovered(later, &outcomes);
        options.progress.skip(waiting - later.len());
        outcomes.extend(self.run_all(options, later));
        // parts are named by many robots
        let read: FastSet<&PathBuf> = outcomes.iter().flat_map(|outcome| &outcome.reads).collect();
        reads.extend(read.into_iter().cloned());
        reads.extend(self.config_files());
        reads.extend(self.mesh_files());
        let mut kept = self.keep(outcomes);
        if let Some(change) = Change::of(self, options) {
            kept.retain(|outcome| change.is_read_by(outcome));
        }
        Report { unreadable: report.unreadable, reads, ..self.conclude(options, kept) }
    }

    /// Take the words out of findings in files that belong to no robot: a link or an include can lead to any file, and
    /// the report may stand in a public log.
    fn conceal(&self, report: &Report, findings: &mut [Finding]) {
        let around = self.packages.around(report.roots.iter().map(PathBuf::as_path));
        let mut known: FastMap<FileId, bool> = FastMap::default();
        for finding in findings {
            let file = finding.span.file;
            if !*known.entry(file).or_insert_with(|| around.hold(&self.vfs.path(file))) {
                finding.message = UNQUOTED.to_owned();
                (finding.help, finding.fix) = (None, None);
                finding.related.clear();
                finding.ways.clear();
            }
        }
    }

    fn run_all(&self, options: &CheckOptions, jobs: Vec<Job>) -> Vec<Outcome> {
        let run = |job| {
            let outcome = job::run(self, options, job);
            options.progress.step();
            outcome
        };
        if jobs.len() < 2 {
            return jobs.into_iter().map(run).collect();
        }
        match large_stacks() {
            Some(pool) => pool.install(|| jobs.into_par_iter().map(run).collect()),
            None => jobs.into_par_iter().map(run).collect(),
        }
    }

    /// One report of many outcomes: merged, as configured, in order.
    pub(super) fn conclude(&self, options: &CheckOptions, mut kept: Vec<Outcome>) -> Report {
        let mut report = Report::default();
        for outcome in &kept {
            report.roots.push(outcome.job.file.clone());
            report.robots += usize::from(outcome.is_robot);
            report.files.extend(outcome.files.iter().map(|file| (file.id, file.clone())));
        }
        let homes = self.homes(options);
        let mut hiding = Hiding::new(self, options, &kept);
        for outcome in &mut kept {
            outcome.findings.retain(|finding| !hiding.hides(finding));
        }
        let mut findings = merge(kept);
        findings.extend(hiding.finish());
        findings.extend(self.config_findings());
        findings.retain_mut(|finding| self.admit(finding, &homes));
        self.conceal(&report, &mut findings);
        if let Some(change) = Change::of(self, options) {
            findings.retain(|finding| change.concerns(finding));
        }
        findings.sort_by_cached_key(|f| (self.vfs.path(f.span.file), f.span.range.start, f.rule.code));
        for finding in &findings {
            let spans =
                std::iter::once(finding.span).chain(finding.related.iter().map(|related| related.span));
            let edits = finding.fix.iter().flat_map(|fix| &fix.edits).map(|edit| edit.span);
            report.paths.extend(spans.chain(edits).map(|span| (span.file, self.vfs.path(span.file))));
        }
        // findings and fixes may be about files that no expansion reads, such as package.xml
        let unread = report.paths.iter().filter(|(id, _)| !report.files.contains_key(id));
        let beside: Vec<_> = unread.filter_map(|(_, path)| self.vfs.document(path).ok()).collect();
        report.beside.extend(beside.into_iter().map(|file| (file.id, file)));
        report.findings = findings;
        report
    }

    /// The files that [`check`](Self::check) would look at, sorted; what they include comes on top.
    pub fn files(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let jobs = self.jobs(options, &mut Report::default());
        let files: BTreeSet<PathBuf> = jobs.into_iter().map(|job| job.file).collect();
        files.into_iter().collect()
    }

    fn jobs(&self, options: &CheckOptions, report: &mut Report) -> Vec<Job> {
        let absolute = |path: &PathBuf| self.vfs.absolute(path);
        let plain = |file, reason| Job { file, reason, args: options.args.clone(), preset: None };
        let entries = options.entries.iter().map(|path| plain(absolute(path), Reason::Root));
        let mut jobs: Vec<Job> = entries.collect();
        let mut named = Vec::new();
        let mut walked = Vec::new();
        for path in options.paths.iter().map(absolute) {
            match self.vfs.is_dir(&path) {
                true => walked.extend(walk::descriptions(&path, self)),
                false => named.push(path),
            }
        }
        jobs.extend(self.configured(options, &named, &walked));
        let mut known: FastSet<PathBuf> = jobs.iter().map(|job| job.file.clone()).collect();
        let named = named.into_iter().map(|path| plain(path, Reason::Named));
        let walked = walked.into_iter().map(|path| plain(path, Reason::Walked));
        jobs.extend(named.chain(walked).filter(|job| known.insert(job.file.clone())));
        if let Some(change) = Change::of(self, options) {
            jobs.extend(change.further(&jobs, &options.args));
            jobs = change.reached(jobs);
        }
        for job in jobs.iter().filter(|job| job.reason != Reason::Walked) {
            if let Err(error) = self.vfs.document(&job.file) {
                report.unreadable.push(Unreadable { path: job.file.clone(), error });
            }
        }
        jobs.retain(|job| !report.unreadable.iter().any(|unreadable| unreadable.path == job.file));
        jobs
    }

    /// The jobs of `[[roots]]` that are among the files to be checked, or below a folder to be checked.
    fn configured(&self, options: &CheckOptions, named: &[PathBuf], walked: &[PathBuf]) -> Vec<Job> {
        let folders: Vec<PathBuf> = options.paths.iter().map(|path| self.vfs.absolute(path)).collect();
        let mut seen: FastSet<Vec<PathBuf>> = FastSet::default();
        let mut jobs = Vec::new();
        let own =
            folders.iter().filter(|path| self.vfs.is_dir(path)).map(|folder| self.folder_settings(folder));
        let settings = own.chain(named.iter().chain(walked).map(|file| self.settings(file)));
        for settings in settings {
            if !seen.insert(settings.config.files.clone()) {
                continue;
            }
            for root in &settings.config.roots {
                let mut files = root.files(&self.vfs);
                files.retain(|file| folders.iter().any(|folder| file.starts_with(folder)));
                jobs.extend(files.iter().flat_map(|file| Job::of_root(root, file, &options.args)));
            }
        }
        jobs
    }

    /// The folders whose files are the user's own: in files elsewhere, only errors are news.
    pub(super) fn homes(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let paths = options.paths.iter().chain(&options.entries).chain(&options.changed);
        let paths = paths.map(|path| self.vfs.absolute(path));
        let homes = paths.flat_map(|path| {
            let is_dir = self.vfs.is_dir(&path);
            let folder = if is_dir { Some(path.clone()) } else { path.parent().map(Path::to_owned) };
            let package = self.packages.containing(&path.join("_")).map(|package| package.folder);
            let workspace = folder.as_ref().and_then(|folder| self.packages.workspace(folder));
            [folder, package, workspace]
        });
        homes.flatten().collect()
    }

    /// What in the configurations read so far has no effect.
    fn config_findings(&self) -> Vec<Finding> {
        let warnings = self.config_warnings();
        // what is wrong in the settings of an editor has no place in a file
        let in_files = warnings.iter().filter(|warning| !warning.place.path.as_os_str().is_empty());
        in_files.map(|w| invalid_config(self.vfs.file_id(&w.place.path), w)).collect()
    }

    /// Whether a finding is wanted; sets its severity as configured.
    fn admit(&self, finding: &mut Finding, homes: &[PathBuf]) -> bool {
        let path = self.vfs.path(finding.span.file);
        let Some(severity) = self.settings(&path).severity(finding, &path) else { return false };
        finding.severity = severity;
        // what `$(find)` made absolute is shown as the user would write it
        let cwd = format!("{}/", self.env.cwd.display());
        let related = finding.related.iter_mut().map(|related| &mut related.message);
        for text in std::iter::once(&mut finding.message).chain(&mut finding.help).chain(related) {
            if text.contains(&cwd) {
                *text = text.replace(&cwd, "");
            }
            shorten(text);
        }
        let is_config = finding.rule.code == "LNT004";
        severity == Severity::Error || is_config || homes.iter().any(|home| path.starts_with(home))
    }
}

/// Names can be as long as files and hold line ends: what a message shows of them has a bound and stands in one
/// line, so that it is never taken for a line of its own by whoever reads a log.
fn shorten(message: &mut String) {
    if message.contains(['\n', '\r']) {
        *message = message.split(['\n', '\r']).map(str::trim).collect::<Vec<_>>().join(" ");
    }
    if message.len() > MESSAGE_LETTERS {
        message.truncate(message.floor_char_boundary(MESSAGE_LETTERS));
        message.push('…');
    }
}
