//! A controller of MoveIt with a joint that the robot does not have.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::{ProjectNameKind, is_computed};

pub(super) static RULE: Rule = Rule::beside(
    "MOV006",
    "moveit-controller-unknown-joint",
    Category::Moveit,
    Severity::Error,
    page("moveit-controller-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for controller in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.moveit)
    {
        for joint in controller
            .joints
            .iter()
            .filter(|joint| !is_computed(&joint.name))
        {
            if cx.lacks(ProjectNameKind::Joint, &joint.name) {
                let message = format!(
                    "MoveIt controller `{}` has unknown joint `{}`",
                    controller.name.name, joint.name
                );
                cx.report(out, joint, message)
                    .help(cx.advice(ProjectNameKind::Joint, &joint.name))
                    .done();
            }
        }
    }
}
