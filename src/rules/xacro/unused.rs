//! Definitions that nothing reads: what the rules about them share.
use super::super::context::{DocumentCx, RootKind};
use super::source;
use base::{Id, TextRange};
use expand::{
    Definition, DefinitionId, Expansion, FileIdx, FileRange, ProblemKind, SymbolKind, UseKind,
};

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
    let symbols = cx
        .expansion
        .index
        .symbols
        .iter()
        .filter(|(_, definition)| kinds.contains(&definition.kind));
    let unused =
        symbols.filter(|(id, definition)| !is_used(cx, *id) && !definition.name.starts_with('_'));
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

/// Whether a definition is read, called or inserted.
pub(super) fn is_used(cx: &DocumentCx<'_>, id: DefinitionId) -> bool {
    let used = cx.used.get_or_init(|| find_used(cx.expansion));
    used.get(id.index()).is_some_and(|used| *used)
}

/// For each definition, whether it is read, called or inserted.
fn find_used(expansion: &Expansion) -> Vec<bool> {
    let symbols = &expansion.index.symbols;
    let mut used = vec![false; symbols.definitions.len()];
    for one in symbols.uses.iter().filter(|one| one.kind != UseKind::Given) {
        if let Some(used) = used.get_mut(one.definition.index()) {
            *used = true;
        }
    }
    used
}

/// The text to delete to remove the element of a definition; none when something but a name stands there.
pub(super) fn removal(cx: &DocumentCx<'_>, definition: &Definition) -> Option<TextRange> {
    let (base, node) = source::tag(cx.expansion, definition.place)?;
    let place = source::place(cx.expansion, definition.place)?;
    let document = &cx.expansion.files.get(place.file)?.source.document;
    Some(source::removal(document, node.range().shift(base)))
}
