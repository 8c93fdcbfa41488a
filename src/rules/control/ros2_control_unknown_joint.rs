//! A joint of ros2_control that the robot does not have.
use std::cell::LazyCell;

use ecow::EcoString;

use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;
use super::ros2_control_unknown_interface;
use model::{AttrValue, ControlJoint};
use packages::nearest;

pub(super) static RULE: Rule = Rule {
    code: "CTL001",
    name: "ros2-control-unknown-joint",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page("ros2-control-unknown-joint"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let joints = cx.robot.controls.iter().flat_map(|control| &control.joints);
    // before Jazzy, a controller manager does not ask for the joints
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let is_before_jazzy =
        LazyCell::new(|| root.is_some_and(|root| cx.world.packages.is_before_jazzy(root)));
    // a link with hardware and without any joint is for the controller manager alone
    let is_bare = cx.robot.joints.is_empty() && cx.robot.links.len() == 1;
    let is_idle = |joint: &&ControlJoint| (is_bare || is_device(joint)) && *is_before_jazzy;
    let (idle, others): (Vec<_>, Vec<_>) = joints.partition(is_idle);
    for (joints, severity) in [(others, RULE.severity), (idle, Severity::Info)] {
        let names = joints.into_iter().filter_map(|joint| joint.name.as_ref());
        unknown_joints(cx, out, names, "ros2_control", severity);
    }
}

/// Whether a joint has interfaces, and none of a joint: it is a fan or a lamp, which has no other place in ros2_control.
fn is_device(joint: &ControlJoint) -> bool {
    let mut names = joint
        .interfaces()
        .map(|interface| interface.name.as_ref().and_then(AttrValue::name))
        .peekable();
    let is_other = |name: &EcoString| {
        !ros2_control_unknown_interface::KNOWN.contains(&name.as_str())
            && nearest(name, ros2_control_unknown_interface::KNOWN).is_none()
    };
    names.peek().is_some() && names.all(|name| name.is_some_and(is_other))
}
