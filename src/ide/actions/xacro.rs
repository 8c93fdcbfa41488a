//! Fixes of xacro that touch more than the text of the finding.

use super::place::{before, element_at, line_end, margin, top_level};
use super::{Action, edit, fix};
use crate::{Cx, TextNames, rename};
use base::TextRange;
use expr::is_identifier;
use facts::{FactKind, facts};
use rules::Edit;
use vfs::SourceFile;
use xml::{Document, DocumentPart};

/// Another name for a property or parameter that hides something of Python, everywhere it is used.
pub fn other_name(cx: &Cx<'_>, all: &TextNames, range: TextRange) -> Option<Action> {
    let old = cx.source.document.slice(range);
    let names = [
        format!("{old}_"),
        format!("{old}_value"),
        format!("my_{old}"),
    ];
    names
        .iter()
        .filter(|name| is_identifier(name))
        .find_map(|name| {
            let places = rename(cx, all, range.start, name).ok()?;
            let edits = places
                .into_iter()
                .map(|span| Edit {
                    span,
                    content: name.clone(),
                })
                .collect();
            Some(fix(format!("rename `{old}` to `{name}`"), edits))
        })
}

/// Replace the text of a finding by the known name that its help suggests.
pub fn suggested(source: &SourceFile, range: TextRange, near: &str) -> Option<Action> {
    let old = source.document.slice(range);
    let fits = is_word(&old) && is_word(near) && old != near;
    fits.then(|| {
        fix(
            format!("change to `{near}`"),
            vec![edit(source, range, near)],
        )
    })
}

/// Whether a text is one word, as it is written in an attribute.
fn is_word(text: &str) -> bool {
    !text.is_empty() && !text.contains(['$', '<', '&', '"', '\'', ' ', '\n'])
}

/// Remove the attribute that a finding names.
pub(super) fn without_attribute(source: &SourceFile, range: TextRange) -> Vec<Action> {
    removed(source, range).into_iter().collect()
}

fn removed(source: &SourceFile, range: TextRange) -> Option<Action> {
    let (base, node) = element_at(&source.document, range.start)?;
    let attr = node
        .attrs()
        .find(|attr| attr.range().shift(base).contains_range(range))?;
    let whole = attr.range().shift(base);
    let before = source.document.slice(TextRange::new(
        base + node.start_tag_range().start,
        whole.start,
    ));
    let blanks = (before.len() - before.trim_end().len()) as u32;
    let gone = TextRange::new(whole.start - blanks, whole.end);
    Some(fix(
        format!("remove `{}`", attr.name()),
        vec![edit(source, gone, "")],
    ))
}

/// Move a definition, a child of the root, in front of the child of the root that uses it.
pub fn before_use(cx: &Cx<'_>, used: TextRange, given: TextRange) -> Option<Action> {
    let (source, document) = (cx.source, &cx.source.document);
    let place = document.item_at(given.start);
    let (_, name) = element_at(document, given.start)?;
    let element = place
        .item
        .element()
        .filter(|_| matches!(place.part, DocumentPart::Item(_)))?;
    if element.range() != name.range() || used.start >= place.start {
        return None;
    }
    let whole = element.range().shift(place.start);
    let at = before(document, used.start)?;
    if rests_on(document, place.start, at) {
        return None;
    }
    let text = document.slice(whole);
    let text = top_level(document, at, &text);
    // with the line it has for itself
    let lead = format!("{}{}", line_end(document), margin(document, whole.start));
    let start = whole
        .start
        .checked_sub(lead.len() as u32)
        .unwrap_or(whole.start);
    let alone = document.slice(TextRange::new(start, whole.start)) == lead;
    let gone = TextRange::new(if alone { start } else { whole.start }, whole.end);
    let edits = vec![
        edit(source, TextRange::empty(at), text),
        edit(source, gone, ""),
    ];
    Some(fix(
        "move definition before its first use".to_owned(),
        edits,
    ))
}

/// Whether the definition in the item at `given` uses names that are defined, or may be included, from `at` on: it
/// cannot go in front of them.
fn rests_on(document: &Document, given: u32, at: u32) -> bool {
    const DEFINING: [FactKind; 3] = [FactKind::Property, FactKind::Macro, FactKind::Argument];
    let own = facts(document).filter(|(base, _)| *base == given);
    let used: Vec<String> = own
        .flat_map(|(_, own)| {
            own.mentions()
                .map(|used| used.name.to_string())
                .collect::<Vec<_>>()
        })
        .collect();
    let ends = document.items().map(|(base, item)| base + item.len());
    let between = facts(document)
        .zip(ends)
        .filter(|((base, _), end)| *end > at && *base < given);
    between.map(|((_, facts), _)| facts).any(|facts| {
        let defines = DEFINING.iter().any(|&kind| {
            facts
                .of(kind)
                .any(|fact| used.iter().any(|used| *used == fact.name))
        });
        defines || !used.is_empty() && facts.of(FactKind::Include).next().is_some()
    })
}
