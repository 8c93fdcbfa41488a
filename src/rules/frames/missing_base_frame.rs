//! An arm without a base frame.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::can_move;
use model::tag_start;

pub(super) static RULE: Rule = Rule {
    code: "FRM012",
    name: "missing-base-frame",
    category: Category::Frames,
    severity: Severity::Warning,
    default: Activation::Profiles(&["ros-industrial"]),
    since: "0.1",
    fix: None,
    docs: page("missing-base-frame"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    let has_base = cx
        .robot
        .links
        .iter()
        .any(|link| link.shown().ends_with("base"));
    if !has_base && can_move(cx.robot) {
        out.report(tag_start(cx.expansion, cx.robot.element), "robot has no frame `base`")
            .help("add a link `base` without geometry at the origin of the robot controller, fixed to `base_link`")
            .done();
    }
}
