//! What fixes change, as a unified diff.

use std::path::Path;

use similar::TextDiff;

use super::render::{shown_path, visible};
use analysis::FixedFile;

/// The changes of one file, as `git apply` and `patch -p1` read them: with the very bytes of the file, but on a
/// `terminal`, which these could steer.
pub(super) fn unified(file: &FixedFile, cwd: &Path, terminal: bool) -> String {
    let path = visible(&shown_path(&file.path, cwd));
    let path = path.trim_start_matches('/');
    // `patch` takes a name with blanks up to a tab
    let end = if path.contains(' ') { "\t" } else { "" };
    let (before, after) = (format!("a/{path}{end}"), format!("b/{path}{end}"));
    let (old, new): (Vec<&str>, Vec<&str>) = (
        file.before.split_inclusive('\n').collect(),
        file.after.split_inclusive('\n').collect(),
    );
    let diff = TextDiff::configure()
        .newline_terminated(true)
        .diff_slices(&old, &new);
    let text = diff
        .unified_diff()
        .context_radius(3)
        .header(&before, &after)
        .to_string();
    if terminal {
        text.split("\r\n")
            .map(visible)
            .collect::<Vec<_>>()
            .join("\r\n")
    } else {
        text
    }
}
