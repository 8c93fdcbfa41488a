//! Proof that edits leave every robot as it is.
//!
//! Most edits are proved by the text alone: if a file says the same to a reader of URDF before and after, whatever its
//! expressions give, so do all robots made of it. For the others, every robot that reads a changed file is expanded
//! before and after: with its defaults, its presets and the arguments of its callers, with each switch turned over, and
//! with the branches taken that hold an edit. The files themselves are never touched: the texts after lie in an overlay.
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::candidates::Candidates;
use super::check_task::{CheckReason, CheckTask};
use super::plan::apply;
use super::run_cache::{RunResult, RunSetting, Runs};
use super::runs::run_once;
use super::session::Session;
use super::task_list::tasks_reading;
use super::walk::is_description;
use base::{CancelFlag, TextRange};
use expand::Forced;
use model::{JointType, same_but_for_mesh_formats, same_robot};
use vfs::{SourceFile, Vfs};
use xml::{Document, Node, NodeKind};

/// The tags of conditions.
pub(super) const CONDITIONS: [&str; 2] = ["xacro:if", "xacro:unless"];
/// Arguments of one caller that are tried, at most so many callers.
const MOST_CALLERS: usize = 4;
/// Values that are tried for arguments when an edit is in an expression.
const OTHER_VALUES: [&str; 3] = ["other", "2", ""];

/// A file as it is and as it would be.
pub(super) struct Changed {
    /// Its path, absolute.
    pub path: Arc<Path>,
    /// The text as it is.
    pub old: String,
    /// The text as it would be.
    pub new: String,
    /// What leads from one to the other, in order.
    pub edits: Vec<(TextRange, String)>,
}

/// What is to be proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Claim {
    /// Every robot stays what it is.
    Same,
    /// The same, but for robots that are refused, or that hold what was meant for xacro: those are accepted afterwards.
    Repaired,
    /// The same, but for robots whose collision meshes are in other formats.
    Fitted,
    /// No robot that is accepted is refused afterwards.
    Accepted,
}

/// How much may be done for a proof.
#[derive(Clone)]
pub struct Effort {
    /// Expansions that are made for one claim; where more are needed, it is not proved.
    pub expansions: usize,
    /// The robots that may read the files.
    pub roots: AffectedRobots,
    /// Set to stop early; nothing is proved then.
    pub cancel: CancelFlag,
}

/// The robots that may read the files of a claim.
#[derive(Clone)]
pub enum AffectedRobots {
    /// Those are known.
    Known(Vec<PathBuf>),
    /// They are searched for in the workspaces of the files, once for all claims.
    Searched(Arc<Candidates>),
}

/// Whether a claim about changes holds, as far as it can be proved.
pub(super) fn proves(
    session: &Session,
    changed: &[Changed],
    claim: Claim,
    effort: &Effort,
) -> bool {
    let open: Vec<&Changed> = changed
        .iter()
        .filter(|changed| !changed.is_same_by_text())
        .collect();
    open.is_empty() || Trial::new(session, open, effort).is_some_and(|trial| trial.holds(claim))
}

/// Whether every robot stays what it is when texts of a file are replaced; they are in order and do not overlap.
pub fn expansion_unchanged(
    session: &Session,
    path: &Path,
    edits: Vec<(TextRange, String)>,
    effort: &Effort,
) -> bool {
    let Ok(source) = session.vfs.document(path) else {
        return false;
    };
    let old = source.document.text();
    let new = apply(&old, &edits);
    proves(
        session,
        &[Changed {
            path: source.path.clone(),
            old,
            new,
            edits,
        }],
        Claim::Same,
        effort,
    )
}

impl Changed {
    /// Whether the file says the same before and after, whatever its expressions give.
    pub fn is_same_by_text(&self) -> bool {
        !is_description(&self.path) || same_robot(&self.old, &self.new) == Some(true)
    }

    /// Where a place of the old text stands in the new one; edits that begin there come behind it.
    pub fn moved(&self, at: u32) -> u32 {
        let before = self
            .edits
            .iter()
            .filter(|(range, _)| range.end <= at && range.start < at);
        let shift: i64 = before
            .map(|(range, new)| new.len() as i64 - i64::from(range.len()))
            .sum();
        (i64::from(at) + shift) as u32
    }
}

/// Expansions before and after changes.
pub(super) struct Trial<'a> {
    pub session: &'a Session,
    pub changed: Vec<&'a Changed>,
    /// The changed files, parsed as they are.
    sources: Vec<Arc<SourceFile>>,
    pub after: Vfs,
    pub effort: &'a Effort,
    runs: Arc<Runs>,
}

impl<'a> Trial<'a> {
    pub fn new(
        session: &'a Session,
        changed: Vec<&'a Changed>,
        effort: &'a Effort,
    ) -> Option<Self> {
        let sources = changed
            .iter()
            .map(|changed| session.vfs.document(&changed.path).ok())
            .collect::<Option<Vec<_>>>()?;
        let texts = changed
            .iter()
            .map(|changed| (changed.path.to_path_buf(), changed.new.clone()));
        let after = session.vfs.overlay(texts);
        let runs = match &effort.roots {
            AffectedRobots::Known(_) => Arc::default(),
            AffectedRobots::Searched(known) => known.runs.clone(),
        };
        Some(Self {
            session,
            changed,
            sources,
            after,
            effort,
            runs,
        })
    }

    fn holds(&self, claim: Claim) -> bool {
        let mut uncalled = self.macros_around_edits();
        let mut unread: Vec<&Path> = self.changed.iter().map(|changed| &*changed.path).collect();
        let mut left = self.effort.expansions;
        for task in self.tasks() {
            let first = RunSetting {
                args: task.args.clone(),
                forced: Vec::new(),
            };
            let Some(before) = self.compare(&task, &first, claim) else {
                return false;
            };
            if !self
                .changed
                .iter()
                .any(|changed| before.reads(&changed.path))
            {
                continue;
            }
            unread.retain(|path| !before.reads(path));
            uncalled.retain(|place| !before.calls(place));
            for setting in self.settings(&task, &before) {
                left = left.saturating_sub(1);
                let Some(run) = self.compare(&task, &setting, claim).filter(|_| left > 0) else {
                    return false;
                };
                uncalled.retain(|place| !run.calls(place));
            }
        }
        // what nobody reads or calls here may be read and called elsewhere
        claim == Claim::Accepted || unread.is_empty() && uncalled.is_empty()
    }

    /// The robots that may read a changed file, below the workspaces of these files.
    fn tasks(&self) -> Vec<CheckTask> {
        let known = match &self.effort.roots {
            AffectedRobots::Known(files) => return files.iter().map(|file| named(file)).collect(),
            AffectedRobots::Searched(known) => known,
        };
        let session = self.session;
        let files: Vec<PathBuf> = self
            .changed
            .iter()
            .map(|changed| changed.path.to_path_buf())
            .collect();
        let around = |file: &PathBuf| {
            let folder = file.parent()?;
            let package = || {
                session
                    .packages
                    .containing(file)
                    .map(|package| package.folder)
            };
            Some(
                session
                    .packages
                    .workspace(folder)
                    .or_else(package)
                    .unwrap_or_else(|| folder.to_owned()),
            )
        };
        let mut folders: Vec<PathBuf> = files.iter().filter_map(around).collect();
        folders.sort();
        folders.dedup();
        tasks_reading(known, session, folders, files)
    }

    /// What an expansion gives before; none when the claim does not hold for it.
    fn compare(
        &self,
        task: &CheckTask,
        setting: &RunSetting,
        claim: Claim,
    ) -> Option<Arc<RunResult>> {
        if self.effort.cancel.is_cancelled() {
            return None;
        }
        let before = self.run(task, &self.session.vfs, setting);
        let forced = setting.forced.iter().map(|forced| Forced {
            at: self.moved(forced),
            ..forced.clone()
        });
        let setting = RunSetting {
            args: setting.args.clone(),
            forced: forced.collect(),
        };
        let after = self.run(task, &self.after, &setting);
        let same = if claim == Claim::Fitted {
            same_but_for_mesh_formats
        } else {
            same_robot
        };
        let is_same = before.text == after.text || same(&before.text, &after.text) == Some(true);
        let holds = match claim {
            Claim::Same | Claim::Fitted if !is_same => before.refused && !after.refused,
            _ => before.refused || !after.refused,
        };
        holds.then_some(before)
    }

    pub fn moved(&self, forced: &Forced) -> u32 {
        let changed = self
            .changed
            .iter()
            .find(|changed| *changed.path == *forced.file);
        changed.map_or(forced.at, |changed| changed.moved(forced.at))
    }

    pub fn run(&self, task: &CheckTask, vfs: &Vfs, setting: &RunSetting) -> Arc<RunResult> {
        let (runs, cancel) = (&self.runs, &self.effort.cancel);
        run_once(runs, self.session, vfs, cancel, task, setting)
    }

    /// Further ways to expand a robot that may show what an edit does.
    fn settings(&self, task: &CheckTask, before: &RunResult) -> Vec<RunSetting> {
        let mut found = Vec::new();
        for caller in self
            .session
            .callers
            .of(&task.file)
            .iter()
            .take(MOST_CALLERS)
        {
            let known = caller
                .args
                .iter()
                .filter_map(|arg| Some((arg.name.clone(), arg.value.clone()?)));
            let known: Vec<_> = known.collect();
            if !known.is_empty() {
                found.push(with_arguments(task, known));
            }
        }
        let in_expressions = self
            .edits()
            .any(|(document, range, new)| is_in_expression(document, range, new));
        for (name, value) in &before.arguments {
            let others: &[&str] = if in_expressions { &OTHER_VALUES } else { &[] };
            let values = turned_over(value).into_iter().chain(others.iter().copied());
            found.extend(
                values.map(|value| with_arguments(task, [(name.to_string(), value.to_owned())])),
            );
        }
        found.extend(self.branches().into_iter().map(|forced| RunSetting {
            args: task.args.clone(),
            forced,
        }));
        found
    }

    /// The edits with the documents they are made in.
    fn edits(&self) -> impl Iterator<Item = (&Document, TextRange, &str)> {
        let files = self.changed.iter().zip(&self.sources);
        files.flat_map(|(changed, source)| {
            changed
                .edits
                .iter()
                .map(|(range, new)| (&source.document, *range, new.as_str()))
        })
    }

    /// For each edit inside of conditions: these conditions, taken.
    fn branches(&self) -> Vec<Vec<Forced>> {
        let mut found = Vec::new();
        for (changed, source) in self.changed.iter().zip(&self.sources) {
            for (range, _) in &changed.edits {
                let conditions = enclosing(&source.document, *range, &CONDITIONS);
                let forced = |at: TextRange| Forced {
                    file: changed.path.to_path_buf(),
                    at: at.start,
                    taken: true,
                };
                let forced: Vec<Forced> = conditions.into_iter().map(forced).collect();
                if !forced.is_empty() && !found.contains(&forced) {
                    found.push(forced);
                }
            }
        }
        found
    }

    /// The macros that have an edit in their bodies: file and place.
    fn macros_around_edits(&self) -> Vec<(PathBuf, TextRange)> {
        let mut found = Vec::new();
        for (changed, source) in self.changed.iter().zip(&self.sources) {
            for (range, _) in &changed.edits {
                let macros = enclosing(&source.document, *range, &["xacro:macro"]);
                found.extend(
                    macros
                        .into_iter()
                        .map(|place| (changed.path.to_path_buf(), place)),
                );
            }
        }
        found.sort_by(|(a, one), (b, other)| (a, one.start).cmp(&(b, other.start)));
        found.dedup();
        found
    }
}

/// The expansion of a file that was named.
fn named(file: &Path) -> CheckTask {
    CheckTask::new(file.to_owned(), CheckReason::Named, Vec::new())
}

/// The elements of these names around a range, outermost first.
pub(super) fn enclosing(document: &Document, range: TextRange, names: &[&str]) -> Vec<TextRange> {
    let place = document.item_at(range.start);
    let holds = |node: &Node<'_>| {
        let own = node.range().shift(place.start);
        node.kind() == NodeKind::Element && own.start < range.start && range.end <= own.end
    };
    let named = place
        .item
        .all_nodes()
        .filter(holds)
        .filter(|node| names.contains(&node.name()));
    named.map(|node| node.range().shift(place.start)).collect()
}

/// Whether an edit touches a value that is computed.
fn is_in_expression(document: &Document, range: TextRange, new: &str) -> bool {
    let place = document.item_at(range.start);
    let mut attrs = place.item.all_nodes().flat_map(|node| node.attrs());
    new.contains('$')
        || attrs.any(|attr| {
            attr.range().shift(place.start).contains_range(range) && attr.raw().contains('$')
        })
}

/// A robot with other arguments than its own, or further ones.
pub(super) fn with_arguments(
    task: &CheckTask,
    more: impl IntoIterator<Item = (String, String)>,
) -> RunSetting {
    RunSetting {
        args: task.args.iter().cloned().chain(more).collect(),
        forced: Vec::new(),
    }
}

/// Other values of an argument that decides between two or few things.
pub(super) fn turned_over(value: &str) -> Vec<&'static str> {
    match value.trim() {
        "true" | "True" => vec!["false"],
        "false" | "False" => vec!["true"],
        "1" => vec!["0"],
        "0" => vec!["1"],
        kind if JointType::of(kind).is_some() => JointType::ALL
            .iter()
            .map(|(name, _)| *name)
            .filter(|name| *name != kind)
            .collect(),
        _ => Vec::new(),
    }
}
