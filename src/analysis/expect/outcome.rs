//! What is tested, and what came out.
use std::ops::Range;
use std::path::PathBuf;

use super::super::options::CheckOptions;
use super::super::report::Report;
use super::super::root_config::{RootConfig, label};
use super::super::session::Session;
use base::Span;
use rules::{Activation, Category, Check, Rule, Severity};
use vfs::Vfs;
use workspace::config::{ConfigLocation, ConfigWarning};

/// What failed expectations are reported as. It is in no list of rules: nothing selects it.
pub(super) static RULE: Rule = Rule {
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

/// The name of a test: the path of the root and its arguments.
pub fn test_name(session: &Session, root: &RootConfig) -> String {
    let path = root
        .file
        .strip_prefix(&session.env.cwd)
        .unwrap_or(&root.file);
    label(vfs::slashed(path), &root.args)
}

/// Where a place of a configuration is.
pub(super) fn span_of_place(vfs: &Vfs, place: &ConfigLocation) -> Span {
    Span {
        file: vfs.file_id(&place.path),
        range: place.range,
    }
}
