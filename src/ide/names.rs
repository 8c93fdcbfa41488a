//! Where names are given and where they are used.

use super::beside::BesideName;
use super::context::Cx;
use super::robot_names::named_at;
use base::{Span, TextRange};
use expand::{DefinitionId, Origin, SourceRange, SymbolKind};

/// A place where a name stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NameOccurrence {
    /// The name's text.
    pub span: Span,
    /// Whether the name is given there.
    pub is_definition: bool,
}

/// A place to jump to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NavigationTarget {
    /// All that belongs to it: an element, or the file.
    pub whole: Span,
    /// Its name.
    pub name: Span,
}

/// What the name at an offset refers to, with the name's range: the definition of a xacro name, or the links and
/// joints of the robot that a text names, with the calls that made them behind.
pub fn definitions(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, Vec<NavigationTarget>)> {
    if let Some((id, range)) = cx.symbol_at(offset) {
        return Some((range, definition_of(cx, id).into_iter().collect()));
    }
    let (range, names) = named_at(cx, offset)?;
    let mut targets: Vec<NavigationTarget> = Vec::new();
    for text in names {
        for target in made_by(cx, text.origin) {
            if !targets.contains(&target) {
                targets.push(target);
            }
        }
    }
    // groups and virtual joints are given beside the robot
    if let Some(asked) = cx.beside.iter().find(|name| name.is_at(cx, offset)) {
        let is_it = |name: &&BesideName| {
            name.is_definition && name.kind.is(asked.kind) && name.value == asked.value
        };
        let given = cx.beside.iter().filter(is_it);
        targets.extend(given.map(|name| NavigationTarget {
            whole: name.place,
            name: name.place,
        }));
    }
    (!targets.is_empty()).then_some((range, targets))
}

/// The place of a definition.
pub fn definition_of(cx: &Cx<'_>, id: DefinitionId) -> Option<NavigationTarget> {
    let definition = cx.expansion.index.symbols.get(id)?;
    let name = cx.span(definition.place)?;
    let source = cx.expansion.sources.get(definition.place.src)?;
    let around = source.item.all_nodes().filter(|node| {
        let range = node.range();
        range.start <= definition.place.range.start && definition.place.range.end <= range.end
    });
    let element = around.filter(|node| !node.name().is_empty()).last();
    let whole = match (definition.kind, element) {
        (SymbolKind::Parameter | SymbolKind::BlockParameter, _) | (_, None) => name,
        (_, Some(node)) => Span {
            range: node.range().shift(source.base),
            ..name
        },
    };
    Some(NavigationTarget { whole, name })
}

/// A definition and its uses, as far as they were evaluated.
pub(super) fn evaluated_uses(cx: &Cx<'_>, id: DefinitionId) -> Vec<NameOccurrence> {
    let given = cx
        .expansion
        .index
        .symbols
        .get(id)
        .and_then(|definition| cx.span(definition.place));
    let given = given.map(|span| NameOccurrence {
        span,
        is_definition: true,
    });
    let uses = cx
        .expansion
        .index
        .symbols
        .all_uses()
        .filter(|used| used.definition == id)
        .filter_map(|used| {
            Some(NameOccurrence {
                span: cx.span(used.place)?,
                is_definition: false,
            })
        });
    given.into_iter().chain(uses).collect()
}

/// The text at an origin, then the calls that led there.
fn made_by(cx: &Cx<'_>, origin: Origin) -> Vec<NavigationTarget> {
    let own = place(cx, origin).map(|name| NavigationTarget { whole: name, name });
    let calls = cx
        .expansion
        .frames_of(origin)
        .filter(|frame| frame.kind == expand::FrameKind::Macro);
    let calls = calls
        .filter_map(|frame| place(cx, frame.call))
        .map(|name| NavigationTarget { whole: name, name });
    own.into_iter().chain(calls).collect()
}

/// Where the text at an origin stands.
pub(super) fn place(cx: &Cx<'_>, origin: Origin) -> Option<Span> {
    cx.span(SourceRange::from(origin))
}
