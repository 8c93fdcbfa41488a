//! An expansion to be made.
use std::path::PathBuf;

use super::root_config::RootConfig;
use base::Span;
use workspace::config::XacroArgs;

/// Why a file is expanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum CheckReason {
    /// It lies below a folder that is checked.
    Walked,
    /// It was named on the command line, or is shown in an editor.
    Named,
    /// It is all that was named on the command line: what is asked for is whether this file works.
    Alone,
    /// It is configured as a root.
    Root,
}

/// One expansion to be made.
#[derive(Clone, Debug)]
pub(super) struct CheckTask {
    /// The file, absolute.
    pub(super) file: PathBuf,
    /// What the file is expanded for.
    pub(super) reason: CheckReason,
    /// Arguments; later ones win.
    pub(super) args: XacroArgs,
    /// Name of the preset.
    pub(super) preset: Option<String>,
    /// The calls in launch files that it is made for.
    pub(super) called: Option<LaunchCallSites>,
}

impl CheckTask {
    /// A file with arguments.
    pub(super) fn new(file: PathBuf, reason: CheckReason, args: XacroArgs) -> Self {
        Self {
            file,
            reason,
            args,
            preset: None,
            called: None,
        }
    }

    /// What is expanded.
    pub(super) fn root(&self) -> RootConfig {
        let Self {
            file, args, preset, ..
        } = self.clone();
        RootConfig { file, args, preset }
    }
}

/// The calls that an expansion is made for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct LaunchCallSites {
    /// Where the launch files make them.
    pub calls: Vec<Span>,
    /// How many calls of the robot are checked.
    pub of: usize,
    /// Whether nothing loads the robot but the calls that are checked, and none of them as it is without arguments.
    pub are_all: bool,
}
