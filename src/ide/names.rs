//! Where names are given and where they are used.

use super::context::Cx;
use crate::base::{Span, TextRange};
use crate::expand::{DefinitionId, Origin, SourceRange, SymbolKind};
use crate::model::Text;

/// A place where a name stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NameUse {
    /// The name's text.
    pub span: Span,
    /// Whether the name is given there.
    pub is_definition: bool,
}

/// A place to jump to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// All that belongs to it: an element, or the file.
    pub whole: Span,
    /// Its name.
    pub name: Span,
}

/// What the name at an offset refers to, with the name's range: the definition of a xacro name, or the links and
/// joints of the robot that a text names, with the calls that made them behind.
pub fn definitions(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, Vec<Target>)> {
    if let Some((id, range)) = cx.symbol_at(offset) {
        return Some((range, definition_of(cx, id).into_iter().collect()));
    }
    let (range, names) = named_at(cx, offset)?;
    let mut targets: Vec<Target> = Vec::new();
    for text in names {
        for target in made_by(cx, text.origin) {
            if !targets.contains(&target) {
                targets.push(target);
            }
        }
    }
    (!targets.is_empty()).then_some((range, targets))
}

/// The place of a definition.
pub fn definition_of(cx: &Cx<'_>, id: DefinitionId) -> Option<Target> {
    let definition = cx.expansion.symbols.get(id)?;
    let name = cx.span(definition.place)?;
    let source = cx.expansion.sources.get(definition.place.src.0 as usize)?;
    let around = source.item.all_nodes().filter(|node| {
        let range = node.range();
        range.start <= definition.place.range.start && definition.place.range.end <= range.end
    });
    let element = around.filter(|node| !node.name().is_empty()).last();
    let whole = match (definition.kind, element) {
        (SymbolKind::Parameter | SymbolKind::BlockParameter, _) | (_, None) => name,
        (_, Some(node)) => Span { range: node.range().shift(source.base), ..name },
    };
    Some(Target { whole, name })
}

/// All places of the name at an offset, its definition among them; none when there is no name.
pub fn occurrences(cx: &Cx<'_>, offset: u32) -> Vec<NameUse> {
    if let Some((id, _)) = cx.symbol_at(offset) {
        let given = cx.expansion.symbols.get(id).and_then(|definition| cx.span(definition.place));
        let given = given.map(|span| NameUse { span, is_definition: true });
        let uses = cx
            .expansion
            .symbols
            .all_uses()
            .filter(|used| used.definition == id)
            .filter_map(|used| Some(NameUse { span: cx.span(used.place)?, is_definition: false }));
        return given.into_iter().chain(uses).collect();
    }
    let Some((_, names)) = named_at(cx, offset) else { return Vec::new() };
    let Some(name) = names.first().and_then(|text| text.name()) else { return Vec::new() };
    let mut found: Vec<NameUse> = Vec::new();
    for (text, is_definition) in robot_names(cx) {
        let span = place(cx, text.origin).filter(|_| text.name() == Some(name));
        if let Some(span) = span
            && !found.iter().any(|used| used.span == span)
        {
            found.push(NameUse { span, is_definition });
        }
    }
    found
}

/// The names of links and joints that the attribute value at an offset stands for (it may give several, when a
/// macro is called often): texts that define them.
pub(super) fn named_at<'a>(cx: &Cx<'a>, offset: u32) -> Option<(TextRange, Vec<&'a Text>)> {
    let here = |text: &Text| {
        place(cx, text.origin).is_some_and(|span| {
            span.file == cx.source.id && span.range.start <= offset && offset <= span.range.end
        })
    };
    let all: Vec<(&Text, bool)> = robot_names(cx);
    let asked: Vec<&Text> = all.iter().map(|(text, _)| *text).filter(|text| here(text)).collect();
    let range = place(cx, asked.first()?.origin)?.range;
    let given = all.iter().filter(|(_, is_definition)| *is_definition).map(|(text, _)| *text);
    let names: Vec<&Text> =
        given.filter(|text| asked.iter().any(|asked| asked.value == text.value)).collect();
    Some((range, if names.is_empty() { asked } else { names }))
}

/// The names of links and joints, and the texts that refer to them; true: it is given there.
pub(super) fn robot_names<'a>(cx: &Cx<'a>) -> Vec<(&'a Text, bool)> {
    let Some(robot) = cx.robot else { return Vec::new() };
    let links = robot.links.iter().filter_map(|link| Some((link.name.as_ref()?, true)));
    let joints = robot.joints.iter().flat_map(|joint| {
        let ends = [&joint.parent, &joint.child].into_iter().flatten().map(|text| (text, false));
        let mimic = joint.mimic.iter().filter_map(|mimic| Some((mimic.joint.as_ref()?, false)));
        joint.name.iter().map(|text| (text, true)).chain(ends).chain(mimic)
    });
    let gazebo = robot.gazebo.iter().filter_map(|gazebo| Some((gazebo.reference.as_ref()?, false)));
    let control = robot.controls.iter().flat_map(|control| &control.joints);
    let control = control.filter_map(|joint| Some((joint.name.as_ref()?, false)));
    let driven = robot.transmissions.iter().flat_map(|transmission| &transmission.joints);
    let driven = driven.filter_map(|(_, name)| Some((name.as_ref()?, false)));
    links.chain(joints).chain(gazebo).chain(control).chain(driven).collect()
}

/// The text at an origin, then the calls that led there.
fn made_by(cx: &Cx<'_>, origin: Origin) -> Vec<Target> {
    let own = place(cx, origin).map(|name| Target { whole: name, name });
    let calls = cx.expansion.frames_of(origin).filter(|frame| frame.kind == crate::expand::FrameKind::Macro);
    let calls = calls.filter_map(|frame| place(cx, frame.call)).map(|name| Target { whole: name, name });
    own.into_iter().chain(calls).collect()
}

fn place(cx: &Cx<'_>, origin: Origin) -> Option<Span> {
    cx.span(SourceRange::from(origin))
}
