//! Expanding only what an edit touched, with what that needs: for a first answer while somebody types.
//!
//! Of the file, the items in focus and those that they need are evaluated; of other files, all that define something,
//! so names mean what they mean in the whole robot. Macros in focus are looked into with unknown parameters.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use super::machine::Expander;
use super::origin::SrcId;
use vfs::SourceFile;
use xml::{Document, Item, NodeKind};

/// Some items of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Focus {
    /// The file, absolute.
    pub path: PathBuf,
    /// The items, by number.
    pub items: Range<usize>,
    /// All items of the file that are evaluated: these, and those that they need; sorted.
    pub needed: Vec<usize>,
}

impl Focus {
    /// The items with their offsets.
    fn items<'d>(&self, document: &'d Document) -> Vec<(u32, &'d Arc<Item>)> {
        self.needed.iter().filter_map(|&number| document.item(number)).collect()
    }

    /// Whether one of the items that are evaluated is in focus itself.
    fn holds(&self, place: usize) -> bool {
        self.needed.get(place).is_some_and(|number| self.items.contains(number))
    }
}

impl Expander<'_> {
    /// The items of a file that take part, with their offsets: all, or those needed for what is in focus.
    pub(super) fn items_of<'d>(&self, source: &'d SourceFile) -> Vec<(u32, &'d Arc<Item>)> {
        let document = &source.document;
        match &self.request.focus {
            None => document.items().collect(),
            Some(focus) if *source.path == *focus.path => focus.items(document),
            Some(_) => document.items().filter(|(_, item)| defines(item)).collect(),
        }
    }

    /// Whether the macro whose body is `src` is to be looked into when nothing calls it.
    pub(super) fn may_probe(&self, src: SrcId) -> bool {
        let Some(focus) = &self.request.focus else { return true };
        let file = self.result.sources.get(src.0 as usize).map(|source| source.file);
        let file = file.and_then(|file| self.result.files.get(file.0 as usize));
        file.is_some_and(|file| {
            let place = (src.0 as usize).checked_sub(file.first_source.0 as usize + 1);
            *file.source.path == *focus.path && place.is_some_and(|place| focus.holds(place))
        })
    }
}

/// Whether an item may define names; what a call hands out is left aside.
fn defines(item: &Item) -> bool {
    const DEFINING: [&str; 6] =
        ["xacro:property", "xacro:macro", "xacro:arg", "xacro:include", "xacro:if", "xacro:unless"];
    item.nodes().any(|node| node.kind() == NodeKind::Element && DEFINING.contains(&node.name()))
}
