//! What editors ask of names of xacro: from the expansion where that came by, else from the texts.

use super::TextNames;
use crate::context::Cx;
use crate::names::{NameUse, Target, evaluated_uses};
use crate::rename::definition_at;
use crate::robot_names::{robot_name_at, uses_of};
use base::{FastSet, Span, TextRange};

/// The definitions that the name at an offset may mean, as far as the texts say, with the name's range.
pub fn definitions_by_text(
    cx: &Cx<'_>,
    names: &TextNames,
    offset: u32,
) -> Option<(TextRange, Vec<Target>)> {
    let (span, meaning) = names.at(cx.source.id, offset)?;
    let target = |given: &&super::Given| Target {
        whole: given.whole,
        name: given.span,
    };
    let targets: Vec<Target> = meaning.all().iter().map(target).collect();
    (!targets.is_empty()).then_some((span.range, targets))
}

/// All places of the name at an offset, its definition among them, evaluated or not; none when there is no name.
pub fn occurrences(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Vec<NameUse> {
    let mut found = match cx.symbol_at(offset) {
        Some((id, _)) => evaluated_uses(cx, id),
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
    found.extend(further.map(|span| NameUse {
        span,
        is_definition: false,
    }));
    found
}

/// The definitions that a name may mean which was not evaluated, and the evaluated uses of these.
fn by_text(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Vec<NameUse> {
    let Some((_, meaning)) = names.at(cx.source.id, offset) else {
        return Vec::new();
    };
    let mut found: Vec<NameUse> = Vec::new();
    for given in meaning.all() {
        let own = definition_at(cx, given.span).map(|id| evaluated_uses(cx, id));
        let own = own.unwrap_or_else(|| {
            vec![NameUse {
                span: given.span,
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
