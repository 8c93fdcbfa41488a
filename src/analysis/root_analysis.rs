//! A root expanded, with what was read off it: kept until something it rests on has changed.
use std::path::Path;
use std::sync::{Arc, OnceLock};

use super::check_task::{CheckReason, CheckTask};
use super::options::CheckOptions;
use super::root_config::RootConfig;
use super::root_result::RootResult;
use super::run_task;
use super::run_task::{expanded, request, run_rules};
use super::session::Session;
use base::CancelFlag;
use base::limits::GLOB_ENTRIES;
use expand::{Expansion, Read, SymbolKind, Written, write_mapped};
use model::{Kinematics, Robot};
use rules::{RobotNames, Settled};
use vfs::Vfs;

/// How much was expanded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// How many times a robot was expanded.
    pub expanded: u64,
    /// How many items of root files were not evaluated for it, because an edit did not reach them.
    pub items_left_out: u64,
}

impl Work {
    pub(super) fn add(&mut self, expansion: &Expansion) {
        self.expanded += 1;
        self.items_left_out += expansion.left_out() as u64;
    }

    /// What was done since there was less.
    pub fn since(self, before: Self) -> Self {
        Self {
            expanded: self.expanded - before.expanded,
            items_left_out: self.items_left_out - before.items_left_out,
        }
    }
}

/// A root expanded.
pub struct RootAnalysis {
    /// What was expanded.
    pub root: RootConfig,
    /// The result.
    pub expansion: Expansion,
    /// The robot; none when the root element is not `robot`.
    pub robot: Option<Robot>,
    /// What the rules say, once somebody has asked: most questions of an editor are about the robot alone.
    result: OnceLock<RootResult>,
    /// What was settled when it was last checked, in the expansion before.
    before: Arc<Settled>,
    written: OnceLock<Written>,
    /// The names that it has when it is expanded in other ways.
    pub(super) further: OnceLock<RobotNames>,
    /// When it was made, as the host counts.
    pub(super) epoch: u64,
}

impl RootAnalysis {
    /// What an expansion is worth to an editor; `before` is that of the expansion before, of which this one may have taken steps
    /// over.
    pub(super) fn new(
        root: RootConfig,
        expansion: Expansion,
        epoch: u64,
        before: Option<&Self>,
    ) -> Self {
        let old = before.and_then(|old| Some((&old.expansion, old.robot.as_ref()?)));
        let robot = Robot::again(&expansion, old);
        #[cfg(debug_assertions)]
        verify(robot.as_ref(), Robot::of(&expansion).as_ref());
        let (result, written, further) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self {
            root,
            expansion,
            robot,
            result,
            before: before.map(|old| old.settled()).unwrap_or_default(),
            written,
            further,
            epoch,
        }
    }

    /// What was settled when it was checked, or before that.
    fn settled(&self) -> Arc<Settled> {
        let settled = self.result.get().map(|result| &result.settled);
        Arc::clone(settled.unwrap_or(&self.before))
    }

    /// A root expanded once, for a check.
    pub(super) fn of(session: &Session, root: &RootConfig, options: &CheckOptions) -> Self {
        Self::new(
            root.clone(),
            run_task::expansion(session, &options.cancel, &task_of(root), None),
            0,
            None,
        )
    }

    /// How the links of the robot hang together.
    pub fn kinematics(&self) -> Option<&Kinematics> {
        self.robot.as_ref().map(Robot::kinematics)
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
    pub(super) fn result(&self, session: &Session, cancel: &CancelFlag) -> Option<&RootResult> {
        if self.result.get().is_none() {
            let (task, robot) = (task_of(&self.root), self.robot.as_ref());
            let options = CheckOptions {
                cancel: cancel.clone(),
                ..CheckOptions::default()
            };
            let expanded = (&self.expansion, robot);
            let result = run_rules(session, &options, task, expanded, &self.before);
            if cancel.is_cancelled() {
                return None;
            }
            let _ = self.result.set(result);
        }
        self.result.get()
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

/// In builds for tests: what is shared with the robot before is what is read off the expansion.
#[cfg(debug_assertions)]
fn verify(made: Option<&Robot>, fresh: Option<&Robot>) {
    let shown = |robot: &Robot| {
        let links = robot.links.iter();
        // numbers and what names say are read when they are asked for
        links
            .filter_map(|link| link.inertial.as_ref())
            .for_each(|inertial| {
                inertial.entries();
            });
        robot.joints.iter().for_each(|joint| {
            joint.axis();
        });
        robot.naming();
        format!("{robot:?}")
    };
    let (made, fresh) = (made.map(shown), fresh.map(shown));
    // robots are long: where they differ is enough
    let (made, fresh) = (made.unwrap_or_default(), fresh.unwrap_or_default());
    let pairs = made.bytes().zip(fresh.bytes());
    let start = pairs.take_while(|(a, b)| a == b).count();
    let part = |text: &str| -> String {
        let from = text.floor_char_boundary(start.saturating_sub(60));
        let rest = text.get(from..).unwrap_or_default();
        rest.chars().take(200).collect()
    };
    assert!(
        made == fresh,
        "the robot of an incremental expansion: {} instead of {}",
        part(&made),
        part(&fresh)
    );
}

/// The expansion of a root.
pub(super) fn task_of(root: &RootConfig) -> CheckTask {
    let RootConfig { file, args, preset } = root.clone();
    CheckTask {
        preset,
        ..CheckTask::new(file, CheckReason::Named, args)
    }
}

/// The same, for somebody who needs the expansion as well, but expands nothing again.
pub(super) fn run_kept(
    session: &Session,
    options: &CheckOptions,
    task: CheckTask,
) -> (RootResult, RootAnalysis) {
    let request = request(session, &options.cancel, &task);
    let (expansion, is_as_called) = expanded(session, &task, &request, None);
    let analyzed = RootAnalysis::new(task.root(), expansion, 0, None);
    let robot = analyzed.robot.as_ref();
    let expanded = (&analyzed.expansion, robot);
    let result = run_rules(session, options, task, expanded, &Settled::default());
    (
        RootResult {
            is_as_called,
            ..result
        },
        analyzed,
    )
}
