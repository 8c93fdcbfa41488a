//! From expanded elements back to the words of the source.

use base::TextRange;
use expand::{Expansion, Origin, XId, XTree};
use xml::Node;

/// The start of an element's tag: from `<` to the end of the name as the source spells it.
pub fn tag_start(expansion: &Expansion, element: XId) -> Origin {
    let origin = expansion.tree.get(element).origin;
    match node(expansion, origin) {
        Some(node) => Origin {
            range: TextRange::new(origin.range.start, node.name_range().end),
            ..origin
        },
        None => origin,
    }
}

/// A whole element, from `<` to the `>` that ends it.
pub fn element_range(expansion: &Expansion, element: XId) -> Origin {
    let origin = expansion.tree.get(element).origin;
    node(expansion, origin).map_or(origin, |node| Origin {
        range: node.range(),
        ..origin
    })
}

/// An attribute of an element, from its name to the closing quote; none when the source has no such attribute.
pub fn attr_range(expansion: &Expansion, element: XId, name: &str) -> Option<Origin> {
    let origin = expansion.tree.get(element).origin;
    Some(Origin {
        range: node(expansion, origin)?.attr(name)?.range(),
        ..origin
    })
}

/// Whether the source of an element has elements inside, whatever became of them.
pub fn source_has_elements(expansion: &Expansion, element: XId) -> bool {
    let origin = expansion.tree.get(element).origin;
    node(expansion, origin).is_none_or(|node| node.child_elements().next().is_some())
}

/// Whether the source of an element has an element of a name somewhere inside, whatever became of it.
pub fn source_mentions(expansion: &Expansion, element: XId, name: &str) -> bool {
    let origin = expansion.tree.get(element).origin;
    let Some(node) = node(expansion, origin) else {
        return false;
    };
    let mut open: Vec<Node<'_>> = node.child_elements().collect();
    while let Some(inner) = open.pop() {
        if inner.name() == name {
            return true;
        }
        open.extend(inner.child_elements());
    }
    false
}

/// The source element whose start tag is at `origin`.
fn node(expansion: &Expansion, origin: Origin) -> Option<Node<'_>> {
    let item = &expansion.sources.get(origin.src)?.item;
    item.element_at(origin.range.start)
        .filter(|node| node.start_tag_range() == origin.range)
}

/// The first child element of a name.
pub(super) fn child(tree: &XTree, element: XId, name: &str) -> Option<XId> {
    tree.elements(element).find(|&id| tree.get(id).text == name)
}

/// The first child element of each name; urdfdom reads no others.
pub(super) fn first_children<const N: usize>(
    tree: &XTree,
    element: XId,
    names: [&str; N],
) -> [Option<XId>; N] {
    let mut found = [None; N];
    for id in tree.elements(element) {
        let name = tree.get(id).text.as_str();
        let place = names.iter().position(|wanted| *wanted == name);
        if let Some(slot) = place.and_then(|place| found.get_mut(place)) {
            slot.get_or_insert(id);
        }
    }
    found
}

/// The child elements of a name.
pub(super) fn children<'a>(
    tree: &'a XTree,
    element: XId,
    name: &'a str,
) -> impl Iterator<Item = XId> + 'a {
    tree.elements(element)
        .filter(move |&id| tree.get(id).text == name)
}
