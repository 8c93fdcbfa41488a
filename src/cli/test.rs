//! `xacro-lint test`.

use std::path::Path;

use indexmap::IndexMap;
use serde_json::{Value, json};

use super::args::{TestArgs, TestFormat};
use super::io::Io;
use super::progress::watched;
use super::render::{shown_path, visible, visible_name};
use super::services::quoted;
use super::text::{counted, drawings};
use analysis::{CheckOptions, Overrides, Report, Session, Setup, TestCase, TestOptions, Tests};
use base::Span;
use base::limits::DRAWN_PROBLEMS;
use rules::Finding;
use vfs::{Environment, write_atomically};

/// Tests that are named with a failure that they share.
const NAMED: usize = 3;

/// Test the configured roots; the exit code is that of `check`.
pub(super) fn run(args: &TestArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let paths = if args.paths.is_empty() {
        vec![".".into()]
    } else {
        args.paths.clone()
    };
    let setup = Setup {
        about: paths.first().cloned().unwrap_or_default(),
        package_path: args.package_path.iter().map(Into::into).collect(),
        overrides: Overrides {
            config: args.config.clone(),
            ..Overrides::default()
        },
        folders: paths.iter().map(|path| env.cwd.join(path)).collect(),
    };
    let session = match Session::new(env, setup) {
        Ok(session) => session,
        Err(error) => {
            return failed(
                io,
                &format!("{}: {}", vfs::slashed(&error.path), error.reason()),
            );
        }
    };
    let options = TestOptions {
        check: CheckOptions {
            paths,
            ..CheckOptions::default()
        },
        filter: args.filter.clone(),
        update: args.update,
    };
    let tests = watched(io, &options.check.progress, || {
        analysis::test(&session, &options)
    });
    let code = Runner {
        args,
        session: &session,
        tests: &tests,
        env,
    }
    .finish(io);
    // the process ends after this: it need not take everything apart first
    std::mem::forget((session, tests));
    code
}

fn failed(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", visible(message)));
    2
}

struct Runner<'a> {
    args: &'a TestArgs,
    session: &'a Session,
    tests: &'a Tests,
    env: &'a Environment,
}

impl Runner<'_> {
    fn finish(&self, io: &mut Io<'_>) -> u8 {
        let code = self.preconditions(io);
        if code > 0 {
            return code;
        }
        match self.args.format {
            TestFormat::Text => self.text(io),
            TestFormat::Json => io.out(&format!("{:#}\n", self.json())),
            TestFormat::Junit => io.out(&self.junit()),
        }
        let written = self.write_updates(io);
        let fails = self
            .tests
            .cases
            .iter()
            .any(|case| !case.failures.is_empty());
        if written > 0 {
            written
        } else {
            u8::from(fails)
        }
    }

    /// What keeps tests from running: a test that does not run must not look like one that passes.
    fn preconditions(&self, io: &mut Io<'_>) -> u8 {
        let mut code = 0;
        for unreadable in &self.tests.report.unreadable {
            let path = self.shown(&unreadable.path);
            code = failed(io, &format!("{path}: {}", unreadable.error.reason()));
        }
        let prefix = format!("{}/", vfs::slashed(&self.env.cwd));
        for warning in &self.tests.invalid {
            code = failed(io, &warning.to_string().replace(&prefix, ""));
        }
        if code == 0 && self.tests.cases.is_empty() {
            let message = match (self.tests.left_out, &self.args.filter) {
                (1.., Some(filter)) => format!("no test contains `{filter}`"),
                _ => "no robots to test; add `[[roots]]` to xacro-lint.toml".to_owned(),
            };
            code = failed(io, &message);
        }
        code
    }

    fn shown(&self, path: &Path) -> String {
        shown_path(path, &self.env.cwd)
    }

    fn name(&self, case: &TestCase) -> String {
        analysis::test_name(self.session, &case.root)
    }

    fn failures(&self, case: &TestCase) -> &[Finding] {
        self.tests
            .report
            .findings
            .get(case.failures.clone())
            .unwrap_or_default()
    }

    // Text.

    fn text(&self, io: &mut Io<'_>) {
        for case in &self.tests.cases {
            let word = match (case.failures.is_empty(), io.color_out) {
                (true, true) => "\u{1b}[32mPASS\u{1b}[0m",
                (true, false) => "PASS",
                (false, true) => "\u{1b}[31mFAIL\u{1b}[0m",
                (false, false) => "FAIL",
            };
            io.out(&format!("{word}  {}\n", visible_name(&self.name(case))));
        }
        self.draw(io);
        io.out(&format!("\n{}\n", self.summary()));
    }

    /// Each different failure once, with the tests that have it.
    fn draw(&self, io: &mut Io<'_>) {
        let mut first: IndexMap<(Span, &str), (usize, Vec<usize>)> = IndexMap::new();
        for (number, case) in self.tests.cases.iter().enumerate() {
            for finding in case.failures.clone() {
                let Some(found) = self.tests.report.findings.get(finding) else {
                    continue;
                };
                let entry = first
                    .entry((found.span, &found.message))
                    .or_insert((finding, Vec::new()));
                entry.1.push(number);
            }
        }
        let (report, packages) = (&self.tests.report, &self.session.packages);
        let kept = first
            .values()
            .take(DRAWN_PROBLEMS)
            .filter_map(|(finding, _)| report.findings.get(*finding));
        let drawn = drawings(kept, report, packages, &self.env.cwd, io.color_out);
        for (drawing, (_, cases)) in drawn.iter().zip(first.values()) {
            io.out(&format!(
                "\n{drawing}\n{}\n",
                visible_name(&self.in_tests(cases))
            ));
        }
        if first.len() > drawn.len() {
            io.out(&format!(
                "\n{} not shown\n",
                counted(first.len() - drawn.len(), "more failure")
            ));
        }
    }

    /// `in 5 tests: a, b, c and 2 more`
    fn in_tests(&self, cases: &[usize]) -> String {
        let names = cases
            .iter()
            .take(NAMED)
            .filter_map(|&number| self.tests.cases.get(number));
        let names: Vec<String> = names.map(|case| format!("`{}`", self.name(case))).collect();
        let more = cases.len().saturating_sub(NAMED);
        let more = if more > 0 {
            format!(" and {more} more")
        } else {
            String::new()
        };
        format!(
            "in {}: {}{more}",
            counted(cases.len(), "test"),
            names.join(", ")
        )
    }

    fn summary(&self) -> String {
        let failing = self
            .tests
            .cases
            .iter()
            .filter(|case| !case.failures.is_empty())
            .count();
        let passing = self.tests.cases.len() - failing;
        let expectations = self.tests.cases.iter().map(|case| case.expectations).sum();
        let left_out = match self.tests.left_out {
            0 => String::new(),
            count => format!(", {count} left out by the filter"),
        };
        let expectations = counted(expectations, "expectation");
        format!("{passing} passed, {failing} failed{left_out} ({expectations} checked)")
    }

    // For programs.

    fn json(&self) -> Value {
        let case = |case: &TestCase| {
            let args: Vec<Value> = case
                .root
                .args
                .iter()
                .map(|(name, value)| json!({"name": name, "value": value}))
                .collect();
            let failures = self.failures(case).iter();
            json!({
                "name": self.name(case),
                "file": self.shown(&case.root.file),
                "preset": case.root.preset,
                "arguments": args,
                "passed": case.failures.is_empty(),
                "expectations": case.expectations,
                "failures": failures.map(|found| analysis::finding_to_json(&self.tests.report, found, &self.env.cwd)).collect::<Value>(),
            })
        };
        self.tests.cases.iter().map(case).collect()
    }

    /// A suite for each root, a test for each set of arguments.
    fn junit(&self) -> String {
        let mut suites: IndexMap<String, Vec<&TestCase>> = IndexMap::new();
        for case in &self.tests.cases {
            suites
                .entry(self.shown(&case.root.file))
                .or_default()
                .push(case);
        }
        let all: Vec<&TestCase> = self.tests.cases.iter().collect();
        let mut out = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <testsuites name=\"xacro-lint test\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
            all.len(),
            failing(&all)
        );
        for (path, cases) in &suites {
            let path = quoted(path);
            let (tests, failures) = (cases.len(), failing(cases));
            out.push_str(&format!(
                "  <testsuite name=\"{path}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"0\">\n"
            ));
            cases
                .iter()
                .for_each(|case| out.push_str(&self.testcase(case, &path)));
            out.push_str("  </testsuite>\n");
        }
        out.push_str("</testsuites>\n");
        out
    }

    fn testcase(&self, case: &TestCase, path: &str) -> String {
        let name = quoted(&self.name(case));
        let head = format!("    <testcase classname=\"{path}\" name=\"{name}\" file=\"{path}\"");
        let failures = self.failures(case);
        if failures.is_empty() {
            return format!("{head}/>\n");
        }
        let failures = failures.iter().map(|found| {
            let message = quoted(&found.message);
            let text = quoted(&self.located(&self.tests.report, found));
            format!(
                "      <failure type=\"{}\" message=\"{message}\">{text}</failure>\n",
                found.rule.name
            )
        });
        format!("{head}>\n{}    </testcase>\n", failures.collect::<String>())
    }

    /// `file:row:column: message`
    fn located(&self, report: &Report, found: &Finding) -> String {
        let (row, column) = report.position(found.span).start;
        format!(
            "{}:{row}:{column}: {}",
            self.shown(report.path(found.span.file)),
            found.message
        )
    }

    // Snapshots.

    /// Write the snapshots that differ; the exit code.
    fn write_updates(&self, io: &mut Io<'_>) -> u8 {
        let mut code = 0;
        for update in &self.tests.updates {
            let path = visible_name(&self.shown(&update.path));
            match write_atomically(&update.path, update.text.as_bytes()) {
                Ok(()) => {
                    let verb = if update.exists { "updated" } else { "wrote" };
                    io.line(&format!("{verb} {path}"));
                }
                Err(error) => code = failed(io, &format!("cannot write {path}: {error}")),
            }
        }
        if self.args.update && self.tests.updates.is_empty() {
            io.line("nothing to update");
        }
        code
    }
}

fn failing(cases: &[&TestCase]) -> usize {
    cases
        .iter()
        .filter(|case| !case.failures.is_empty())
        .count()
}
