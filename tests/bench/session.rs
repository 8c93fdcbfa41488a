//! What a language server does with a large robot: the first check, a letter typed in a macro that everything calls,
//! a letter typed in one call, completion and hover. Each also says what it allocates.
//!
//! `first_look` is what the author waits for, `whole_check` what follows when no further key is pressed.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::disallowed_methods
)] // benches may fail loudly

mod large;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use divan::{AllocProfiler, Bencher, black_box};
use large::robot;
use xacro_lsp::analysis::{self, AnalysisHost, RootConfig};
use xacro_lsp::base::{CancelFlag, TextRange};
use xacro_lsp::ide::{self, CompletionScope, CompletionSources, Cx};
use xacro_lsp::vfs::Environment;

#[global_allocator]
static ALLOCATIONS: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

/// Calls of one macro; each gives a link and a joint in four lines.
const CALLS: [usize; 3] = [50, 500, 5000];

/// A session with one open robot, checked once.
struct Session {
    host: AnalysisHost,
    path: PathBuf,
    text: String,
    /// Whether the extra letter stands in the text.
    typed: bool,
}

impl Session {
    fn open(calls: usize) -> Self {
        let folder = Path::new("/nowhere");
        let env = Environment {
            vars: BTreeMap::new(),
            cwd: folder.to_owned(),
            ..Environment::default()
        };
        let (mut host, path, text) = (
            AnalysisHost::new(env, Vec::new()),
            folder.join("bench.xacro"),
            robot(calls),
        );
        host.set_text(&path, text.clone());
        let mut session = Self {
            host,
            path,
            text,
            typed: false,
        };
        session.check();
        session
    }

    fn check(&mut self) -> usize {
        let report = analysis::report_on(
            &mut self.host,
            std::slice::from_ref(&self.path),
            &CancelFlag::default(),
        );
        report.unwrap().findings.len()
    }

    /// Type a letter behind the first `name`, or take it back.
    fn toggle(&mut self, name: &str) {
        let at = (self.text.find(name).unwrap() + name.len()) as u32;
        let (end, letter) = if self.typed { (at + 1, "") } else { (at, "x") };
        self.typed = !self.typed;
        self.host.edit(&self.path, TextRange::new(at, end), letter);
    }
}

#[divan::bench(args = CALLS, sample_count = 10)]
fn open(bencher: Bencher<'_, '_>, calls: usize) {
    bencher.bench_local(|| Session::open(black_box(calls)));
}

#[divan::bench(args = CALLS, sample_count = 10)]
fn check_of_an_edit_in_the_macro(bencher: Bencher<'_, '_>, calls: usize) {
    let mut session = Session::open(calls);
    bencher.bench_local(move || {
        session.toggle("${base_mass");
        session.check()
    });
}

#[divan::bench(args = CALLS, sample_count = 10)]
fn check_of_an_edit_in_a_call(bencher: Bencher<'_, '_>, calls: usize) {
    let mut session = Session::open(calls);
    bencher.bench_local(move || {
        session.toggle("name=\"s7");
        session.check()
    });
}

#[divan::bench(args = CALLS)]
fn completion(bencher: Bencher<'_, '_>, calls: usize) {
    let mut session = Session::open(calls);
    let root = RootConfig::plain(&session.path);
    let analyzed = session
        .host
        .analyzed(&root, &CancelFlag::default())
        .unwrap();
    let source = session.host.document(&session.path).unwrap();
    let offset = session.text.find("base_mass *").unwrap() as u32 + 4;
    bencher.bench_local(|| {
        let expansions = [(&analyzed.expansion, analyzed.robot.as_ref())];
        let scope = CompletionScope::new(CompletionSources {
            source: &source,
            root: &root.file,
            expansions: &expansions,
            vfs: &session.host.session().vfs,
            packages: &session.host.session().packages,
            folders: &[],
            described: &[],
            roots: &[],
        });
        ide::completions(&scope, black_box(offset), None)
            .items
            .len()
    });
}

#[divan::bench(args = CALLS)]
fn hover(bencher: Bencher<'_, '_>, calls: usize) {
    let mut session = Session::open(calls);
    let root = RootConfig::plain(&session.path);
    let analyzed = session
        .host
        .analyzed(&root, &CancelFlag::default())
        .unwrap();
    let source = session.host.document(&session.path).unwrap();
    let settings = session.host.session().settings(&session.path);
    let offset = session.text.find("base_mass *").unwrap() as u32 + 4;
    bencher.bench_local(|| {
        let cx = Cx {
            source: &source,
            expansion: &analyzed.expansion,
            robot: analyzed.robot.as_ref(),
            kinematics: analyzed.kinematics(),
            beside: &[],
            selected_frame: None,
        };
        let around = session.host.session().rule_env(&settings.config);
        let names = || ide::TextNames::of(&analyzed.expansion, around);
        ide::hover(&cx, around, names, black_box(offset)).is_some()
    });
}
