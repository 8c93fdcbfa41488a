//! A transmission for a joint that does not exist.

use super::super::context::RobotCx;
use super::super::registry::{Activation, Category, Check, Rule, Safety, Severity, page};
use super::super::sink::Sink;
use super::joints::unknown_joints;

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
    let joints = cx.robot.transmissions.iter().flat_map(|transmission| &transmission.joints);
    unknown_joints(cx, out, joints.filter_map(|(_, name)| name.as_ref()), "a transmission");
}
