//! Expanding only what an edit touched, with what that needs: for a first answer while somebody types.
//!
//! The items of a file that only give output are passed over, except those in focus. Definitions count, so names
//! mean what they mean in the whole file; macros in focus are looked into with unknown parameters.

use std::ops::Range;
use std::path::PathBuf;

use super::machine::Expander;
use super::origin::{FileIdx, SrcId};
use crate::xml::{Item, NodeKind};

/// Some items of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Focus {
    /// The file, absolute.
    pub path: PathBuf,
    /// The items, by number.
    pub items: Range<usize>,
}

impl Expander<'_> {
    /// Whether an item is to be evaluated: all without a focus, else those in it and those that define something.
    pub(super) fn is_wanted(&self, file: FileIdx, number: usize, item: &Item) -> bool {
        self.request.focus.is_none() || self.in_focus(file, number) || defines(item)
    }

    /// Whether the macro whose body is `src` is to be looked into when nothing calls it.
    pub(super) fn may_probe(&self, src: SrcId) -> bool {
        if self.request.focus.is_none() {
            return true;
        }
        let source = self.result.sources.get(src.0 as usize);
        source.is_some_and(|source| {
            let first = self.result.files.get(source.file.0 as usize).map_or(0, |file| file.first_source.0);
            src.0 > first && self.in_focus(source.file, (src.0 - first - 1) as usize)
        })
    }

    fn in_focus(&self, file: FileIdx, number: usize) -> bool {
        let file = self.result.files.get(file.0 as usize);
        let focus = self.request.focus.as_ref();
        file.zip(focus)
            .is_some_and(|(file, focus)| focus.items.contains(&number) && *file.source.path == *focus.path)
    }
}

/// Whether an item may define names; what a call hands out is left aside.
fn defines(item: &Item) -> bool {
    const DEFINING: [&str; 6] =
        ["xacro:property", "xacro:macro", "xacro:arg", "xacro:include", "xacro:if", "xacro:unless"];
    item.nodes().any(|node| node.kind() == NodeKind::Element && DEFINING.contains(&node.name()))
}
