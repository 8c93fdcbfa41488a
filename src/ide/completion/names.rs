//! Names of links, joints, materials and blocks.

use std::path::Path;

use super::item::{Completion, ItemKind};
use super::made;
use super::mentioned;
use super::scope::{CompletionScope, MacroInfo};
use super::tags::spec_of;
use crate::typed::{Typed, attr_text};
use base::FastSet;
use expand::{Expansion, parse_params};
use facts::FactKind;
use model::AttrValue;
use rules::schema::AttributeKind;
use xml::{Node, NodeKind};

/// Which names are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WantedName {
    Link,
    Joint,
    LinkOrJoint,
}

impl WantedName {
    fn kinds(self) -> &'static [(FactKind, ItemKind)] {
        const BOTH: &[(FactKind, ItemKind)] = &[
            (FactKind::Link, ItemKind::Link),
            (FactKind::Joint, ItemKind::Joint),
        ];
        match self {
            WantedName::Link => BOTH.get(..1).unwrap_or(BOTH),
            WantedName::Joint => BOTH.get(1..).unwrap_or(BOTH),
            WantedName::LinkOrJoint => BOTH,
        }
    }

    /// What the value of an attribute names.
    pub fn of(kind: AttributeKind) -> Option<Self> {
        match kind {
            AttributeKind::Link => Some(WantedName::Link),
            AttributeKind::Joint => Some(WantedName::Joint),
            AttributeKind::LinkOrJoint => Some(WantedName::LinkOrJoint),
            _ => None,
        }
    }
}

/// Links or joints: those that the macro around gives as they are written, those of the expanded robot, those that
/// stand in the texts. `is_end` says that the value is the child of a joint: links that have no parent come first.
pub(super) fn names(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    wanted: WantedName,
    is_end: bool,
) -> Vec<Completion> {
    let mut found = Vec::new();
    for &(fact, kind) in wanted.kinds() {
        let patterns = scope
            .patterns(fact, typed.offset)
            .into_iter()
            .filter(|name| !name.is_empty());
        found.extend(patterns.map(|name| Completion::new(kind, name).note("here").rank(0)));
        let beside = scope.patterns_beside(fact, typed.offset).into_iter();
        found.extend(beside.map(|name| Completion::new(kind, name).note("in this file").rank(4)));
        if typed.in_macro().is_some() && kind == ItemKind::Link {
            found.extend(link_parameters(typed));
        }
        for (expansion, robot) in scope.robots() {
            let texts: Vec<&AttrValue> = match kind {
                ItemKind::Link => robot
                    .links
                    .iter()
                    .filter_map(|link| link.name.as_ref())
                    .collect(),
                _ => robot
                    .joints
                    .iter()
                    .filter_map(|joint| joint.name.as_ref())
                    .collect(),
            };
            let held: FastSet<&str> = robot
                .joints
                .iter()
                .filter_map(|joint| Some(joint.child.as_ref()?.value.as_str()))
                .collect();
            for text in texts.into_iter().filter(|text| text.name().is_some()) {
                let free = is_end && !held.contains(text.value.as_str());
                let item =
                    Completion::new(kind, text.value.as_str()).note(file_of(expansion, text));
                found.push(item.rank(if free { 1 } else { 2 }));
            }
        }
        found.extend(made::names(scope, typed, fact, kind));
        found.extend(mentioned::names(scope, typed, kind));
        // an SRDF gives none of them
        let plain = scope
            .plain_names(fact)
            .into_iter()
            .filter(|(name, _)| !name.is_empty() && !scope.is_semantic);
        found.extend(
            plain.map(|(name, file)| Completion::new(kind, name).note(file_name(&file)).rank(3)),
        );
    }
    found
}

/// Parameters of the macro around that are there to name a link.
fn link_parameters(typed: &Typed<'_>) -> Vec<Completion> {
    let params = typed
        .in_macro()
        .and_then(|open| parse_params(&attr_text(open, "params")?))
        .unwrap_or_default();
    let links = params
        .iter()
        .filter(|param| !param.is_block() && is_link_name(&param.name));
    links
        .map(|param| {
            Completion::new(ItemKind::Link, format!("${{{}}}", param.name))
                .note("parameter")
                .rank(1)
        })
        .collect()
}

/// Whether a parameter of this name mostly names a link.
pub(super) fn is_link_name(name: &str) -> bool {
    let last = name.rsplit('_').next().unwrap_or(name);
    matches!(last, "parent" | "child" | "link" | "frame") || name.starts_with("parent")
}

/// What a parameter of a macro is used for: the value of an attribute that names a link or joint.
pub(super) fn flows_into(
    scope: &CompletionScope<'_>,
    info: &MacroInfo,
    param: &str,
) -> Option<WantedName> {
    flow(scope, info, param, 3).or_else(|| is_link_name(param).then_some(WantedName::Link))
}

fn flow(
    scope: &CompletionScope<'_>,
    info: &MacroInfo,
    param: &str,
    depth: u32,
) -> Option<WantedName> {
    let read = format!("${{{param}}}");
    let body = info.item.node(info.node);
    let range = body.range();
    let inside = info.item.all_nodes().filter(|node| {
        node.kind() == NodeKind::Element && range.contains_range(node.range()) && *node != body
    });
    for node in inside {
        for attr in node.attrs().filter(|attr| attr.raw().trim() == read) {
            let found = match node.name() {
                name if name.starts_with("xacro:") && depth > 0 => scope
                    .called(name)
                    .and_then(|inner| flow(scope, &inner, attr.name(), depth - 1)),
                _ => spec(scope, node)
                    .and_then(|spec| spec.attribute(attr.name()))
                    .and_then(|attribute| WantedName::of(attribute.kind)),
            };
            if found.is_some() {
                return found;
            }
        }
    }
    None
}

fn spec(
    scope: &CompletionScope<'_>,
    node: Node<'_>,
) -> Option<&'static rules::schema::ElementSpec> {
    let mut names: Vec<&str> = std::iter::successors(Some(node), |node| node.parent())
        .map(Node::name)
        .collect();
    names.push("robot");
    names.reverse();
    spec_of(scope, &names)
}

/// The materials of the robot, and those the texts give.
pub(super) fn materials(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let patterns = scope
        .patterns(FactKind::Material, typed.offset)
        .into_iter()
        .filter(|name| !name.is_empty());
    let mut found: Vec<Completion> = patterns
        .map(|name| Completion::new(ItemKind::Color, name).note("here").rank(0))
        .collect();
    for (expansion, robot) in scope.sources.expansions {
        let Some(robot) = robot else { continue };
        let visuals = robot.links.iter().flat_map(|link| &link.visuals);
        let own = visuals.filter_map(|visual| visual.material.as_deref());
        for material in robot.materials.iter().chain(own) {
            let Some(name) = material.name.as_ref().filter(|name| name.name().is_some()) else {
                continue;
            };
            let item = Completion::new(ItemKind::Color, name.value.as_str());
            let item = item.note(file_of(expansion, name)).rank(1);
            found.push(
                match material.rgba.as_ref().and_then(AttrValue::numbers::<4>) {
                    Some(rgba) => item.detail(hex(rgba)).rank(0),
                    None => item,
                },
            );
        }
    }
    let beside = scope
        .patterns_beside(FactKind::Material, typed.offset)
        .into_iter();
    found.extend(beside.map(|name| {
        Completion::new(ItemKind::Color, name)
            .note("in this file")
            .rank(3)
    }));
    let plain = scope
        .plain_names(FactKind::Material)
        .into_iter()
        .filter(|(name, _)| !name.is_empty());
    found.extend(plain.map(|(name, file)| {
        Completion::new(ItemKind::Color, name)
            .note(file_name(&file))
            .rank(2)
    }));
    found
}

/// A color as editors show it.
fn hex(rgba: [f64; 4]) -> String {
    let [red, green, blue, _] = rgba.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The blocks that can be inserted: parameters of the macros around, and properties.
pub(super) fn blocks(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let macros = typed
        .open
        .iter()
        .filter(|open| open.name() == "xacro:macro");
    let params = macros
        .filter_map(|open| parse_params(&attr_text(*open, "params")?))
        .flatten();
    let params: Vec<Completion> = params
        .filter(|param| param.is_block())
        .map(|param| {
            let name = param.name.trim_start_matches('*').to_owned();
            Completion::new(ItemKind::Block, name)
                .note("parameter")
                .rank(0)
        })
        .collect();
    let properties = scope
        .properties(typed.offset)
        .into_iter()
        .filter(|property| property.is_block);
    let properties =
        properties.map(|property| Completion::new(ItemKind::Block, property.name).note("property"));
    params.into_iter().chain(properties).collect()
}

pub(super) fn file_of(expansion: &Expansion, text: &AttrValue) -> String {
    let source = expansion.sources.get(text.origin.src);
    let file = source.and_then(|source| expansion.files.get(source.file));
    file.map(|file| file_name(&file.source.path))
        .unwrap_or_default()
}

/// The last part of a path.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name()
        .map(|name| name.to_string_lossy().into_owned())
        .unwrap_or_default()
}
