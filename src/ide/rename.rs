//! Renaming: every text that gives or uses a name, or why it cannot be renamed.

use super::context::Cx;
use super::names::definition_of;
use super::{new_name, rename_robot};
use base::limits::NAME_LETTERS;
use base::{Span, TextRange};
use expand::{DefinitionId, SourceRange, SymbolKind};
use facts::{MentionKind, facts};

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
    if cx.source.document.slice(range) == new {
        return Ok(Vec::new());
    }
    let places = places(cx, id);
    new_name::admit(cx, id, new, &places)?;
    Ok(places)
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
        found.extend(end_tag(cx, used.place));
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

/// The same part of a name in the end tag, for one that is used in the name of a tag: a macro or a namespace.
fn end_tag(cx: &Cx<'_>, used: SourceRange) -> Option<Span> {
    let source = cx.expansion.sources.get(used.src.0 as usize)?;
    let node = source.item.all_nodes().find(|node| node.name_range().contains_range(used.range))?;
    let (start, end) = (node.name_range(), node.end_name_range()?);
    let at = end.start + (used.range.start - start.start);
    let range = TextRange::new(at, at + used.range.len());
    end.contains_range(range).then(|| cx.span(SourceRange { range, ..used })).flatten()
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
    let known: base::FastSet<Span> = symbols.all_uses().filter_map(|used| cx.span(used.place)).collect();
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
