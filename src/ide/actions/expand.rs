//! A macro call gives way to what it makes.

use super::place::{element_at, indented, line_end};
use super::{Action, ActionKind, edit};
use crate::Cx;
use crate::expand_at::made_in;
use crate::instances::{frames_of_tag, is_within, numbered};
use base::TextRange;
use expand::{FrameId, FrameKind, Origin, write_mapped};
use xml::{Document, Node, NodeKind};

/// Write what the call at an offset makes in its place, fully evaluated. Only for a call that is made once, whose
/// macro leaves nothing behind but elements.
pub(super) fn call(cx: &Cx<'_>, offset: u32) -> Option<Action> {
    let document = &cx.source.document;
    let (base, node) = element_at(document, offset)?;
    let tag = node.start_tag_range().shift(base);
    if base == 0 || !tag.touches(offset) || cx.expansion.has_errors() || !cx.expansion.complete {
        return None;
    }
    let frame = only_frame(cx, tag)?;
    let name = &cx.expansion.frames.get(frame)?.name;
    if leaves_something(cx, frame) {
        return None;
    }
    let parts = parts(cx, frame);
    let text = parts.join(line_end(document));
    // what looks like an expression would be evaluated once more
    if parts.is_empty() || text.contains("${") || text.contains("$(") || text.contains("$$") {
        return None;
    }
    let range = node.range().shift(base);
    let content = indented(document, range, &text)?;
    let title = format!("expand macro call `{name}` with evaluated values");
    Some(Action {
        title,
        kind: ActionKind::Inline,
        edits: vec![edit(cx.source, range, content)],
    })
}

/// The only expansion of the call whose tag stands at a range.
pub(super) fn only_frame(cx: &Cx<'_>, tag: TextRange) -> Option<FrameId> {
    let is_macro = |id: &FrameId| {
        cx.expansion
            .frames
            .get(*id)
            .is_some_and(|frame| frame.kind == FrameKind::Macro)
    };
    let mut made = frames_of_tag(cx, tag).into_iter().filter(is_macro);
    let only = made.next()?;
    made.next().is_none().then_some(only)
}

/// Whether a macro on the way defines something for those around it.
fn leaves_something(cx: &Cx<'_>, outer: FrameId) -> bool {
    let frames = numbered(cx.expansion).filter(|(id, _)| is_within(cx.expansion, *id, outer));
    let mut definitions = frames.filter_map(|(_, frame)| Some((frame.kind, frame.definition?)));
    definitions.any(
        |(kind, definition)| match (kind, source_node(cx, definition)) {
            (FrameKind::Macro, Some(node)) => below(node).any(defines),
            (FrameKind::Include, _) | (FrameKind::Macro, None) => true,
            _ => false,
        },
    )
}

pub(super) fn source_node<'a>(cx: &Cx<'a>, origin: Origin) -> Option<Node<'a>> {
    let item = &cx.expansion.sources.get(origin.src)?.item;
    let around = item.all_nodes().filter(|node| {
        node.kind() == NodeKind::Element
            && node.name() == "xacro:macro"
            && node.range().contains_range(origin.range)
    });
    around.last()
}

fn below<'a>(node: Node<'a>) -> impl Iterator<Item = Node<'a>> {
    let range = node.range();
    node.item()
        .all_nodes()
        .filter(move |inner| *inner != node && range.contains_range(inner.range()))
}

fn defines(node: Node<'_>) -> bool {
    match node.name() {
        "xacro:macro" | "xacro:include" | "xacro:arg" => true,
        "xacro:property" => node.attr("scope").is_some(),
        _ => false,
    }
}

/// The texts of the outermost elements and comments that came through a frame.
fn parts(cx: &Cx<'_>, frame: FrameId) -> Vec<String> {
    let written = write_mapped(&cx.expansion.tree, "");
    let mut found = made_in(cx.expansion, &written, frame);
    // indentation starts again
    found.retain(|text| {
        Document::parse(&format!("<a>{text}</a>"))
            .errors()
            .is_empty()
    });
    found
}
