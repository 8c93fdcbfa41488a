//! A root expanded, with what was read off it: kept until something it rests on has changed.
use std::path::Path;
use std::sync::OnceLock;

use super::job;
use super::job::{expanded, judge, request};
use super::options::CheckOptions;
use super::outcome::RootResult;
use super::root_choice::RootChoice;
use super::session::Session;
use super::task::{CheckReason, CheckTask};
use base::CancelFlag;
use base::limits::GLOB_ENTRIES;
use expand::{Expansion, Read, Request, SymbolKind, Written, write_mapped};
use model::{Kinematics, Robot};
use rules::RobotNames;
use vfs::Vfs;

/// A root expanded.
pub struct Analyzed {
    /// What was expanded.
    pub root: RootChoice,
    /// The result.
    pub expansion: Expansion,
    /// The robot; none when the root element is not `robot`.
    pub robot: Option<Robot>,
    /// How its links hang together.
    pub kinematics: Option<Kinematics>,
    /// What the rules say, once somebody has asked: most questions of an editor are about the robot alone.
    outcome: OnceLock<RootResult>,
    written: OnceLock<Written>,
    /// The names that it has when it is expanded in other ways.
    pub(super) further: OnceLock<RobotNames>,
    /// When it was made, as the world counts.
    pub(super) epoch: u64,
}

impl Analyzed {
    /// What an expansion is worth to an editor.
    pub(super) fn new(root: RootChoice, expansion: Expansion, epoch: u64) -> Self {
        let robot = Robot::of(&expansion);
        let kinematics = robot.as_ref().map(Kinematics::of);
        let (outcome, written, further) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self {
            root,
            expansion,
            robot,
            kinematics,
            outcome,
            written,
            further,
            epoch,
        }
    }

    /// A root expanded once, for a check.
    pub(super) fn of(session: &Session, root: &RootChoice, options: &CheckOptions) -> Self {
        Self::new(
            root.clone(),
            job::expansion(session, &options.cancel, &job_of(root), None),
            0,
        )
    }

    /// The expanded document as text, with its map.
    pub fn written(&self) -> &Written {
        let name = self
            .expansion
            .files
            .first()
            .map_or("", |file| file.name.as_str());
        self.written
            .get_or_init(|| write_mapped(&self.expansion.tree, name))
    }

    /// The arguments with their values, in the order in which they are declared: what matters is declared first.
    pub fn declared_arguments(&self) -> Vec<(&str, &str)> {
        let definitions = self.expansion.index.symbols.definitions.iter();
        let names = definitions.filter(|given| given.kind == SymbolKind::Argument);
        let order: Vec<&str> = names.map(|given| given.name.as_str()).collect();
        let arguments = self
            .expansion
            .arguments
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()));
        let mut arguments: Vec<(&str, &str)> = arguments.collect();
        arguments.sort_by_key(|(name, _)| {
            order
                .iter()
                .position(|known| known == name)
                .unwrap_or(usize::MAX)
        });
        arguments
    }

    /// What the rules say. `None` when cancelled.
    pub(super) fn outcome(&self, session: &Session, cancel: &CancelFlag) -> Option<&RootResult> {
        if self.outcome.get().is_none() {
            let (job, robot) = (job_of(&self.root), self.robot.as_ref());
            let options = CheckOptions {
                cancel: cancel.clone(),
                ..CheckOptions::default()
            };
            let outcome = job::judge(session, &options, job, &self.expansion, robot);
            if cancel.is_cancelled() {
                return None;
            }
            let _ = self.outcome.set(outcome);
        }
        self.outcome.get()
    }

    /// Whether everything that the expansion read is as it was, but for one file.
    pub(super) fn is_current_beside(&self, vfs: &Vfs, cwd: &Path, except: &Path) -> bool {
        let mut left = GLOB_ENTRIES;
        self.expansion.record.iter().all(|read| match read {
            Read::File(path, _) if path == except => true,
            Read::File(path, hash) => vfs.document_hash(path) == Some(*hash),
            Read::Missing(path) => !vfs.is_file(path),
            Read::Glob(pattern, found) => vfs
                .glob(pattern, cwd, &mut left)
                .is_ok_and(|now| now == *found),
            Read::Package(..) | Read::Env(..) | Read::Arg(..) => true,
        })
    }

    /// Whether a file took part.
    pub fn includes(&self, path: &Path) -> bool {
        self.expansion
            .files
            .iter()
            .any(|file| *file.source.path == *path)
    }
}

/// The expansion of a root.
pub(super) fn job_of(root: &RootChoice) -> CheckTask {
    let RootChoice { file, args, preset } = root.clone();
    CheckTask {
        preset,
        ..CheckTask::new(file, CheckReason::Named, args)
    }
}

/// The same, for somebody who keeps the expansion.
pub(super) fn run_kept(
    session: &Session,
    options: &CheckOptions,
    job: CheckTask,
) -> (RootResult, Analyzed) {
    let kept = Request {
        keep: true,
        ..request(session, &options.cancel, &job)
    };
    let (expansion, is_as_called) = expanded(session, &job, &kept, None);
    let analyzed = Analyzed::new(job.root(), expansion, 0);
    let robot = analyzed.robot.as_ref();
    let outcome = judge(session, options, job, &analyzed.expansion, robot);
    (
        RootResult {
            is_as_called,
            ..outcome
        },
        analyzed,
    )
}
