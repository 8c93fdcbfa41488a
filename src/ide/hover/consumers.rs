//! What the programs that read URDF make of the text under the pointer, for whoever has named some of them.

use super::super::context::Cx;
use super::page::Page;
use base::TextRange;
use rules::RuleEnv;
use rules::consumers::{Consumer, Met, Outcome, constructs};

/// Constructs of one text that are shown.
const MOST: usize = 2;

/// What was found about a text, with a table for each construct in it that a program rejects or changes.
pub(super) fn add(
    cx: &Cx<'_>,
    world: RuleEnv<'_>,
    offset: u32,
    found: Option<(TextRange, Page)>,
) -> Option<(TextRange, Page)> {
    let wanted: Vec<&Consumer> = world
        .config
        .consumers
        .iter()
        .filter_map(|name| Consumer::named(name))
        .collect();
    if wanted.is_empty() {
        return found;
    }
    let is_found = |met: &Met| {
        wanted
            .iter()
            .any(|consumer| met.construct.outcome(consumer) > Outcome::Accepts)
    };
    let file = cx.file();
    let mut here: Vec<(Met, TextRange)> = Vec::new();
    for met in constructs(cx.expansion, cx.robot, world)
        .into_iter()
        .filter(is_found)
    {
        let Some(place) = cx
            .expansion
            .place(met.origin)
            .filter(|place| Some(place.file) == file)
        else {
            continue;
        };
        let is_new = here
            .iter()
            .all(|(known, _)| known.construct.name != met.construct.name);
        if is_new && place.range.start <= offset && offset <= place.range.end {
            here.push((met, place.range));
        }
    }
    let Some((_, range)) = here.first() else {
        return found;
    };
    let (range, mut page) = found.unwrap_or((*range, Page::default()));
    here.iter()
        .take(MOST)
        .for_each(|(met, _)| page.add(table(met)));
    Some((range, page))
}

/// Who rejects, changes and accepts a construct.
fn table(met: &Met) -> String {
    let row = |(verb, outcome): (&str, Outcome)| {
        let who = met.construct.who(outcome);
        (!who.is_empty()).then(|| format!("| {verb} | {} |", who.join(", ")))
    };
    let rows = [
        ("rejected", Outcome::Rejects),
        ("changed or ignored", Outcome::Changes),
        ("accepted", Outcome::Accepts),
    ];
    let rows: Vec<String> = rows.into_iter().filter_map(row).collect();
    format!(
        "| {} | by |\n|---|---|\n{}",
        met.construct.title,
        rows.join("\n")
    )
}
