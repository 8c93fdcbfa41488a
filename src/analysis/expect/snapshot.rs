//! What files of `expands-to` are to hold, and what differs from them.
use std::path::PathBuf;

use super::outcome::RULE;
use base::Span;
use expand::MapEntry;
use model::{Comparison, DifferenceKind, compare};
use rules::Finding;

/// What a file is to hold.
pub(super) struct Snapshot {
    pub(super) path: PathBuf,
    pub(super) text: String,
    /// The first test that wants it.
    pub(super) owner: String,
    /// The expectation.
    pub(super) place: Span,
    /// Its path as it is written.
    pub(super) shown: String,
}

impl Snapshot {
    /// Whether another test wants the same.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        compare(&self.text, &other.text) == Comparison::Same
    }

    /// Whether a file needs no update.
    pub(super) fn is_written_in(&self, text: &str) -> bool {
        compare(&self.text, text) == Comparison::Same
    }

    /// Another test wants something else in the same file.
    pub(super) fn conflict(&self, owner: &str) -> Finding {
        let message = format!(
            "`{}` is also the file of `{owner}`, a different robot",
            self.shown
        );
        let mut finding = Finding::new(&RULE, self.place, message);
        finding.help = Some(
            "add `$(arg NAME)` to the name of the file, or limit the expectation with `when`"
                .to_owned(),
        );
        finding
    }
}

/// What differs between the robot and a file.
pub(crate) fn worded(what: &DifferenceKind, file: &str) -> String {
    match what {
        DifferenceKind::Value { of, one, other } => {
            let (one, other) = (quoted(one.as_deref()), quoted(other.as_deref()));
            format!("{of} is {one}, but {other} in `{file}`")
        }
        DifferenceKind::OnlyOne(element) => format!("{element} is not in `{file}`"),
        DifferenceKind::OnlyOther(element) => format!("{element} of `{file}` is missing"),
    }
}

fn quoted(text: Option<&str>) -> String {
    text.map_or("missing".to_owned(), |text| format!("`{text}`"))
}

/// What a part of the printed document came from: the innermost entry of the map that holds its start.
pub(crate) fn entry_at<'m>(
    map: &'m [MapEntry],
    range: &std::ops::Range<usize>,
) -> Option<&'m MapEntry> {
    let at = range.start as u32;
    let holds =
        |entry: &&MapEntry| entry.out.start <= at && at < entry.out.end.max(entry.out.start + 1);
    map.iter().filter(holds).min_by_key(|entry| entry.out.len())
}
