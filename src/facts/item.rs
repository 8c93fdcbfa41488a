//! Reading facts off the tree of an item.

use std::sync::{Arc, OnceLock};

use super::marks::Marks;
use super::mentions::site;
use super::tags::is_keyword;
use super::{Fact, FactKind, Facts, FactsOf, Site};
use base::TextRange;
use xml::{Attr, Entities, Item, Node, NodeKind};

/// The facts of an item; read once, kept with it.
pub fn facts_of(item: &Arc<Item>) -> FactsOf<'_> {
    /// Most items of a file with a million of them have no names.
    static NAMELESS: [OnceLock<Arc<Facts>>; Marks::COUNT] =
        [const { OnceLock::new() }; Marks::COUNT];
    let facts = item.cached(|item| {
        let (named, marks) = (named(item), Marks::of(item));
        let is_plain = named.is_empty() && !item.text().contains('$');
        let shared = NAMELESS.get(marks.number()).filter(|_| is_plain);
        let facts = || {
            let sites = OnceLock::new();
            Arc::new(Facts {
                named,
                marks,
                sites,
            })
        };
        match shared {
            Some(shared) => Arc::clone(shared.get_or_init(facts)),
            None => facts(),
        }
    });
    FactsOf { item, facts }
}

fn named(item: &Item) -> Vec<Fact> {
    let mut named = Vec::new();
    // the end of the macro around the current node; macros nest, so the outermost one counts
    let mut macro_end = 0;
    for node in item
        .all_nodes()
        .filter(|node| node.kind() == NodeKind::Element)
    {
        let in_macro = node.range().start < macro_end;
        named.extend(fact(node, in_macro));
        if node.name() == "xacro:macro" {
            macro_end = macro_end.max(node.range().end);
        }
    }
    named
}

/// Texts with expressions in document order.
pub(super) fn sites(item: &Item) -> Vec<Site> {
    let mut sites = Vec::new();
    for node in item.all_nodes() {
        match node.kind() {
            NodeKind::Element => {
                sites.extend(
                    node.attrs()
                        .filter(|attr| attr.has_dollar())
                        .filter_map(attribute_site),
                );
            }
            NodeKind::Text if node.has_dollar() => {
                sites.extend(site(node.raw(), node.raw_range(), false));
            }
            _ => {}
        }
    }
    sites
}

fn attribute_site(attr: Attr<'_>) -> Option<Site> {
    site(attr.raw(), attr.value_range(), true)
}

fn fact(node: Node<'_>, in_macro: bool) -> Option<Fact> {
    let (kind, attr) = match node.name() {
        "xacro:property" => (FactKind::Property, "name"),
        "xacro:macro" => (FactKind::Macro, "name"),
        "xacro:arg" => (FactKind::Argument, "name"),
        "xacro:include" => (FactKind::Include, "filename"),
        "link" => (FactKind::Link, "name"),
        "joint" if node.attr("type").is_some() => (FactKind::Joint, "name"),
        "material" => (FactKind::Material, "name"),
        "mesh" => (FactKind::Mesh, "filename"),
        name => return call(node, name, in_macro),
    };
    let attr = node.attr(attr)?;
    let name = attr.value(&Entities::default()).as_ref().into();
    Some(Fact {
        kind,
        name,
        range: attr.value_range(),
        node: node.id(),
        in_macro,
    })
}

fn call(node: Node<'_>, name: &str, in_macro: bool) -> Option<Fact> {
    let called = name
        .strip_prefix("xacro:")
        .filter(|called| !is_keyword(called))?;
    let end = node.name_range().end;
    let range = TextRange::new(end - called.len() as u32, end);
    Some(Fact {
        kind: FactKind::Call,
        name: called.into(),
        range,
        node: node.id(),
        in_macro,
    })
}
