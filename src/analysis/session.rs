//! Checking files and folders.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use globset::Glob;
use rayon::prelude::*;

use super::includes;
use super::job::{self, Outcome};
use super::merge::{merge, once_per_package};
use super::report::{Report, Unreadable};
use super::roots::{Job, Reason, RootSpec};
use super::walk;
use crate::base::{CancelFlag, FastSet};
use crate::expand::Limits;
use crate::rules::{Finding, PackageWorld, Selection};
use crate::vfs::{Environment, Vfs};
use crate::workspace::{PackageOptions, Packages, workspace_root};

/// Files, packages and environment that checks share.
pub struct Session {
    /// Files.
    pub vfs: Arc<Vfs>,
    /// `$(find)` and `package://`.
    pub packages: Packages,
    /// Variables and working directory.
    pub env: Environment,
}

/// What to check, and how.
#[derive(Clone, Debug, Default)]
pub struct CheckOptions {
    /// Files and folders.
    pub paths: Vec<PathBuf>,
    /// Files that are robots, whatever their content looks like.
    pub entries: Vec<PathBuf>,
    /// Configured roots.
    pub roots: Vec<RootSpec>,
    /// Arguments of every expansion, over those of the roots.
    pub args: Vec<(String, String)>,
    /// Globs of files that are not checked.
    pub exclude: Vec<String>,
    /// Budgets of each expansion.
    pub limits: Limits,
    /// Set to stop early.
    pub cancel: CancelFlag,
}

impl Session {
    /// A session that sees the world from `env`; files above `max_file_bytes` are not read.
    pub fn new(env: &Environment, max_file_bytes: u64, packages: PackageOptions) -> Self {
        let vfs = Arc::new(Vfs::with_cwd(max_file_bytes, env.cwd.clone()));
        let packages = Packages::new(vfs.clone(), env, packages);
        Self { vfs, packages, env: env.clone() }
    }

    /// Where rules look for packages.
    pub(super) fn package_world(&self) -> PackageWorld<'_> {
        let variables = ["AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "ROS_PACKAGE_PATH"];
        let sourced = variables.iter().any(|name| self.env.var(name).is_some_and(|value| !value.is_empty()));
        let has_ros = sourced || self.vfs.is_dir(Path::new("/opt/ros"));
        PackageWorld { packages: &self.packages, has_ros }
    }

    /// Check files and folders. `selection` says for each file which rules run.
    pub fn check(
        &self,
        options: &CheckOptions,
        selection: &(dyn Fn(&Path) -> Arc<Selection> + Sync),
    ) -> Report {
        let mut report = Report::default();
        let jobs = self.jobs(options, &mut report);
        let outcomes: Vec<Outcome> = jobs.into_par_iter().map(|job| job::run(self, options, job)).collect();
        let kept = self.keep(outcomes);
        for outcome in &kept {
            report.roots.push(outcome.job.file.clone());
            report.robots += usize::from(outcome.is_robot);
            report.files.extend(outcome.files.iter().map(|file| (file.id, file.clone())));
        }
        let homes = self.homes(options);
        let mut findings = merge(kept);
        findings.retain_mut(|finding| self.admit(finding, &homes, selection));
        findings.sort_by_cached_key(|f| (self.vfs.path(f.span.file), f.span.range.start, f.rule.code));
        once_per_package(&mut findings, |file| Some(self.packages.containing(&self.vfs.path(file))?.folder));
        for finding in &findings {
            let spans =
                std::iter::once(finding.span).chain(finding.related.iter().map(|related| related.span));
            report.paths.extend(spans.map(|span| (span.file, self.vfs.path(span.file))));
        }
        report.findings = findings;
        report
    }

    /// The files that [`check`](Self::check) would look at, sorted; what they include comes on top.
    pub fn files(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let jobs = self.jobs(options, &mut Report::default());
        let files: std::collections::BTreeSet<PathBuf> = jobs.into_iter().map(|job| job.file).collect();
        files.into_iter().collect()
    }

    fn jobs(&self, options: &CheckOptions, report: &mut Report) -> Vec<Job> {
        let absolute = |path: &PathBuf| self.vfs.absolute(path);
        let mut jobs: Vec<Job> = Vec::new();
        let plain = |file, reason| Job { file, reason, args: options.args.clone(), preset: None };
        jobs.extend(options.entries.iter().map(|path| plain(absolute(path), Reason::Root)));
        let mut walked = Vec::new();
        for path in options.paths.iter().map(absolute) {
            if self.vfs.is_dir(&path) {
                walked.extend(walk::descriptions(&path, &options.exclude));
            } else {
                jobs.push(plain(path, Reason::Named));
            }
        }
        jobs.extend(self.configured(options, &walked));
        let mut known: FastSet<PathBuf> = jobs.iter().map(|job| job.file.clone()).collect();
        let walked = walked.into_iter().filter(|path| known.insert(path.clone()));
        jobs.extend(walked.map(|path| plain(path, Reason::Walked)));
        for job in jobs.iter().filter(|job| job.reason != Reason::Walked) {
            if let Err(error) = self.vfs.document(&job.file) {
                report.unreadable.push(Unreadable { path: job.file.clone(), error });
            }
        }
        jobs.retain(|job| !report.unreadable.iter().any(|unreadable| unreadable.path == job.file));
        jobs
    }

    /// The jobs of `[[roots]]`: those that name a file, and those whose glob fits a file that was found.
    fn configured(&self, options: &CheckOptions, walked: &[PathBuf]) -> Vec<Job> {
        let mut jobs = Vec::new();
        for root in &options.roots {
            let literal = PathBuf::from(&root.file);
            let files = match Glob::new(&root.file) {
                Ok(glob) if crate::vfs::has_magic(&root.file) => {
                    let glob = glob.compile_matcher();
                    walked.iter().filter(|path| glob.is_match(path)).cloned().collect()
                }
                _ => vec![literal],
            };
            jobs.extend(files.into_iter().flat_map(|file| root.jobs(file, &options.args)));
        }
        jobs
    }

    /// Drop what another expansion covers, and what cannot be judged without the file that includes it.
    fn keep(&self, outcomes: Vec<Outcome>) -> Vec<Outcome> {
        let included = self.statically_included(&outcomes);
        let (mut kept, mut others): (Vec<Outcome>, Vec<Outcome>) =
            outcomes.into_iter().partition(|outcome| outcome.job.reason != Reason::Walked);
        let mut covered: FastSet<u128> = FastSet::default();
        let identities = |outcome: &Outcome| -> Vec<u128> {
            outcome.reads.iter().filter_map(|path| self.vfs.identity(path)).collect()
        };
        let robots = others.iter().chain(&kept).filter(|outcome| outcome.is_robot);
        covered.extend(robots.flat_map(identities));
        // robots first: what they include needs no look of its own
        others.sort_by_key(|outcome| !outcome.is_robot);
        for mut outcome in others {
            let own = self.vfs.identity(&outcome.job.file).unwrap_or_default();
            if covered.contains(&own) {
                continue;
            }
            if !outcome.is_robot {
                covered.extend(identities(&outcome));
                if included.contains(&own) {
                    outcome.findings.retain(|finding| !needs_includer(finding));
                }
            }
            kept.push(outcome);
        }
        kept
    }

    /// The files that another file may include, by what its text says.
    fn statically_included(&self, outcomes: &[Outcome]) -> FastSet<u128> {
        let patterns: Vec<_> = outcomes
            .par_iter()
            .filter_map(|outcome| outcome.files.first())
            .map(|file| (file.path.clone(), includes::patterns(file, &self.packages)))
            .collect();
        let files = outcomes.iter().map(|outcome| &outcome.job.file).filter(|file| {
            let from_other = patterns.iter().filter(|(from, _)| **from != ***file);
            from_other.flat_map(|(_, patterns)| patterns).any(|pattern| pattern.is_match(file))
        });
        files.filter_map(|file| self.vfs.identity(file)).collect()
    }

    /// The folders whose files are the user's own: in files elsewhere, only errors are news.
    fn homes(&self, options: &CheckOptions) -> Vec<PathBuf> {
        let home = self.env.var("HOME").map(Path::new);
        let paths = options.paths.iter().chain(&options.entries).map(|path| self.vfs.absolute(path));
        let homes = paths.flat_map(|path| {
            let folder =
                if self.vfs.is_dir(&path) { Some(path.clone()) } else { path.parent().map(Path::to_owned) };
            let package = self.packages.containing(&path.join("_")).map(|package| package.folder);
            let workspace = folder.as_ref().and_then(|folder| workspace_root(&self.vfs, folder, home));
            [folder, package, workspace]
        });
        homes.flatten().collect()
    }

    /// Whether a finding is wanted; sets its severity as configured.
    fn admit(
        &self,
        finding: &mut Finding,
        homes: &[PathBuf],
        selection: &(dyn Fn(&Path) -> Arc<Selection> + Sync),
    ) -> bool {
        let path = self.vfs.path(finding.span.file);
        let Some(severity) = selection(&path).severity(finding) else { return false };
        finding.severity = severity;
        // what `$(find)` made absolute is shown as the user would write it
        let cwd = format!("{}/", self.env.cwd.display());
        if finding.message.contains(&cwd) {
            finding.message = finding.message.replace(&cwd, "");
        }
        severity == crate::rules::Severity::Error || homes.iter().any(|home| path.starts_with(home))
    }
}

/// Whether a finding may be wrong as long as the file that includes this one is not known.
fn needs_includer(finding: &Finding) -> bool {
    ["XAC001", "XAC002", "XAC003", "XAC004", "XAC005", "XAC025", "XAC027"].contains(&finding.rule.code)
}
