//! Fixes of syntax errors.

use super::{Action, edit, fix};
use base::TextRange;
use rules::Edit;
use vfs::SourceFile;
use xml::{Document, NodeKind, SyntaxError, SyntaxErrorKind};

/// The fixes of the error at a range.
pub(super) fn fixes(source: &SourceFile, range: TextRange) -> Vec<Action> {
    let errors = source.document.errors();
    // a finding may stand at either place of a mistake
    let here = |error: &&SyntaxError| {
        error.range == range || error.related.is_some_and(|(related, _)| related == range)
    };
    let Some(error) = errors.iter().find(here) else {
        return Vec::new();
    };
    let found: Vec<Action> = match error.kind {
        SyntaxErrorKind::MismatchedEndTag => end_tag(source, error),
        SyntaxErrorKind::UnclosedElement => unclosed(source, error).into_iter().collect(),
        SyntaxErrorKind::DuplicateAttribute => duplicate(source, error).into_iter().collect(),
        SyntaxErrorKind::LtInValue | SyntaxErrorKind::StrayLt => escape(source, error, '<', "&lt;"),
        SyntaxErrorKind::BadReference => escape(source, error, '&', "&amp;"),
        _ => Vec::new(),
    };
    // what leaves as many errors is no fix
    found
        .into_iter()
        .filter(|action| helps(&source.document, &action.edits, errors.len()))
        .collect()
}

fn helps(document: &Document, edits: &[Edit], errors: usize) -> bool {
    let mut text = document.text();
    for edit in edits.iter().rev() {
        let (start, end) = (edit.span.range.start as usize, edit.span.range.end as usize);
        if text.get(start..end).is_none() {
            return false;
        }
        text.replace_range(start..end, &edit.content);
    }
    Document::parse(&text).errors().len() < errors
}

/// Another name for an end tag, or none.
fn end_tag(source: &SourceFile, error: &SyntaxError) -> Vec<Action> {
    let document = &source.document;
    match error.related {
        Some((open, _)) => {
            let (own, name) = (document.slice(open), document.slice(error.range));
            vec![
                fix(
                    format!("change end tag to `{own}`"),
                    vec![edit(source, error.range, own.as_str())],
                ),
                fix(
                    format!("change start tag to `{name}`"),
                    vec![edit(source, open, name.as_str())],
                ),
            ]
        }
        None => vec![fix(
            "remove end tag".to_owned(),
            vec![edit(source, error.range, "")],
        )],
    }
}

/// The end tag of an element, behind the last thing in it.
fn unclosed(source: &SourceFile, error: &SyntaxError) -> Option<Action> {
    let document = &source.document;
    if document.root_end_tag().is_none()
        && document
            .root()?
            .start_tag_range()
            .contains_range(error.range)
    {
        let name = document.root()?.name();
        let at = document.text().trim_end().len() as u32;
        let end = super::place::line_end(document);
        let edits = vec![edit(
            source,
            TextRange::empty(at),
            format!("{end}</{name}>"),
        )];
        return Some(fix(format!("add `</{name}>`"), edits));
    }
    let place = document.item_at(error.range.start);
    let inside = error.range.start - place.start;
    let mut elements = place
        .item
        .all_nodes()
        .filter(|node| node.kind() == NodeKind::Element);
    let element = elements.find(|node| {
        let tag = node.start_tag_range();
        node.end_tag().is_none() && tag.start <= inside && inside < tag.end
    })?;
    let text = document.slice(element.range().shift(place.start));
    let at = place.start + element.range().start + text.trim_end().len() as u32;
    let name = element.name();
    Some(fix(
        format!("add `</{name}>`"),
        vec![edit(source, TextRange::empty(at), format!("</{name}>"))],
    ))
}

/// The second of two attributes goes, with the blank in front of it.
fn duplicate(source: &SourceFile, error: &SyntaxError) -> Option<Action> {
    let document = &source.document;
    let place = document.item_at(error.range.start);
    let mut attrs = place.item.all_nodes().flat_map(|node| node.attrs());
    let attr = attrs.find(|attr| attr.range().shift(place.start).touches(error.range.start))?;
    let range = attr.range().shift(place.start);
    let before = document.slice(TextRange::new(place.start, range.start));
    let blanks = before.len() - before.trim_end().len();
    let range = TextRange::new(range.start - blanks as u32, range.end);
    Some(fix(
        format!("remove duplicate `{}`", attr.name()),
        vec![edit(source, range, "")],
    ))
}

fn escape(source: &SourceFile, error: &SyntaxError, character: char, entity: &str) -> Vec<Action> {
    let document = &source.document;
    let at = TextRange::new(error.range.start, error.range.start + 1);
    if document.slice(at) != character.to_string() {
        return Vec::new();
    }
    vec![fix(
        format!("replace with `{entity}`"),
        vec![edit(source, at, entity)],
    )]
}
