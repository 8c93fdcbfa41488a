//! Where new elements go, and how they are indented.

use crate::{LocatedNode, format_range, indentation, locate};
use base::TextRange;
use vfs::SourceFile;
use workspace::config::Format;
use xml::{Document, DocumentPart, Node, NodeKind};

/// The line end of a document.
pub(super) fn line_end(document: &Document) -> &'static str {
    document.line_end()
}

/// The white space that begins the line of an offset.
pub(super) fn margin(document: &Document, offset: u32) -> String {
    let line = document.line_col(offset, base::Encoding::Utf8).line;
    let text = document.line_text(line);
    text.chars()
        .take_while(|c| matches!(c, ' ' | '\t'))
        .collect()
}

/// The innermost element at an offset; at the border of two, the one that begins there.
pub(super) fn element_at(document: &Document, offset: u32) -> Option<(u32, Node<'_>)> {
    let LocatedNode { base, item, .. } = locate(document, offset);
    let inside = offset - base.min(offset);
    let around = item.all_nodes().filter(|node| {
        let range = node.range();
        node.kind() == NodeKind::Element && range.start <= inside && inside < range.end
    });
    around.last().map(|node| (base, node))
}

/// The nearest element of this name at or around an offset.
pub(super) fn enclosing<'a>(
    document: &'a Document,
    offset: u32,
    name: &str,
) -> Option<(u32, Node<'a>)> {
    let (base, node) = element_at(document, offset)?;
    let mut next = Some(node);
    while let Some(node) = next {
        if node.name() == name {
            return Some((base, node));
        }
        next = node.parent();
    }
    None
}

/// Where a new child of the root goes that is to stand in front of what is at an offset: behind a line end or a
/// tag, in front of the comments that belong to the element there.
pub(super) fn before(document: &Document, offset: u32) -> Option<u32> {
    let place = document.item_at(offset);
    if !matches!(place.part, DocumentPart::Item(_)) {
        return first_child(document);
    }
    let element = place.item.element()?;
    let mut nodes: Vec<Node<'_>> = place
        .item
        .nodes()
        .take_while(|node| *node != element)
        .collect();
    let mut start = element.range().start;
    while let Some(node) = nodes.pop() {
        match node.kind() {
            NodeKind::Text if node.raw().matches('\n').count() <= 1 => {}
            NodeKind::Comment => start = node.range().start,
            _ => break,
        }
    }
    Some(place.start + start)
}

/// Where the first child of the root goes.
pub(super) fn first_child(document: &Document) -> Option<u32> {
    let root = document.root().filter(|root| !root.is_self_closing())?;
    Some(root.start_tag_range().end)
}

/// The text of a new element as a child of the root at an offset that [`before`] gave.
pub(super) fn top_level(document: &Document, at: u32, element: &str) -> String {
    let end = line_end(document);
    let is_first = first_child(document) == Some(at);
    if is_first {
        return format!("{end}{}{element}", indentation(document).unit);
    }
    format!("{element}{end}{}", margin(document, at))
}

/// A text that takes the place of a range, indented as the formatter would in the changed document.
pub(super) fn indented(document: &Document, range: TextRange, text: &str) -> Option<String> {
    let mut changed = document.text();
    changed.replace_range(range.start as usize..range.end as usize, text);
    let new = TextRange::new(range.start, range.start + text.len() as u32);
    let edits = format_range(
        &Document::parse(&changed),
        new,
        &indentation(document),
        &Format::default(),
    );
    for (place, text) in edits
        .iter()
        .rev()
        .filter(|(place, _)| new.contains_range(*place))
    {
        changed.replace_range(place.start as usize..place.end as usize, text);
    }
    let end = (changed.len() as u32 + range.end).checked_sub(document.len())?;
    changed
        .get(range.start as usize..end as usize)
        .map(str::to_owned)
}

/// The place and text of a new last child of an element.
pub(super) fn last_child(
    source: &SourceFile,
    base: u32,
    parent: Node<'_>,
    child: &str,
) -> (TextRange, String) {
    let document = &source.document;
    let end = line_end(document);
    let margin = margin(document, base + parent.range().start);
    let inner = format!("{margin}{}", indentation(document).unit);
    let Some(tag) = parent.end_tag() else {
        let closer = parent.start_tag_range().shift(base);
        let text = document.slice(closer);
        let blanks = text
            .trim_end_matches('>')
            .trim_end_matches('/')
            .trim_end()
            .len() as u32;
        let range = TextRange::new(closer.start + blanks, closer.end);
        return (
            range,
            format!(">{end}{inner}{child}{end}{margin}</{}>", parent.name()),
        );
    };
    let last = parent
        .children()
        .filter(|node| node.kind() != NodeKind::Text)
        .last();
    match last {
        Some(last) => (
            TextRange::empty(base + last.range().end),
            format!("{end}{inner}{child}"),
        ),
        None => {
            let range = TextRange::new(parent.start_tag_range().end, tag.start).shift(base);
            (range, format!("{end}{inner}{child}{end}{margin}"))
        }
    }
}
