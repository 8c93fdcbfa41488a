//! A robot without a base_link.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::can_move;

pub(super) static RULE: Rule = Rule {
    code: "FRM013",
    name: "missing-base-link",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::Profiles(&["ros-industrial", "mobile"]),
    since: "0.1",
    fix: None,
    docs: page("missing-base-link"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let has_base = cx
        .robot
        .links
        .iter()
        .any(|link| link.shown().ends_with("base_link"));
    if has_base || !can_move(cx.robot) {
        return;
    }
    let root = cx
        .kinematics
        .roots(cx.robot)
        .first()
        .and_then(|&root| cx.robot.links.get(root)?.name.as_ref());
    let Some(root) = root else { return };
    out.report(
        root.origin,
        format!(
            "robot has no link `base_link`; its root link is `{}`",
            root.value
        ),
    )
    .help("rename the root link to `base_link`, or add one; navigation and planning expect it")
    .done();
}
