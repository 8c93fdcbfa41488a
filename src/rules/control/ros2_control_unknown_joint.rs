//! A joint of ros2_control that the robot does not have.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;

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
    unknown_joints(
        cx,
        out,
        joints.filter_map(|joint| joint.name.as_ref()),
        "ros2_control",
        severity(cx),
    );
}

/// A link with hardware and without any joint is for a controller manager alone. Before Jazzy it does not ask for the joints.
fn severity(cx: &RobotCx<'_>) -> Severity {
    let is_bare = cx.robot.joints.is_empty() && cx.robot.links.len() == 1;
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    if is_bare && root.is_some_and(|root| cx.world.packages.is_before_jazzy(root)) {
        Severity::Info
    } else {
        RULE.severity
    }
}
