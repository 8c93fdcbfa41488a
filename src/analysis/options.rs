//! What is checked, and how.
use std::path::PathBuf;

use super::progress::Progress;
use base::CancelFlag;

/// What to check.
#[derive(Clone, Debug, Default)]
pub struct CheckOptions {
    /// Files and folders.
    pub paths: Vec<PathBuf>,
    /// Files that are robots, whatever their content looks like.
    pub entries: Vec<PathBuf>,
    /// Files that changed, when only what concerns them is asked for; below `paths`, or elsewhere.
    pub changed: Vec<PathBuf>,
    /// Arguments of every expansion, over those of configured roots.
    pub args: Vec<(String, String)>,
    /// Whether to count what programs reject or change that nobody named.
    pub count_consumers: bool,
    /// Set to stop early.
    pub cancel: CancelFlag,
    /// Says how far the check is.
    pub progress: Progress,
}
