//! The calls that a macro was expanded from, and the one of them that the user looks at.

use std::path::{Path, PathBuf};

use ecow::EcoString;

use super::calls::macro_at;
use super::context::Cx;
use super::locate::locate;
use base::TextRange;
use expand::{
    Definition, DefinitionId, Expansion, Frame, FrameId, FrameKind, Origin, SourceRange, SymbolKind,
};
use xml::{Node, NodeKind};

/// A call that was selected, in terms that hold after an edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SelectedInstance {
    /// The macro.
    pub name: EcoString,
    /// The file that defines it.
    pub file: PathBuf,
    /// Its place among the calls.
    index: usize,
    /// The start tags that led there, the call's own first.
    tags: Vec<String>,
}

/// The frames with their numbers.
pub(super) fn numbered(expansion: &Expansion) -> impl Iterator<Item = (FrameId, &Frame)> {
    expansion.frames.iter_ids()
}

/// Whether a frame lies in another one, or is that one.
pub(super) fn is_within(expansion: &Expansion, frame: FrameId, outer: FrameId) -> bool {
    let next = |inner: &FrameId| {
        let call = expansion.frames.get(*inner)?.call.frame;
        (call != *inner && *inner != FrameId::ROOT).then_some(call)
    };
    std::iter::successors(Some(frame), next).any(|frame| frame == outer)
}

/// The frames that a definition of a macro was expanded in.
pub(super) fn frames_of_macro(expansion: &Expansion, id: DefinitionId) -> Vec<FrameId> {
    let Some(definition) = expansion.index.symbols.get(id) else {
        return Vec::new();
    };
    numbered(expansion)
        .filter(|(_, frame)| is_call_of(frame, definition))
        .map(|(id, _)| id)
        .collect()
}

/// Whether a frame is a call of the macro.
pub(super) fn is_call_of(frame: &Frame, definition: &Definition) -> bool {
    frame.kind == FrameKind::Macro
        && frame
            .definition
            .is_some_and(|at| SourceRange::from(at) == definition.place)
}

/// The frames that were made by the tag at a range of the file.
pub(super) fn frames_of_tag(cx: &Cx<'_>, tag: TextRange) -> Vec<FrameId> {
    let made = numbered(cx.expansion).filter(|(_, frame)| {
        let span = cx.span(SourceRange::from(frame.call));
        span.is_some_and(|span| span.file == cx.source.id && tag.contains_range(span.range))
    });
    made.map(|(id, _)| id).collect()
}

/// The definition of the macro whose element `node` is; `base` is the offset of its item.
pub(super) fn macro_of(cx: &Cx<'_>, base: u32, node: Node<'_>) -> Option<DefinitionId> {
    let name = cx.source_range(node.attr("name")?.value_range().shift(base))?;
    let mut known = cx.expansion.index.symbols.iter();
    known
        .find(|(_, known)| known.kind == SymbolKind::Macro && known.place == name)
        .map(|(id, _)| id)
}

/// The calls to choose from at an offset: those of the macro around it, or what the call at it made.
fn choices(cx: &Cx<'_>, offset: u32) -> Vec<FrameId> {
    let at = locate(&cx.source.document, offset);
    let mut next = at.node;
    while let Some(node) = next {
        if node.kind() == NodeKind::Element {
            if node.name() == "xacro:macro"
                && let Some(id) = macro_of(cx, at.base, node)
            {
                return frames_of_macro(cx.expansion, id);
            }
            let tag = node.start_tag_range().shift(at.base);
            if macro_at(cx, tag.start + 1 + "xacro:".len() as u32).is_some() {
                return frames_of_tag(cx, tag);
            }
        }
        next = node.parent();
    }
    Vec::new()
}

/// Select one of the calls at an offset.
///
/// # Errors
/// How many there are to choose from.
pub fn select_instance(cx: &Cx<'_>, offset: u32, index: usize) -> Result<SelectedInstance, usize> {
    let choices = choices(cx, offset);
    let Some(&chosen) = choices.get(index) else {
        return Err(choices.len());
    };
    selected(cx.expansion, chosen).ok_or(choices.len())
}

/// The call of a frame, in terms that hold after an edit.
fn selected(expansion: &Expansion, chosen: FrameId) -> Option<SelectedInstance> {
    let frame = expansion.frames.get(chosen)?;
    let place = expansion.place(frame.definition?)?;
    let file = expansion.files.get(place.file)?.source.path.to_path_buf();
    let id = definition_of(expansion, frame)?;
    let index = frames_of_macro(expansion, id)
        .iter()
        .position(|known| *known == chosen)?;
    Some(SelectedInstance {
        name: frame.name.clone(),
        file,
        index,
        tags: tags(expansion, chosen),
    })
}

fn definition_of(expansion: &Expansion, frame: &Frame) -> Option<DefinitionId> {
    let place = SourceRange::from(frame.definition?);
    let mut known = expansion.index.symbols.iter();
    known
        .find(|(_, known)| known.kind == SymbolKind::Macro && known.place == place)
        .map(|(id, _)| id)
}

/// The texts of the tags that led to a frame, its own first.
fn tags(expansion: &Expansion, frame: FrameId) -> Vec<String> {
    let at = Origin {
        frame,
        ..Origin::NOWHERE
    };
    expansion
        .frames_of(at)
        .map(|frame| tag(expansion, frame).unwrap_or_default())
        .collect()
}

/// The text of the tag that led to a frame.
fn tag(expansion: &Expansion, frame: &Frame) -> Option<String> {
    let source = expansion.sources.get(frame.call.src)?;
    let mut nodes = source
        .item
        .all_nodes()
        .filter(|node| node.kind() == NodeKind::Element);
    let node = nodes.find(|node| node.start_tag_range().contains_range(frame.call.range))?;
    Some(node.start_tag_range().slice(source.item.text()).to_owned())
}

/// The frame of the call that was selected; none when it is gone.
pub fn selected_frame(expansion: &Expansion, selected: &SelectedInstance) -> Option<FrameId> {
    let symbols = expansion.index.symbols.iter();
    let mut known =
        symbols.filter(|(_, known)| known.kind == SymbolKind::Macro && known.name == selected.name);
    let (id, _) = known.find(|(_, known)| is_in(expansion, known.place, &selected.file))?;
    let frames = frames_of_macro(expansion, id);
    let same = |frame: &&FrameId| tags(expansion, **frame) == selected.tags;
    // calls that read alike are told apart by their order
    match frames.get(selected.index) {
        Some(frame) if same(&frame) => Some(*frame),
        other => frames.iter().find(same).or(other).copied(),
    }
}

/// Whether a place stands in the file.
fn is_in(expansion: &Expansion, place: SourceRange, file: &Path) -> bool {
    expansion
        .sources
        .get(place.src)
        .and_then(|source| expansion.files.get(source.file))
        .is_some_and(|known| *known.source.path == *file)
}
