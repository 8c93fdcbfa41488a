//! Elements go into another one.

use super::place::{element_at, indented, line_end, margin};
use super::{Action, ActionKind, edit};
use base::TextRange;
use vfs::SourceFile;
use xml::Document;

/// Put the selected elements under a condition. At every tag there would be too many offers.
pub(super) fn in_condition(source: &SourceFile, selection: TextRange) -> Option<Action> {
    let document = &source.document;
    document
        .root()?
        .attr("xmlns:xacro")
        .filter(|_| !selection.is_empty())?;
    let range = elements(document, selection)?;
    let (end, margin) = (line_end(document), margin(document, range.start));
    let body = document.slice(range);
    let wrapped = format!("<xacro:if value=\"true\">{end}{margin}{body}{end}{margin}</xacro:if>");
    let content = indented(document, range, &wrapped)?;
    let edits = vec![edit(source, range, content)];
    Some(Action {
        title: "wrap in `xacro:if`".to_owned(),
        kind: ActionKind::Rewrite,
        edits,
    })
}

/// The whole elements that a selection covers.
pub(super) fn elements(document: &Document, selection: TextRange) -> Option<TextRange> {
    let text = document.slice(selection);
    let blanks = (text.len() - text.trim_start().len()) as u32;
    let range = TextRange::new(
        selection.start + blanks,
        selection.start + text.trim_end().len() as u32,
    );
    if range.is_empty() {
        let (base, node) = element_at(document, selection.start)?;
        let in_tag = node.start_tag_range().shift(base).touches(selection.start);
        return (in_tag && base > 0).then(|| node.range().shift(base));
    }
    let (base, first) = element_at(document, range.start)?;
    let (last_base, mut last) = element_at(document, range.end - 1)?;
    while last.range().shift(last_base).end < range.end {
        last = last.parent()?;
    }
    let begins = first.range().shift(base).start == range.start;
    let ends = last.range().shift(last_base).end == range.end;
    let beside = first.parent() == last.parent();
    (begins && ends && beside && base > 0).then_some(range)
}
