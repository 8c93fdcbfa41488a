//! The tree of links and joints.
use super::facts::{ConstructCollector, RobotFacts, joint_owner, link_owner};
use base::{FastMap, FastSet};
use model::{AttrValue, JointType, Link, Version};

/// More joints than these are too many for PyBullet.
const WIDE: usize = 128;
/// Longer chains of links end the stacks of some consumers.
const DEEP: usize = 1000;

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    robot(facts, out);
    version(facts, out);
    roots(facts, out);
    ends(facts, out);
    repeated(facts, out);
}

fn robot(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let (robot, at) = (facts.robot, facts.at(facts.robot.element));
    match &robot.name {
        None => out.add("robot-without-name", at, "the robot"),
        Some(name) if name.value.is_empty() => out.add("robot-name-empty", at, "the robot"),
        Some(_) => {}
    }
    if robot.links.is_empty() {
        out.add("no-links", at, "the robot");
    }
    if let (Some(link), None) = (robot.links.get(0), robot.links.get(1))
        && robot.joints.is_empty()
        && link.inertial.is_none()
    {
        out.add("one-link", facts.at(link.element), link_owner(link));
    }
    if robot.joints.len() > WIDE {
        out.add("wide-tree", at, "the robot");
    }
    let mut links = 0..robot.links.len();
    if robot.joints.len() >= DEEP
        && links.any(|link| facts.kinematics.ancestor_joints(link).count() >= DEEP)
    {
        out.add("deep-tree", at, "the robot");
    }
}

fn version(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let text = AttrValue::attr(&facts.cx.expansion.tree, facts.robot.element, "version");
    let Some(text) = text.filter(AttrValue::is_known) else {
        return;
    };
    let row = match Version::parse(&text.value) {
        Some(Version::V1_0) => return,
        Some(Version::V1_1) => "version-1.1",
        Some(Version::V1_2) => "version-1.2",
        Some(_) => "version-2",
        None if text.number().is_some() => "version-whole",
        None => "version-no-number",
    };
    out.add(row, text.origin, "the robot");
}

fn roots(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let roots = facts.kinematics.roots(facts.robot);
    for cycle in facts.kinematics.cycles() {
        let joint = cycle
            .first()
            .and_then(|&joint| facts.robot.joints.get(joint));
        if let Some(joint) = joint {
            let row = if roots.is_empty() {
                "link-cycle"
            } else {
                "link-cycle-beside-root"
            };
            out.add(
                row,
                facts.at_name(joint.name.as_ref(), joint.element),
                joint_owner(joint),
            );
        }
    }
    for &root in roots.iter().skip(1) {
        let Some(link) = facts.robot.links.get(root) else {
            continue;
        };
        let row = if facts.kinematics.child_joints(root).is_empty() {
            "two-roots"
        } else {
            "second-tree"
        };
        out.add(
            row,
            facts.at_name(link.name.as_ref(), link.element),
            link_owner(link),
        );
    }
    for (index, link) in facts.robot.links.iter().enumerate() {
        if facts.kinematics.parent_joints(index).len() > 1 && !roots.is_empty() {
            out.add(
                "two-parents",
                facts.at_name(link.name.as_ref(), link.element),
                link_owner(link),
            );
        }
    }
}

fn ends(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let is_empty = |link: &Link| link.name.as_ref().is_some_and(|name| name.value.is_empty());
    let has_empty = facts.robot.links.iter().any(is_empty);
    for joint in &facts.robot.joints {
        let at = facts.at_name(joint.name.as_ref(), joint.element);
        let (owner, element) = (joint_owner(joint), joint.element);
        match &joint.parent {
            None if facts.has_child(element, "parent") => {
                out.add("parent-without-link", at, owner);
            }
            None => out.add("joint-without-parent", at, owner),
            Some(parent) if parent.value.is_empty() && !has_empty => {
                out.add("parent-empty", parent.origin, owner);
            }
            Some(parent) if is_unknown(facts, parent) => {
                let row = unknown_row(parent, ["parent-world-unknown", "parent-unknown"]);
                out.add(row, parent.origin, owner);
            }
            Some(_) => {}
        }
        match &joint.child {
            None if facts.has_child(element, "child") => out.add("child-without-link", at, owner),
            Some(child) if child.value.is_empty() && !has_empty => {
                out.add("child-empty", child.origin, owner);
            }
            None => out.add("joint-without-child", at, owner),
            Some(child) if is_unknown(facts, child) => {
                let row = unknown_row(child, ["child-world-unknown", "child-unknown"]);
                out.add(row, child.origin, owner);
            }
            Some(_) => {}
        }
        if joint.ends().is_some_and(|(parent, child)| parent == child) {
            out.add("joint-to-itself", at, owner);
        }
    }
}

fn is_unknown(facts: &RobotFacts<'_, '_>, link: &AttrValue) -> bool {
    link.name()
        .is_some_and(|name| facts.kinematics.link(name).is_none())
}

/// The row of a link that is not there: Drake knows `world` without being told.
fn unknown_row(link: &AttrValue, [world, other]: [&'static str; 2]) -> &'static str {
    if link.value == "world" { world } else { other }
}

fn repeated(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let mut links: FastMap<&str, ()> = FastMap::default();
    let mut by_case: FastMap<String, &str> = FastMap::default();
    for link in &facts.robot.links {
        let Some(name) = link.name.as_ref().filter(|name| name.name().is_some()) else {
            continue;
        };
        let other = by_case.insert(name.value.to_lowercase().into(), name.value.as_str());
        if links.insert(name.value.as_str(), ()).is_some() {
            out.add("duplicate-link", name.origin, link_owner(link));
        } else if other.is_some() {
            out.add("names-by-case", name.origin, link_owner(link));
        }
    }
    // links that are fixed to others become a part of those in SDFormat, as fixed joints do
    let tops = facts.bodies.iter().filter_map(|body| body.links.first());
    let moving: FastSet<&str> = tops
        .filter_map(|&top| Some(facts.robot.links.get(top)?.name.as_ref()?.value.as_str()))
        .collect();
    let mut joints: FastMap<&str, ()> = FastMap::default();
    for joint in &facts.robot.joints {
        let Some(name) = joint.name.as_ref().filter(|name| name.name().is_some()) else {
            continue;
        };
        if joints.insert(name.value.as_str(), ()).is_some() {
            out.add("duplicate-joint", name.origin, joint_owner(joint));
        }
        if links.contains_key(name.value.as_str()) {
            let is_gone = joint.is(&[JointType::Fixed]) || !moving.contains(name.value.as_str());
            let row = if is_gone {
                "link-and-fixed-joint-of-one-name"
            } else {
                "link-and-joint-of-one-name"
            };
            out.add(row, name.origin, joint_owner(joint));
        }
    }
}
