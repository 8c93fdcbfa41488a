//! A value takes the place of its name.

use super::place::element_at;
use super::{Action, ActionKind};
use crate::{Cx, TextNames, definition_of, places};
use base::{Span, TextRange};
use expand::{DefinitionId, SymbolKind};
use rules::{Edit, RuleEnv};
use xml::Document;

/// The property that is given or read at an offset, with its name: one that is given once, at no condition.
pub fn inlinable(cx: &Cx<'_>, offset: u32) -> Option<(DefinitionId, String)> {
    let (id, _) = cx.symbol_at(offset)?;
    let symbols = &cx.expansion.index.symbols;
    let own = symbols.get(id)?;
    let rivals = symbols
        .iter()
        .filter(|(_, other)| other.name == own.name)
        .count();
    let plain = own.kind == SymbolKind::Property && !own.conditional && rivals == 1;
    plain.then(|| (id, own.name.to_string()))
}

/// Put the value of the property at an offset wherever it is read, and remove the property.
pub(super) fn property(cx: &Cx<'_>, world: RuleEnv<'_>, offset: u32) -> Option<Action> {
    let (id, name) = inlinable(cx, offset)?;
    let target = definition_of(cx, id)?;
    let document = &cx.file_of(target.whole.file)?.document;
    let (base, node) = element_at(document, target.whole.range.start)?;
    let value = node
        .attr("value")
        .filter(|_| node.name() == "xacro:property")?
        .raw();
    // other attributes, such as scope, mean more than the value
    let literal = !value.contains(['$', '"', '\'', '&']) && node.attrs().len() == 2;
    let definition = node.range().shift(base);
    if !literal || document.slice(target.name.range) != name {
        return None;
    }
    let mut edits = vec![Edit {
        span: line(document, target.whole, definition),
        content: String::new(),
    }];
    let names = TextNames::of(cx.expansion, world);
    let all = places(cx, &names, &[target.name], &name);
    for span in all.into_iter().filter(|span| *span != target.name) {
        let document = &cx.file_of(span.file)?.document;
        edits.push(inlined(document, span, &name, value)?);
    }
    edits.sort_by_key(|edit| (edit.span.file, edit.span.range.start));
    Some(Action {
        title: format!("inline property `{name}`"),
        kind: ActionKind::Inline,
        edits,
    })
}

/// The value at one use.
fn inlined(document: &Document, span: Span, name: &str, value: &str) -> Option<Edit> {
    const FAR: u32 = 64;
    let range = span.range;
    if document.slice(range) != name {
        return None;
    }
    let before = document.slice(TextRange::new(range.start.saturating_sub(FAR), range.start));
    let behind = document.slice(TextRange::new(range.end, range.end.saturating_add(FAR)));
    let (left, right) = (before.trim_end_matches(' '), behind.trim_start_matches(' '));
    if left.ends_with("${") && !left.ends_with("$${") && right.starts_with('}') {
        let start = range.start - (before.len() - left.len()) as u32 - 2;
        let end = range.end + (behind.len() - right.len()) as u32 + 1;
        return Some(Edit {
            span: Span {
                range: TextRange::new(start, end),
                ..span
            },
            content: value.to_owned(),
        });
    }
    // in an expression only numbers mean what they are
    let number = value.trim();
    number
        .parse::<f64>()
        .ok()
        .filter(|number| number.is_finite())?;
    let content = if number.starts_with(['-', '+']) {
        format!("({number})")
    } else {
        number.to_owned()
    };
    Some(Edit { span, content })
}

/// An element with its line, when it stands there alone.
fn line(document: &Document, span: Span, element: TextRange) -> Span {
    let start = document.line_col(element.start, base::Encoding::Utf8).col;
    let line_start = element.start - start;
    let alone = document
        .slice(TextRange::new(line_start, element.start))
        .trim()
        .is_empty();
    let behind = document.slice(TextRange::new(element.end, element.end.saturating_add(200)));
    let end = behind.find('\n').filter(|end| {
        behind
            .get(..*end)
            .is_some_and(|rest| rest.trim().is_empty())
    });
    let range = match end.filter(|_| alone) {
        Some(end) => TextRange::new(line_start, element.end + end as u32 + 1),
        None => element,
    };
    Span { range, ..span }
}
