//! Planners of a group that the SRDF does not define.
use super::super::beside::BesideCx;
use super::super::rule::{Category, Rule, Severity, page};
use super::super::sink::Sink;
use super::groups::unknown;

pub(super) static RULE: Rule = Rule::semantic(
    "MOV005",
    "planning-unknown-group",
    Category::Moveit,
    Severity::Warning,
    page("planning-unknown-group"),
    check,
);

fn check(cx: &BesideCx<'_>, out: &mut Sink<'_>) {
    let Some(settings) = cx.settings() else {
        return;
    };
    unknown(cx, out, &settings.planners, ("planners", true));
}
