//! Under which root a file is shown.
use std::path::{Path, PathBuf};

/// A root and the arguments it is expanded with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RootConfig {
    /// The file, absolute.
    pub file: PathBuf,
    /// Arguments over the defaults of the file.
    pub args: Vec<(String, String)>,
    /// The preset of the configuration they come from.
    pub preset: Option<String>,
}

impl RootConfig {
    /// A file with the defaults of its arguments.
    pub fn plain(file: &Path) -> Self {
        Self {
            file: file.to_path_buf(),
            args: Vec::new(),
            preset: None,
        }
    }
}

/// Why a root was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootReason {
    /// The user selected it.
    Selected,
    /// A comment `xacro-root:` at the top of the file names it.
    Comment,
    /// The configuration lists it.
    Configured,
    /// The file is a robot itself.
    Itself,
    /// It includes the file.
    Includes,
    /// No robot includes the file.
    None,
}

impl RootReason {
    /// For a status line.
    pub fn text(self) -> &'static str {
        match self {
            RootReason::Selected => "selected in this session",
            RootReason::Comment => "set by the xacro-root comment",
            RootReason::Configured => "set in the configuration",
            RootReason::Itself => "the file is a robot",
            RootReason::Includes => "it includes the file",
            RootReason::None => "no root includes this file",
        }
    }
}

/// The context of a file.
#[derive(Clone, Debug)]
pub struct Context {
    /// The active root; none for a file that no robot includes.
    pub root: Option<RootConfig>,
    /// Why it is active.
    pub reason: RootReason,
    /// All roots that reach the file, with their distance in includes.
    pub candidates: Vec<(RootConfig, u32)>,
}
