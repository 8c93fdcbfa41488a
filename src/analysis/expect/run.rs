//! A run of tests: which robots are tested, and one report of all that failed.
use std::collections::BTreeMap;
use std::path::PathBuf;

use super::super::check::conceal;
use super::super::options::CheckOptions;
use super::super::report::{Report, Unreadable};
use super::super::root_config::RootConfig;
use super::super::roots::{choices, variants};
use super::super::session::Session;
use super::super::task_list::{configured_files, named_and_walked};
use super::super::threads::map_all;
use super::case::{Case, Ran};
use super::outcome::{RULE, TestCase, TestOptions, Tests, Update, span_of_place, test_name};
use super::snapshot::Snapshot;
use base::limits::MATRIX_RUNS;
use base::{FastMap, FastSet};
use rules::Finding;
use workspace::config::{Axes, ConfigLocation, ConfigWarning};

/// Test the configured roots among files and below folders.
pub fn test(session: &Session, options: &TestOptions) -> Tests {
    let _held = session.vfs.freeze();
    let mut tests = Tests::default();
    let cases = cases(session, &options.check, &mut tests);
    if !tests.invalid.is_empty() {
        return tests;
    }
    let all = cases.len();
    let is_wanted = |case: &&Case| {
        let part = options.filter.as_ref();
        part.is_none_or(|part| test_name(session, &case.root).contains(part.as_str()))
    };
    let chosen: Vec<&Case> = cases.iter().filter(is_wanted).collect();
    tests.left_out = all - chosen.len();
    options.check.progress.begin(chosen.len());
    let mut ran = run_cases(session, chosen, options);
    if options.update {
        tests.updates = updates(session, &mut ran);
    }
    if options.filter.is_none() {
        ran.extend(never_applied(session, &cases, &ran));
    }
    gather(session, ran, &mut tests);
    tests
}

/// The cases of all configured roots. What is wrong in the configurations is noted.
fn cases(session: &Session, options: &CheckOptions, tests: &mut Tests) -> Vec<Case> {
    let mut report = Report::default();
    let (named, walked) = named_and_walked(session, options, &mut report);
    for path in &named {
        if let Err(error) = session.vfs.text(path) {
            report.unreadable.push(Unreadable {
                path: path.clone(),
                error,
            });
        }
    }
    let mut cases = Vec::new();
    let mut invalid: Vec<ConfigWarning> = Vec::new();
    for (settings, number, files) in configured_files(session, options, &named, &walked) {
        let Some(root) = settings.config.roots.get(number) else {
            continue;
        };
        if root.files(&session.vfs).is_empty() {
            invalid.push(warning(
                &root.place,
                format!("no file matches `{}`", root.file),
            ));
        }
        for file in files {
            let choices = choices(&session.callers, root, &file);
            let count = root.combinations(&choices);
            if root.launch_choices && count > MATRIX_RUNS as u64 {
                let message = format!(
                    "{count} combinations of arguments with those of launch files; only {MATRIX_RUNS} are used"
                );
                invalid.push(warning(&root.place, message));
            }
            let variants = variants(&session.callers, root, &file).into_iter();
            let args =
                |args: Vec<(String, String)>| args.into_iter().chain(options.args.iter().cloned());
            cases.extend(variants.map(|variant| Case {
                root: RootConfig {
                    file: file.clone(),
                    args: args(variant.args).collect(),
                    preset: variant.preset,
                },
                settings: settings.clone(),
                number,
            }));
        }
    }
    tests.invalid = session.config_warnings();
    tests.invalid.extend(invalid);
    report.unreadable.extend(
        session
            .unreadable_configs()
            .into_iter()
            .map(|error| Unreadable {
                path: error.path.clone(),
                error,
            }),
    );
    tests.report = report;
    cases
}

fn run_cases(session: &Session, cases: Vec<&Case>, options: &TestOptions) -> Vec<Ran> {
    map_all(cases, |case| {
        let ran = case.run(session, options);
        options.check.progress.step();
        ran
    })
}

/// Expectations that apply to none of the robots they are made for: a value in `when` is probably wrong.
fn never_applied(session: &Session, cases: &[Case], ran: &[Ran]) -> Vec<Ran> {
    let mut applied: FastMap<(PathBuf, u32), bool> = FastMap::default();
    let mut places: Vec<(&ConfigLocation, &Axes)> = Vec::new();
    for (case, ran) in cases.iter().zip(ran) {
        for (number, expected) in case.expectations().iter().enumerate() {
            let key = (expected.place.path.clone(), expected.place.range.start);
            let is_new = !applied.contains_key(&key);
            *applied.entry(key).or_default() |= ran.applied.contains(&number);
            if is_new {
                places.push((&expected.place, &expected.when));
            }
        }
    }
    places
        .retain(|(place, _)| applied.get(&(place.path.clone(), place.range.start)) == Some(&false));
    let unused = places.into_iter().map(|(place, when)| {
        let args: Vec<String> = when
            .iter()
            .map(|(name, values)| format!("{name}:={}", values.join("|")))
            .collect();
        let message = format!("no robot has the arguments `{}`", args.join(" "));
        let mut finding = Finding::new(&RULE, span_of_place(&session.vfs, place), message);
        finding.help = Some("correct `when`, or add the values to `args` of the root".to_owned());
        Ran {
            root: RootConfig::plain(&place.path),
            findings: vec![finding],
            applied: vec![0],
            ..Ran::default()
        }
    });
    unused.collect()
}

/// Snapshots to be written. One that several different robots are to have is a failure of these.
fn updates(session: &Session, ran: &mut [Ran]) -> Vec<Update> {
    let mut wanted: BTreeMap<PathBuf, Snapshot> = BTreeMap::new();
    let mut unclear: FastSet<PathBuf> = FastSet::default();
    for ran in ran.iter_mut() {
        for snapshot in std::mem::take(&mut ran.snapshots) {
            match wanted.get(&snapshot.path) {
                Some(known) if !known.is_same(&snapshot) => {
                    ran.findings.push(snapshot.conflict(&known.owner));
                    unclear.insert(snapshot.path);
                }
                Some(_) => {}
                None => drop(wanted.insert(snapshot.path.clone(), snapshot)),
            }
        }
    }
    wanted.retain(|path, _| !unclear.contains(path));
    let update = |snapshot: Snapshot| {
        let old = session.vfs.text(&snapshot.path);
        let is_current = old
            .as_ref()
            .is_ok_and(|old| snapshot.is_written_in(&old.text));
        let Snapshot { path, text, .. } = snapshot;
        (!is_current).then(|| Update {
            exists: old.is_ok(),
            path,
            text,
        })
    };
    wanted.into_values().filter_map(update).collect()
}

/// One report of all findings, in the order of the tests.
fn gather(session: &Session, ran: Vec<Ran>, tests: &mut Tests) {
    let report = &mut tests.report;
    let mut findings: Vec<Finding> = Vec::new();
    for mut ran in ran {
        let start = findings.len();
        report.roots.push(ran.root.file.clone());
        report
            .files
            .extend(ran.files.into_iter().map(|file| (file.id, file)));
        findings.append(&mut ran.findings);
        let failures = start..findings.len();
        tests.cases.push(TestCase {
            root: ran.root,
            expectations: ran.applied.len(),
            failures,
        });
    }
    report.roots.sort();
    report.roots.dedup();
    conceal(session, report, &mut findings);
    report.findings = findings;
    for finding in &report.findings {
        let related = finding.related.iter().map(|related| related.span.file);
        let files = related.chain([finding.span.file]);
        report
            .paths
            .extend(files.map(|file| (file, session.vfs.path(file))));
    }
    report.read_beside(&session.vfs);
}

fn warning(place: &ConfigLocation, message: String) -> ConfigWarning {
    ConfigWarning {
        place: place.clone(),
        message,
        nearest: None,
    }
}
