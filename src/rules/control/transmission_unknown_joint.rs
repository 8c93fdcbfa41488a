//! A transmission for a joint that does not exist.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;
use crate::workspace::Target;

pub(super) const RULE: Rule = Rule {
    code: "CTL012",
    name: "transmission-unknown-joint",
    category: Category::Control,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: Some(Safety::Unsafe),
    docs: page!("transmission-unknown-joint"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    // nothing in ROS 2 reads these elements
    let root = cx.expansion.files.first().map(|file| &*file.source.path);
    let is_ros2 = root.and_then(|root| cx.world.packages.generation(root)) == Some(Target::Ros2);
    let severity = if is_ros2 { Severity::Warning } else { RULE.severity };
    let joints = cx.robot.transmissions.iter().flat_map(|transmission| &transmission.joints);
    unknown_joints(cx, out, joints.filter_map(|(_, name)| name.as_ref()), "a transmission", severity);
}
