//! The robots of calls in launch files, as these call them.
use std::collections::BTreeMap;
use std::path::PathBuf;

use super::root_analysis::task_of;
use super::root_config::RootConfig;
use super::run_task;
use super::session::Session;
use base::CancelFlag;
use base::limits::CALL_RUNS;
use expand::{Expansion, Request, expand};
use model::Robot;
use workspace::RobotCall;
use workspace::config::XacroArgs;

/// Expands the robots of calls, each of them once.
pub(super) struct CalledRobots<'s> {
    session: &'s Session,
    cancel: &'s CancelFlag,
    expanded: BTreeMap<(PathBuf, XacroArgs), Option<(Expansion, Robot)>>,
}

impl<'s> CalledRobots<'s> {
    pub fn new(session: &'s Session, cancel: &'s CancelFlag) -> Self {
        Self {
            session,
            cancel,
            expanded: BTreeMap::new(),
        }
    }

    /// The robot of a call, with what is known of its arguments; none where it fails.
    pub fn of(&mut self, call: &RobotCall) -> Option<&(Expansion, Robot)> {
        let session = self.session;
        let caller = &call.call.caller;
        let file = call
            .target
            .clone()
            .filter(|file| session.vfs.is_file(file))?;
        let args = call.call.args.iter().filter_map(|argument| {
            let value = argument.given(&session.packages, caller)?;
            Some((argument.name.clone(), value))
        });
        let args: XacroArgs = args.collect();
        let is_known = self.expanded.contains_key(&(file.clone(), args.clone()));
        let of_this = self.expanded.keys().filter(|(other, _)| *other == file);
        if !is_known && of_this.count() >= CALL_RUNS {
            return None;
        }
        let cancel = self.cancel;
        let expanded = || {
            let root = RootConfig {
                file: file.clone(),
                args: args.clone(),
                preset: None,
            };
            let request = Request {
                probe: false,
                args: args.clone(),
                ..run_task::request(session, cancel, &task_of(&root))
            };
            let expansion = expand(run_task::sources(session), &request);
            let robot = Robot::of(&expansion).filter(|_| !expansion.has_errors())?;
            Some((expansion, robot))
        };
        let place = self.expanded.entry((file.clone(), args.clone()));
        place.or_insert_with(expanded).as_ref()
    }
}
