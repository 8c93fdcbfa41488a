//! Which files are expanded, and with which arguments.

use std::path::{Path, PathBuf};

use workspace::config::Root;

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
    pub(super) args: Vec<(String, String)>,
    /// Name of the preset.
    pub(super) preset: Option<String>,
}

impl Job {
    /// The expansions of one file of a configured root; `args` go over all others.
    pub(super) fn of_root(root: &Root, file: &Path, args: &[(String, String)]) -> Vec<Self> {
        let variants = root.variants().into_iter();
        let job = |variant: workspace::config::Variant| Self {
            file: file.to_path_buf(),
            reason: Reason::Root,
            args: variant.args.into_iter().chain(args.iter().cloned()).collect(),
            preset: variant.preset,
        };
        variants.map(job).collect()
    }
}
