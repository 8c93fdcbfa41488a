//! What an expansion gave.
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

use ecow::EcoString;

use super::check_task::CheckTask;
use super::cut::Cut;
use base::{FastSet, FileId, Span};
use rules::consumers::Tally;
use rules::{Finding, Settled};
use vfs::SourceFile;

/// What a task gave.
#[derive(Clone)]
pub(super) struct RootResult {
    pub(super) task: CheckTask,
    /// Whether the file is a robot on its own.
    pub(super) is_robot: bool,
    /// Whether only a name is missing to make it one.
    pub(super) is_nameless: bool,
    /// The packages of a robot that were not found.
    pub(super) unfound: BTreeSet<String>,
    /// What was not checked of it: it is a robot, and errors left out a part of it.
    pub(super) cut: Option<Cut>,
    /// Whether it is one of the contexts that are checked: findings say in which of these they occur.
    pub(super) is_context: bool,
    /// Whether it has arguments of a caller, since it fails with the defaults.
    pub(super) is_as_called: bool,
    /// Whether everything was read and expanded, so that what was not found is not there.
    pub(super) complete: bool,
    /// Files that were read, the root file left out.
    pub(super) reads: Vec<PathBuf>,
    /// Descriptions that were read.
    pub(super) files: Vec<Arc<SourceFile>>,
    pub(super) findings: Vec<Finding>,
    /// Its arguments with their values: with others it may be another robot.
    pub(super) arguments: Vec<(EcoString, EcoString)>,
    /// The files that were included, each with the tag that did.
    pub(super) includes: Vec<(FileId, Span)>,
    /// The macros that were called: where each is defined.
    pub(super) called: FastSet<Span>,
    /// What need not be checked again where the next expansion takes it over.
    pub(super) settled: Arc<Settled>,
    /// What programs reject or change that nobody named, where somebody asked.
    pub(super) consumers: Tally,
}
