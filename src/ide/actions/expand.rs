//! A macro call gives way to what it makes.

use super::place::{element_at, indented, line_end};
use super::{Action, ActionKind, edit};
use crate::base::TextRange;
use crate::expand::{FrameId, FrameKind, MapEntry, Origin, SourceRange, XKind, write_mapped};
use crate::ide::Cx;
use crate::xml::{Document, Node, NodeKind};

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
    let name = &cx.expansion.frames.get(frame.0 as usize)?.name;
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
    let title = format!("expand macro `{name}` here");
    Some(Action { title, kind: ActionKind::Inline, edits: vec![edit(cx.source, range, content)] })
}

/// The only expansion of the call whose tag stands at a range.
fn only_frame(cx: &Cx<'_>, tag: TextRange) -> Option<FrameId> {
    let is_here = |origin: Origin| {
        let span = cx.span(SourceRange::from(origin));
        span.is_some_and(|span| span.file == cx.source.id && tag.contains_range(span.range))
    };
    let frames = (0..).map(FrameId).zip(&cx.expansion.frames);
    let mut made = frames.filter(|(_, frame)| frame.kind == FrameKind::Macro && is_here(frame.call));
    let (only, _) = made.next()?;
    made.next().is_none().then_some(only)
}

/// Whether a frame lies in another one, or is that one.
fn is_within(cx: &Cx<'_>, frame: FrameId, outer: FrameId) -> bool {
    let frames = &cx.expansion.frames;
    let next = |inner: &FrameId| {
        let call = frames.get(inner.0 as usize)?.call.frame;
        (call != *inner && *inner != FrameId::ROOT).then_some(call)
    };
    std::iter::successors(Some(frame), next).any(|frame| frame == outer)
}

/// Whether a macro on the way defines something for those around it.
fn leaves_something(cx: &Cx<'_>, outer: FrameId) -> bool {
    let frames = (0..).map(FrameId).zip(&cx.expansion.frames).filter(|(id, _)| is_within(cx, *id, outer));
    let mut definitions = frames.filter_map(|(_, frame)| Some((frame.kind, frame.definition?)));
    definitions.any(|(kind, definition)| match (kind, source_node(cx, definition)) {
        (FrameKind::Macro, Some(node)) => below(node).any(defines),
        (FrameKind::Include, _) | (FrameKind::Macro, None) => true,
        _ => false,
    })
}

fn source_node<'a>(cx: &Cx<'a>, origin: Origin) -> Option<Node<'a>> {
    let item = &cx.expansion.sources.get(origin.src.0 as usize)?.item;
    let around = item.all_nodes().filter(|node| {
        node.kind() == NodeKind::Element
            && node.name() == "xacro:macro"
            && node.range().contains_range(origin.range)
    });
    around.last()
}

fn below<'a>(node: Node<'a>) -> impl Iterator<Item = Node<'a>> {
    let range = node.range();
    node.item().all_nodes().filter(move |inner| *inner != node && range.contains_range(inner.range()))
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
    let tree = &cx.expansion.tree;
    let written = write_mapped(tree, "");
    let made = |entry: &MapEntry| is_within(cx, tree.get(entry.node).origin.frame, frame);
    let mut end = 0;
    let mut found = Vec::new();
    for entry in &written.map {
        let whole = matches!(tree.get(entry.node).kind, XKind::Element | XKind::Comment);
        if entry.out.start < end || !whole || !made(entry) {
            continue;
        }
        end = entry.out.end;
        found.push(entry.out.slice(&written.text).trim_end().to_owned());
    }
    // indentation starts anew
    found.retain(|text| Document::parse(&format!("<a>{text}</a>")).errors().is_empty());
    found
}
