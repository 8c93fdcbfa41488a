//! The one link of an arm that has no collision.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::{JointType, Link};

pub(super) static RULE: Rule = Rule {
    code: "GEO036",
    name: "collision-left-out",
    category: Category::Geometry,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("collision-left-out"),
    check: Check::Whole(check),
};

/// Links that have one, at least.
const LEAST: usize = 3;

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let bodies = cx
        .robot
        .links
        .iter()
        .enumerate()
        .filter(|(_, link)| !link.visuals.is_empty() && link.inertial.is_some());
    let (with, without): (Vec<_>, Vec<_>) =
        bodies.partition(|(_, link)| !link.collisions.is_empty());
    let [(index, link)] = without.as_slice() else {
        return;
    };
    let Some(name) = link
        .name
        .as_ref()
        .filter(|_| with.len() >= LEAST && is_between(cx, *index))
    else {
        return;
    };
    out.report(
        name.origin,
        format!(
            "link `{}` has no collision, unlike all others",
            link.shown()
        ),
    )
    .help("add a <collision>; planners and simulators ignore a link without one")
    .done();
}

/// Whether a link moves, and moves others.
fn is_between(cx: &RobotCx<'_>, index: usize) -> bool {
    let moves = |joint: usize| {
        let kind = cx
            .robot
            .joints
            .get(joint)
            .and_then(|joint| joint.joint_type());
        kind.is_some_and(|kind| kind != JointType::Fixed)
    };
    let name = cx
        .robot
        .links
        .get(index)
        .map(Link::shown)
        .unwrap_or_default();
    let below = (0..cx.robot.joints.len()).filter(|&joint| {
        let parent = cx
            .robot
            .joints
            .get(joint)
            .and_then(|joint| joint.parent.as_ref());
        parent.is_some_and(|parent| parent.value == name)
    });
    cx.kinematics
        .parent_joints(index)
        .first()
        .is_some_and(|&joint| moves(joint))
        && below.into_iter().any(moves)
}
