//! A joint that joins a link to itself.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;

pub(in super::super) static RULE: Rule = Rule {
    code: "STR006",
    name: "joint-self-loop",
    category: Category::Structure,
    severity: Severity::Error,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("joint-self-loop"),
    check: Check::Robot(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    if !cx.robot.naming().has_loop {
        return;
    }
    for joint in &cx.robot.joints {
        if let (Some((parent, child)), Some(at)) = (joint.ends(), &joint.child)
            && parent == child
        {
            out.report(
                at.origin,
                format!(
                    "joint `{}` connects link `{child}` to itself",
                    joint.shown()
                ),
            )
            .help("use another parent or child link; some parsers hang on this")
            .done();
        }
    }
}
