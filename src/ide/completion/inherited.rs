//! What a macro sees of those that call it: their parameters and properties.

use std::sync::Arc;

use ecow::EcoString;

use super::item::{Completion, ItemKind};
use super::scope::CompletionScope;
use crate::typed::{Typed, attr_text};
use base::FastSet;
use expand::parse_params;
use facts::{FactKind, facts_of};
use xml::{Entities, Item, Node};

/// Macros that are followed back.
const MOST_MACROS: usize = 40;

/// A macro that calls others.
struct CallingMacro {
    name: EcoString,
    item: Arc<Item>,
    node: xml::NodeId,
}

/// The names of the macros that call the one around the cursor, and of those that call them: the nearest first.
pub(super) fn names(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let Some(own) = typed.in_macro().and_then(|open| attr_text(open, "name")) else {
        return Vec::new();
    };
    let mut open: Vec<EcoString> = vec![own.trim_start_matches("xacro:").into()];
    let mut seen: FastSet<EcoString> = open.iter().cloned().collect();
    let mut found = Vec::new();
    let mut next = 0;
    while let Some(name) = open.get(next).cloned().filter(|_| next < MOST_MACROS) {
        next += 1;
        for caller in callers(scope, &name) {
            if seen.insert(caller.name.clone()) {
                found.extend(given_in(&caller));
                open.push(caller.name);
            }
        }
    }
    found
}

/// The macros whose bodies call one of this name.
fn callers(scope: &CompletionScope<'_>, name: &str) -> Vec<CallingMacro> {
    let mut found = Vec::new();
    for (_, _, item) in scope.items() {
        let facts = facts_of(item);
        let calls = facts.of(FactKind::Call).filter(|call| call.in_macro);
        let calls = calls.filter(|call| call.name.rsplit('.').next() == Some(name));
        for node in calls.filter_map(|call| macro_around(item.node(call.node))) {
            let name = node
                .attr("name")
                .map_or("", |attr| attr.raw())
                .trim_start_matches("xacro:")
                .into();
            found.push(CallingMacro {
                name,
                item: item.clone(),
                node: node.id(),
            });
        }
    }
    found
}

/// The innermost macro around a node.
fn macro_around(node: Node<'_>) -> Option<Node<'_>> {
    let mut around = std::iter::successors(node.parent(), |node| node.parent());
    around.find(|node| node.name() == "xacro:macro")
}

/// The names that a macro gives to what it calls.
fn given_in(caller: &CallingMacro) -> Vec<Completion> {
    let node = caller.item.node(caller.node);
    let note = format!("from `{}`, which calls this macro", caller.name);
    let params = node
        .attr("params")
        .map(|attr| attr.value(&Entities::default()).into_owned());
    let params = params
        .and_then(|text| parse_params(&text))
        .unwrap_or_default()
        .into_iter();
    let params = params.filter(|param| !param.is_block());
    let mut found: Vec<Completion> = params
        .map(|param| Completion::new(ItemKind::Parameter, param.name))
        .collect();
    let body = node.range();
    let facts = facts_of(&caller.item);
    let own = facts.of(FactKind::Property).filter(|fact| {
        let given = caller.item.node(fact.node);
        body.contains_range(given.range())
            && given.attr("value").or(given.attr("default")).is_some()
    });
    let own = own.filter(|fact| !fact.name.contains('$'));
    found.extend(
        own.map(|fact| Completion::new(ItemKind::Property, fact.name.clone()).detail("property")),
    );
    found
        .into_iter()
        .map(|item| item.note(note.clone()).rank(3))
        .collect()
}
