//! An origin with its rotation in both ways.
use super::super::context::DocumentCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::poses::ElementPose;

pub(super) static RULE: Rule = Rule {
    code: "FRM018",
    name: "two-rotations",
    category: Category::Frames,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("two-rotations"),
    check: Check::Pose(check),
};

fn check(_: &DocumentCx<'_>, placed: &ElementPose<'_>, out: &mut Sink<'_>) {
    let (Some(_), Some(quaternion)) = (&placed.pose.rpy, &placed.pose.quaternion) else {
        return;
    };
    let message = format!(
        "origin of {} has both `rpy` and `quat_xyzw`",
        placed.owner()
    );
    out.report(quaternion.origin, message)
        .help("remove `rpy` or `quat_xyzw`; urdfdom rejects a joint with both and ignores other elements with both")
        .done();
}
