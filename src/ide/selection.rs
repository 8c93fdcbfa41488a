//! Growing selections: from a word to the file.

use super::locate::{NodePart, locate};
use base::TextRange;
use base::limits::SELECTIONS;
use expr::{self, TemplateToken};
use xml::{Document, Node};

/// The ranges around an offset, the smallest first; each holds the one in front of it.
pub fn selection(document: &Document, offset: u32) -> Vec<TextRange> {
    let at = locate(document, offset);
    let inside = offset.saturating_sub(at.base);
    let mut ranges = Vec::new();
    match at.part {
        NodePart::AttrValue(attr) => {
            expression(attr.raw(), attr.value_range().start, inside, &mut ranges);
            ranges.extend([attr.value_range(), attr.range()]);
        }
        NodePart::AttrName(attr) => ranges.extend([attr.name_range(), attr.range()]),
        NodePart::Text => {
            if let Some(node) = at.node {
                expression(node.raw(), node.raw_range().start, inside, &mut ranges);
            }
        }
        NodePart::StartName => ranges.extend(at.node.map(Node::name_range)),
        NodePart::EndName => ranges.extend(at.node.and_then(Node::end_name_range)),
        _ => {}
    }
    let mut around = at.node;
    while let Some(node) = around {
        let tag = node.start_tag_range();
        if tag.start <= inside && inside <= tag.end {
            ranges.push(tag);
        }
        if let (Some(end), false) = (node.end_tag(), node.is_self_closing()) {
            ranges.push(TextRange::new(tag.end.min(end.start), end.start));
        }
        ranges.push(node.range());
        around = node.parent();
    }
    let ranges: Vec<TextRange> = ranges.into_iter().map(|range| at.shift(range)).collect();
    let mut ranges = nested(ranges, offset);
    ranges.truncate(SELECTIONS - 1);
    ranges.push(TextRange::new(0, document.len()));
    nested(ranges, offset)
}

/// Only ranges that hold the offset and everything smaller.
fn nested(ranges: Vec<TextRange>, offset: u32) -> Vec<TextRange> {
    let mut kept: Vec<TextRange> = Vec::new();
    for range in ranges {
        let holds = |inner: &TextRange| {
            range.start <= inner.start && inner.end <= range.end && range != *inner
        };
        let here = range.start <= offset && offset <= range.end;
        if here && kept.last().is_none_or(holds) {
            kept.push(range);
        }
    }
    kept
}

/// The parts of the expression at `inside`, the smallest first. `raw` begins at `start`.
fn expression(raw: &str, start: u32, inside: u32, ranges: &mut Vec<TextRange>) {
    let Some(offset) = inside.checked_sub(start) else {
        return;
    };
    let template = expr::split(raw);
    let Some(token) = template
        .tokens
        .iter()
        .find(|token| token.range().touches(offset) && !is_text(token))
    else {
        return;
    };
    if let TemplateToken::Expr {
        inner,
        code: expr::Code::Static(parsed),
        ..
    } = token
    {
        let mut path = vec![&parsed.expr];
        while let Some(outer) = path.last().copied() {
            let mut next = None;
            expr::visit::children(outer, &mut |child| {
                if child.range.shift(inner.start).touches(offset) {
                    next = Some(child);
                }
            });
            match next {
                Some(child) => path.push(child),
                None => break,
            }
        }
        ranges.extend(
            path.iter()
                .rev()
                .map(|part| part.range.shift(inner.start).shift(start)),
        );
        ranges.push(inner.shift(start));
    }
    ranges.push(token.range().shift(start));
}

fn is_text(token: &TemplateToken) -> bool {
    matches!(token, TemplateToken::Text(_) | TemplateToken::Escape(_))
}
