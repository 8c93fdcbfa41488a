//! Links and joints that no text around the cursor names by the letter: those that other places refer to, and those of the robot,
//! spelled behind the expression that was typed.

use super::evaluate::Evaluator;
use super::item::{Completion, ItemKind};
use super::names::{file_name, file_of, is_link_name};
use super::scope::CompletionScope;
use crate::typed::Typed;
use base::FastSet;
use expand::{BindingKind, Expansion};
use expr::{TemplateToken, display};
use facts::FactKind;
use model::AttrValue;
use xml::Node;

/// Different values of one expression that are tried.
const MOST_VALUES: usize = 16;

/// The names that are not given where the cursor is.
pub(super) fn names(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    kind: ItemKind,
) -> Vec<Completion> {
    let mut found = referred_to(scope, typed, kind);
    let lead = lead(typed.before);
    if !lead.is_empty() {
        found.extend(behind(scope, typed, lead, kind));
        let fact = if kind == ItemKind::Link {
            FactKind::Link
        } else {
            FactKind::Joint
        };
        found.extend(spelled_alike(scope, lead, fact, kind));
        found.extend(rests_of_others(scope, lead, fact, kind));
    }
    found
}

/// What attributes of the file refer to; what is typed is none of them.
fn referred_to(scope: &CompletionScope<'_>, typed: &Typed<'_>, kind: ItemKind) -> Vec<Completion> {
    let mut found = Vec::new();
    for (base, item) in scope.sources.source.document.parts() {
        let attrs = item.all_nodes().flat_map(|node| references(node, kind));
        let others = attrs.filter(|attr| !attr.value_range().shift(base).touches(typed.offset));
        let named = others
            .map(|attr| attr.raw().trim())
            .filter(|name| !name.is_empty());
        found.extend(named.map(|name| {
            Completion::new(kind, name)
                .note("used in this file")
                .rank(4)
        }));
    }
    found
}

/// The attributes of an element that refer to links or joints: of a call those that are there to name a link.
fn references(node: Node<'_>, kind: ItemKind) -> impl Iterator<Item = xml::Attr<'_>> {
    let called = node
        .name()
        .strip_prefix("xacro:")
        .filter(|called| !facts::is_keyword(called));
    let given = called
        .filter(|_| kind == ItemKind::Link)
        .map(|_| node.attrs());
    let given = given
        .into_iter()
        .flatten()
        .filter(|attr| is_link_name(attr.name()));
    reference(node, kind).into_iter().chain(given)
}

/// The attribute of an element that refers to a link or joint.
fn reference(node: Node<'_>, kind: ItemKind) -> Option<xml::Attr<'_>> {
    match (node.name(), kind) {
        ("parent" | "child", ItemKind::Link) => node.attr("link"),
        ("mimic", ItemKind::Joint) => node.attr("joint"),
        _ => None,
    }
}

/// The part of a value up to the end of its last expression.
fn lead(text: &str) -> &str {
    let tokens = expr::split(text).tokens;
    let computed = tokens.iter().filter_map(|token| match token {
        TemplateToken::Expr { range, .. } | TemplateToken::Subst { range, .. } => Some(range.end),
        _ => None,
    });
    text.get(..computed.max().unwrap_or(0) as usize)
        .unwrap_or("")
}

/// The names of the robot that begin with what an expression stands for, with the expression instead.
fn behind(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    lead: &str,
    kind: ItemKind,
) -> Vec<Completion> {
    let mut found = Vec::new();
    // what no expansion knows is computed from the texts, once
    let mut known: Option<Option<String>> = None;
    for (expansion, robot) in scope.robots() {
        // an SRDF has an expansion of its own
        let own = scope
            .sources
            .expansions
            .iter()
            .map(|(own, _)| *own)
            .filter(|_| scope.is_semantic);
        let mut values: Vec<String> = own
            .chain([expansion])
            .flat_map(|known| values_in(scope, known, lead))
            .collect();
        if values.is_empty() {
            let known =
                known.get_or_insert_with(|| Evaluator::new(scope, typed.offset).string(lead));
            values.extend(known.clone());
        }
        let names: Vec<&AttrValue> = match kind {
            ItemKind::Link => robot
                .links
                .iter()
                .filter_map(|link| link.name.as_ref())
                .collect(),
            _ => robot
                .joints
                .iter()
                .filter_map(|joint| joint.name.as_ref())
                .collect(),
        };
        for text in names.into_iter().filter(|text| text.name().is_some()) {
            let rests = values
                .iter()
                .filter_map(|value| text.value.strip_prefix(value.as_str()));
            found.extend(rests.filter(|rest| !rest.is_empty()).map(|rest| {
                Completion::new(kind, format!("{lead}{rest}"))
                    .note(file_of(expansion, text))
                    .rank(5)
            }));
        }
    }
    found
}

/// What `${name}` with text around it stood for when a robot was expanded, where the file gives that name.
fn values_in(scope: &CompletionScope<'_>, expansion: &Expansion, lead: &str) -> Vec<String> {
    let Some((text, name)) = lead
        .strip_suffix('}')
        .and_then(|lead| lead.rsplit_once("${"))
    else {
        return Vec::new();
    };
    let name = name.trim();
    if text.contains('$') || !expr::is_identifier(name) {
        return Vec::new();
    }
    let own = &scope.sources.source.path;
    let is_here = |id| {
        let source = expansion
            .sources
            .get(expansion.index.symbols.get(id)?.place.src)?;
        Some(expansion.files.get(source.file)?.source.path == *own)
    };
    let bindings = expansion.index.bindings.iter().filter(|info| {
        info.name == name
            && matches!(info.kind, BindingKind::Parameter | BindingKind::Property)
            && info.definition.and_then(is_here) == Some(true)
    });
    let mut seen = FastSet::default();
    let values = bindings.filter_map(|info| display::to_str(info.value.as_ref()?));
    let values = values.map(|value| format!("{text}{value}"));
    values
        .filter(|value| seen.insert(value.clone()))
        .take(MOST_VALUES)
        .collect()
}

/// The computed names of all files that begin with the same expression.
fn spelled_alike(
    scope: &CompletionScope<'_>,
    lead: &str,
    fact: FactKind,
    kind: ItemKind,
) -> Vec<Completion> {
    let mut found = Vec::new();
    for (_, file, item) in scope.items() {
        let facts = facts::facts_of(item);
        let alike = facts
            .of(fact)
            .filter(|fact| fact.name.starts_with(lead) && fact.name.len() > lead.len());
        let note = file_name(&file.source.path);
        found.extend(alike.map(|fact| {
            Completion::new(kind, fact.name.as_str())
                .note(note.clone())
                .rank(5)
        }));
    }
    found
}

/// What the edited file writes behind other expressions, behind this one: where it has `${name}_link`, `${parent}_link` may be meant.
fn rests_of_others(
    scope: &CompletionScope<'_>,
    own: &str,
    fact: FactKind,
    kind: ItemKind,
) -> Vec<Completion> {
    let mut found = Vec::new();
    for (_, item) in scope.sources.source.document.parts() {
        for fact in facts::facts_of(item)
            .of(fact)
            .filter(|fact| fact.name.contains('$'))
        {
            let other = lead(&fact.name);
            let rest = fact.name.get(other.len()..).unwrap_or("");
            if other != own && !rest.is_empty() {
                let note = format!("like `{}`", fact.name);
                found.push(
                    Completion::new(kind, format!("{own}{rest}"))
                        .note(note)
                        .rank(6),
                );
            }
        }
    }
    found
}
