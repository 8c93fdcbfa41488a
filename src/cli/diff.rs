//! What fixes change, as a unified diff.

use std::path::Path;

use similar::TextDiff;

use super::render::{shown_path, visible};
use crate::analysis::FixedFile;

/// The changes of one file, as `git apply` and `patch -p1` read them.
pub(super) fn unified(file: &FixedFile, cwd: &Path) -> String {
    let path = shown_path(&file.path, cwd);
    let path = path.trim_start_matches('/');
    let diff = TextDiff::from_lines(file.before.as_str(), file.after.as_str());
    let (before, after) = (format!("a/{path}"), format!("b/{path}"));
    let text = diff.unified_diff().context_radius(3).header(&before, &after).to_string();
    // line ends stay, or the diff would not apply
    text.split("\r\n").map(visible).collect::<Vec<_>>().join("\r\n")
}
