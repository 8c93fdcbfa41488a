//! From the places of the expander to those that the pages of the rules promise.
use super::finding::Related;
use base::{FileId, Span, TextRange};
use xml::{Document, Node, SyntaxErrorKind};

/// Of a syntax error: the token in the way, and what it belongs to.
pub(super) fn syntax(document: &Document, file: FileId) -> Option<(TextRange, Option<Related>)> {
    let errors = document.errors();
    let error = errors.iter().min_by_key(|error| error.expat_offset)?;
    let (at, related) = match (error.kind, error.related) {
        // the end tag that comes too early is in the way, not the element that lacks one
        (SyntaxErrorKind::UnclosedElement, Some((range, _))) => {
            (range, Some((error.range, "this element is not closed")))
        }
        (SyntaxErrorKind::BadDeclaration, _)
            if document.slice(error.range).starts_with("<?xml") =>
        {
            let end = error.range.start + "<?xml".len() as u32;
            (TextRange::new(error.range.start, end), None)
        }
        (_, related) => (error.range, related),
    };
    let related = related.map(|(range, message)| Related {
        span: Span { file, range },
        message: message.to_owned(),
        is_call: false,
    });
    Some((at, related))
}

/// The tag start or attribute name that begins with the prefix at `range`.
pub(super) fn whole_name(document: &Document, range: TextRange) -> TextRange {
    let place = document.item_at(range.start);
    let inside = (range.start - place.start) as usize;
    let (before, behind) = place
        .item
        .text()
        .split_at_checked(inside)
        .unwrap_or_default();
    let ends_name = |c: char| c.is_whitespace() || matches!(c, '=' | '>' | '/' | '<' | '"' | '\'');
    let length = behind.find(ends_name).unwrap_or(behind.len()) as u32;
    let start = range.start - u32::from(before.ends_with('<'));
    TextRange::new(start, range.start + length)
}

/// The value of the `name` of the element that has an attribute with its value at `range`.
pub(super) fn name_of_element(document: &Document, range: TextRange) -> TextRange {
    let place = document.item_at(range.start);
    let has_value = |node: &Node<'_>| {
        node.attrs()
            .any(|attr| attr.value_range().shift(place.start) == range)
    };
    let name = place
        .item
        .all_nodes()
        .find(has_value)
        .and_then(|node| node.attr("name"));
    name.map_or(range, |name| name.value_range().shift(place.start))
}

/// The attribute whose value is at `range`, from its name to the closing quote.
pub(super) fn whole_attribute(document: &Document, range: TextRange) -> TextRange {
    let place = document.item_at(range.start);
    let attrs = place.item.all_nodes().flat_map(|node| node.attrs());
    let mut found = attrs.filter(|attr| attr.value_range().shift(place.start) == range);
    found
        .next()
        .map_or(range, |attr| attr.range().shift(place.start))
}
