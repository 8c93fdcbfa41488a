//! Where names are given and where they are used.

use super::context::Cx;
use super::instances::is_within;
use base::{Span, TextRange};
use expand::{DefinitionId, Origin, SourceRange, SymbolKind, argument};
use model::Text;

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

/// A definition and its uses, as far as they were evaluated.
pub(super) fn evaluated_uses(cx: &Cx<'_>, id: DefinitionId) -> Vec<NameUse> {
    let given = cx.expansion.symbols.get(id).and_then(|definition| cx.span(definition.place));
    let given = given.map(|span| NameUse { span, is_definition: true });
    let uses = cx
        .expansion
        .symbols
        .all_uses()
        .filter(|used| used.definition == id)
        .filter_map(|used| Some(NameUse { span: cx.span(used.place)?, is_definition: false }));
    given.into_iter().chain(uses).collect()
}

/// The name of a link, joint or material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RobotThing {
    /// Its name in the expanded robot.
    pub name: String,
    kind: NameKind,
}

/// The link, joint or material that the text at an offset names.
pub fn robot_name_at(cx: &Cx<'_>, offset: u32) -> Option<RobotThing> {
    let (_, names, kind) = named(cx, offset)?;
    let name = names.first()?.name()?.to_string();
    Some(RobotThing { name, kind })
}

/// All places that give or use a name of the robot.
pub fn uses_of(cx: &Cx<'_>, thing: &RobotThing) -> Vec<NameUse> {
    let mut found: Vec<NameUse> = Vec::new();
    for other in all_names(cx).into_iter().filter(|other| other.kind.is(thing.kind)) {
        let same = other.text.name().is_some_and(|name| *name == *thing.name);
        let span = written(cx, other.text).filter(|_| same);
        if let Some(span) = span
            && !found.iter().any(|used| used.span == span)
        {
            found.push(NameUse { span, is_definition: other.is_definition });
        }
    }
    found
}

/// What a name is the name of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NameKind {
    Link,
    Joint,
    /// `gazebo` says only that it means one of both.
    LinkOrJoint,
    Material,
}

impl NameKind {
    /// Whether two names may mean one thing.
    pub fn is(self, other: Self) -> bool {
        let mixed = |a, b| a == Self::LinkOrJoint && b != Self::Material;
        self == other || mixed(self, other) || mixed(other, self)
    }
}

/// A text that gives or names a link, joint or material.
#[derive(Clone, Copy)]
pub(super) struct RobotName<'a> {
    pub text: &'a Text,
    pub is_definition: bool,
    pub kind: NameKind,
}

/// The names that the attribute value at an offset stands for (it may give several, when a macro is called often):
/// texts that define them.
pub(super) fn named_at<'a>(cx: &Cx<'a>, offset: u32) -> Option<(TextRange, Vec<&'a Text>)> {
    named(cx, offset).map(|(range, names, _)| (range, names))
}

fn named<'a>(cx: &Cx<'a>, offset: u32) -> Option<(TextRange, Vec<&'a Text>, NameKind)> {
    let all = all_names(cx);
    let here = |span: Option<Span>| {
        span.filter(|span| {
            span.file == cx.source.id && span.range.start <= offset && offset <= span.range.end
        })
    };
    let mut asked: Vec<(RobotName<'a>, TextRange)> = Vec::new();
    for name in &all {
        // its own text, or what a call passes for it
        let own = here(place(cx, name.text.origin)).or_else(|| here(written(cx, name.text)));
        asked.extend(own.map(|span| (*name, span.range)));
    }
    let (first, range) = *asked.first()?;
    let picked = |name: &RobotName<'_>| {
        cx.pinned.is_some_and(|pin| is_within(cx.expansion, name.text.origin.frame, pin))
    };
    if asked.iter().any(|(name, _)| picked(name)) {
        asked.retain(|(name, _)| picked(name));
    }
    let given = all.iter().filter(|name| name.is_definition && name.kind.is(first.kind));
    let is_asked = |text: &Text| asked.iter().any(|(asked, _)| asked.text.value == text.value);
    let names: Vec<&Text> = given.map(|name| name.text).filter(|text| is_asked(text)).collect();
    let names = if names.is_empty() { asked.iter().map(|(name, _)| name.text).collect() } else { names };
    Some((range, names, first.kind))
}

/// The names of links and joints, and the texts that refer to them; true: it is given there.
pub(super) fn robot_names<'a>(cx: &Cx<'a>) -> Vec<(&'a Text, bool)> {
    let names = all_names(cx).into_iter().filter(|name| name.kind != NameKind::Material);
    names.map(|name| (name.text, name.is_definition)).collect()
}

/// All names of links, joints and materials, and the texts that refer to them.
pub(super) fn all_names<'a>(cx: &Cx<'a>) -> Vec<RobotName<'a>> {
    use NameKind::{Joint, Link, LinkOrJoint, Material};
    let Some(robot) = cx.robot else { return Vec::new() };
    let mut found: Vec<RobotName<'a>> = Vec::new();
    let mut add = |text: &'a Option<Text>, is_definition: bool, kind: NameKind| {
        found.extend(text.iter().map(|text| RobotName { text, is_definition, kind }));
    };
    for link in &robot.links {
        add(&link.name, true, Link);
        for material in link.visuals.iter().filter_map(|visual| visual.material.as_ref()) {
            add(&material.name, material.color.or(material.texture).is_some(), Material);
        }
    }
    for joint in &robot.joints {
        add(&joint.name, true, Joint);
        add(&joint.parent, false, Link);
        add(&joint.child, false, Link);
        joint.mimic.iter().for_each(|mimic| add(&mimic.joint, false, Joint));
    }
    robot.gazebo.iter().for_each(|gazebo| add(&gazebo.reference, false, LinkOrJoint));
    robot
        .controls
        .iter()
        .flat_map(|control| &control.joints)
        .for_each(|joint| add(&joint.name, false, Joint));
    for (_, name) in robot.transmissions.iter().flat_map(|transmission| &transmission.joints) {
        add(name, false, Joint);
    }
    robot.materials.iter().for_each(|material| add(&material.name, true, Material));
    found
}

/// Where a name is written: in the text itself, or, when that is a parameter of a macro, in the call.
fn written(cx: &Cx<'_>, text: &Text) -> Option<Span> {
    place(cx, argument(cx.expansion, text.origin).unwrap_or(text.origin))
}

/// The text at an origin, then the calls that led there.
fn made_by(cx: &Cx<'_>, origin: Origin) -> Vec<Target> {
    let own = place(cx, origin).map(|name| Target { whole: name, name });
    let calls = cx.expansion.frames_of(origin).filter(|frame| frame.kind == expand::FrameKind::Macro);
    let calls = calls.filter_map(|frame| place(cx, frame.call)).map(|name| Target { whole: name, name });
    own.into_iter().chain(calls).collect()
}

fn place(cx: &Cx<'_>, origin: Origin) -> Option<Span> {
    cx.span(SourceRange::from(origin))
}
