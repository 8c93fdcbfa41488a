//! A root link with an unusual name.
use super::super::context::RobotCx;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::names::prefix_of;

pub(super) static RULE: Rule = Rule {
    code: "FRM017",
    name: "root-not-conventional",
    category: Category::Frames,
    severity: Severity::Info,
    default: Activation::Off,
    since: "0.1",
    fix: None,
    docs: page("root-not-conventional"),
    check: Check::Whole(check),
};

fn check(cx: &RobotCx<'_>, out: &mut Sink<'_>) {
    for root in cx.kinematics.roots(cx.robot) {
        let Some(text) = cx.robot.links.get(root).and_then(|link| link.name.as_ref()) else {
            continue;
        };
        let usual = ["world", "base_footprint", "base_link"].contains(&text.value.as_str());
        if !usual && prefix_of(&text.value, "base_link").is_none() {
            out.report(text.origin, format!("root link `{}` has an unconventional name", text.value))
                .help("rename it to `world`, `base_footprint` or `base_link`, or add such a link above it")
                .done();
        }
    }
}
