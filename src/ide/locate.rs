//! What stands at an offset of a file.

use std::sync::Arc;

use base::TextRange;
use xml::{Attr, Document, Item, Node, NodeKind};

/// What stands at an offset: the part of the document, its innermost node and what of it. All ranges of nodes
/// and attributes count from `base`.
pub struct LocatedNode<'a> {
    /// The offset asked for.
    pub offset: u32,
    /// Offset of the item.
    pub base: u32,
    /// The item around the offset.
    pub item: &'a Arc<Item>,
    /// The innermost node around the offset.
    pub node: Option<Node<'a>>,
    /// What of the node.
    pub part: NodePart<'a>,
}

/// A part of a node.
#[derive(Clone, Copy)]
pub enum NodePart<'a> {
    /// The name in the start tag.
    StartName,
    /// The name in the end tag.
    EndName,
    /// The name of an attribute.
    AttrName(Attr<'a>),
    /// The value of an attribute, without its quotes.
    AttrValue(Attr<'a>),
    /// Elsewhere inside of a start tag.
    InTag,
    /// Character data.
    Text,
    /// A comment or a CDATA section, an instruction, a document type.
    Verbatim,
    /// Between the children of an element, or outside of everything.
    Between,
}

/// What stands at `offset` of a document.
pub fn locate(document: &Document, offset: u32) -> LocatedNode<'_> {
    let place = document.item_at(offset);
    let (base, item) = (place.start, place.item);
    let inside = offset.saturating_sub(base);
    // parents come before their children: the last one around the offset is the innermost
    let around = |node: &Node<'_>| {
        let range = node.range();
        range.start < inside && inside < range.end
            || range.touches(inside) && node.kind() == NodeKind::Text
    };
    let node = item.all_nodes().filter(around).last();
    let part = node.map_or(NodePart::Between, |node| part(node, inside));
    LocatedNode {
        offset,
        base,
        item,
        node,
        part,
    }
}

fn part(node: Node<'_>, inside: u32) -> NodePart<'_> {
    match node.kind() {
        NodeKind::Element => {}
        NodeKind::Text => return NodePart::Text,
        NodeKind::Junk => return NodePart::Between,
        _ => return NodePart::Verbatim,
    }
    if node.name_range().touches(inside) {
        return NodePart::StartName;
    }
    if node
        .end_name_range()
        .is_some_and(|range| range.touches(inside))
    {
        return NodePart::EndName;
    }
    for attr in node.attrs() {
        if attr.has_equals() && attr.value_range().touches(inside) && inside > attr.name_range().end
        {
            return NodePart::AttrValue(attr);
        }
        if attr.name_range().touches(inside) {
            return NodePart::AttrName(attr);
        }
    }
    let tag = node.start_tag_range();
    if tag.start < inside && inside < tag.end {
        NodePart::InTag
    } else {
        NodePart::Between
    }
}

/// The offset of the name of a tag, for one at the `<` or the `xacro:` in front of it: these mean what the name means. Every
/// other offset stays as it is.
pub fn on_name_of_tag(document: &Document, offset: u32) -> u32 {
    let place = document.item_at(offset);
    let inside = offset.saturating_sub(place.start);
    let is_in_front = |node: &Node<'_>| {
        node.kind() == NodeKind::Element
            && node.start_tag_range().start <= inside
            && inside < start_of_name(node)
    };
    let mut nodes = place.item.all_nodes();
    nodes
        .find(is_in_front)
        .map_or(offset, |node| place.start + start_of_name(&node))
}

/// Where the name of a tag begins, behind `xacro:`.
fn start_of_name(node: &Node<'_>) -> u32 {
    const PREFIX: &str = "xacro:";
    let prefix = if node.name().starts_with(PREFIX) {
        PREFIX.len() as u32
    } else {
        0
    };
    node.name_range().start + prefix
}

impl LocatedNode<'_> {
    /// A range of the item as a range of the file.
    pub fn shift(&self, range: TextRange) -> TextRange {
        range.shift(self.base)
    }
}
