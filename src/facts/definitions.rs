//! Where a file defines names among the children of its root, and which of these places a few of its items need.

use std::collections::BTreeSet;
use std::hash::{Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;

use super::{FactKind, facts_of};
use xml::{Document, Item, Node, NodeKind};

/// The places of definitions in a document, found without a look at its items.
#[derive(Debug, Default)]
pub struct Definitions {
    /// Hashes of names, each with the number of an item that defines it; sorted.
    named: Vec<(u32, u32)>,
    /// Items that may define anything: includes, conditions, names made by expressions.
    open: Vec<u32>,
    /// How many items the document has.
    count: usize,
}

impl Definitions {
    /// Those of a document.
    pub fn of(document: &Document) -> Self {
        let mut found = Self { count: document.item_count(), ..Self::default() };
        for (number, (_, item)) in document.items().enumerate() {
            for node in item.nodes().filter(|node| node.kind() == NodeKind::Element) {
                match node.name() {
                    "xacro:property" | "xacro:macro" | "xacro:arg" => match literal(node, "name") {
                        Some(name) => found.named.push((hash(name), number as u32)),
                        None => found.open.push(number as u32),
                    },
                    "xacro:include" | "xacro:if" | "xacro:unless" => found.open.push(number as u32),
                    _ => {}
                }
            }
        }
        found.named.sort_unstable();
        found
    }

    /// The items, by number, that some items need for their meaning: they themselves, what defines the names they
    /// mention or define as well, what these need in turn, and what may define anything. `document` is a later
    /// state, in which `changed` are the items that the first one did not have.
    pub fn needed(&self, document: &Document, changed: Range<usize>) -> Vec<usize> {
        let kept = document.item_count().saturating_sub(changed.len());
        let moves = Moves { gone: self.count.saturating_sub(kept), changed: changed.clone() };
        let mut needed: BTreeSet<usize> = changed.clone().collect();
        needed.extend(self.open.iter().filter_map(|&number| moves.number(number)));
        let mut queue: Vec<usize> = needed.iter().copied().collect();
        while let Some(number) = queue.pop() {
            let Some((_, item)) = document.item(number) else { continue };
            let mut names = Names::default();
            names.mentioned(item);
            if changed.contains(&number) {
                names.defined(item);
            }
            for number in self.defining(&names).filter_map(|number| moves.number(number)) {
                if needed.insert(number) {
                    queue.push(number);
                }
            }
        }
        needed.into_iter().collect()
    }

    /// The items that define some names.
    fn defining<'a>(&'a self, names: &'a Names) -> impl Iterator<Item = u32> + 'a {
        let of = |name: u32| {
            let start = self.named.partition_point(|&(known, _)| known < name);
            let named = self.named.get(start..).unwrap_or_default();
            named.iter().take_while(move |&&(known, _)| known == name).map(|&(_, number)| number)
        };
        let all = self.named.iter().filter(|_| names.any).map(|&(_, number)| number);
        names.hashes.iter().flat_map(move |&name| of(name)).chain(all)
    }
}

/// Where items are in a later state of a document.
struct Moves {
    /// How many items went.
    gone: usize,
    /// What came in their place.
    changed: Range<usize>,
}

impl Moves {
    fn number(&self, number: u32) -> Option<usize> {
        let number = number as usize;
        if number < self.changed.start {
            return Some(number);
        }
        (number >= self.changed.start + self.gone).then(|| number - self.gone + self.changed.len())
    }
}

/// Names that an item is about.
#[derive(Default)]
struct Names {
    hashes: BTreeSet<u32>,
    /// Which names these are is known only when the item is evaluated.
    any: bool,
}

impl Names {
    fn mentioned(&mut self, item: &Arc<Item>) {
        let facts = facts_of(item);
        self.hashes.extend(facts.mentions().map(|mention| hash(&mention.name)));
        self.hashes.extend(facts.of(FactKind::Call).map(|call| hash(&call.name)));
        for node in item.all_nodes().filter(|node| node.kind() == NodeKind::Element) {
            match node.name() {
                "xacro:insert_block" => self.attribute(node, "name"),
                "xacro:call" => self.attribute(node, "macro"),
                // a parameter with `^` is a property of the caller
                "xacro:macro" => self.passed_on(node),
                _ => {}
            }
        }
    }

    fn attribute(&mut self, node: Node<'_>, attr: &str) {
        match literal(node, attr) {
            Some(name) => self.hashes.extend([hash(name)]),
            None => self.any = true,
        }
    }

    fn passed_on(&mut self, node: Node<'_>) {
        let Some(params) = node.attr("params").map(|attr| attr.raw()).filter(|raw| raw.contains('^')) else {
            return;
        };
        let words = params.split(|c: char| !c.is_alphanumeric() && c != '_');
        self.hashes.extend(words.map(hash));
    }

    fn defined(&mut self, item: &Arc<Item>) {
        let facts = facts_of(item);
        let kinds = [FactKind::Property, FactKind::Macro, FactKind::Argument];
        let defined = facts.named.iter().filter(|fact| kinds.contains(&fact.kind));
        self.hashes.extend(defined.map(|fact| hash(&fact.name)));
    }
}

/// The value of an attribute without expressions or entities.
fn literal<'a>(node: Node<'a>, attr: &str) -> Option<&'a str> {
    let raw = node.attr(attr)?.raw();
    (!raw.contains(['$', '&'])).then_some(raw)
}

fn hash(name: &str) -> u32 {
    let mut state = rustc_hash::FxHasher::default();
    // the definition of a macro may name it with the prefix of its calls
    name.strip_prefix("xacro:").unwrap_or(name).hash(&mut state);
    let whole = state.finish();
    (whole ^ (whole >> 32)) as u32
}
