//! What an expansion is asked for: files, arguments and budgets.
use std::path::PathBuf;

use base::{CancelFlag, ExpansionLimits};
use packages::Packages;
use vfs::{Environment, Vfs};

/// Where an expansion reads from.
#[derive(Clone, Copy)]
pub struct Sources<'w> {
    /// Files.
    pub vfs: &'w Vfs,
    /// `$(find)`.
    pub packages: &'w Packages,
    /// `$(env)` and the working directory.
    pub env: &'w Environment,
}

/// What to expand, and how.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The root file as the user named it, relative to the root directory.
    pub file: String,
    /// `name:=value` in order; later ones win.
    pub args: Vec<(String, String)>,
    /// `--root-dir`: what relative names are relative to; the working directory when absent.
    pub root_dir: Option<String>,
    /// Budgets.
    pub limits: ExpansionLimits,
    /// Whether more is wanted than the document: macros that nothing calls are looked into, with parameters whose
    /// values are unknown, and it is noted what names refer to and what expressions gave.
    pub probe: bool,
    /// Arguments that are given, nobody knows with which values; `args` win.
    pub unknown_args: Vec<String>,
    /// Whether variables that every shell of ROS has are set, as far as the environment does not say otherwise.
    pub ros_shell: bool,
    /// Whether the result is kept for long: it then takes no more room than it must.
    pub keep: bool,
    /// Whether the process ends behind this: what the expansion was made with is then left to the system.
    pub last: bool,
    /// Conditions whose outcome is given, whatever their values say.
    pub forced: Vec<Forced>,
    /// Set to stop early; the result is then incomplete.
    pub cancel: CancelFlag,
}

impl Request {
    /// Whether the same is asked for, whoever may cancel it.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let Self {
            file,
            args,
            root_dir,
            limits,
            probe,
            unknown_args,
            ros_shell,
            keep,
            last: _,
            forced,
            cancel: _,
        } = self;
        (file, args, root_dir, limits) == (&other.file, &other.args, &other.root_dir, &other.limits)
            && (*probe, *ros_shell, *keep) == (other.probe, other.ros_shell, other.keep)
            && (unknown_args, forced) == (&other.unknown_args, &other.forced)
    }
}

/// A condition (`xacro:if` or `xacro:unless`) whose outcome is given.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Forced {
    /// The file, absolute.
    pub file: PathBuf,
    /// Where its tag begins: byte offset of the `<`.
    pub at: u32,
    /// Whether its content is taken.
    pub taken: bool,
}
