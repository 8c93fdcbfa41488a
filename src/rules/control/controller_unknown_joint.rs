//! A controller with a joint that the robot does not have.

use super::super::beside::BesideCx;
use super::super::registry::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::{Kind, is_computed};

pub(super) const RULE: Rule = Rule::beside(
    "CTL025",
    "controller-unknown-joint",
    Category::Control,
    Severity::Error,
    page("controller-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for controller in cx.settings().into_iter().flat_map(|settings| &settings.controllers) {
        for (key, joint) in &controller.joints {
            // `pid/joint_1` is an interface of another controller
            if is_computed(&joint.name) || joint.name.contains('/') || !cx.lacks(Kind::Joint, &joint.name) {
                continue;
            }
            let message = format!(
                "`{key}` of controller `{}` has unknown joint `{}`",
                controller.name.name, joint.name
            );
            cx.report(out, joint, message).help(cx.advice(Kind::Joint, &joint.name)).done();
        }
    }
}
