//! What editors ask of names of xacro: from the expansion where that came by, else from the texts.

use super::TextNames;
use crate::context::Cx;
use crate::names::{NameOccurrence, NavigationTarget, definition_of, evaluated_uses};
use crate::rename::definition_at;
use crate::robot_names::{robot_name_at, uses_of};
use base::{FastSet, Span, TextRange};

/// The definitions that the name at an offset may mean, as far as the texts say, with the name's range.
pub fn definitions_by_text(
    cx: &Cx<'_>,
    names: &TextNames,
    offset: u32,
) -> Option<(TextRange, Vec<NavigationTarget>)> {
    let (span, meaning) = names.at(cx.source.id, offset)?;
    let target = |given: &&super::TextDefinition| NavigationTarget {
        whole: given.whole,
        name: given.span,
    };
    let targets: Vec<NavigationTarget> = meaning.all().iter().map(target).collect();
    (!targets.is_empty()).then_some((span.range, targets))
}

/// The definitions that a name which was evaluated may mean with other arguments, besides the one that it meant, which stands
/// in a condition then: those that the texts allow. None where the texts say something else than the expansion.
pub fn definitions_elsewhere(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Vec<NavigationTarget> {
    let own = cx.symbol_at(offset);
    let Some(own) = own.and_then(|(id, _)| definition_of(cx, id)) else {
        return Vec::new();
    };
    if !names.depends(cx.source.id, offset, own.name) {
        return Vec::new();
    }
    let (_, mut targets) = definitions_by_text(cx, names, offset).unwrap_or_default();
    targets.retain(|target| target.name != own.name);
    targets
}

/// All places of the name at an offset, its definition among them, evaluated or not; none when there is no name.
pub fn occurrences(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Vec<NameOccurrence> {
    let mut found = match cx.symbol_at(offset) {
        Some((id, _)) => {
            let elsewhere = definitions_elsewhere(cx, names, offset);
            let elsewhere = elsewhere.iter().map(|target| target.name);
            with_uses(cx, evaluated_uses(cx, id), elsewhere)
        }
        None => by_text(cx, names, offset),
    };
    if found.is_empty() {
        return robot_name_at(cx, offset)
            .map(|name| uses_of(cx, &name))
            .unwrap_or_default();
    }
    let given: Vec<Span> = found
        .iter()
        .filter(|used| used.is_definition)
        .map(|used| used.span)
        .collect();
    let mut known: FastSet<Span> = cx
        .expansion
        .index
        .symbols
        .all_uses()
        .filter_map(|used| cx.span(used.place))
        .collect();
    known.extend(found.iter().map(|used| used.span));
    let further = names
        .uses_of(&given)
        .into_iter()
        .filter(|span| known.insert(*span));
    found.extend(further.map(|span| NameOccurrence {
        span,
        is_definition: false,
    }));
    found
}

/// The definitions that a name may mean which was not evaluated, and the evaluated uses of these.
fn by_text(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Vec<NameOccurrence> {
    let Some((_, meaning)) = names.at(cx.source.id, offset) else {
        return Vec::new();
    };
    let given = meaning.all().iter().map(|given| given.span);
    with_uses(cx, Vec::new(), given)
}

/// Uses, and definitions with the uses of these that were evaluated.
fn with_uses(
    cx: &Cx<'_>,
    mut found: Vec<NameOccurrence>,
    given: impl Iterator<Item = Span>,
) -> Vec<NameOccurrence> {
    for span in given {
        let own = definition_at(cx, span).map(|id| evaluated_uses(cx, id));
        let own = own.unwrap_or_else(|| {
            vec![NameOccurrence {
                span,
                is_definition: true,
            }]
        });
        for used in own {
            if !found.contains(&used) {
                found.push(used);
            }
        }
    }
    found
}
