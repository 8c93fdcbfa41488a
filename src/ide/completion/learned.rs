//! Names of elements and attributes that no schema here describes, those of SDF, SRDF and plugins: taken from the same elements elsewhere in
//! the files of the robot.

use super::item::{Completion, ItemKind};
use super::names::file_name;
use super::scope::CompletionScope;
use crate::typed::Typed;
use base::FastSet;
use ecow::EcoString;
use std::sync::Arc;
use xml::{Node, NodeKind};

/// Different names that are taken over.
const MOST: usize = 60;

/// Attributes that elements with a tag have elsewhere.
pub(super) fn attributes(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: &str,
) -> Vec<Completion> {
    learned(scope, typed, tag, |node, add| {
        node.attrs().for_each(|attr| add(attr.name()))
    })
    .into_iter()
    .filter(|(name, _)| !name.contains(':'))
    .map(|(name, file)| {
        let snippet = format!("{name}=\"$1\"$0");
        Completion::new(ItemKind::Attribute, name)
            .snippet(snippet)
            .note(file)
    })
    .collect()
}

/// Elements that stand in elements with a tag elsewhere.
pub(super) fn children(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: &str,
) -> Vec<Completion> {
    learned(scope, typed, tag, |node, add| {
        node.child_elements().for_each(|child| add(child.name()))
    })
    .into_iter()
    .filter(|(name, _)| !name.contains(':'))
    .map(|(name, file)| {
        let snippet = format!("{name}>$1</{name}>$0");
        Completion::new(ItemKind::Element, name)
            .snippet(snippet)
            .note(file)
    })
    .collect()
}

/// What is read off the elements with a tag, each with the file that it is taken from. What is being typed is left out.
fn learned(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    tag: &str,
    read: impl Fn(Node<'_>, &mut dyn FnMut(&str)),
) -> Vec<(EcoString, String)> {
    let edited = &scope.sources.source.document;
    let place = edited.item_at(typed.offset.saturating_sub(1));
    let inside = typed.offset.saturating_sub(place.start);
    let mut seen: FastSet<EcoString> = FastSet::default();
    let mut found = Vec::new();
    let start = format!("<{tag}");
    for (_, file, item) in scope
        .items()
        .filter(|(_, _, item)| item.text().contains(start.as_str()))
    {
        let here = Arc::ptr_eq(item, place.item);
        let elements = item
            .all_nodes()
            .filter(|node| node.kind() == NodeKind::Element && node.name() == tag);
        for node in elements.filter(|node| !here || !node.range().touches(inside)) {
            read(node, &mut |name| {
                if found.len() < MOST && seen.insert(name.into()) {
                    found.push((EcoString::from(name), file_name(&file.source.path)));
                }
            });
        }
    }
    found
}
