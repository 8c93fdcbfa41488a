//! Renaming: every text that gives or uses a name, or why it cannot be renamed.

use super::context::Cx;
use super::names::definition_of;
use super::rename_robot;
use crate::base::limits::NAME_LETTERS;
use crate::base::{Span, TextRange};
use crate::expand::{DefinitionId, SourceRange, SymbolKind, UseKind};
use crate::expr::is_identifier;
use crate::facts::{MentionKind, facts};

/// What stands at an offset and can be renamed: its text and its name.
pub fn renameable(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, String)> {
    if let Some((id, range)) = cx.symbol_at(offset) {
        let name = cx.expansion.symbols.get(id)?.name.to_string();
        return (cx.source.document.slice(range) == name).then_some((range, name));
    }
    rename_robot::renameable(cx, offset)
}

/// The texts to be replaced by `new` when the name at an offset is renamed, in the files of this expansion.
///
/// # Errors
/// Why it cannot be renamed, for the user.
pub fn rename(cx: &Cx<'_>, offset: u32, new: &str) -> Result<Vec<Span>, String> {
    if new.len() > NAME_LETTERS {
        return Err(format!("a name of more than {NAME_LETTERS} letters is refused"));
    }
    let Some((id, range)) = cx.symbol_at(offset) else { return rename_robot::rename(cx, offset, new) };
    if symbols_name(cx, id) != Some(cx.source.document.slice(range)) {
        return Err("no name that can be renamed stands here".to_owned());
    }
    admit(cx, id, new)?;
    Ok(places(cx, id))
}

fn symbols_name(cx: &Cx<'_>, id: DefinitionId) -> Option<String> {
    Some(cx.expansion.symbols.get(id)?.name.to_string())
}

/// The texts of a definition and its uses, in the files of this expansion.
pub fn places(cx: &Cx<'_>, id: DefinitionId) -> Vec<Span> {
    let Some(definition) = cx.expansion.symbols.get(id) else { return Vec::new() };
    let mut found: Vec<Span> = definition_of(cx, id).map(|target| target.name).into_iter().collect();
    for used in cx.expansion.symbols.all_uses().filter(|used| used.definition == id) {
        found.extend(cx.span(used.place));
        if used.kind == UseKind::Call {
            found.extend(end_tag(cx, used.place, &definition.name));
        }
    }
    found.extend(unread(cx, id));
    // what a computed text gives is not the name itself
    found.retain(|span| {
        cx.file_of(span.file).is_some_and(|file| file.document.slice(span.range) == definition.name)
    });
    found.sort_by_key(|span| (span.file, span.range.start));
    found.dedup();
    found
}

/// The definition of this expansion whose name stands at a span.
pub fn definition_at(cx: &Cx<'_>, span: Span) -> Option<DefinitionId> {
    let here = |id: &DefinitionId| definition_of(cx, *id).is_some_and(|target| target.name == span);
    cx.expansion.symbols.iter().map(|(id, _)| id).find(here)
}

/// The name in the end tag of a call.
fn end_tag(cx: &Cx<'_>, call: SourceRange, name: &str) -> Option<Span> {
    let source = cx.expansion.sources.get(call.src.0 as usize)?;
    let around = |range: TextRange| range.start <= call.range.start && call.range.end <= range.end;
    let node = source.item.all_nodes().find(|node| around(node.name_range()))?;
    let end = node.end_name_range()?.end;
    cx.span(SourceRange { src: call.src, range: TextRange::new(end.checked_sub(name.len() as u32)?, end) })
}

/// Places that name it and that expansion did not come by: branches not taken.
fn unread(cx: &Cx<'_>, id: DefinitionId) -> Vec<Span> {
    let symbols = &cx.expansion.symbols;
    let Some(definition) = symbols.get(id) else { return Vec::new() };
    let wanted = match definition.kind {
        SymbolKind::Argument => MentionKind::Argument,
        SymbolKind::Property => MentionKind::Name,
        _ => return Vec::new(),
    };
    let known: crate::base::FastSet<Span> =
        symbols.all_uses().filter_map(|used| cx.span(used.place)).collect();
    let mut found = Vec::new();
    for file in &cx.expansion.files {
        for (base, facts) in facts(&file.source.document) {
            let named =
                facts.mentions().filter(|mention| mention.kind == wanted && mention.name == definition.name);
            let spans = named.map(|mention| Span { file: file.source.id, range: mention.range.shift(base) });
            found.extend(spans.filter(|span| !known.contains(span)));
        }
    }
    found
}

/// Whether a definition may be called `new`.
fn admit(cx: &Cx<'_>, id: DefinitionId, new: &str) -> Result<(), String> {
    let symbols = &cx.expansion.symbols;
    let Some(definition) = symbols.get(id) else { return Err("this name is not known any more".to_owned()) };
    let fits = match definition.kind {
        SymbolKind::Macro => {
            !new.is_empty()
                && new != "call"
                && new.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-'))
        }
        SymbolKind::Argument => {
            !new.is_empty() && new.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-' | '.' | '/'))
        }
        _ => is_identifier(new) && !new.starts_with("__"),
    };
    if !fits {
        return Err(format!(
            "`{new}` is no good name here: letters, digits and `_`, not a keyword of Python"
        ));
    }
    let class = |kind: SymbolKind| match kind {
        SymbolKind::Property | SymbolKind::Parameter | SymbolKind::Namespace => 0,
        SymbolKind::BlockProperty | SymbolKind::BlockParameter => 1,
        SymbolKind::Argument => 2,
        SymbolKind::Macro => 3,
    };
    let clashes = |other: &&crate::expand::Definition| {
        other.name == new
            && class(other.kind) == class(definition.kind)
            && (other.of.is_none() || other.of == definition.of)
    };
    match symbols.definitions.iter().find(clashes) {
        Some(_) => Err(format!("`{new}` is defined already")),
        None => Ok(()),
    }
}
