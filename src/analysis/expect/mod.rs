//! Tests of robots: every configured root under each combination of its arguments, compared with what the
//! configuration expects of it.

mod case;
mod evaluate;
mod snapshot;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;

use self::case::{Case, Ran};
pub(super) use self::evaluate::filled;
use self::snapshot::Snapshot;
pub(super) use self::snapshot::{entry_at, worded};
use super::options::CheckOptions;
use super::report::{Report, Unreadable};
use super::root_config::RootConfig;
use super::session::Session;
use super::threads::map_all;
use base::limits::MATRIX_RUNS;
use base::{FastMap, FastSet, Span};
use rules::{Activation, Category, Check, Finding, Rule, Severity};
use workspace::config::{Axes, ConfigLocation, ConfigWarning};

/// What failed expectations are reported as. It is in no list of rules: nothing selects it.
static RULE: Rule = Rule {
    code: "",
    name: "expectation",
    category: Category::Linter,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: "",
    check: Check::Analysis,
};

/// What to test, and how.
#[derive(Clone, Debug, Default)]
pub struct TestOptions {
    /// The files and folders whose configured roots are tested.
    pub check: CheckOptions,
    /// Only tests whose names contain this.
    pub filter: Option<String>,
    /// Whether the files of `expands-to` are made instead of compared.
    pub update: bool,
}

/// One robot that was tested.
#[derive(Clone, Debug)]
pub struct TestCase {
    /// The root with its arguments; for an expectation that applies to no robot, the configuration file.
    pub root: RootConfig,
    /// How many expectations apply to it.
    pub expectations: usize,
    /// What failed: numbers of findings of the report.
    pub failures: Range<usize>,
}

/// A snapshot that has to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Update {
    /// The file.
    pub path: PathBuf,
    /// What it is to hold.
    pub text: String,
    /// Whether it is there, with other content.
    pub exists: bool,
}

/// The result of a run of tests.
#[derive(Debug, Default)]
pub struct Tests {
    /// The tests, in the order of the configuration.
    pub cases: Vec<TestCase>,
    /// The findings of all tests, with the files they are in.
    pub report: Report,
    /// How many tests the filter left out.
    pub left_out: usize,
    /// What in the configurations keeps tests from running.
    pub invalid: Vec<ConfigWarning>,
    /// Snapshots that differ from the robots, when these are to be updated; sorted by path.
    pub updates: Vec<Update>,
}

impl Session {
    /// Test the configured roots among files and below folders.
    pub fn test(&self, options: &TestOptions) -> Tests {
        let _held = self.vfs.freeze();
        let mut tests = Tests::default();
        let cases = self.cases(&options.check, &mut tests);
        if !tests.invalid.is_empty() {
            return tests;
        }
        let all = cases.len();
        let is_wanted = |case: &&Case| {
            let part = options.filter.as_ref();
            part.is_none_or(|part| self.test_name(&case.root).contains(part.as_str()))
        };
        let chosen: Vec<&Case> = cases.iter().filter(is_wanted).collect();
        tests.left_out = all - chosen.len();
        options.check.progress.begin(chosen.len());
        let mut ran = self.run_cases(chosen, options);
        if options.update {
            tests.updates = self.updates(&mut ran);
        }
        if options.filter.is_none() {
            ran.extend(self.never_applied(&cases, &ran));
        }
        self.gather(ran, &mut tests);
        tests
    }

    /// The name of a test: the path of the root and its arguments.
    pub fn test_name(&self, root: &RootConfig) -> String {
        let path = root.file.strip_prefix(&self.env.cwd).unwrap_or(&root.file);
        super::contexts::label(vfs::slashed(path), &root.args)
    }

    /// The cases of all configured roots. What is wrong in the configurations is noted.
    fn cases(&self, options: &CheckOptions, tests: &mut Tests) -> Vec<Case> {
        let mut report = Report::default();
        let (named, walked) = self.named_and_walked(options, &mut report);
        for path in &named {
            if let Err(error) = self.vfs.text(path) {
                report.unreadable.push(Unreadable {
                    path: path.clone(),
                    error,
                });
            }
        }
        let mut cases = Vec::new();
        let mut invalid: Vec<ConfigWarning> = Vec::new();
        for (settings, number, files) in self.configured_files(options, &named, &walked) {
            let Some(root) = settings.config.roots.get(number) else {
                continue;
            };
            if root.files(&self.vfs).is_empty() {
                invalid.push(warning(
                    &root.place,
                    format!("no file matches `{}`", root.file),
                ));
            }
            for file in files {
                let choices = self.choices(root, &file);
                let count = root.combinations(&choices);
                if root.launch_choices && count > MATRIX_RUNS as u64 {
                    let message = format!(
                        "{count} combinations of arguments with those of launch files; only {MATRIX_RUNS} are used"
                    );
                    invalid.push(warning(&root.place, message));
                }
                let variants = self.variants(root, &file).into_iter();
                let args = |args: Vec<(String, String)>| {
                    args.into_iter().chain(options.args.iter().cloned())
                };
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
        tests.invalid = self.config_warnings();
        tests.invalid.extend(invalid);
        report.unreadable.extend(
            self.unreadable_configs()
                .into_iter()
                .map(|error| Unreadable {
                    path: error.path.clone(),
                    error,
                }),
        );
        tests.report = report;
        cases
    }

    fn run_cases(&self, cases: Vec<&Case>, options: &TestOptions) -> Vec<Ran> {
        map_all(cases, |case| {
            let ran = case.run(self, options);
            options.check.progress.step();
            ran
        })
    }

    /// Expectations that apply to none of the robots they are made for: a value in `when` is probably wrong.
    fn never_applied(&self, cases: &[Case], ran: &[Ran]) -> Vec<Ran> {
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
        places.retain(|(place, _)| {
            applied.get(&(place.path.clone(), place.range.start)) == Some(&false)
        });
        let unused = places.into_iter().map(|(place, when)| {
            let args: Vec<String> = when
                .iter()
                .map(|(name, values)| format!("{name}:={}", values.join("|")))
                .collect();
            let message = format!("no robot has the arguments `{}`", args.join(" "));
            let mut finding = Finding::new(&RULE, self.span_of_place(place), message);
            finding.help =
                Some("correct `when`, or add the values to `args` of the root".to_owned());
            Ran {
                root: RootConfig::plain(&place.path),
                findings: vec![finding],
                applied: vec![0],
                ..Ran::default()
            }
        });
        unused.collect()
    }

    fn span_of_place(&self, place: &ConfigLocation) -> Span {
        Span {
            file: self.vfs.file_id(&place.path),
            range: place.range,
        }
    }

    /// Snapshots to be written. One that several different robots are to have is a failure of these.
    fn updates(&self, ran: &mut [Ran]) -> Vec<Update> {
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
            let old = self.vfs.text(&snapshot.path);
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
    fn gather(&self, ran: Vec<Ran>, tests: &mut Tests) {
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
        self.conceal(report, &mut findings);
        report.findings = findings;
        for finding in &report.findings {
            let related = finding.related.iter().map(|related| related.span.file);
            let files = related.chain([finding.span.file]);
            report
                .paths
                .extend(files.map(|file| (file, self.vfs.path(file))));
        }
        report.read_beside(&self.vfs);
    }
}

fn warning(place: &ConfigLocation, message: String) -> ConfigWarning {
    ConfigWarning {
        place: place.clone(),
        message,
        nearest: None,
    }
}
