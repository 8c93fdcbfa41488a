//! Joints: types, limits, axes, dynamics.
use super::super::context::RootKind;
use super::facts::{ConstructCollector, RobotFacts, joint_owner};
use model::{AttrValue, Dynamics, Joint, JointType, Limit, Version};

/// Shorter axes are zero.
const TINY_AXIS: f64 = 1e-6;

pub(super) fn find(facts: &RobotFacts<'_, '_>, out: &mut ConstructCollector) {
    debug_assert_eq!(facts.cx.kind, RootKind::Robot);
    let last = facts
        .robot
        .joints
        .iter()
        .rposition(|joint| !joint.is(&[JointType::Fixed]))
        .unwrap_or_default();
    for (number, joint) in facts.robot.joints.iter().enumerate() {
        kind(facts, joint, number < last, out);
        limits(facts, joint, out);
        axis(facts, joint, out);
        rest(facts, joint, out);
    }
}

fn kind(facts: &RobotFacts<'_, '_>, joint: &Joint, is_before: bool, out: &mut ConstructCollector) {
    let Some(text) = &joint.kind else {
        return out.add(
            "joint-without-type",
            facts.at(joint.element),
            joint_owner(joint),
        );
    };
    if !text.is_known() {
        return;
    }
    let name = text.value.as_str();
    let row = match JointType::of(name) {
        None if name.is_empty() && is_before => "joint-type-empty-before",
        None if name.is_empty() => "joint-type-empty",
        None if name == "spherical" => "joint-type-spherical",
        None if is_before => "joint-type-unknown-before",
        None => "joint-type-unknown",
        Some(JointType::Floating) if is_below_root(facts, joint) => "joint-floating-root",
        Some(JointType::Floating) => "joint-floating",
        Some(JointType::Planar) => "joint-planar",
        Some(_) => return,
    };
    out.add(row, text.origin, joint_owner(joint));
}

/// Whether the parent of a joint is a root.
fn is_below_root(facts: &RobotFacts<'_, '_>, joint: &Joint) -> bool {
    let parent = joint
        .parent
        .as_ref()
        .and_then(|parent| facts.kinematics.link(parent.value.as_str()));
    parent.is_some_and(|link| facts.kinematics.parent_joints(link).is_empty())
}

fn limits(facts: &RobotFacts<'_, '_>, joint: &Joint, out: &mut ConstructCollector) {
    let Some(kind) = joint.joint_type() else {
        return;
    };
    let is_bounded = matches!(kind, JointType::Revolute | JointType::Prismatic);
    let Some(limit) = &joint.limit else {
        let row = if kind == JointType::Revolute {
            "revolute-without-limit"
        } else {
            "prismatic-without-limit"
        };
        if is_bounded {
            out.add(
                row,
                facts.at_name(joint.name.as_ref(), joint.element),
                joint_owner(joint),
            );
        }
        return;
    };
    let mut add = |row: &str| out.add(row, facts.at(limit.element), joint_owner(joint));
    if facts.children(joint.element, "limit").nth(1).is_some() {
        add("two-limits");
    }
    if kind == JointType::Fixed {
        add("limit-on-fixed");
    }
    if limit.dynamic.iter().any(Option::is_some) {
        add("limit-1.2");
    }
    let is_1_2 = facts
        .version
        .is_some_and(|version| version >= Version::V1_2);
    let bare = limit.effort.is_none() && limit.velocity.is_none();
    if bare && limit.lower.is_none() && limit.upper.is_none() {
        return add("limit-empty");
    }
    if limit.effort.is_none() && !is_1_2 {
        add("limit-without-effort");
    }
    if limit.velocity.is_none() && !is_1_2 {
        add("limit-without-velocity");
    }
    signs(limit, &mut add);
    if is_bounded {
        bounds(limit, &mut add);
    } else if kind == JointType::Continuous && (limit.lower.is_some() || limit.upper.is_some()) {
        add("limits-on-continuous");
    }
}

fn signs(limit: &Limit, add: &mut impl FnMut(&str)) {
    let rows = [
        (&limit.effort, "limit-effort-zero", "limit-effort-negative"),
        (
            &limit.velocity,
            "limit-velocity-zero",
            "limit-velocity-negative",
        ),
    ];
    for (text, zero, negative) in rows {
        match text.as_ref().and_then(AttrValue::number) {
            Some(0.0) => add(zero),
            Some(number) if number < 0.0 => add(negative),
            _ => {}
        }
    }
}

fn bounds(limit: &Limit, add: &mut impl FnMut(&str)) {
    match (&limit.lower, &limit.upper) {
        (None, None) => add("limit-without-bounds"),
        (None, Some(_)) => add("limit-without-lower"),
        (Some(_), None) => add("limit-without-upper"),
        (Some(lower), Some(upper)) => match lower.number().zip(upper.number()) {
            Some((0.0, 0.0)) => add("limits-zero"),
            #[allow(clippy::float_cmp)] // consumers compare so
            Some((lower, upper)) if lower == upper => add("limits-equal"),
            Some((lower, upper)) if lower > upper => add("limits-inverted"),
            _ => {}
        },
    }
}

fn axis(facts: &RobotFacts<'_, '_>, joint: &Joint, out: &mut ConstructCollector) {
    let Some(kind) = joint.joint_type() else {
        return;
    };
    let Some(axis) = &joint.axis else {
        if kind.has_axis() {
            out.add(
                "axis-missing",
                facts.at_name(joint.name.as_ref(), joint.element),
                joint_owner(joint),
            );
        }
        return;
    };
    let (at, owner) = (facts.at(axis.element), joint_owner(joint));
    if facts.children(joint.element, "axis").nth(1).is_some() {
        out.add("two-axes", at, owner);
    }
    let Some(xyz) = &axis.xyz else {
        return out.add("axis-empty", at, owner);
    };
    let Some(length) = xyz.numbers::<3>().map(|[x, y, z]| x.hypot(y).hypot(z)) else {
        return;
    };
    let row = match length {
        0.0 if kind.has_axis() => "axis-zero",
        0.0 => "axis-zero-fixed",
        _ if length < TINY_AXIS && kind.has_axis() => "axis-tiny",
        _ => return,
    };
    out.add(row, at, owner);
}

fn rest(facts: &RobotFacts<'_, '_>, joint: &Joint, out: &mut ConstructCollector) {
    let owner = joint_owner(joint);
    if let Some(of_joint) = &joint.dynamics {
        dynamics(facts, joint, of_joint, out);
    }
    if let Some(safety) = joint
        .safety
        .as_ref()
        .filter(|safety| safety.k_velocity.is_none())
    {
        out.add("safety-without-velocity", facts.at(safety.element), owner);
    }
    let tree = &facts.cx.expansion.tree;
    for calibration in facts.children(joint.element, "calibration") {
        if tree.attr(calibration, "rising").is_none() && tree.attr(calibration, "falling").is_none()
        {
            out.add("calibration-empty", facts.at(calibration), owner);
        }
    }
    if facts.children(joint.element, "origin").nth(1).is_some() {
        out.add("two-origins", facts.at(joint.element), owner);
    }
    for name in ["parent", "child"] {
        if let Some(second) = facts.children(joint.element, name).nth(1) {
            out.add("two-parents-in-joint", facts.at(second), owner);
        }
    }
    for origin in facts.children(joint.element, "origin") {
        if tree.attr(origin, "quat_xyzw").is_none() {
            continue;
        }
        let is_read = facts
            .version
            .is_some_and(|version| version >= Version::V1_1);
        let row = match tree.attr(origin, "rpy") {
            _ if !is_read => "quaternion-1.0",
            Some(_) => "origin-with-both-rotations",
            None => "quaternion",
        };
        out.add(row, facts.at(origin), owner);
    }
}

fn dynamics(
    facts: &RobotFacts<'_, '_>,
    joint: &Joint,
    dynamics: &Dynamics,
    out: &mut ConstructCollector,
) {
    let (at, owner) = (facts.at(dynamics.element), joint_owner(joint));
    if dynamics.damping.is_none() && dynamics.friction.is_none() {
        out.add("dynamics-empty", at, owner);
    }
    let rows = [
        (&dynamics.damping, "damping-negative"),
        (&dynamics.friction, "friction-negative"),
    ];
    for (text, row) in rows {
        let number = text.as_ref().and_then(AttrValue::number);
        if number.is_some_and(|number| number < 0.0) {
            out.add(row, at, owner);
        }
    }
    if facts.children(joint.element, "dynamics").nth(1).is_some() {
        out.add("two-dynamics", at, owner);
    }
}
