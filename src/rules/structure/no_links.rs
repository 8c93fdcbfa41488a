//! A robot without links.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use model::tag_start;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR009",
    name: "no-links",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("no-links"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    if cx.robot.links.is_empty() {
        out.report(
            tag_start(cx.expansion, cx.robot.element),
            "robot has no links",
        )
        .help("add <link name=\"base_link\"/>; urdfdom rejects a robot without links")
        .done();
    }
}
