//! Why an expanded thing exists: the text it came from, and the calls it came through.
use std::sync::Arc;

use ecow::EcoString;

use base::TextRange;
use xml::Item;

/// A file that took part in an expansion: index of [`Expansion::files`](super::Expansion::files).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FileIdx(pub u32);

/// A part of the source (an item of a parsed file): index of [`Expansion::sources`](super::Expansion::sources).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SrcId(pub u32);

/// A step of the way from the root file to a piece of the result: index of
/// [`Expansion::frames`](super::Expansion::frames).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FrameId(pub u32);

impl FrameId {
    /// The root file itself.
    pub const ROOT: FrameId = FrameId(0);
}

base::ids!(FileIdx, SrcId, FrameId);

/// A piece of source text and the frame it was reached through.
///
/// The range is relative to the item, so it stays valid when text in front of the item moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Origin {
    /// The item.
    pub src: SrcId,
    /// Byte range relative to the item.
    pub range: TextRange,
    /// The way that led here.
    pub frame: FrameId,
}

impl Origin {
    /// Of things that have no text: the document node.
    pub const NOWHERE: Origin = Origin {
        src: SrcId(u32::MAX),
        range: TextRange { start: 0, end: 0 },
        frame: FrameId::ROOT,
    };
}

/// An item that was read.
#[derive(Clone, Debug)]
pub struct SourceItem {
    /// The file it belongs to.
    pub file: FileIdx,
    /// The item; identity survives edits elsewhere in the file.
    pub item: Arc<Item>,
    /// Absolute offset of the item when it was read.
    pub base: u32,
}

/// A step on the way: an include, a macro call or an inserted block.
#[derive(Clone, Debug)]
pub struct Frame {
    /// What kind of step.
    pub kind: FrameKind,
    /// Macro, block or file name as the user wrote it.
    pub name: EcoString,
    /// The tag that made the step; its frame is the step before.
    pub call: Origin,
    /// Where the macro or block is defined.
    pub definition: Option<Origin>,
    /// How many macro calls deep.
    pub depth: u32,
}

/// The kinds of steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameKind {
    /// The root file.
    Root,
    /// `xacro:include`
    Include,
    /// A macro call.
    Macro,
    /// `xacro:insert_block`
    Block,
}
