//! Definitions that nothing reads: what the rules about them share.
use super::super::context::{DocumentCx, RootKind};
use super::source;
use base::{FastSet, TextRange};
use expand::{Definition, DefinitionId, FileIdx, FileRange, ProblemKind, SymbolKind, UseKind};

/// The definitions of some kinds in the root file of a robot that nothing uses in this expansion. None, when
/// something of the robot could not be resolved.
pub(super) fn in_root<'a>(
    cx: &DocumentCx<'a>,
    kinds: &[SymbolKind],
) -> Vec<(DefinitionId, &'a Definition, FileRange)> {
    if !source::is_main(cx) || cx.kind != RootKind::Robot || !cx.complete {
        return Vec::new();
    }
    // an undefined name may be a definition misspelled
    if cx.expansion.problems.iter().any(|problem| {
        matches!(
            problem.kind,
            ProblemKind::UndefinedProperty | ProblemKind::UndefinedArg
        )
    }) {
        return Vec::new();
    }
    let used = used(cx);
    let symbols = cx
        .expansion
        .index
        .symbols
        .iter()
        .filter(|(_, definition)| kinds.contains(&definition.kind));
    let unused =
        symbols.filter(|(id, definition)| !used.contains(id) && !definition.name.starts_with('_'));
    let placed = unused.filter_map(|(id, definition)| {
        Some((
            id,
            definition,
            source::place(cx.expansion, definition.place)?,
        ))
    });
    // what other files define may be for others
    placed
        .filter(|(_, _, place)| place.file == FileIdx(0))
        .collect()
}

/// The definitions that are read, called or inserted.
pub(super) fn used(cx: &DocumentCx<'_>) -> FastSet<DefinitionId> {
    let uses = cx
        .expansion
        .index
        .symbols
        .uses
        .iter()
        .filter(|used| used.kind != UseKind::Given);
    uses.map(|used| used.definition).collect()
}

/// The text to delete to remove the element of a definition; none when something but a name stands there.
pub(super) fn removal(cx: &DocumentCx<'_>, definition: &Definition) -> Option<TextRange> {
    let (base, node) = source::tag(cx.expansion, definition.place)?;
    let place = source::place(cx.expansion, definition.place)?;
    let document = &cx.expansion.files.get(place.file)?.source.document;
    Some(source::removal(document, node.range().shift(base)))
}
