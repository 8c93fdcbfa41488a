//! What one file says by itself, item by item: names it gives, names it mentions, files it includes.
//!
//! Facts are read off the tree of an item once and stay with it, so after an edit only the edited item is
//! looked at again. They know nothing of other files: what a name refers to is the expander's business.

mod item;
mod marks;
mod mentions;
mod tags;
#[cfg(test)]
mod tests;

use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use ecow::EcoString;

pub use item::facts_of;
pub use marks::{Marks, ORDINARY_TAGS};
pub use mentions::{Mention, MentionKind, Site};
pub use tags::{XACRO_TAGS, XacroAttribute, XacroTag, is_keyword, xacro_tag};

use base::TextRange;
use xml::{Document, Item, ItemRun, NodeId};

/// The kinds of named things.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FactKind {
    /// `xacro:property`
    Property,
    /// `xacro:macro`
    Macro,
    /// `xacro:arg`
    Argument,
    /// `xacro:include`; its name is the file name.
    Include,
    /// A macro call; its name is that of the macro, with its namespaces.
    Call,
    /// `link`
    Link,
    /// `joint` with a `type`: a definition.
    Joint,
    /// `material`
    Material,
    /// `mesh`; its name is the file name.
    Mesh,
}

/// Something with a name; the name may hold expressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// What it is.
    pub kind: FactKind,
    /// The name as it is written, entities decoded.
    pub name: EcoString,
    /// The name's text, relative to the item.
    pub range: TextRange,
    /// The element.
    pub node: NodeId,
    /// Whether it stands inside a macro.
    pub in_macro: bool,
}

/// The facts of an item.
#[derive(Debug, Default)]
pub struct Facts {
    /// Named things in document order.
    pub named: Vec<Fact>,
    /// What it may hold.
    pub marks: Marks,
    /// Texts with expressions in document order; read when somebody asks, since expressions have to be parsed for it.
    sites: OnceLock<Vec<Site>>,
}

/// An item's facts, with the item.
pub struct FactsOf<'a> {
    item: &'a Arc<Item>,
    facts: Arc<Facts>,
}

impl Deref for FactsOf<'_> {
    type Target = Facts;

    fn deref(&self) -> &Facts {
        &self.facts
    }
}

impl FactsOf<'_> {
    /// Texts with expressions in document order.
    pub fn sites(&self) -> &[Site] {
        self.facts.sites.get_or_init(|| item::sites(self.item))
    }

    /// The names in them.
    pub fn mentions(&self) -> impl Iterator<Item = &Mention> {
        self.sites().iter().flat_map(|site| &site.mentions)
    }
}

impl Facts {
    /// The named things of one kind.
    pub fn of(&self, kind: FactKind) -> impl Iterator<Item = &Fact> {
        self.named.iter().filter(move |fact| fact.kind == kind)
    }
}

/// The facts of all parts of a document: header, items, footer; each with the offset its ranges count from.
pub fn facts(document: &Document) -> impl Iterator<Item = (u32, FactsOf<'_>)> {
    document.parts().map(|(base, item)| (base, facts_of(item)))
}

/// The parts of a document that may hold something: header, items, footer; each with the offset its ranges count from. Of items in
/// a row of which none does, each is not asked.
pub fn parts_where(
    document: &Document,
    may: impl Fn(Marks) -> bool + Copy,
) -> impl Iterator<Item = (u32, &Arc<Item>)> {
    let header = std::iter::once((0, document.header()));
    let footer = std::iter::once((document.footer_start(), document.footer()));
    let runs = document
        .item_runs()
        .filter(move |(_, run)| may(marks_of_run(run)));
    let items = runs.flat_map(|(mut next, run)| {
        run.iter().map(move |item| {
            let start = next;
            next += item.len();
            (start, item)
        })
    });
    let parts = header.chain(items).chain(footer);
    parts.filter(move |(_, item)| may(facts_of(item).marks))
}

/// Whether a part of a document may hold something.
pub fn may_hold(document: &Document, may: impl Fn(Marks) -> bool + Copy) -> bool {
    parts_where(document, may).next().is_some()
}

/// What one of several items may hold; kept with these.
fn marks_of_run(run: &ItemRun) -> Marks {
    *run.cached(|items| {
        let marks = items.iter().map(|item| facts_of(item).marks);
        Arc::new(marks.fold(Marks::default(), Marks::or))
    })
}
