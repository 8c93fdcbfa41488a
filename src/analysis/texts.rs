//! What texts say.
use std::path::Path;

use rules::Finding;
use vfs::Vfs;
use workspace::{has_name, without_comments};

/// Whether a text has a name outside of its comments.
pub(super) fn says(vfs: &Vfs, path: &Path, name: &str) -> bool {
    let ending = path.file_name().and_then(|file| file.to_str());
    vfs.text(path).is_ok_and(|text| {
        has_name(&text.text, name)
            && has_name(
                &without_comments(ending.unwrap_or_default(), &text.text),
                name,
            )
    })
}

/// The text that a finding is about.
pub(super) fn text_of(vfs: &Vfs, finding: &Finding) -> Option<String> {
    let source = vfs.document(&vfs.path(finding.span.file)).ok()?;
    Some(source.document.slice(finding.span.range))
}
