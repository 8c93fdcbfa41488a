//! Which macro calls which.

use super::context::Cx;
use super::names::{NavigationTarget, definition_of};
use base::{FileId, Span, TextRange};
use expand::{DefinitionId, SourceRange, SymbolKind, Use, UseKind};

/// Who calls or is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CallParticipant {
    /// The body of a macro.
    Macro(DefinitionId),
    /// What stands in a file outside of macros.
    File(FileId),
}

/// Somebody at the other end of calls, and the names in these calls.
#[derive(Clone, Debug)]
pub struct CallEdge {
    /// Who.
    pub other: CallParticipant,
    /// Where.
    pub at: Vec<Span>,
}

/// The macro that is called or defined at an offset.
pub fn macro_at(cx: &Cx<'_>, offset: u32) -> Option<DefinitionId> {
    let (id, _) = cx.symbol_at(offset)?;
    is_macro(cx, id).then_some(id)
}

fn is_macro(cx: &Cx<'_>, id: DefinitionId) -> bool {
    cx.expansion
        .index
        .symbols
        .get(id)
        .is_some_and(|given| given.kind == SymbolKind::Macro)
}

/// Who calls a macro.
pub fn incoming(cx: &Cx<'_>, id: DefinitionId) -> Vec<CallEdge> {
    let mut found = Vec::new();
    for used in calls(cx).filter(|used| used.definition == id) {
        if let (Some(caller), Some(span)) = (caller(cx, used.place), cx.span(used.place)) {
            add(&mut found, caller, span);
        }
    }
    found
}

/// The macros that somebody calls.
pub fn outgoing(cx: &Cx<'_>, from: &CallParticipant) -> Vec<CallEdge> {
    let mut found = Vec::new();
    for used in calls(cx).filter(|used| caller(cx, used.place).as_ref() == Some(from)) {
        if let Some(span) = cx.span(used.place) {
            add(&mut found, CallParticipant::Macro(used.definition), span);
        }
    }
    found
}

/// All calls of a macro: the names in them.
pub fn calls_of(cx: &Cx<'_>, id: DefinitionId) -> Vec<Span> {
    calls(cx)
        .filter(|used| used.definition == id)
        .filter_map(|used| cx.span(used.place))
        .collect()
}

/// Where a caller stands.
pub fn caller_target(cx: &Cx<'_>, caller: &CallParticipant) -> Option<NavigationTarget> {
    match caller {
        CallParticipant::Macro(id) => definition_of(cx, *id),
        CallParticipant::File(file) => {
            let document = &cx.file_of(*file)?.document;
            let whole = Span {
                file: *file,
                range: TextRange::new(0, document.len()),
            };
            let name = document
                .root()
                .map_or(TextRange::default(), |root| root.name_range());
            Some(NavigationTarget {
                whole,
                name: Span {
                    file: *file,
                    range: name,
                },
            })
        }
    }
}

/// The macros that the file defines.
pub fn macros_of(cx: &Cx<'_>) -> Vec<(DefinitionId, TextRange)> {
    let given = cx
        .expansion
        .index
        .symbols
        .iter()
        .filter(|(_, given)| given.kind == SymbolKind::Macro);
    let placed = given.filter_map(|(id, given)| Some((id, cx.span(given.place)?)));
    placed
        .filter(|(_, span)| span.file == cx.source.id)
        .map(|(id, span)| (id, span.range))
        .collect()
}

fn calls<'a>(cx: &Cx<'a>) -> impl Iterator<Item = &'a Use> {
    cx.expansion
        .index
        .symbols
        .uses
        .iter()
        .filter(|used| used.kind == UseKind::Call)
}

fn add(found: &mut Vec<CallEdge>, other: CallParticipant, span: Span) {
    match found.iter_mut().find(|known| known.other == other) {
        Some(known) => known.at.push(span),
        None => found.push(CallEdge {
            other,
            at: vec![span],
        }),
    }
}

/// The macro around a call, or its file.
fn caller(cx: &Cx<'_>, place: SourceRange) -> Option<CallParticipant> {
    let source = cx.expansion.sources.get(place.src)?;
    let macros = source
        .item
        .all_nodes()
        .filter(|node| node.name() == "xacro:macro");
    let around = macros
        .filter(|node| node.range().contains_range(place.range))
        .filter_map(|node| node.attr("name"))
        .last();
    let defined = around.and_then(|name| {
        let name = SourceRange {
            src: place.src,
            range: name.value_range(),
        };
        let mut given = cx.expansion.index.symbols.iter();
        given
            .find(|(_, given)| given.kind == SymbolKind::Macro && given.place == name)
            .map(|(id, _)| id)
    });
    match defined {
        Some(id) => Some(CallParticipant::Macro(id)),
        None => Some(CallParticipant::File(
            cx.expansion.files.get(source.file)?.source.id,
        )),
    }
}
