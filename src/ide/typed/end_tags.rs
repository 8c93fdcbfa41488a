//! End tags that are missing, and those that are too many.

use xml::{Document, DocumentPart, Node, NodeKind};

/// Whether an element of the document has an end tag, and one of its own name.
pub fn has_end_tag(document: &Document, node: Node<'_>) -> bool {
    if document.root() == Some(node) {
        return document.root_end_tag().is_some();
    }
    end_name(node).is_some_and(|name| name == node.name())
}

fn end_name(node: Node<'_>) -> Option<&str> {
    Some(node.end_name_range()?.slice(node.item().text()))
}

/// The element whose end tag, one of its own name, ends at an offset.
pub fn ended_at(document: &Document, offset: u32) -> Option<Node<'_>> {
    let place = document.item_at(offset.saturating_sub(1));
    let inside = offset - place.start;
    let is_it = |node: &Node<'_>| node.end_tag().is_some_and(|tag| tag.end == inside);
    let node = place.item.all_nodes().find(is_it)?;
    has_end_tag(document, node).then_some(node)
}

/// Whether there is an end tag too many of the name that the one at an offset has: it closes nothing or something of
/// another name, or else one behind it does, with nothing but end tags of this name between that close something.
pub fn is_surplus(document: &Document, offset: u32, name: &str) -> bool {
    let mut offset = offset;
    loop {
        let next = match owner(document, offset) {
            ClosedElement::Nothing => return true,
            ClosedElement::Root => return is_junk_of(document.epilog(), name) == Some(true),
            ClosedElement::Element(node, _) if node.name() != name => return true,
            ClosedElement::Element(node, base) => behind(document, node, base, name),
        };
        match next {
            Next::EndTag(at) => offset = at,
            Next::Surplus(is_surplus) => return is_surplus,
        }
    }
}

/// What an end tag closes.
enum ClosedElement<'a> {
    Nothing,
    Root,
    /// An element, and where its item begins.
    Element(Node<'a>, u32),
}

fn owner(document: &Document, offset: u32) -> ClosedElement<'_> {
    if document
        .root_end_tag()
        .is_some_and(|tag| tag.start == offset)
    {
        return ClosedElement::Root;
    }
    let place = document.item_at(offset);
    let inside = offset - place.start;
    let is_it = |node: &Node<'_>| node.end_tag().is_some_and(|tag| tag.start == inside);
    match place.item.all_nodes().find(is_it) {
        Some(node) => ClosedElement::Element(node, place.start),
        None => ClosedElement::Nothing,
    }
}

/// What follows the end tag of an element.
enum Next {
    /// An end tag of the same name, that closes what is around.
    EndTag(u32),
    /// Whether one of the name follows that closes nothing.
    Surplus(bool),
}

fn behind(document: &Document, node: Node<'_>, base: u32, name: &str) -> Next {
    let siblings = std::iter::successors(node.next_sibling(), |node| node.next_sibling());
    if let Some(is_it) = is_junk_of(siblings, name) {
        return Next::Surplus(is_it);
    }
    let Some(parent) = node.parent() else {
        return behind_item(document, base + node.range().end, name);
    };
    let end = parent.end_tag().filter(|_| end_name(parent) == Some(name));
    match end {
        Some(tag) => Next::EndTag(base + tag.start),
        None => Next::Surplus(false),
    }
}

/// What follows an item, up to the next element. Those behind it are not looked through: there may be many.
fn behind_item(document: &Document, end: u32, name: &str) -> Next {
    let place = document.item_at(end);
    let inner = place.item.nodes().take_while(|node| {
        let is_behind_root = document
            .root_end_tag()
            .is_some_and(|tag| tag.end <= place.start + node.range().start);
        node.kind() != NodeKind::Element && !is_behind_root
    });
    if let Some(is_it) = is_junk_of(inner, name) {
        return Next::Surplus(is_it);
    }
    let root = document
        .root_end_tag()
        .filter(|_| place.part == DocumentPart::Footer);
    let is_named = document.root().is_some_and(|root| root.name() == name);
    match root {
        Some(tag) if is_named => Next::EndTag(tag.start),
        _ => Next::Surplus(false),
    }
}

/// Whether the first end tag among nodes that closes nothing has this name.
fn is_junk_of<'a>(nodes: impl Iterator<Item = Node<'a>>, name: &str) -> Option<bool> {
    let mut tags = nodes.filter_map(|node| {
        let text = node.range().slice(node.item().text());
        text.strip_prefix("</")
            .filter(|_| node.kind() == NodeKind::Junk)
    });
    let tag = tags.next()?;
    let rest = tag.strip_prefix(name);
    Some(rest.is_some_and(|rest| rest.starts_with(|c: char| c.is_whitespace() || c == '>')))
}
