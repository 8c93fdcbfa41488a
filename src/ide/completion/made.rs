//! Links and joints that the macros make which a text calls, spelled as the caller would spell them.
//!
//! Of `<xacro:wheel name="left"/>`, whose macro makes `${prefix}wheel_${name}`, that is `${prefix}wheel_left`.

use std::sync::Arc;

use ecow::EcoString;

use super::item::{Completion, ItemKind};
use super::members::is_word;
use super::scope::{CompletionScope, MacroInfo, macro_around, macro_at};
use crate::typed::Typed;
use base::FastMap;
use expr::TemplateToken;
use facts::{Fact, FactKind, facts_of};
use xml::{Entities, Item, Node};

/// Calls that are looked into.
const MOST_CALLS: usize = 300;
/// Macros that call macros.
const MOST_DEEP: u32 = 3;

/// What a call gives, by the name of the parameter, as the first caller would write it; none: that cannot be written.
type CallValues = FastMap<EcoString, Option<EcoString>>;

/// The names that the calls of the edited file make; those around the cursor come before the others.
pub(super) fn names(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    fact: FactKind,
    kind: ItemKind,
) -> Vec<Completion> {
    let document = &scope.sources.source.document;
    let place = document.item_at(typed.offset.saturating_sub(1));
    let around = macro_at(place.item, typed.offset.saturating_sub(place.start));
    let mut work = CallContext {
        scope,
        fact,
        macros: FastMap::default(),
        left: MOST_CALLS,
        found: Vec::new(),
    };
    let mut found = Vec::new();
    for (base, item) in document.parts() {
        let here = Arc::ptr_eq(item, place.item);
        for call in facts_of(item).of(FactKind::Call) {
            let node = item.node(call.node);
            if here && node.start_tag_range().shift(base).touches(typed.offset) {
                continue;
            }
            let is_near = match around {
                Some(_) => here && macro_around(node) == around,
                None => !call.in_macro,
            };
            work.call(&call.name, node, &|text| Some(text.into()), MOST_DEEP);
            let rank = if is_near { 2 } else { 4 };
            let note = format!("made by {}", call.name);
            let made = work
                .found
                .drain(..)
                .map(|name| Completion::new(kind, name).note(note.clone()));
            found.extend(made.map(|item| item.rank(rank)));
        }
    }
    found
}

/// What is known while calls are followed.
struct CallContext<'a> {
    scope: &'a CompletionScope<'a>,
    fact: FactKind,
    macros: FastMap<EcoString, Option<Arc<MacroInfo>>>,
    left: usize,
    found: Vec<EcoString>,
}

impl CallContext<'_> {
    /// Add what a call makes. `written` spells what it gives as the first caller would write it.
    fn call(
        &mut self,
        name: &EcoString,
        node: Node<'_>,
        written: &dyn Fn(&str) -> Option<EcoString>,
        deep: u32,
    ) {
        let scope = self.scope;
        let look_up = || scope.called(&format!("xacro:{name}")).map(Arc::new);
        let Some(info) = self
            .macros
            .entry(name.clone())
            .or_insert_with(look_up)
            .clone()
        else {
            return;
        };
        let Some(left) = self.left.checked_sub(1) else {
            return;
        };
        self.left = left;
        let given = given(&info, node, written);
        let body = info.item.node(info.node).range();
        let facts = facts_of(&info.item);
        let inside = |fact: &&Fact| body.contains_range(info.item.node(fact.node).range());
        for fact in facts.of(self.fact).filter(inside) {
            self.found
                .extend(spelled(&fact.name, &given).filter(|name| !name.is_empty()));
        }
        let Some(deeper) = deep.checked_sub(1) else {
            return;
        };
        for call in facts.of(FactKind::Call).filter(inside) {
            self.call(
                &call.name,
                info.item.node(call.node),
                &|text| spelled(text, &given),
                deeper,
            );
        }
    }
}

/// What the names in a macro's body stand for in a call.
fn given(
    info: &MacroInfo,
    node: Node<'_>,
    written: &dyn Fn(&str) -> Option<EcoString>,
) -> CallValues {
    let mut given: CallValues = own_properties(&info.item, info.node)
        .map(|name| (name, None))
        .collect();
    for param in info.params.iter().filter(|param| !param.is_block()) {
        let value = match (node.attr(&param.name), &param.default) {
            (Some(attr), _) => written(&attr.value(&Entities::default())),
            (None, _) if param.forward => Some(ecow::eco_format!("${{{}}}", param.name)),
            (None, Some((text, _))) => Some(text.trim_matches('\'').into()),
            (None, None) => None,
        };
        given.insert(param.name.clone(), value);
    }
    given
}

/// The names that the body of a macro gives itself.
fn own_properties(item: &Arc<Item>, of: xml::NodeId) -> impl Iterator<Item = EcoString> {
    let body = item.node(of).range();
    let facts = facts_of(item);
    let own = facts
        .of(FactKind::Property)
        .filter(|fact| body.contains_range(item.node(fact.node).range()));
    own.map(|fact| fact.name.clone())
        .collect::<Vec<_>>()
        .into_iter()
}

/// A text of a macro's body as the caller would write it; none when it is computed from what the caller gives.
fn spelled(text: &str, given: &CallValues) -> Option<EcoString> {
    let mut found = EcoString::new();
    for token in expr::split(text).tokens {
        let TemplateToken::Expr { range, inner, .. } = &token else {
            found.push_str(token.range().slice(text));
            continue;
        };
        let code = inner.slice(text);
        match given.get(code.trim()) {
            Some(value) => found.push_str(value.as_ref()?),
            None if code
                .split(|c| !is_word(c))
                .any(|word| given.contains_key(word)) =>
            {
                return None;
            }
            None => found.push_str(range.slice(text)),
        }
    }
    Some(found)
}
