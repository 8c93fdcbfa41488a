//! Values of attributes in an SRDF: names of the robot that it is for, groups, positions.

use super::choices::{AttributeContext, words_to_choose};
use super::item::{Completion, ItemKind};
use super::names::{self, WantedName};
use super::scope::CompletionScope;
use super::settings::{joint_item, same_text};
use crate::typed::{Typed, attr_text};
use base::FastSet;
use model::{Joint, JointType, Kinematics};
use project::{Srdf, joints_of_group};
use rules::schema::AttributeKind;
use xml::Node;

/// Values of an attribute of a start tag in an SRDF.
pub(super) fn values(
    scope: &CompletionScope<'_>,
    typed: &Typed<'_>,
    AttributeContext {
        spec,
        tag,
        attribute,
    }: AttributeContext<'_>,
) -> Vec<Completion> {
    let Some(given) = spec.and_then(|spec| spec.attribute(attribute)) else {
        return Vec::new();
    };
    match given.kind {
        AttributeKind::Name if tag.name() == "robot" => robots(scope),
        AttributeKind::Link => names::names(scope, typed, WantedName::Link, false),
        AttributeKind::Joint => joints(scope, typed),
        AttributeKind::Group => groups(scope, typed),
        AttributeKind::Choice(words) => words_to_choose(words),
        AttributeKind::Number if tag.name() == "joint" => positions(scope, tag),
        _ => Vec::new(),
    }
}

fn robots(scope: &CompletionScope<'_>) -> Vec<Completion> {
    let names = scope
        .robots()
        .filter_map(|(_, robot)| robot.name.as_ref()?.name());
    names
        .map(|name| Completion::new(ItemKind::Choice, name.as_str()))
        .collect()
}

/// Joints; in a state of a group, those of the group that have no position yet come first.
fn joints(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let around = typed
        .open
        .last()
        .filter(|open| open.name() == "group_state");
    let group = around.and_then(|open| attr_text(*open, "group"));
    let members = group
        .map(|group| members(scope, &group))
        .unwrap_or_default();
    let taken = if around.is_some() {
        given_beside(scope, typed)
    } else {
        Vec::new()
    };
    let mut found = names::names(scope, typed, WantedName::Joint, false);
    found.retain(|item| !taken.contains(&item.label));
    for item in &mut found {
        let known = scope
            .robots()
            .find_map(|(_, robot)| robot.joint(&item.label));
        if let Some(joint) = known {
            let shown = joint_item(joint, item.rank);
            (item.note, item.detail) = (shown.note, shown.detail);
        }
        if members.contains(&item.label) {
            item.rank = 0;
        }
    }
    found
}

/// The driven joints of a group.
fn members(scope: &CompletionScope<'_>, group: &str) -> FastSet<String> {
    let mut found = FastSet::default();
    for srdf in scope
        .sources
        .expansions
        .iter()
        .filter_map(|(own, _)| Srdf::of(own))
    {
        for (_, robot) in scope.robots() {
            let kinematics = Kinematics::of(robot);
            let joints = joints_of_group(&srdf, group, (robot, &kinematics))
                .unwrap_or_default()
                .into_iter();
            let is_driven = |name: &&str| robot.joint(name).is_some_and(Joint::is_driven);
            found.extend(joints.filter(is_driven).map(str::to_owned));
        }
    }
    found
}

/// The joints that have a position in the state around already.
fn given_beside(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<String> {
    let place = scope
        .sources
        .source
        .document
        .item_at(typed.offset.saturating_sub(1));
    let inside = typed.offset.saturating_sub(place.start);
    let is_around = |node: &Node<'_>| {
        node.name() == "group_state" && node.range().start < inside && inside <= node.range().end
    };
    let states = place.item.all_nodes().filter(is_around);
    let names = states.flat_map(|state| {
        state
            .child_elements()
            .filter_map(|child| child.attr("name"))
    });
    names
        .filter(|name| !name.value_range().touches(inside))
        .map(|name| name.raw().to_owned())
        .collect()
}

/// The groups: those that the text defines, and those of the last expansion.
fn groups(scope: &CompletionScope<'_>, typed: &Typed<'_>) -> Vec<Completion> {
    let mut found: Vec<Completion> = Vec::new();
    for (own, _) in scope.sources.expansions {
        let srdf = Srdf::of(own);
        let groups = srdf.iter().flat_map(|srdf| &srdf.groups);
        found.extend(groups.filter_map(|group| {
            let name = group.name.as_ref()?.name()?;
            Some(
                Completion::new(ItemKind::Group, name.as_str())
                    .note(group.in_short())
                    .rank(1),
            )
        }));
    }
    for (base, item) in scope.sources.source.document.parts() {
        let is_defined = |node: &Node<'_>| {
            node.name() == "group" && node.parent().is_none_or(|parent| parent.name() != "group")
        };
        let names = item
            .all_nodes()
            .filter(is_defined)
            .filter_map(|node| node.attr("name"));
        let names = names.filter(|name| !name.value_range().shift(base).touches(typed.offset));
        found.extend(names.map(|name| Completion::new(ItemKind::Group, name.raw()).rank(2)));
    }
    // a group is no part of itself
    let own = typed
        .open
        .last()
        .filter(|open| open.name() == "group")
        .and_then(|open| attr_text(*open, "name"));
    found.retain(|item| {
        !item.label.is_empty() && !own.as_ref().is_some_and(|own| same_text(own, &item.label))
    });
    found
}

/// Positions that people often write: zero and the ends of the range.
fn positions(scope: &CompletionScope<'_>, tag: Node<'_>) -> Vec<Completion> {
    let name = attr_text(tag, "name").unwrap_or_default();
    let joint = scope.robots().find_map(|(_, robot)| robot.joint(&name));
    let kind = joint.and_then(Joint::joint_type);
    let range = joint.and_then(|joint| joint.limit.as_ref()?.range());
    let range = range.filter(|_| matches!(kind, Some(JointType::Revolute | JointType::Prismatic)));
    let zero = range.is_none_or(|(lower, upper)| lower <= 0.0 && 0.0 <= upper);
    let mut found: Vec<Completion> = zero.then(|| position(0.0, "", 0)).into_iter().collect();
    found.extend(range.into_iter().flat_map(|(lower, upper)| {
        [
            position(lower, "lower limit", 1),
            position((lower + upper) / 2.0, "middle", 2),
            position(upper, "upper limit", 3),
        ]
    }));
    found
}

fn position(value: f64, note: &str, rank: u8) -> Completion {
    Completion::new(ItemKind::Choice, format!("{value}"))
        .note(note)
        .rank(rank)
}
