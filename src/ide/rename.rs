//! Renaming: every text that gives or uses a name, or why it cannot be renamed.

use super::context::Cx;
use super::names::{definition_of, evaluated_uses};
use super::text_names::TextNames;
use super::{new_name, rename_robot};
use base::limits::NAME_LETTERS;
use base::{Encoding, Span, TextRange};
use expand::{DefinitionId, SourceRange, SymbolKind};

/// A name of xacro that can be renamed.
struct Renamed {
    /// The text at which it is renamed.
    range: TextRange,
    name: String,
    kind: SymbolKind,
    /// Its definition, where that was evaluated.
    id: Option<DefinitionId>,
    /// Places that give or use it.
    seeds: Vec<Span>,
}

/// What stands at an offset and can be renamed: its text and its name.
pub fn renameable(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Option<(TextRange, String)> {
    match xacro_name(cx, names, offset) {
        Some(asked) => (cx.source.document.slice(asked.range) == asked.name)
            .then_some((asked.range, asked.name)),
        None => rename_robot::renameable(cx, offset),
    }
}

/// What kind of name of xacro stands at an offset; none for the names of links and joints.
pub fn kind_at(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Option<SymbolKind> {
    Some(xacro_name(cx, names, offset)?.kind)
}

fn xacro_name(cx: &Cx<'_>, names: &TextNames, offset: u32) -> Option<Renamed> {
    if let Some((id, range)) = cx.symbol_at(offset) {
        let definition = cx.expansion.index.symbols.get(id)?;
        let seeds = evaluated_uses(cx, id)
            .into_iter()
            .map(|used| used.span)
            .collect();
        let (name, kind) = (definition.name.to_string(), definition.kind);
        return Some(Renamed {
            range,
            name,
            kind,
            id: Some(id),
            seeds,
        });
    }
    let (span, meaning) = names.at(cx.source.id, offset)?;
    let first = meaning.all().first()?;
    let seeds = meaning
        .all()
        .iter()
        .map(|given| given.span)
        .chain([span])
        .collect();
    Some(Renamed {
        range: span.range,
        name: first.name.to_string(),
        kind: first.kind,
        id: None,
        seeds,
    })
}

/// The texts to be replaced by `new` when the name at an offset is renamed, in the files of this expansion and in those
/// that its branches may include.
///
/// # Errors
/// Why it cannot be renamed, for the user.
pub fn rename(cx: &Cx<'_>, names: &TextNames, offset: u32, new: &str) -> Result<Vec<Span>, String> {
    if new.len() > NAME_LETTERS {
        return Err(format!("names are limited to {NAME_LETTERS} characters"));
    }
    let Some(asked) = xacro_name(cx, names, offset) else {
        return rename_robot::rename(cx, offset, new);
    };
    let text = cx.source.document.slice(asked.range);
    if asked.name != text {
        return Err("nothing to rename here".to_owned());
    }
    if text == new {
        return Ok(Vec::new());
    }
    let places = places(cx, names, &asked.seeds, &asked.name);
    new_name::fits_kind(asked.kind, new)?;
    if let Some(id) = asked.id {
        new_name::is_free(cx, id, new)?;
    }
    if let Some(place) = names.clash(&places, new) {
        let line = line(cx, place);
        return Err(format!(
            "`{new}` has another meaning where this name is used{line}"
        ));
    }
    asked
        .id
        .map_or(Ok(()), |id| new_name::admit(cx, id, new, &places))?;
    Ok(places)
}

/// The line of a place, for a message.
fn line(cx: &Cx<'_>, place: Span) -> String {
    let Some(file) = cx.file_of(place.file) else {
        return String::new();
    };
    let name = file
        .path
        .file_name()
        .map(|name| name.to_string_lossy().into_owned())
        .unwrap_or_default();
    format!(
        ": {name}:{}",
        file.document
            .line_col(place.range.start, Encoding::Utf8)
            .line
            + 1
    )
}

/// The texts of a name that belong together with those at some places: by what was evaluated and by the texts, until
/// neither adds any.
pub fn places(cx: &Cx<'_>, names: &TextNames, seeds: &[Span], name: &str) -> Vec<Span> {
    let mut found: Vec<Span> = seeds.to_vec();
    loop {
        let before = found.len();
        found.extend(names.together(&found).into_iter().map(|text| text.span));
        for (id, _) in cx
            .expansion
            .index
            .symbols
            .iter()
            .filter(|(_, definition)| definition.name == name)
        {
            let own = evaluated_places(cx, id);
            if own.iter().any(|span| found.contains(span)) {
                found.extend(own);
            }
        }
        // what a computed text gives is not the name itself
        found.retain(|span| {
            cx.file_of(span.file)
                .is_none_or(|file| file.document.slice(span.range) == name)
        });
        found.sort_by_key(|span| (span.file, span.range.start));
        found.dedup();
        if found.len() <= before {
            return found;
        }
    }
}

/// The texts of a definition and its uses, as far as they were evaluated, end tags too.
fn evaluated_places(cx: &Cx<'_>, id: DefinitionId) -> Vec<Span> {
    let mut found: Vec<Span> = definition_of(cx, id)
        .map(|target| target.name)
        .into_iter()
        .collect();
    for used in cx
        .expansion
        .index
        .symbols
        .all_uses()
        .filter(|used| used.definition == id)
    {
        found.extend(cx.span(used.place));
        found.extend(end_tag(cx, used.place));
    }
    found
}

/// The definition of this expansion whose name stands at a span.
pub fn definition_at(cx: &Cx<'_>, span: Span) -> Option<DefinitionId> {
    let here = |id: &DefinitionId| definition_of(cx, *id).is_some_and(|target| target.name == span);
    cx.expansion
        .index
        .symbols
        .iter()
        .map(|(id, _)| id)
        .find(here)
}

/// The same part of a name in the end tag, for one that is used in the name of a tag: a macro or a namespace.
fn end_tag(cx: &Cx<'_>, used: SourceRange) -> Option<Span> {
    let source = cx.expansion.sources.get(used.src)?;
    let node = source
        .item
        .all_nodes()
        .find(|node| node.name_range().contains_range(used.range))?;
    let (start, end) = (node.name_range(), node.end_name_range()?);
    let at = end.start + (used.range.start - start.start);
    let range = TextRange::new(at, at + used.range.len());
    end.contains_range(range)
        .then(|| cx.span(SourceRange { range, ..used }))
        .flatten()
}
