//! Limits of a joint that the robot does not have.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use project::{ProjectNameKind, is_computed};

pub(super) static RULE: Rule = Rule::beside(
    "MOV001",
    "joint-limits-unknown-joint",
    Category::Moveit,
    Severity::Warning,
    page("joint-limits-unknown-joint"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    for limit in cx
        .settings()
        .into_iter()
        .flat_map(|settings| &settings.limits)
    {
        let joint = &limit.joint;
        if !is_computed(&joint.name) && cx.lacks(ProjectNameKind::Joint, &joint.name) {
            let message = format!("limits of unknown joint `{}`", joint.name);
            let advice = cx.advice(ProjectNameKind::Joint, &joint.name);
            // MoveIt passes over it: what resembles no joint is of another robot
            let severity = if advice.similar.is_some() {
                RULE.severity
            } else {
                Severity::Info
            };
            let report = cx.report(out, joint, message).severity(severity);
            report.help(advice).done();
        }
    }
}
