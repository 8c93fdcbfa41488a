//! What a single place expands to: a call, an expression, a property, an include, a condition or a block.

use super::context::Cx;
use super::expressions::ExprText;
use super::hover::call_label;
use super::instances::{frames_of_macro, frames_of_tag, is_within, macro_of, numbered};
use super::locate::{LocatedNode, locate};
use super::values::{self, UNKNOWN};
use base::TextRange;
use expand::{Expansion, FrameId, FrameKind, Origin, Written, XKind};
use expr::{Value, display};
use xml::{Node, NodeKind};

/// A place and what it expands to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpandedAt {
    /// `macro`, `expression`, `property`, `include`, `condition` or `block`.
    pub kind: &'static str,
    /// What it is, for people.
    pub title: String,
    /// The text that the result stands for.
    pub range: TextRange,
    /// The result.
    pub expanded: String,
    /// How many ways lead here, each with a result of its own.
    pub instances: usize,
}

/// What stands at an offset, and each of its results.
struct EvaluatedText {
    kind: &'static str,
    title: String,
    range: TextRange,
    results: Vec<(FrameId, String)>,
}

/// What the place at an offset expands to on the way with the number `instance`; without one, on the way that was
/// selected, else on the first.
pub fn expand_at(
    cx: &Cx<'_>,
    written: &Written,
    offset: u32,
    instance: Option<usize>,
) -> Option<ExpandedAt> {
    let at = locate(&cx.source.document, offset);
    let found = expression(cx, &at).or_else(|| element(cx, written, &at))?;
    let selected = || {
        let selected_frame = cx.selected_frame?;
        found
            .results
            .iter()
            .position(|(frame, _)| is_within(cx.expansion, *frame, selected_frame))
    };
    let index = instance.or_else(selected).unwrap_or(0);
    let result = found.results.get(index);
    let mut title = found.title;
    if found.results.len() > 1
        && let Some(label) = result.and_then(|(frame, _)| call_label(cx, *frame))
    {
        title.push_str(&format!(" in {label}"));
    }
    Some(ExpandedAt {
        kind: found.kind,
        title,
        range: found.range,
        expanded: result.map(|(_, text)| text.clone()).unwrap_or_default(),
        instances: found.results.len(),
    })
}

/// The text of a value, whole.
fn text(value: &Value) -> String {
    display::to_str(value).map_or_else(|| UNKNOWN.to_owned(), |text| text.to_string())
}

fn expression(cx: &Cx<'_>, at: &LocatedNode<'_>) -> Option<EvaluatedText> {
    let text_here = ExprText::at(&cx.source.document, at)?;
    let token = text_here.token_at(at.offset)?;
    let range = text_here.range(token.range());
    let all = values::all_instances(cx, range);
    let results = all
        .iter()
        .map(|instance| (instance.frame, text(&instance.value)))
        .collect();
    let title = format!("`{}`", cx.source.document.slice(range));
    Some(EvaluatedText {
        kind: "expression",
        title,
        range,
        results,
    })
}

/// The element around a place that expands to something.
fn element(cx: &Cx<'_>, written: &Written, at: &LocatedNode<'_>) -> Option<EvaluatedText> {
    let mut next = at.node;
    while let Some(node) = next {
        let found = (node.kind() == NodeKind::Element).then(|| of_element(cx, written, at, node));
        if let Some(found) = found.flatten() {
            return Some(found);
        }
        next = node.parent();
    }
    None
}

fn of_element(
    cx: &Cx<'_>,
    written: &Written,
    at: &LocatedNode<'_>,
    node: Node<'_>,
) -> Option<EvaluatedText> {
    let tag = node.name().strip_prefix("xacro:")?;
    let range = at.shift(node.range());
    let (kind, title, results) = match tag {
        "property" => (
            "property",
            format!("property `{}`", raw(node, "name")),
            property(cx, written, at, node),
        ),
        "include" => (
            "include",
            format!("include `{}`", raw(node, "filename")),
            made_by_tag(cx, written, at, node),
        ),
        "insert_block" => (
            "block",
            format!("block `{}`", raw(node, "name")),
            made_by_tag(cx, written, at, node),
        ),
        "macro" => {
            let frames = macro_of(cx, at.base, node).map(|id| frames_of_macro(cx.expansion, id));
            (
                "macro",
                format!("macro `{}`", raw(node, "name")),
                made_in_each(cx, written, frames.unwrap_or_default()),
            )
        }
        "if" | "unless" => {
            let title = format!("`xacro:{tag}` of `{}`", raw(node, "value"));
            ("condition", title, condition(cx, written, at, node))
        }
        "arg" | "element" | "attribute" => return None,
        _ => (
            "macro",
            format!(
                "call of `{}`",
                if tag == "call" {
                    raw(node, "macro")
                } else {
                    tag
                }
            ),
            made_by_tag(cx, written, at, node),
        ),
    };
    Some(EvaluatedText {
        kind,
        title,
        range,
        results,
    })
}

/// What an attribute of an element says; nothing without it.
fn raw<'a>(node: Node<'a>, attr: &str) -> &'a str {
    node.attr(attr).map_or("", |attr| attr.raw())
}

/// What the tag of an element made, each time.
fn made_by_tag(
    cx: &Cx<'_>,
    written: &Written,
    at: &LocatedNode<'_>,
    node: Node<'_>,
) -> Vec<(FrameId, String)> {
    let frames = frames_of_tag(cx, at.shift(node.start_tag_range()));
    made_in_each(cx, written, frames)
}

fn made_in_each(cx: &Cx<'_>, written: &Written, frames: Vec<FrameId>) -> Vec<(FrameId, String)> {
    let result = |frame: FrameId| (frame, made_in(cx.expansion, written, frame).join("\n"));
    frames.into_iter().map(result).collect()
}

/// What the content of a condition gave, for each way that led there.
fn condition(
    cx: &Cx<'_>,
    written: &Written,
    at: &LocatedNode<'_>,
    node: Node<'_>,
) -> Vec<(FrameId, String)> {
    let expansion = cx.expansion;
    let Some(content) = cx.source_range(at.shift(node.range())) else {
        return Vec::new();
    };
    let holds =
        |origin: Origin| origin.src == content.src && content.range.contains_range(origin.range);
    contexts(cx, at, node)
        .into_iter()
        .map(|frame| {
            let from_here = |origin: Origin| {
                is_within(expansion, origin.frame, frame) && steps(expansion, origin).any(holds)
            };
            (frame, made(expansion, written, from_here).join("\n"))
        })
        .collect()
}

/// An origin, and the calls that led there.
fn steps(expansion: &Expansion, origin: Origin) -> impl Iterator<Item = Origin> + '_ {
    std::iter::once(origin).chain(expansion.frames_of(origin).map(|frame| frame.call))
}

/// The frames in which an element was looked at: those of the macro around it, or of its file.
fn contexts(cx: &Cx<'_>, at: &LocatedNode<'_>, node: Node<'_>) -> Vec<FrameId> {
    let mut outer = node.parent();
    while let Some(around) = outer {
        if around.name() == "xacro:macro" {
            let id = macro_of(cx, at.base, around);
            return id
                .map(|id| frames_of_macro(cx.expansion, id))
                .unwrap_or_default();
        }
        outer = around.parent();
    }
    let mut frames: Vec<FrameId> = Vec::new();
    for attr in node.attrs().filter(|attr| attr.has_dollar()) {
        let text = ExprText::of_attr(&cx.source.document, at.base, attr);
        for token in &text.template.tokens {
            let all = values::all_instances(cx, text.range(token.range()));
            frames.extend(all.iter().map(|instance| instance.frame));
        }
    }
    if frames.is_empty() {
        frames.push(FrameId::ROOT);
    }
    frames.dedup();
    frames
}

/// The values that a property had, or what its block gave where it was put in.
fn property(
    cx: &Cx<'_>,
    written: &Written,
    at: &LocatedNode<'_>,
    node: Node<'_>,
) -> Vec<(FrameId, String)> {
    let expansion = cx.expansion;
    let name = node
        .attr("name")
        .and_then(|name| cx.source_range(at.shift(name.value_range())));
    let given = expansion
        .index
        .symbols
        .iter()
        .find(|(_, given)| Some(given.place) == name);
    let Some((id, _)) = given else {
        return Vec::new();
    };
    let bindings = expansion
        .index
        .bindings
        .iter()
        .filter(|info| info.definition == Some(id));
    let mut results: Vec<(FrameId, String)> = Vec::new();
    for info in bindings {
        let frame = info.origin.map_or(FrameId::ROOT, |origin| origin.frame);
        let result = info.value.as_ref().map(|value| (frame, text(value)));
        results.extend(result.filter(|result| !results.contains(result)));
    }
    if results.is_empty()
        && let Some(whole) = cx
            .source_range(at.shift(node.range()))
            .filter(|_| node.attr("value").is_none())
    {
        let holds = |at: Origin| at.src == whole.src && whole.range.contains_range(at.range);
        let blocks = numbered(expansion).filter(|(_, frame)| {
            frame.kind == FrameKind::Block && frame.definition.is_some_and(holds)
        });
        results.extend(
            blocks.map(|(frame, _)| (frame, made_in(expansion, written, frame).join("\n"))),
        );
    }
    if results.is_empty()
        && let Some(value) = node.attr("value").filter(|value| !value.has_dollar())
    {
        results.push((FrameId::ROOT, value.raw().to_owned()));
    }
    results
}

/// What a call, an include or a block gave. Blocks that a call holds are made where the call stands, and only put in
/// by the macro.
pub(super) fn made_in(expansion: &Expansion, written: &Written, frame: FrameId) -> Vec<String> {
    let inside = numbered(expansion).filter(|(id, _)| is_within(expansion, *id, frame));
    let blocks = inside.filter(|(_, frame)| frame.kind == FrameKind::Block);
    let given: Vec<Origin> = blocks
        .filter_map(|(_, block)| element_of(expansion, block.definition?))
        .collect();
    made(expansion, written, |origin| {
        is_within(expansion, origin.frame, frame)
            || given.iter().any(|block| is_held_by(origin, *block))
    })
}

/// Whether a text stands in a block, on the same way.
fn is_held_by(origin: Origin, block: Origin) -> bool {
    block.src == origin.src
        && block.frame == origin.frame
        && block.range.contains_range(origin.range)
}

/// The whole element whose tag begins at an origin.
fn element_of(expansion: &Expansion, tag: Origin) -> Option<Origin> {
    let source = expansion.sources.get(tag.src)?;
    let mut nodes = source.item.all_nodes();
    let node = nodes
        .find(|node| node.kind() == NodeKind::Element && node.range().start == tag.range.start)?;
    Some(Origin {
        range: node.range(),
        ..tag
    })
}

/// The texts of the outermost elements, comments and words whose origin fits, each indented from its own start.
pub(super) fn made(
    expansion: &Expansion,
    written: &Written,
    fits: impl Fn(Origin) -> bool,
) -> Vec<String> {
    let tree = &expansion.tree;
    let mut end = 0;
    let mut found = Vec::new();
    for entry in &written.map {
        let node = tree.get(entry.node);
        if entry.out.start < end || !is_whole(node.kind) || !fits(node.origin) {
            continue;
        }
        end = entry.out.end;
        let text = entry.out.slice(&written.text).trim_end();
        if !text.trim().is_empty() {
            found.push(dedented(&written.text, entry.out.start, text));
        }
    }
    found
}

/// Whether a kind of node is shown by itself.
fn is_whole(kind: XKind) -> bool {
    matches!(
        kind,
        XKind::Element | XKind::Comment | XKind::Text | XKind::CData
    )
}

/// A text whose lines are indented as its first one is, without that.
fn dedented(all: &str, start: u32, text: &str) -> String {
    let before = all.get(..start as usize).unwrap_or("");
    let line = before.rsplit('\n').next().unwrap_or("");
    let margin = line.len() - line.trim_start_matches(' ').len();
    let strip = |line: &str| {
        let blanks = line.len() - line.trim_start_matches(' ').len();
        line.get(blanks.min(margin)..).unwrap_or("").to_owned()
    };
    let mut lines = text.split('\n');
    let first = lines.next().map(str::to_owned);
    let rest: Vec<String> = first.into_iter().chain(lines.map(strip)).collect();
    rest.join("\n")
}
