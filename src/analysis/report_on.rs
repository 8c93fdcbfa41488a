//! What an editor shows of files: one report, each file under its active root.
use std::path::PathBuf;
use std::sync::Arc;

use super::beside::shown_beside_findings;
use super::check::build_report;
use super::context::{configured_contexts, context, is_configured};
use super::host::AnalysisHost;
use super::launch_findings::shown_launch_findings;
use super::named::{keep_meshes, notice_meshes};
use super::options::CheckOptions;
use super::report::Report;
use super::root_config::RootConfig;
use super::root_result::RootResult;
use super::{placing, walk};
use base::CancelFlag;
use rules::check_recovered;

/// What there is to say about files, each under its active root. `None` when cancelled.
pub fn report_on(
    host: &mut AnalysisHost,
    paths: &[PathBuf],
    cancel: &CancelFlag,
) -> Option<Report> {
    // one answer rests on one state of the disk, which is asked once about each file
    let vfs = Arc::clone(&host.session().vfs);
    let _held = vfs.freeze();
    notice_meshes(host);
    let mut roots: Vec<RootConfig> = Vec::new();
    let mut own: Vec<RootConfig> = Vec::new();
    let asked = paths;
    let paths: Vec<&PathBuf> = paths
        .iter()
        .filter(|path| !walk::is_something_else(path))
        .collect();
    for path in &paths {
        let root = context(host, path)
            .root
            .unwrap_or_else(|| RootConfig::plain(path));
        own.push(root.clone());
        if !roots.contains(&root) {
            roots.push(root);
        }
    }
    if host.has_all_contexts() {
        let further = configured_contexts(host, &paths);
        roots.extend(further.into_iter().filter(|root| !own.contains(root)));
    }
    let mut results = Vec::new();
    for root in &roots {
        let is_context = host.has_all_contexts() || is_configured(host.session(), root);
        let analyzed = host.analyzed(root, cancel)?;
        let mut result = analyzed.result(host.session(), cancel)?.clone();
        result
            .findings
            .extend(check_recovered(&analyzed.expansion, &host.session().vfs));
        results.push(RootResult {
            is_context,
            ..result
        });
    }
    keep_meshes(host);
    let entries: Vec<PathBuf> = paths.iter().map(|path| (*path).clone()).collect();
    let mut beside = shown_beside_findings(host, asked, &roots, cancel)?;
    let robots: Vec<PathBuf> = roots.into_iter().map(|root| root.file).collect();
    beside.findings.extend(shown_launch_findings(
        host.session(),
        &robots,
        asked,
        cancel,
    ));
    let mut report = build_report(
        host.session(),
        &check_options(host, &entries),
        results,
        beside,
    );
    placing::place(&mut report, &host.session().vfs, |path| host.is_open(path));
    Some(report)
}

/// What a check of these files is about.
fn check_options(host: &AnalysisHost, paths: &[PathBuf]) -> CheckOptions {
    CheckOptions {
        paths: host.folders().to_vec(),
        entries: paths.to_vec(),
        ..CheckOptions::default()
    }
}
