//! Which names a definition may get: those that are good ones, and that stand for nothing else where it is used.

use super::context::Cx;
use super::names::definition_of;
use base::{Span, TextRange};
use expand::{Definition, DefinitionId, SymbolKind, UseKind, parse_params};
use expr::{is_global_symbol, is_identifier};
use facts::{MentionKind, facts, is_keyword};
use xml::{Document, Node, NodeKind};

/// Whether nothing of the same kind is called `new` already.
///
/// # Errors
/// That it is, for the user.
pub(super) fn is_free(cx: &Cx<'_>, id: DefinitionId, new: &str) -> Result<(), String> {
    let symbols = &cx.expansion.index.symbols;
    let Some(definition) = symbols.get(id) else {
        return Err("this name no longer exists".to_owned());
    };
    let mut named = symbols.definitions.iter().filter(|other| other.name == new);
    if named.any(|other| {
        class(other.kind) == class(definition.kind)
            && (other.of.is_none() || other.of == definition.of)
    }) {
        return Err(format!("`{new}` is already defined"));
    }
    Ok(())
}

/// Whether a definition may be called `new`, where its name stands at `places`.
///
/// # Errors
/// Why not, for the user.
pub(super) fn admit(
    cx: &Cx<'_>,
    id: DefinitionId,
    new: &str,
    places: &[Span],
) -> Result<(), String> {
    let symbols = &cx.expansion.index.symbols;
    let Some(definition) = symbols.get(id) else {
        return Err("this name no longer exists".to_owned());
    };
    // what a call gives is named after the parameter, whatever is around the call
    let uses = symbols
        .all_uses()
        .filter(|used| used.definition == id && used.kind == UseKind::Given);
    let given: Vec<Span> = uses.filter_map(|used| cx.span(used.place)).collect();
    let reads: Vec<Span> = places
        .iter()
        .filter(|place| !given.contains(place))
        .copied()
        .collect();
    if hidden(cx, definition, new, &reads) || hides(cx, id, definition, new) {
        Err(format!(
            "`{new}` has another meaning where the name is used"
        ))
    } else {
        Ok(())
    }
}

/// Whether a name is good for a kind of things.
///
/// # Errors
/// Why not, for the user.
pub(super) fn fits_kind(kind: SymbolKind, new: &str) -> Result<(), String> {
    if kind == SymbolKind::Macro && is_keyword(new) {
        return Err(format!("`xacro:{new}` is reserved by xacro"));
    }
    if fits(kind, new) {
        Ok(())
    } else {
        Err(format!(
            "invalid name `{new}`: use letters, digits and `_`; do not start with a digit or use a Python keyword"
        ))
    }
}

/// Whether a name is good for what is called so.
fn fits(kind: SymbolKind, new: &str) -> bool {
    match kind {
        // a part of the name of a tag; a dot would part it from a namespace
        SymbolKind::Macro => {
            new.starts_with(|c: char| c.is_alphabetic() || c == '_') && is_made_of(new, &['_', '-'])
        }
        SymbolKind::Argument => !new.is_empty() && is_made_of(new, &['_', '-', '.', '/']),
        _ => is_identifier(new) && !new.starts_with("__"),
    }
}

/// Whether a name has nothing but letters, digits and some further characters.
fn is_made_of(name: &str, further: &[char]) -> bool {
    name.chars()
        .all(|c| c.is_alphanumeric() || further.contains(&c))
}

/// Names of one class hide each other.
fn class(kind: SymbolKind) -> u8 {
    match kind {
        SymbolKind::Property | SymbolKind::Parameter | SymbolKind::Namespace => 0,
        SymbolKind::BlockProperty | SymbolKind::BlockParameter => 1,
        SymbolKind::Argument => 2,
        SymbolKind::Macro => 3,
    }
}

/// Whether a use of the definition would mean a parameter of the macro around it.
fn hidden(cx: &Cx<'_>, definition: &Definition, new: &str, reads: &[Span]) -> bool {
    if class(definition.kind) > 1 {
        return false;
    }
    let is_block = class(definition.kind) == 1;
    reads.iter().any(|place| {
        let Some(file) = cx.file_of(place.file) else {
            return false;
        };
        macros_around(&file.document, place.range).any(|(_, node)| {
            node.attr("params")
                .is_some_and(|params| has_param(params.raw(), new, is_block))
        })
    })
}

/// Whether the parameters of a macro have one of the name.
fn has_param(params: &str, name: &str, is_block: bool) -> bool {
    let params = parse_params(params).unwrap_or_default();
    params
        .iter()
        .any(|param| param.is_block() == is_block && param.name.trim_start_matches('*') == name)
}

/// Whether the definition would hide a name of xacro's own, such as `pi`, where that is used.
fn hides(cx: &Cx<'_>, id: DefinitionId, definition: &Definition, new: &str) -> bool {
    if class(definition.kind) != 0 || !is_global_symbol(new) {
        return false;
    }
    // a parameter is known in its macro only
    let own = definition
        .of
        .and(definition_of(cx, id))
        .map(|target| target.name);
    let is_within = |span: Span| {
        let Some(own) = own else { return true };
        let file = cx.file_of(own.file).filter(|_| span.file == own.file);
        file.is_some_and(|file| {
            let innermost = macros_around(&file.document, own.range).last();
            innermost.is_some_and(|(range, _)| range.contains_range(span.range))
        })
    };
    cx.expansion.files.iter().any(|file| {
        let of_file = facts(&file.source.document);
        let mut spans = of_file.flat_map(|(base, facts)| {
            let named = facts
                .mentions()
                .filter(|it| it.kind == MentionKind::Name && it.name == new);
            named
                .map(|it| Span {
                    file: file.source.id,
                    range: it.range.shift(base),
                })
                .collect::<Vec<_>>()
        });
        spans.any(is_within)
    })
}

/// The definitions of macros around a range, outermost first, and where they stand.
fn macros_around(
    document: &Document,
    range: TextRange,
) -> impl Iterator<Item = (TextRange, Node<'_>)> {
    let place = document.item_at(range.start);
    let base = place.start;
    let is_macro =
        |node: &Node<'_>| node.kind() == NodeKind::Element && node.name() == "xacro:macro";
    let nodes = place
        .item
        .all_nodes()
        .filter(is_macro)
        .map(move |node| (node.range().shift(base), node));
    nodes.filter(move |(around, _)| around.contains_range(range))
}
