//! Where the robot's links, joints and materials are named: in the expanded document, with the texts that say so.

use super::context::Cx;
use super::instances::is_within;
use super::names::{NameOccurrence, place};
use base::{Span, TextRange};
use expand::{XId, XKind, XTree, blamed_argument};
use model::AttrValue;

/// The name of a link, joint or material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RobotThing {
    /// Its name in the expanded robot.
    pub name: String,
    kind: RobotNameKind,
}

/// The link, joint, material or group that the text at an offset names.
pub fn robot_name_at(cx: &Cx<'_>, offset: u32) -> Option<RobotThing> {
    if let Some(beside) = cx.beside.iter().find(|name| name.is_at(cx, offset)) {
        return Some(RobotThing {
            name: beside.value.to_string(),
            kind: beside.kind,
        });
    }
    let (_, names, kind) = named(cx, offset)?;
    let name = names.first()?.name()?.to_string();
    Some(RobotThing { name, kind })
}

/// All places that give or use a name of the robot.
pub fn uses_of(cx: &Cx<'_>, thing: &RobotThing) -> Vec<NameOccurrence> {
    let mut found: Vec<NameOccurrence> = Vec::new();
    for other in all_names(cx)
        .into_iter()
        .filter(|other| other.kind.is(thing.kind))
    {
        let same = other.text.name().is_some_and(|name| *name == *thing.name);
        let span = written(cx, &other.text).filter(|_| same);
        if let Some(span) = span
            && !found.iter().any(|used| used.span == span)
        {
            found.push(NameOccurrence {
                span,
                is_definition: other.is_definition,
            });
        }
    }
    for other in cx
        .beside
        .iter()
        .filter(|other| other.kind.is(thing.kind) && *other.value == *thing.name)
    {
        let used = NameOccurrence {
            span: other.place,
            is_definition: other.is_definition,
        };
        if !found.iter().any(|known| known.span == used.span) {
            found.push(used);
        }
    }
    found
}

/// What a name is the name of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RobotNameKind {
    Link,
    Joint,
    /// `gazebo` says only that it means one of both.
    LinkOrJoint,
    Material,
    /// A planning group of an SRDF.
    Group,
}

impl RobotNameKind {
    /// Whether two names may mean one thing.
    pub fn is(self, other: Self) -> bool {
        self == other || self.is_either(other) || other.is_either(self)
    }

    /// Whether this is a link or a joint, not known which, and the other one of the two.
    fn is_either(self, other: Self) -> bool {
        self == Self::LinkOrJoint && matches!(other, Self::Link | Self::Joint)
    }
}

/// A text that gives or names a link, joint or material.
#[derive(Clone)]
pub(super) struct RobotName {
    pub text: AttrValue,
    pub is_definition: bool,
    pub kind: RobotNameKind,
}

/// The names that the attribute value at an offset stands for (it may give several, when a macro is called often):
/// texts that define them.
pub(super) fn named_at(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, Vec<AttrValue>)> {
    named(cx, offset).map(|(range, names, _)| (range, names))
}

fn named(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, Vec<AttrValue>, RobotNameKind)> {
    let all = all_names(cx);
    if let Some(beside) = cx.beside.iter().find(|name| name.is_at(cx, offset)) {
        let is_it = |name: &&RobotName| {
            name.is_definition && name.kind.is(beside.kind) && name.text.value == beside.value
        };
        let given = all
            .iter()
            .filter(is_it)
            .map(|name| name.text.clone())
            .collect();
        return Some((beside.place.range, given, beside.kind));
    }
    let mut asked: Vec<(&RobotName, TextRange)> = Vec::new();
    for name in &all {
        // its own text, or what a call passes for it
        let own = place(cx, name.text.origin).filter(|span| is_at(cx, *span, offset));
        let own = own.or_else(|| written(cx, &name.text).filter(|span| is_at(cx, *span, offset)));
        asked.extend(own.map(|span| (name, span.range)));
    }
    let &(first, range) = asked.first()?;
    if asked.iter().any(|(name, _)| is_selected(cx, name)) {
        asked.retain(|(name, _)| is_selected(cx, name));
    }
    let given = all
        .iter()
        .filter(|name| name.is_definition && name.kind.is(first.kind));
    let values: Vec<_> = asked.iter().map(|(asked, _)| &asked.text.value).collect();
    let names: Vec<AttrValue> = given
        .map(|name| &name.text)
        .filter(|text| values.contains(&&text.value))
        .cloned()
        .collect();
    let names = if names.is_empty() {
        asked.iter().map(|(name, _)| name.text.clone()).collect()
    } else {
        names
    };
    Some((range, names, first.kind))
}

/// Whether a span of the file stands at the offset.
fn is_at(cx: &Cx<'_>, span: Span, offset: u32) -> bool {
    span.file == cx.source.id && span.range.touches(offset)
}

/// Whether the call that was selected made a name.
fn is_selected(cx: &Cx<'_>, name: &RobotName) -> bool {
    cx.selected_frame
        .is_some_and(|frame| is_within(cx.expansion, name.text.origin.frame, frame))
}

/// The names of links and joints, and the texts that refer to them; true: it is given there.
pub(super) fn robot_names(cx: &Cx<'_>) -> Vec<(AttrValue, bool)> {
    let names = all_names(cx)
        .into_iter()
        .filter(|name| name.kind != RobotNameKind::Material);
    names.map(|name| (name.text, name.is_definition)).collect()
}

/// All names of links, joints and materials, and the texts that refer to them.
pub(super) fn all_names(cx: &Cx<'_>) -> Vec<RobotName> {
    use RobotNameKind::{Joint, Link, LinkOrJoint, Material};
    let Some(robot) = cx.robot else {
        return Vec::new();
    };
    let tree = &cx.expansion.tree;
    let mut found: Vec<RobotName> = Vec::new();
    for link in &robot.links {
        add(&mut found, &link.name, true, Link);
        for material in materials(tree, link.element) {
            let is_given = tree
                .children(material)
                .any(|child| tree.get(child).kind == XKind::Element);
            add(
                &mut found,
                &AttrValue::attr(tree, material, "name"),
                is_given,
                Material,
            );
        }
    }
    for joint in &robot.joints {
        add(&mut found, &joint.name, true, Joint);
        add(&mut found, &joint.parent, false, Link);
        add(&mut found, &joint.child, false, Link);
        joint
            .mimic
            .iter()
            .for_each(|mimic| add(&mut found, &mimic.joint, false, Joint));
    }
    for gazebo in &robot.gazebo {
        add(&mut found, &gazebo.reference, false, LinkOrJoint);
        let own = contents(tree, gazebo.element).into_iter();
        own.for_each(|(text, kind)| add(&mut found, &Some(text), false, kind));
    }
    let controlled = robot.controls.iter().flat_map(|control| &control.joints);
    controlled.for_each(|joint| add(&mut found, &joint.name, false, Joint));
    for (_, name) in robot
        .transmissions
        .iter()
        .flat_map(|transmission| &transmission.joints)
    {
        add(&mut found, name, false, Joint);
    }
    robot
        .materials
        .iter()
        .for_each(|material| add(&mut found, &material.name, true, Material));
    found
}

fn add(
    found: &mut Vec<RobotName>,
    text: &Option<AttrValue>,
    is_definition: bool,
    kind: RobotNameKind,
) {
    found.extend(text.iter().map(|text| RobotName {
        text: text.clone(),
        is_definition,
        kind,
    }));
}

/// The materials in what one sees of a link, and in what it collides with.
fn materials(tree: &XTree, link: XId) -> impl Iterator<Item = XId> + '_ {
    children_named(tree, link, &["visual", "collision"])
        .flat_map(|shape| children_named(tree, shape, &["material"]))
}

/// The children with one of some tags.
fn children_named<'a>(
    tree: &'a XTree,
    of: XId,
    names: &'static [&str],
) -> impl Iterator<Item = XId> + 'a {
    tree.children(of)
        .filter(|child| names.contains(&tree.get(*child).text.as_str()))
}

/// What elements in a `gazebo` element say that are there to name a link or joint, as `frameName` of a plugin is.
fn contents(tree: &XTree, gazebo: XId) -> Vec<(AttrValue, RobotNameKind)> {
    let mut found = Vec::new();
    let mut open = vec![gazebo];
    while let Some(element) = open.pop() {
        open.extend(
            tree.children(element)
                .filter(|child| tree.get(*child).kind == XKind::Element),
        );
        let Some(kind) = meant_by(&tree.get(element).text) else {
            continue;
        };
        found.extend(AttrValue::content(tree, element).map(|text| (text, kind)));
    }
    found
}

/// What the content of an element in a plugin names, as its tag says.
fn meant_by(tag: &str) -> Option<RobotNameKind> {
    let tag = tag.to_lowercase();
    let is_link = ["frame", "body", "link"]
        .iter()
        .any(|word| tag.contains(word));
    if tag.contains("joint") {
        Some(RobotNameKind::Joint)
    } else {
        is_link.then_some(RobotNameKind::Link)
    }
}

/// Where a name is written: in the text itself, or, when that is a parameter of a macro, in the call.
fn written(cx: &Cx<'_>, text: &AttrValue) -> Option<Span> {
    place(
        cx,
        blamed_argument(cx.expansion, text.origin).unwrap_or(text.origin),
    )
}
