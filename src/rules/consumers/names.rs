//! Names of links and joints that some consumers reserve, change or reject.
use super::facts::{ConstructCollector, ConstructOwner, RobotFacts, joint_owner, link_owner};
use base::FastSet;
use expand::{Origin, XId};
use model::{AttrValue, JointType};

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    let tops: FastSet<usize> = facts
        .bodies
        .iter()
        .filter_map(|body| body.links.first().copied())
        .collect();
    for (index, link) in facts.robot.links.iter().enumerate() {
        let owner = link_owner(link);
        let Some(name) = one(
            facts,
            &link.name,
            link.element,
            owner,
            ["link-without-name", "link-name-empty"],
            out,
        ) else {
            continue;
        };
        let is_top = tops.contains(&index);
        let is_root = facts.kinematics.parent_joints(index).is_empty();
        let at = name.origin;
        match name.value.as_str() {
            "universe" => out.add("link-universe", at, owner),
            "world" if !is_root && is_top => out.add("link-world", at, owner),
            "world" if !is_root => out.add("link-world-fixed", at, owner),
            "world" if link.inertial.is_some() || link.has_geometry() => {
                out.add("root-world-with-body", at, owner)
            }
            "world" => out.add("world-above", at, owner),
            _ if is_root
                && link.inertial.is_none()
                && !link.has_geometry()
                && !facts.robot.joints.is_empty() =>
            {
                out.add("root-without-body", at, owner);
            }
            _ => {}
        }
        let value = name.value.as_str();
        if value.ends_with([' ', '\t']) {
            out.add("name-with-space-at-end", at, owner);
        } else if value.contains(' ') {
            out.add("name-with-space", at, owner);
        }
        if is_reserved(value) && is_top {
            out.add("link-name-reserved-in-sdf", at, owner);
        }
        if value.contains("::") {
            out.add("name-with-colons", at, owner);
        }
        common(name, owner, out);
    }
    for joint in &facts.robot.joints {
        let owner = joint_owner(joint);
        let is_fixed = joint.is(&[JointType::Fixed]);
        let empty = if is_fixed {
            "fixed-joint-name-empty"
        } else {
            "joint-name-empty"
        };
        let rows = ["joint-without-name", empty];
        let Some(name) = one(facts, &joint.name, joint.element, owner, rows, out) else {
            continue;
        };
        let at = name.origin;
        match name.value.as_str() {
            "universe" => out.add("joint-universe", at, owner),
            "world" if !is_fixed => out.add("joint-world", at, owner),
            name if is_reserved(name) && !is_fixed => {
                out.add("joint-name-reserved-in-sdf", at, owner)
            }
            _ => {}
        }
        if name.value.contains(' ') {
            out.add("joint-name-with-space", at, owner);
        }
        if name.value.contains("::") {
            out.add("joint-name-with-colons", at, owner);
        }
    }
}

/// The name of a thing, when it is known and not empty.
fn one<'t>(
    facts: &RobotFacts<'_, '_>,
    name: &'t Option<AttrValue>,
    element: XId,
    owner: ConstructOwner<'_>,
    [missing, empty]: [&str; 2],
    out: &mut ConstructCollector,
) -> Option<&'t AttrValue> {
    let at: Origin = facts.at(element);
    match name {
        None => out.add(missing, at, owner),
        Some(name) if name.value.is_empty() => out.add(empty, at, owner),
        Some(name) if name.is_known() => return Some(name),
        Some(_) => {}
    }
    None
}

/// What holds for a link whatever it is in the robot.
fn common(name: &AttrValue, owner: ConstructOwner<'_>, out: &mut ConstructCollector) {
    let value = name.value.as_str();
    let at = name.origin;
    if value.contains('/') {
        out.add("name-with-slash", at, owner);
    }
    if value.contains('"') {
        out.add("name-with-quote", at, owner);
    }
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !value.chars().all(is_word) || value.starts_with(|c: char| c.is_ascii_digit()) {
        out.add("name-no-identifier", at, owner);
    }
}

/// Whether SDFormat keeps a name for itself.
fn is_reserved(name: &str) -> bool {
    name.len() > 4 && name.starts_with("__") && name.ends_with("__")
}
