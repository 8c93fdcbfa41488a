//! Which files are expanded, and with which arguments.

use std::path::{Path, PathBuf};

use super::context::RootChoice;
use super::launched::Called;
use super::session::Session;
use workspace::config::{Args, Axes, Root, Variant};

/// Why a file is expanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Reason {
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
pub(super) struct Job {
    /// The file, absolute.
    pub(super) file: PathBuf,
    /// Why.
    pub(super) reason: Reason,
    /// Arguments; later ones win.
    pub(super) args: Args,
    /// Name of the preset.
    pub(super) preset: Option<String>,
    /// The calls in launch files that it is made for.
    pub(super) called: Option<Called>,
}

impl Job {
    /// A file with arguments.
    pub(super) fn new(file: PathBuf, reason: Reason, args: Args) -> Self {
        Self {
            file,
            reason,
            args,
            preset: None,
            called: None,
        }
    }

    /// What is expanded.
    pub(super) fn root(&self) -> RootChoice {
        let Self {
            file, args, preset, ..
        } = self.clone();
        RootChoice { file, args, preset }
    }
}

impl Session {
    /// The runs of one file of a configured root.
    pub(super) fn variants(&self, root: &Root, file: &Path) -> Vec<Variant> {
        root.variants(&self.choices(root, file))
    }

    /// The arguments that a root takes from launch files, with their values.
    pub(super) fn choices(&self, root: &Root, file: &Path) -> Axes {
        if root.launch_choices {
            self.launch_choices(file)
        } else {
            Axes::new()
        }
    }

    /// The expansions of one file of a configured root; `args` go over all others.
    pub(super) fn jobs_of(&self, root: &Root, file: &Path, args: &[(String, String)]) -> Vec<Job> {
        let job = |variant: Variant| {
            let args = variant
                .args
                .into_iter()
                .chain(args.iter().cloned())
                .collect();
            Job {
                preset: variant.preset,
                ..Job::new(file.to_path_buf(), Reason::Root, args)
            }
        };
        self.variants(root, file).into_iter().map(job).collect()
    }
}
